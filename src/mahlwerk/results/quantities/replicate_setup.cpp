// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/replicate_setup.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/wear.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"

namespace mahlwerk::results {
namespace {

/// Jars with more faces (meshes) are treated as one face.
constexpr int max_faces = 12;

observe::WallGrid wall_grid(const cases::Case& mill_case) {
  observe::WallGrid grid{.radius = 0, .bottom = INFINITY, .top = -INFINITY};
  if (!mill_case.machine_parts.empty()) grid.faces = cases::jar_faces(mill_case);
  for (const JarMesh& mesh : jar_surface(*mill_case.jar.shape))
    for (const Vec3& p : mesh.vertices) {
      grid.radius = std::max(grid.radius, math::hypot(p.x, p.y));
      grid.bottom = std::min(grid.bottom, p.z);
      grid.top = std::max(grid.top, p.z);
    }
  return grid;
}

/// Flash factors (hea.7) and Hertz times (hea.9) by bins of normal energy, each at the geometric
/// mean of its edges.
/// Of each part, a box about it in its own axes.
std::vector<observe::PartGrid> part_grids(const cases::Case& mill_case) {
  std::vector<observe::PartGrid> made;
  if (mill_case.machine_parts.empty()) return made;
  constexpr double cells_across_jar = 50;  // at most, so that small parts have few
  const double finest = 2 * geometry::reach(*mill_case.jar.shape) / cells_across_jar;
  for (const JarMesh& mesh : own_part_surfaces(cases::chamber(mill_case))) {
    Vec3 least = mesh.vertices.front(), most = least;
    for (const Vec3& p : mesh.vertices) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    made.emplace_back(least, most, finest);
  }
  return made;
}

void set_flash_factors(observe::PairFactors& factors, const powder::FlashPair& pair) {
  using observe::LogHistogram;
  for (int bin = 0; bin < LogHistogram::bins; ++bin) {
    const double middle = std::sqrt(LogHistogram::lower(bin) * LogHistogram::lower(bin + 1));
    factors.flash_per_loss.push_back(powder::flash_factor(middle, pair));
    factors.hertz_time.push_back(powder::hertz_time(middle, pair));
  }
}

observe::PairFactors factors(const cases::Case& mill_case, const contact::BounceRule& rule, int one,
                             int other) {
  observe::PairFactors made;
  made.load_distance_per_loss = powder::load_distance(1, cases::sliding_friction(mill_case, rule));
  if (cases::in_time_steps(mill_case.run.engine))
    made.softened_duration = powder::softened_duration(mill_case.contact.softening);
  if (mill_case.heat)
    set_flash_factors(
        made, other < 0 ? cases::flash_pair_with_jar(mill_case, static_cast<std::size_t>(one))
                        : cases::flash_pair(mill_case, static_cast<std::size_t>(one),
                                            static_cast<std::size_t>(other)));
  return made;
}

/// The distinguished face that each face counts as: those of the jar, then one for each part.
std::vector<std::int32_t> distinguished_faces(const cases::Case& mill_case) {
  const int of_jar = cases::jar_faces(mill_case);
  std::vector<std::int32_t> faces;
  for (int face = 0; face < of_jar; ++face) faces.push_back(of_jar > max_faces ? 0 : face);
  // A jar without walls has one face that nothing hits.
  const std::int32_t first = faces.empty() ? 1 : faces.back() + 1;
  for (const int part : cases::parts_of_faces(mill_case)) faces.push_back(first + part);
  if (faces.empty()) faces.push_back(0);
  return faces;
}

}  // namespace

Replicate empty_replicate(const cases::Case& mill_case) {
  std::vector<std::int32_t> of_ball = cases::kinds_of_balls(mill_case);
  const std::vector<std::int32_t> faces = distinguished_faces(mill_case);
  observe::BallKinds kinds(
      mill_case.balls.size() == 1 ? std::vector<std::int32_t>{} : std::move(of_ball),
      static_cast<int>(mill_case.balls.size()), faces);
  Replicate made(mill_case.observe.threshold, std::move(kinds), wall_grid(mill_case),
                 part_grids(mill_case));
  const contact::BounceTable rules = cases::bounce_table(mill_case);
  observe::StatisticsByPair& pairs = made.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto [one, other] = pairs.kinds_of(pair);
    const auto first = std::ranges::find(faces, ~other) - faces.begin();
    if (other < 0 && first >= rules.faces()) continue;  // a jar without walls
    const contact::BounceRule& rule =
        other < 0 ? rules.wall(one, static_cast<int>(first)) : rules.balls(one, other);
    pairs.set_factors(pair, factors(mill_case, rule, one, other));
  }
  for (const cases::Part* part : cases::parts_of(mill_case))
    if (auto one = part->recorder != nullptr ? part->recorder(mill_case) : nullptr)
      made.recorders.add(std::move(one));
  return made;
}

std::vector<Window> merge_window_pairs(const std::vector<Window>& windows) {
  std::vector<Window> joined;
  for (std::size_t i = 0; i + 1 < windows.size(); i += 2) {
    const Window &a = windows[i], &b = windows[i + 1];
    joined.push_back({.time = b.time,
                      .length = a.length + b.length,
                      .collisions = a.collisions + b.collisions,
                      .above = a.above + b.above,
                      .energy_normal = a.energy_normal + b.energy_normal,
                      .energy_contact_point = a.energy_contact_point + b.energy_contact_point,
                      .lost = a.lost + b.lost,
                      .wall_work = a.wall_work + b.wall_work,
                      .flow = a.flow + b.flow,
                      .contact_time = a.contact_time + b.contact_time,
                      .kinetic = b.kinetic});
  }
  return joined;
}

Replicate unrun_replicate(const cases::Case& mill_case) {
  Replicate made = empty_replicate(mill_case);
  made.pack();
  return made;
}

}  // namespace mahlwerk::results
