// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/base/base64.hpp"
#include "mahlwerk/base/quaternion.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/report/body_surface.hpp"
#include "mahlwerk/report/plot/picture_json.hpp"
#include "mahlwerk/report/scripts.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"

namespace mahlwerk::report {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

template <class T>
std::string packed(const std::vector<T>& list) {
  return base64({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

void append(std::vector<float>& list, const Rotation& r) {
  const Quaternion q = quaternion_of(r);
  for (const double v : {q.x, q.y, q.z, q.w}) list.push_back(static_cast<float>(v));
}
void append(std::vector<float>& list, const Vec3& v) {
  for (const double one : {v.x, v.y, v.z}) list.push_back(static_cast<float>(one));
}

scene::Chamber at_full_speed(const cases::Case& c) {
  scene::Chamber mill = cases::chamber(c);
  mill.motion = c.mill.motion;
  return mill;
}

/// The jar's motion at the times of the frames, those of the mill at full speed.
struct MotionSamples {
  std::vector<float> centre, turn, carrier, rotor;
};
MotionSamples motion_samples(const cases::Case& c, const std::vector<double>& times) {
  const scene::Chamber mill = at_full_speed(c);
  MotionSamples w;
  for (const double t : times) {
    const Rotation turn = kinematics::rotation(*mill.motion, t) * mill.mount;
    append(w.centre, kinematics::frame_motion(*mill.motion, t).centre);
    append(w.turn, turn);
    append(w.carrier, kinematics::carrier(*mill.motion, t).rotation);
    append(w.rotor, turn * results::rotor_turn(*mill.shape, t));
  }
  return w;
}

std::string meshes(const cases::Case& c, const MotionSamples& w) {
  std::string list;
  for (const results::JarMesh& mesh : results::jar_surface(*c.jar.shape)) {
    std::vector<float> vertices;
    for (const Vec3& v : mesh.vertices) append(vertices, v);
    list += fmt::format("{}{{\"name\":{},\"vertices\":\"{}\",\"triangles\":\"{}\",\"turn\":{}}}",
                        list.empty() ? "" : ",", json_string(mesh.name), packed(vertices),
                        packed(mesh.triangles), mesh.rotor ? json_string(packed(w.rotor)) : "null");
  }
  return list;
}

/// The parts of the mill, each with its rotation and place in the jar frame.
std::string part_meshes(const cases::Case& c, const std::vector<double>& times) {
  const scene::Chamber mill = at_full_speed(c);
  const std::vector<results::JarMesh> surfaces = results::part_surfaces(mill);
  std::string list;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    std::vector<float> vertices, turn, shift;
    for (const Vec3& v : surfaces[i].vertices) append(vertices, v);
    for (const double t : times) {
      const scene::PartPose pose = scene::part_pose(
          mill.parts[i].motion, mill.parts[i].in_laboratory, *mill.motion, mill.mount, t);
      append(turn, pose.axes);
      append(shift, pose.origin);
    }
    list += fmt::format(
        ",{{\"name\":{},\"vertices\":\"{}\",\"triangles\":\"{}\",\"turn\":{},\"shift\":{}}}",
        json_string(c.machine_parts[i].name), packed(vertices), packed(surfaces[i].triangles),
        json_string(packed(turn)), json_string(packed(shift)));
  }
  return list;
}

/// One kind of rounded bodies, whose `count` bodies are drawn by their surface in place of their
/// spheres, the first of which is `first`.
std::string rounded_body(const scene::BodyShape& shape, std::size_t first, std::size_t count) {
  const BodySurface surface = body_surface(shape);
  std::vector<float> places, vertices, normals;
  for (const geometry::MemberSphere& s : shape.spheres) append(places, s.centre);
  for (const Vec3& v : surface.vertices) append(vertices, v);
  for (const Vec3& n : surface.normals) append(normals, n);
  return fmt::format(
      "{{\"first\":{},\"count\":{},\"places\":\"{}\",\"radius\":{:.9g},\"vertices\":\"{}\","
      "\"normals\":\"{}\",\"triangles\":\"{}\"}}",
      first, count, packed(places), shape.spheres.front().radius, packed(vertices), packed(normals),
      packed(surface.triangles));
}

/// The rounded bodies among the drawn spheres, `kinds` in turn. A film that leaves spheres out has
/// none.
std::string rounded_bodies(const cases::Case& c, const std::vector<scene::Ball>& spheres,
                           std::size_t stride) {
  const std::vector<scene::BodyShape> shapes = cases::body_shapes(c);
  std::string list;
  for (std::size_t i = 0; i < spheres.size() && !shapes.empty() && stride == 1;) {
    const std::size_t first = i;
    const auto kind = spheres[first].kind;
    while (i < spheres.size() && spheres[i].kind == kind) ++i;
    const scene::BodyShape& shape = shapes[static_cast<std::size_t>(kind)];
    if (shape.is_rounded())
      list += (list.empty() ? "" : ",") +
              rounded_body(shape, first, (i - first) / shape.spheres.size());
  }
  return list;
}

/// Numbers in 16 bits, and the unit that they are in.
struct Scaled {
  double unit = 0;
  std::vector<std::uint16_t> values;
};
Scaled scaled(const std::vector<float>& list) {
  const double largest = std::max(1e-9, double{*std::ranges::max_element(list)});
  constexpr double most = std::numeric_limits<std::uint16_t>::max();
  Scaled made{largest / most, {}};
  for (const float v : list)
    made.values.push_back(static_cast<std::uint16_t>(std::lround(double{v} / largest * most)));
  return made;
}

/// Frame of the replay at a time [s], with its fraction.
float frame_at(const std::vector<double>& times, double time) {
  const auto after = std::ranges::upper_bound(times, time);
  if (after == times.begin()) return 0;
  const auto before = after - 1;
  const auto whole = static_cast<double>(before - times.begin());
  return static_cast<float>(after == times.end() ? whole
                                                 : whole + (time - *before) / (*after - *before));
}

/// The strongest hits as JSON members. `balls`: whether the numbers of balls are those of the film.
std::string hits(const observe::Replay& film, bool balls) {
  constexpr std::uint16_t none = std::numeric_limits<std::uint16_t>::max();
  const auto stride = static_cast<std::int32_t>(film.ball_stride());
  const auto shown = [&](std::int32_t ball) {
    const bool is = ball >= 0 && ball % stride == 0 &&
                    static_cast<std::size_t>(ball / stride) < film.balls() && balls;
    return is ? static_cast<std::uint16_t>(ball / stride) : none;
  };
  std::vector<float> frames, energies;
  std::vector<std::int16_t> places;
  std::vector<std::uint16_t> of_balls;
  const std::vector<observe::ReplayHit> all = film.hits();
  double largest = 0;
  for (const observe::ReplayHit& hit : all) largest = std::max(largest, hit.energy);
  for (const observe::ReplayHit& hit : all) {
    if (hit.energy < 1e-3 * largest) continue;  // its mark would be too small to be seen
    frames.push_back(frame_at(film.times(), hit.time));
    energies.push_back(static_cast<float>(hit.energy));
    for (const double at : {hit.where.x, hit.where.y, hit.where.z})
      places.push_back(static_cast<std::int16_t>(
          std::lround(std::clamp(at / film.position_unit(), -32767.0, 32767.0))));
    of_balls.push_back(shown(hit.ball));
    of_balls.push_back(shown(hit.other));
  }
  std::string counts = "null";
  if (balls) {
    std::vector<std::uint32_t> list = film.hits_of_balls();
    list.resize(film.balls());
    counts = json_string(packed(list));
  }
  return fmt::format(
      "{{\"count\":{},\"frames\":\"{}\",\"places\":\"{}\",\"energies\":\"{}\","
      "\"balls\":\"{}\",\"of_balls\":{}}}",
      frames.size(), packed(frames), packed(places), packed(energies), packed(of_balls), counts);
}

/// [kg/m3] The density of each ball set as JSON: mass over volume of a ball; null for a set without
/// balls. Empty for bodies, whose spheres have no mass of their own.
std::string densities(const cases::Case& c, const std::vector<scene::Ball>& balls) {
  if (!cases::body_shapes(c).empty()) return "null";
  std::vector<double> of_sets(c.balls.size(), 0);
  for (const scene::Ball& ball : balls) of_sets[static_cast<std::size_t>(ball.kind)] = ball.density;
  std::string list;
  for (const double density : of_sets)
    list += (list.empty() ? "" : ",") + (density > 0 ? fmt::format("{:.9g}", density) : "null");
  return '[' + list + ']';
}

}  // namespace

std::string replay_data(const cases::Case& c, const observe::Replay& film) {
  const std::vector<scene::Ball> balls = cases::drawn_spheres(c, cases::starting_balls(c, 0));
  std::vector<float> radius;
  std::vector<std::uint8_t> species;
  for (std::size_t i = 0; i < balls.size(); i += film.ball_stride()) {
    radius.push_back(static_cast<float>(balls[i].radius));
    species.push_back(static_cast<std::uint8_t>(balls[i].kind));
  }
  const Scaled speeds = scaled(film.speeds()), spins = scaled(film.spins());
  std::string times, names;
  for (const double t : film.times()) times += fmt::format("{}{:.9g}", times.empty() ? "" : ",", t);
  for (std::size_t i = 0; i < c.balls.size(); ++i)
    names += (i > 0 ? "," : "") + json_string(cases::set_name(c, i));
  const bool planetary = kinematics::as<kinematics::Planetary>(*c.mill.motion) != nullptr;
  const MotionSamples w = motion_samples(c, film.mill_times());
  return fmt::format(
      "{{\"version\":1,\"title\":{},\"times\":[{}],\"count\":{},\"of\":{},\"radius\":\"{}\","
      "\"species\":\"{}\",\"species_names\":[{}],\"position_scale\":{:.9g},\"positions\":\"{}\","
      "\"speed_scale\":{:.9g},\"speeds\":\"{}\",\"spin_scale\":{:.9g},\"spins\":\"{}\","
      "\"densities\":{},\"hits\":{},\"jar_centre\":\"{}\",\"jar_turn\":\"{}\","
      "\"carrier_turn\":\"{}\",\"carrier\":{},\"bodies\":[{}],\"meshes\":[{}]}}",
      json_string(c.title), times, radius.size(), balls.size(), packed(radius), packed(species),
      names, film.position_unit(), packed(film.positions()), speeds.unit, packed(speeds.values),
      spins.unit, packed(spins.values), densities(c, balls),
      hits(film, cases::body_shapes(c).empty()), packed(w.centre), packed(w.turn),
      packed(w.carrier), planetary ? "\"disc\"" : "null",
      rounded_bodies(c, balls, film.ball_stride()),
      meshes(c, w) + part_meshes(c, film.mill_times()));
}

std::string replay_section(const results::Outcome& outcome) {
  if (outcome.replicates.empty()) return "";
  const observe::Replay& film = outcome.replicates.front().replay;
  if (film.times().size() < 2 || film.speeds().empty()) return "";
  return fmt::format(
      "<section id=\"replay\"></section>\n<script type=\"application/json\" "
      "id=\"replay-data\">{}</script>\n<script>{}</script>\n",
      replay_data(outcome.mill_case, film), replay_script());
}

}  // namespace mahlwerk::report
