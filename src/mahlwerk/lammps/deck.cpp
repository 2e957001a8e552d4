// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/lammps/contact_terms.hpp"
#include "mahlwerk/lammps/jar_terms.hpp"

namespace mahlwerk::lammps {
namespace {

/// One ball of each kind stands for all of its kind in laws whose numbers depend on the mass.
std::vector<scene::Ball> one_of_each_kind(const std::vector<scene::Ball>& balls) {
  std::map<std::int32_t, scene::Ball> seen;
  for (const scene::Ball& ball : balls) seen.try_emplace(ball.kind, ball);
  std::vector<scene::Ball> kinds;
  for (auto& [kind, ball] : seen) kinds.push_back(ball);
  return kinds;
}

contact::EffectivePair pair_of(const contact::Pair& pair, const scene::Ball& a,
                               const scene::Ball& b) {
  return {pair, a.radius * b.radius / (a.radius + b.radius),
          a.mass() * b.mass() / (a.mass() + b.mass())};
}

/// Neighbour lists: by size classes where sizes differ by more than a factor of two, as one cutoff
/// makes lists of small balls six times as long at a ratio of 15.
std::string neighbours(const std::vector<scene::Ball>& balls) {
  const auto [least, most] = std::ranges::minmax(balls, {}, &scene::Ball::radius);
  const bool classes = most.radius > 2 * least.radius;
  return fmt::format("neighbor {:.6g} {}\n{}neigh_modify delay 0 every 1 check yes\n",
                     0.3 * least.radius, classes ? "multi" : "bin",
                     classes ? "comm_modify mode multi vel yes\n" : "");
}

std::string contacts(const cases::Case& c, const std::vector<scene::Ball>& kinds) {
  const contact::PairTable table = cases::pair_table(c);
  std::string text = "pair_style hybrid/overlay granular tracker finite\n";
  for (const scene::Ball& a : kinds)
    for (const scene::Ball& b : kinds)
      if (a.kind <= b.kind)
        text += fmt::format(
            "pair_coeff {} {} granular {}\n", a.kind + 1, b.kind + 1,
            contact_terms(c.contact.model, pair_of(table.balls(a.kind, b.kind), a, b)));
  text += "pair_coeff * * tracker\n";
  for (const scene::Ball& a : kinds)  // the wall is the same on all faces (faults)
    text += fmt::format(
        "group kind{0} type {0}\nfix wall{0} kind{0} wall/gran/region granular {1} region jar contacts\n",
        a.kind + 1, contact_terms(c.contact.model, {table.wall(a.kind, 0), a.radius, a.mass()}));
  return text;
}

std::string measurements(const scene::Chamber& chamber, const std::vector<scene::Ball>& kinds,
                         const Steps& steps) {
  std::vector<int> numbers;
  for (const scene::Ball& kind : kinds) numbers.push_back(kind.kind + 1);
  const std::int64_t row = std::max<std::int64_t>(1, steps.counted / steps.rows / steps.sampling) *
                           steps.sampling;
  return power_commands(chamber, numbers) + fmt::format(
      "compute motion all ke\ncompute spins all erotate/sphere\n"
      "fix power all ave/time {1} {2} {0} v_wall_power v_body_power c_motion c_spins file power.txt\n"
      "fix contacts all pair/tracker {0} id1 id2 time/created time/broken r/min r/ave x y z\n"
      "dump contacts all local {0} contacts.txt f_contacts[*]\n"
      "dump_modify contacts append no\n"
      "thermo_style custom step atoms ke c_spins cpu\n"
      "thermo_modify lost error norm no\n"
      "thermo {0}\n",
      row, steps.sampling, row / steps.sampling);
}

std::string run_commands(const Steps& steps) {
  return fmt::format(
      "restart {} restart.a restart.b\nrun {}\nwrite_restart restart.end\n",
      std::max<std::int64_t>(1000, (steps.settle + steps.counted) / 20),
      steps.settle + steps.counted);
}

std::string ball_file(const std::vector<scene::Ball>& balls, std::size_t kinds, double reach) {
  std::string text = fmt::format("balls of a case of Mahlwerk, in the jar frame\n\n{} atoms\n{} atom types\n\n",
                                 balls.size(), kinds);
  for (const char axis : {'x', 'y', 'z'})
    text += fmt::format("{:.15g} {:.15g} {}lo {}hi\n", -reach, reach, axis, axis);
  text += "\nAtoms # sphere\n\n";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    text += fmt::format("{} {} {:.15g} {:.15g} {:.17g} {:.17g} {:.17g}\n", i + 1, b.kind + 1,
                        2 * b.radius, b.density, b.position.x, b.position.y, b.position.z);
  }
  text += "\nVelocities\n\n";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3 &v = balls[i].velocity, &w = balls[i].spin;
    text += fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, v.x, v.y, v.z,
                        w.x, w.y, w.z);
  }
  return text;
}

}  // namespace

std::vector<Fault> faults(const cases::Case& c) {
  std::vector<Fault> found;
  const auto refuse = [&](bool bad, std::string what, std::string can) {
    if (bad) found.push_back({c.file, "LAMMPS cannot compute " + std::move(what), std::move(can), "lammps"});
  };
  const scene::Chamber chamber = cases::chamber(c);
  const std::string law(contact::name_of(*c.contact.model.law));
  refuse(!has_region(*chamber.shape), fmt::format("the jar \"{}\"", geometry::name_of(*chamber.shape)),
         "it can compute " + known_regions());
  refuse(!has_body_force(*chamber.motion),
         fmt::format("the mill \"{}\"", kinematics::name_of(*chamber.motion)),
         "it can compute " + known_motions());
  refuse(law != "hertz-mindlin" && law != "linear-spring", fmt::format("the contact law \"{}\"", law),
         "it can compute hertz-mindlin and linear-spring");
  const contact::PairTable table = cases::pair_table(c);
  bool differ = false;
  for (int kind = 0; kind < table.kinds(); ++kind)
    for (int face = 1; face < table.faces(); ++face)
      differ = differ || !(table.wall(kind, face) == table.wall(kind, 0));
  refuse(differ, "faces of the jar with different contact values", "give the same values to all faces");
  return found;
}

Deck deck(const cases::Case& c, const std::vector<scene::Ball>& balls, const Steps& steps) {
  if (std::vector<Fault> found = faults(c); !found.empty()) throw InputError(std::move(found));
  const scene::Chamber chamber = cases::chamber(c);
  const std::vector<scene::Ball> kinds = one_of_each_kind(balls);
  const double reach = 1.1 * geometry::reach(*chamber.shape);
  std::string script = fmt::format(
      "# {}\nunits si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
      "read_data balls.data\ntimestep {:.15g}\n",
      c.title, steps.time_step);
  script += neighbours(balls) + jar_commands(chamber, steps.time_step) + contacts(c, kinds) +
            "fix motion all nve/sphere\n" + measurements(chamber, kinds, steps) + run_commands(steps);
  return {script, ball_file(balls, kinds.size(), reach)};
}

}  // namespace mahlwerk::lammps
