// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/wear_rates.hpp"

#include <iterator>

#include "mahlwerk/results/quantities/pairs.hpp"

namespace mahlwerk::results {
namespace {

/// Adds what the collisions of a kind of pair did to one of its bodies, `times` over.
void add_pair(cases::ContactSums& sums, const observe::PairStatistics& pair, double times,
              bool energies) {
  sums.slid += times * pair.load_distance;
  sums.erosion += times * pair.erosion;
  if (!energies) return;
  const observe::PairSums all = pair.all();
  sums.lost += times * (all.lost_normal + all.lost_tangential);
}

bool by_energy(const cases::Wear& wear) {
  return wear.model == cases::Wear::Model::energy;
}

}  // namespace

double set_wear_rate(const cases::Case& c, const Replicate& r, int set) {
  const cases::BallSet& balls = c.balls[static_cast<std::size_t>(set)];
  if (balls.grains) return 0;
  const cases::Wear& wear = *c.parts.find<cases::Wear>();
  cases::ContactSums sums;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto [one, other] = pairs.kinds_of(pair);
    const int times = (one == set ? 1 : 0) + (other == set ? 1 : 0);  // both balls wear
    if (times > 0) add_pair(sums, pairs[pair], times, by_energy(wear));
  }
  return cases::worn_volume(wear, sums, balls.substance.hardness) / r.time();
}

WallMaterial wall_material(const cases::Case& c, const Replicate& r, int face) {
  const cases::MachinePart* part = part_of(c, r.tally.by_pair, face);
  return part != nullptr ? WallMaterial{part->substance.hardness, part->density}
                         : WallMaterial{c.jar.substance.hardness, c.jar.density};
}

double face_wear_rate(const cases::Case& c, const Replicate& r, int face) {
  const cases::Wear& wear = *c.parts.find<cases::Wear>();
  cases::ContactSums sums;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    if (kinds.with_jar() && kinds.face() == face) add_pair(sums, pairs[pair], 1, by_energy(wear));
  }
  sums = {sums.slid / r.time(), sums.erosion / r.time(), sums.lost / r.time()};
  return cases::worn_volume(wear, sums, wall_material(c, r, face).hardness);
}

double faces_wear(const cases::Case& c, const Replicate& r, int first, int end) {
  double mass = 0;
  for (int face = first; face < end; ++face)
    mass += face_wear_rate(c, r, face) * wall_material(c, r, face).density;
  return mass;
}

double balls_wear(const cases::Case& c, const Replicate& r) {
  double mass = 0;
  for (int set = 0; set < std::ssize(c.balls); ++set)
    mass += set_wear_rate(c, r, set) * c.balls[static_cast<std::size_t>(set)].surface_density();
  return mass;
}
double jar_wear(const cases::Case& c, const Replicate& r) {
  return faces_wear(c, r, 0, distinguished_jar_faces(c, r.tally.by_pair));
}
double parts_wear(const cases::Case& c, const Replicate& r) {
  return faces_wear(c, r, distinguished_jar_faces(c, r.tally.by_pair), r.tally.by_pair.faces());
}

}  // namespace mahlwerk::results
