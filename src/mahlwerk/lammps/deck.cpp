// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/lammps/contact_terms.hpp"
#include "mahlwerk/lammps/jar_terms.hpp"

namespace mahlwerk::lammps {
namespace {

/// Neighbour lists: by size classes where sizes differ by more than a factor of two, as one cutoff
/// makes lists of small balls six times as long at a ratio of 15.
std::string neighbours(const std::vector<scene::Ball>& types) {
  const auto [least, most] = std::ranges::minmax(types, {}, &scene::Ball::radius);
  const bool classes = most.radius > 2 * least.radius;
  return fmt::format("neighbor {:.6g} {}\n{}neigh_modify delay 0 every 1 check yes\n",
                     0.3 * least.radius, classes ? "multi" : "bin",
                     classes ? "comm_modify mode multi\n" : "");
}

/// `pair_style tracker` must find its fix.
std::string contacts(const cases::Case& c, const std::vector<scene::Ball>& types,
                     const Steps& steps) {
  const contact::PairTable table = cases::pair_table(c);
  std::string text = fmt::format(
      "fix contacts all pair/tracker {} id1 id2 time/created time/broken r/min x y z\n"
      "pair_style hybrid/overlay granular tracker finite\n",
      steps.row);
  for (std::size_t a = 0; a < types.size(); ++a)
    for (std::size_t b = a; b < types.size(); ++b)
      text += fmt::format(
          "pair_coeff {} {} granular {}\n", a + 1, b + 1,
          contact_terms(c.contact.model,
                        pair_of(table.balls(types[a].kind, types[b].kind), types[a], types[b])));
  text += "pair_coeff * * tracker\n";
  // The wall is the same on all faces (faults). LAMMPS has at most 32 groups.
  std::map<std::string, std::string> types_at_wall;
  for (std::size_t a = 0; a < types.size(); ++a)
    types_at_wall[contact_terms(c.contact.model, {table.wall(types[a].kind, 0), types[a].radius,
                                                  types[a].mass()})] += fmt::format(" {}", a + 1);
  int wall = 0;
  for (const auto& [terms, of] : types_at_wall) {
    text += fmt::format(
        "group wall{0} type{1}\nfix wall{0} wall{0} wall/gran/region granular {2} region jar\n",
        wall + 1, of, terms);
    ++wall;
  }
  return text;
}

/// Balls that have come into contact with a face of the jar, or left one, since the last look: LAST
/// is what the formula was then. Frames as frequent as that show it, too.
std::string wall_looks(const scene::Chamber& chamber, const Steps& steps) {
  if (steps.frames_show_wall()) return "";
  return fmt::format(
      "compute radius all property/atom radius\nvariable touch atom {}\n"
      "dump wall all custom {} wall.${{session}}.txt id x y z vx vy vz omegax omegay omegaz\n"
      "dump_modify wall thresh v_touch != LAST format float %.10g\n",
      touch_formula(chamber), steps.wall);
}

std::string measurements(const scene::Chamber& chamber, const Steps& steps) {
  return power_commands(chamber) +
         fmt::format(
             "compute motion all ke\ncompute spins all erotate/sphere\n"
             "fix power all ave/time {1} {2} {0} v_wall_power v_body_power\n"
             "fix balance all print {0} \"$(step) $(c_motion) $(c_spins) $(xcm(all,x)) "
             "$(xcm(all,y)) "
             "$(xcm(all,z)) $(vcm(all,x)) $(vcm(all,y)) $(vcm(all,z)) $(f_power[1]) "
             "$(f_power[2])\" file "
             "balance.${{session}}.txt screen no title \"\"\n"
             "dump contacts all local {0} contacts.${{session}}.txt f_contacts[*]\n"
             "dump_modify contacts format float %.12g\n"
             "dump balls all custom {3} balls.${{session}}.txt id x y z vx vy vz omegax omegay "
             "omegaz\n"
             "dump_modify balls format float %.10g\n",
             steps.row, steps.power, steps.row / steps.power, steps.frame) +
         wall_looks(chamber, steps) +
         fmt::format(
             "thermo_style custom step atoms c_motion c_spins cpu\n"
             "thermo_modify lost error norm no\nthermo {}\n",
             steps.row);
}

/// Few domains are slices along the jar's axis, which share the bed evenly.
std::string processors(const scene::Chamber& chamber, int ranks) {
  constexpr int few = 8;
  if (ranks > few) return "";
  return fmt::format("processors {}\n", is_lying(chamber) ? "* 1 1" : "1 1 *");
}

}  // namespace

contact::EffectivePair pair_of(const contact::Pair& pair, const scene::Ball& a,
                               const scene::Ball& b) {
  return {pair, a.radius * b.radius / (a.radius + b.radius),
          a.mass() * b.mass() / (a.mass() + b.mass())};
}

std::vector<int> types_of(const std::vector<scene::Ball>& balls) {
  std::map<std::pair<std::int32_t, double>, int> seen;
  std::vector<int> types;
  for (const scene::Ball& ball : balls)
    types.push_back(
        seen.try_emplace({ball.kind, ball.radius}, static_cast<int>(seen.size())).first->second);
  return types;
}

std::vector<scene::Ball> one_of_each_type(const std::vector<scene::Ball>& balls) {
  const std::vector<int> types = types_of(balls);
  std::vector<scene::Ball> made;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (std::cmp_equal(types[i], made.size())) made.push_back(balls[i]);
  return made;
}

Steps steps_of(const cases::Case& c, double time, double counted, double time_step,
               double contact) {
  constexpr double rows = 400, frame_bytes = 2.5e8, ball_bytes = 150;
  constexpr std::int64_t usual_power = 100, least_frames = 20;
  const double balls = static_cast<double>(cases::balls_count(c.balls));
  Steps s{.time_step = time_step, .time = time};
  // At most 20 000 rows in all, if settling takes much longer than what counts.
  double every = std::max(counted / rows, time / (50 * rows));  // [s]
  if (c.observe.frames) every = std::min(every, *c.observe.frames);
  const auto steps = [&](double t) { return static_cast<std::int64_t>(t / time_step); };
  constexpr double soon = 0.15;  // of the shortest collision (hits.cpp)
  s.wall = std::max<std::int64_t>(2, steps(soon * contact));
  s.row = std::max<std::int64_t>(1, steps(every));
  s.power = std::min(usual_power, s.row);
  const auto affordable = static_cast<std::int64_t>(frame_bytes / (ball_bytes * balls));
  s.frame = std::max(s.wall, steps(time) / std::max(least_frames, affordable));
  if (c.observe.frames) s.frame = std::min(s.frame, s.row);
  // Rows are multiples of both, or frames of rows.
  if (s.frame < s.row) {
    s.power = std::min(s.power, s.frame);
    s.frame -= s.frame % s.power;
    s.row -= s.row % s.frame;
  } else {
    s.row -= s.row % s.power;
    s.frame -= s.frame % s.row;
  }
  const std::int64_t block = std::max(s.row, s.frame);
  while (static_cast<double>(s.total) * time_step < time * (1 + 1e-12)) s.total += block;
  s.restart = block * std::max<std::int64_t>(1, s.total / block / 50);
  return s;
}

std::string script(const cases::Case& c, const scene::Chamber& chamber,
                   const std::vector<scene::Ball>& balls, const Steps& steps, int ranks) {
  const std::vector<scene::Ball> types = one_of_each_type(balls);
  return "# A case of Mahlwerk in the jar frame; README.md says how to run it.\n"
         "variable from index none\nvariable session index 0\n"
         "units si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n" +
         processors(chamber, ranks) +
         "if \"${session} == 0\" then \"read_data balls.data\" else \"read_restart ${from}\"\n" +
         fmt::format("timestep {:.15g}\n", steps.time_step) + neighbours(types) +
         jar_commands(chamber, steps.time_step) + contacts(c, types, steps) +
         "fix motion all nve/sphere\n" +
         "fix balance_load all balance 1000 1.1 shift xyz 10 1.05\n" +
         measurements(chamber, steps) +
         fmt::format(
             "print \"$(step)\" file from.${{session}}.txt screen no\n"
             "restart {0} restart.a restart.b\nrun {1} upto\nwrite_restart restart.end\n",
             steps.restart, steps.total);
}

std::string ball_file(const scene::Chamber& chamber, const std::vector<scene::Ball>& balls) {
  const double reach = 1.1 * geometry::reach(*chamber.shape);
  const std::vector<int> types = types_of(balls);
  std::string text =
      fmt::format("balls of a case of Mahlwerk, in the jar frame\n\n{} atoms\n{} atom types\n\n",
                  balls.size(), std::ranges::max(types) + 1);
  for (const char axis : {'x', 'y', 'z'})
    text += fmt::format("{:.15g} {:.15g} {}lo {}hi\n", -reach, reach, axis, axis);
  text += "\nAtoms # sphere\n\n";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    text += fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, types[i] + 1,
                        2 * b.radius, b.density, b.position.x, b.position.y, b.position.z);
  }
  text += "\nVelocities\n\n";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3 &v = balls[i].velocity, &w = balls[i].spin;
    text += fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, v.x, v.y,
                        v.z, w.x, w.y, w.z);
  }
  return text;
}

}  // namespace mahlwerk::lammps
