// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/wear/worn_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/section_profile.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/geometry/worn_section.hpp"

namespace mahlwerk::campaign {
namespace {

using geometry::PlanePoint;
using geometry::Section;

/// A solid of bars with this section.
geometry::MeshSolid bars_of(const cases::MachinePart& part, const Section& section) {
  const double angle = std::get<geometry::MeshSolid>(*part.body.solid).crease_angle;
  return {geometry::weld(geometry::prism(section, part.length, static_cast<int>(part.rows))),
          angle};
}

/// Gives a body of the case another surface.
void wear_mesh(cases::Case& c, const WornCase::MeshBody& body, const geometry::Surface& surface) {
  if (!body.part) {
    const double angle = geometry::as<geometry::Mesh>(*c.jar.shape)->crease_angle;
    c.jar.shape = geometry::Mesh(surface, angle);
    return;
  }
  geometry::AnySolid& solid = *c.machine_parts[*body.part].body.solid;
  const double angle = std::get<geometry::MeshSolid>(solid).crease_angle;
  solid = geometry::MeshSolid(surface, angle);
}

/// The faces of a part, among those of the jar and all parts.
observe::WornBody faces_of_part(const cases::Case& stage, std::size_t part) {
  const std::vector<int> parts = cases::parts_of_faces(stage);
  const auto first = std::ranges::lower_bound(parts, static_cast<int>(part));
  const auto end = std::ranges::upper_bound(parts, static_cast<int>(part));
  observe::WornBody body;
  body.first_face = cases::jar_faces(stage) + static_cast<int>(first - parts.begin());
  body.end_face = body.first_face + static_cast<int>(end - first);
  return body;
}

bool is_profile(const cases::MachinePart& part) {
  return std::holds_alternative<geometry::MeshSolid>(*part.body.solid) && part.length > 0;
}

PlanePoint middle_of(const Section& s, std::size_t side) {
  const PlanePoint &a = s[side], &b = s[side + 1 == s.size() ? 0 : side + 1];
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}

/// Where a point of a section is in the jar's own axes, in the middle of its length.
Vec3 in_jar(const cases::MachinePart& part, const PlanePoint& p) {
  return part.body.position + part.body.axes * Vec3{p.x, p.y, 0};
}

/// [m] Between the z axis and a side.
double distance_from_axis(const Vec3& a, const Vec3& b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double at = square > 0 ? std::clamp(-(a.x * x + a.y * y) / square, 0.0, 1.0) : 0;
  return math::hypot(a.x + at * x, a.y + at * y);
}

/// Turns a point about the origin into the one of `rows` equal sectors whose middle is at `angle`.
PlanePoint folded(const PlanePoint& p, double rows, double angle) {
  if (!(rows > 1)) return p;
  const double sector = 2 * std::numbers::pi / rows;
  const double turns = std::round((math::atan2(p.y, p.x) - angle) / sector);
  const SinCos back = sin_cos(-turns * sector);
  return {back.cos * p.x - back.sin * p.y, back.sin * p.x + back.cos * p.y};
}

/// [rad] of the middle of a section about its own axis.
double angle_of(const Section& s) {
  PlanePoint sum;
  for (const PlanePoint& p : s) sum.x += p.x, sum.y += p.y;
  return math::atan2(sum.y, sum.x);
}

}  // namespace

WornCase::WornCase(const cases::Case& mill_case) {
  Section lifters;
  case_ = with_lifters_as_part(mill_case, lifters);
  const auto* slice = geometry::as<geometry::PeriodicCylinder>(*case_.jar.shape);
  const auto* drum = geometry::as<geometry::Cylinder>(*case_.jar.shape);
  const auto* sphere = geometry::as<geometry::Sphere>(*case_.jar.shape);
  if (slice != nullptr) fresh_.diameter = slice->diameter;
  if (drum != nullptr) fresh_.diameter = drum->diameter, fresh_.height = drum->height;
  if (sphere != nullptr) fresh_.diameter = sphere->diameter;
  for (std::size_t i = 0; i < case_.balls.size(); ++i) {
    if (case_.balls[i].grains) continue;
    sets_.push_back(i);
    powder::BallCharge charge;
    for (const cases::SizeClass& size : case_.balls[i].sizes())
      charge.push_back({size.diameter, static_cast<double>(size.count)});
    std::ranges::reverse(charge);
    fresh_.charges.push_back(std::move(charge));
  }
  constexpr double of_ball = 0.25;  // half the radius of a ball
  smoothing_ = of_ball * cases::largest_ball(case_.balls);
  if (const auto* mesh = geometry::as<geometry::Mesh>(*case_.jar.shape))
    add_mesh(std::nullopt, mesh->surface(), geometry::WornSide::inside);
  else if (!(fresh_.diameter > 0))
    kept_.emplace_back("jar");
  const bool as_part = case_.machine_parts.size() > mill_case.machine_parts.size();
  for (std::size_t i = 0; i < case_.machine_parts.size(); ++i) {
    const cases::MachinePart& part = case_.machine_parts[i];
    if (const auto* solid = std::get_if<geometry::MeshSolid>(&*part.body.solid);
        solid != nullptr && part.length <= 0 && !solid->is_sheet())
      add_mesh(i, solid->surface(), geometry::WornSide::outside);
    else if (!is_profile(part))
      kept_.push_back(part.name);
    else
      add_profile(i, as_part && i + 1 == case_.machine_parts.size() ? lifters : read_section(part));
  }
}

void WornCase::add_profile(std::size_t number, Section section) {
  const cases::MachinePart& part = case_.machine_parts[number];
  Profile made{
      .part = number, .rows = static_cast<double>(part.rows), .length = length_in_jar(part)};
  double outline = 0;
  for (std::size_t i = 0; i < section.size(); ++i) outline += geometry::length_of(section, i);
  constexpr double most_pieces = 200;
  made.piece = std::max(smoothing_, outline / most_pieces);
  profiles_.push_back(made);
  fresh_.sections.push_back(geometry::cut_into_pieces(std::move(section), made.piece));
  profiles_.back().height = height(fresh_, profiles_.size() - 1);
}

void WornCase::add_mesh(std::optional<std::size_t> part, const geometry::Surface& surface,
                        geometry::WornSide side) {
  constexpr std::size_t most_triangles = 20'000;
  meshes_.push_back({part, side});
  fresh_.surfaces.push_back(surface);
  for (double longest = 2 * smoothing_; std::isfinite(longest); longest *= 2)
    if (auto cut = geometry::cut_into_small(surface, longest, most_triangles)) {
      fresh_.surfaces.back() = std::move(*cut);
      return;
    }
}

Section WornCase::read_section(const cases::MachinePart& part) const {
  const auto path = std::filesystem::path(case_.file).parent_path() / part.file;
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  try {
    return cases::read_section_profile(text, parse_in("1 " + part.unit, "m"));
  } catch (const cases::MeshFileError& error) {
    throw InputError(Fault{path.string(), error.what(),
                           "give the file of the section beside the case", "bad-mesh-file"});
  }
}

double WornCase::length_in_jar(const cases::MachinePart& part) const {
  constexpr double parallel = 0.999;
  if (std::abs(part.body.axes.ez.z) < parallel) return part.length;
  const double period = geometry::periods(*case_.jar.shape).z;
  if (std::isfinite(period)) return std::min(part.length, period);
  return fresh_.height > 0 ? std::min(part.length, fresh_.height) : part.length;
}

std::vector<std::pair<std::size_t, std::size_t>> WornCase::cohorts(const WornState& state) const {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    const std::vector<long long> numbers = powder::whole_numbers(state.charges[s]);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (numbers[k] > 0) found.emplace_back(s, k);
  }
  return found;
}

cases::Case WornCase::at(const WornState& state) const {
  cases::Case c = cases::of_one_run(case_);
  if (const auto* slice = geometry::as<geometry::PeriodicCylinder>(*case_.jar.shape))
    c.jar.shape = geometry::PeriodicCylinder{state.diameter, slice->length};
  if (geometry::as<geometry::Cylinder>(*case_.jar.shape) != nullptr)
    c.jar.shape = geometry::Cylinder{state.diameter, state.height};
  if (geometry::as<geometry::Sphere>(*case_.jar.shape) != nullptr)
    c.jar.shape = geometry::Sphere{state.diameter};
  for (std::size_t k = 0; k < profiles_.size(); ++k) {
    cases::MachinePart& part = c.machine_parts[profiles_[k].part];
    part.body.solid = bars_of(part, state.sections[k]);
  }
  for (std::size_t k = 0; k < meshes_.size(); ++k) wear_mesh(c, meshes_[k], state.surfaces[k]);
  c.balls.clear();
  for (const auto& [s, k] : cohorts(state)) {
    cases::BallSet set = case_.balls[sets_[s]];
    set.distribution = {};
    set.classes.clear();
    set.diameter = state.charges[s][k].diameter;
    set.count = powder::whole_numbers(state.charges[s])[k];
    c.balls.push_back(std::move(set));
  }
  for (const cases::BallSet& set : case_.balls)
    if (set.grains) c.balls.push_back(set);
  std::erase_if(c.origins,
                [](const cases::Origin& origin) { return origin.key.starts_with("balls."); });
  return c;
}

std::vector<observe::WornBody> WornCase::bodies(const cases::Case& stage,
                                                const WornState& state) const {
  std::vector<observe::WornBody> made;
  for (std::size_t k = 0; k < profiles_.size(); ++k) {
    observe::WornBody body = faces_of_part(stage, profiles_[k].part);
    body.cells = state.sections[k].size();
    body.cell_of = [section = std::make_shared<const Section>(state.sections[k]),
                    rows = profiles_[k].rows,
                    angle = angle_of(state.sections[k])](const Vec3& own) {
      return geometry::nearest_side(*section, folded({own.x, own.y}, rows, angle));
    };
    made.push_back(std::move(body));
  }
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    observe::WornBody body;
    body.end_face = cases::jar_faces(stage);
    if (meshes_[k].part) body = faces_of_part(stage, *meshes_[k].part);
    body.cells = state.surfaces[k].points.size();
    body.cell_of = [nearest = std::make_shared<const geometry::NearestVertex>(state.surfaces[k])](
                       const Vec3& own) { return (*nearest)(own); };
    made.push_back(std::move(body));
  }
  return made;
}

std::vector<bool> WornCase::exposed(const WornState& state, std::size_t k) const {
  const Section& s = state.sections[k];
  const cases::MachinePart& part = case_.machine_parts[profiles_[k].part];
  std::vector<bool> found;
  const bool ball = geometry::as<geometry::Sphere>(*case_.jar.shape) != nullptr;
  const double reach = geometry::reach(*case_.jar.shape);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (part.body.in_laboratory || part.body.motion.moves()) {
      found.push_back(true);
      continue;
    }
    const Vec3 p = in_jar(part, middle_of(s, i));
    const double out = ball ? norm(p) : math::hypot(p.x, p.y);
    found.push_back(state.diameter > 0 ? out < 0.5 * state.diameter
                                       : geometry::nearest_wall(*case_.jar.shape, p, reach) > 0);
  }
  return found;
}

double WornCase::height(const WornState& state, std::size_t k) const {
  const cases::MachinePart& part = case_.machine_parts[profiles_[k].part];
  const double radius =
      state.diameter > 0 ? 0.5 * state.diameter : geometry::radius_about_axis(*case_.jar.shape);
  double nearest = radius;
  const Section& section = state.sections[k];
  for (std::size_t i = 0; i < section.size(); ++i)
    nearest =
        std::min(nearest, distance_from_axis(in_jar(part, section[i]),
                                             in_jar(part, section[(i + 1) % section.size()])));
  return radius - nearest;
}

double WornCase::bare_share(const WornState& state) const {
  double bare = 1;
  for (std::size_t k = 0; k < profiles_.size(); ++k) {
    const scene::MachinePart& body = case_.machine_parts[profiles_[k].part].body;
    constexpr double parallel = 0.999;
    if (std::abs(body.axes.ez.z) < parallel || body.position.x != 0 || body.position.y != 0)
      continue;  // not about the axis of the jar
    bare -= profiles_[k].rows * geometry::share_of_circle(state.sections[k], 0.5 * state.diameter);
  }
  return bare;
}

}  // namespace mahlwerk::campaign
