// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/many/solver.hpp"

// Contacts that begin and end, and their collision records.
namespace mahlwerk::soft {
namespace {

bool is_wall(const NeighbourPair& pair) {
  return pair.other < 0;
}

}  // namespace

/// Facets kept for a wall pair that does not touch; null if the wall keeps none. Pairs may meet in
/// an element, which costs time only.
geometry::NearFacets* ManyBodySolver::tested_facets(Chunk& chunk, const NeighbourPair& pair) const {
  if (!jar_->keeps_near_facets()) return nullptr;
  const std::size_t pairs = chunk.wall_pairs.pairs.size() + chunk.wall_pairs.separated.size();
  std::vector<geometry::NearFacets>& all = chunk.tested_facets;
  if (all.size() < 2 * pairs) all.resize(4 * pairs);
  const auto number = static_cast<std::size_t>(pair.ball) * static_cast<std::size_t>(jar_->faces());
  return &all[(number + static_cast<std::size_t>(~pair.other)) % all.size()];
}

void ManyBodySolver::test_walls(Chunk& chunk) {
  VerletList& w = chunk.wall_pairs;
  const auto touches = [&](const NeighbourPair& pair) {
    const BallRecord& ball = rows_[static_cast<std::size_t>(pair.ball)];
    return jar_->gap_distance(~pair.other, ball.position(), wall_axes_, ball.radius,
                              tested_facets(chunk, pair)) < ball.radius;
  };
  const std::size_t due = w.due(chunk.max_wall_gap_decrease, skin_ * VerletList::width);
  for (std::size_t k = due; k-- > 0;) {
    if (!touches(w.pairs[k])) continue;
    activate(chunk, w.pairs[k]);
    w.remove(k);
  }
  for (std::size_t k = w.separated.size(); k-- > 0;) {
    if (!touches(w.separated[k])) continue;
    activate(chunk, w.separated[k]);
    w.separated[k] = w.separated.back();
    w.separated.pop_back();
  }
  chunk.sums.tests += static_cast<std::int64_t>(due);
  if (body_species_.has_rounded()) test_near_pairs(chunk);
}

void ManyBodySolver::activate(Chunk& chunk, const NeighbourPair& pair) {
  if (has_rounded(pair)) {
    const TouchingSpheres touch = touching_spheres(pair.ball, pair.other);
    if (touch.distance >= touch.radius_i + touch.radius_j)  // only the spheres that hold them touch
      return chunk.near_pairs.push_back({pair, path_ + touch.least_gap()});
  }
  const std::int32_t mine = species_[static_cast<std::size_t>(pair.ball)];
  const bool own = !is_wall(pair) && pair.other >= chunk.first && pair.other < chunk.last;
  ContactPackets& list = is_wall(pair) ? chunk.wall : own ? chunk.own : chunk.halo;
  const std::int32_t species_pair =
      is_wall(pair) ? pairs_.wall_pair_index(mine, ~pair.other)
                    : pairs_.ball_pair_index(mine, species_[static_cast<std::size_t>(pair.other)]);
  const std::int32_t at = free_lane(list, species_pair, pair.ball);
  ContactPacket& g = list.packets[static_cast<std::size_t>(at / lanes)];
  const auto l = static_cast<std::size_t>(at % lanes);
  g.i[l] = pair.ball;
  g.j[l] = is_wall(pair) ? ~pair.other : pair.other;
  g.touching |= bit(l);
  g.begun |= bit(l);
}

/// Adds eight free lanes.
void ManyBodySolver::add_packet(ContactPackets& list, std::int32_t species_pair,
                                std::int32_t ball) {
  const auto g = static_cast<std::int32_t>(list.packets.size());
  const bool wall = parameters_[static_cast<std::size_t>(species_pair)].wall[0] != 0;
  ContactPacket& fresh = list.packets.emplace_back();
  fresh.species_pair.fill(species_pair);
  fresh.i.fill(ball);
  fresh.j.fill(wall ? 0 : ball);
  list.onsets.emplace_back();
  if (has_history_) list.optional_histories.emplace_back();
  if (has_friction_history_) list.friction_histories.emplace_back();
  if (wall) list.wall_normals.emplace_back();
  if (body_species_.has_rounded()) list.hulls.emplace_back();
  if (settings_.breakage) list.stresses.emplace_back();
  if ((settings_.model.curved_walls && wall) || bodies_.has_members())
    list.parameters.emplace_back() = parameters_[static_cast<std::size_t>(species_pair)];
  for (int l = lanes - 1; l >= 0; --l) list.free.push_back(g * lanes + l);
}

/// Returns a free lane for a contact of `ball` and `species_pair`, with its history cleared.
std::int32_t ManyBodySolver::free_lane(ContactPackets& list, std::int32_t species_pair,
                                       std::int32_t ball) {
  if (list.free.empty()) add_packet(list, species_pair, ball);
  const std::int32_t at = list.free.back();
  list.free.pop_back();
  const auto n = static_cast<std::size_t>(at / lanes), l = static_cast<std::size_t>(at % lanes);
  ContactPacket& g = list.packets[n];
  g.species_pair[l] = species_pair;
  g.one_species_pair = true;
  for (std::size_t k = 0; k < lanes; ++k)
    g.one_species_pair = g.one_species_pair && (!g.touches(k) || g.species_pair[k] == species_pair);
  if (g.one_species_pair) g.species_pair.fill(species_pair);
  g.tensile &= ~bit(l);
  set_lane(g.spring, l, {});
  g.impulse[l] = g.lost_normal[l] = g.lost_tangential[l] = 0;
  if (!list.hulls.empty()) list.hulls[n][l] = {};
  if (has_history_) {
    OptionalHistory& m = list.optional_histories[n];
    for (Lanes& law_history : m.law_history) law_history[l] = 0;
    set_lane(m.rolling_spring_torque, l, {});
    m.stiffness[l] = 0;
  }
  if (has_friction_history_) clear_friction_history(list.friction_histories[n], l);
  if (settings_.breakage) {
    StressHistory& stress = list.stresses[n];
    stress.rest[l] = stress.lost[l] = stress.energy[l] = 0;
    stress.unloading &= ~bit(l);
  }
  return at;
}

void ManyBodySolver::change_contact_count(Chunk& chunk, std::int32_t ball, int more) {
  if (is_member(static_cast<std::size_t>(ball))) ball = bodies_.first_row(ball);
  std::int32_t& count = contacts_of_[static_cast<std::size_t>(ball)];
  const bool was = count > 0;
  count += more;
  if ((count > 0) != was) chunk.balls_in_contact += count > 0 ? 1 : -1;
}

void ManyBodySolver::begin(Chunk& chunk, ContactPackets& list, std::size_t n) {
  ContactPacket& g = list.packets[n];
  for (std::size_t l = 0; l < lanes; ++l) {
    if ((g.begun & bit(l)) == 0) continue;
    change_contact_count(chunk, g.i[l], 1);
    if (&list == &chunk.own) change_contact_count(chunk, g.j[l], 1);
    if (!breakage_.new_balls.empty()) begin_relaxed(list, n, l, &list == &chunk.wall);
    if (list.parameters.empty()) continue;
    PairParameters& own = list.parameters[n];
    copy_lane(parameters_[static_cast<std::size_t>(g.species_pair[l])], l, own, l);
    if (bodies_.has_members()) {
      apply_contact_mass(own, l, {g.i[l], &list == &chunk.wall ? ~g.j[l] : g.j[l]},
                         g.species_pair[l]);
      continue;
    }
    apply_wall_curvature(own, l, *jar_, g.j[l], rows_[static_cast<std::size_t>(g.i[l])].position(),
                         mill_time(step_), pairs_[g.species_pair[l]], settings_.model);
  }
  g.begun = 0;
}

void ManyBodySolver::record_onset(ContactPackets& list, std::size_t n, std::uint32_t begun,
                                  const OnsetSpeeds& speeds) {
  const ContactPacket& g = list.packets[n];
  for (std::size_t l = 0; l < lanes; ++l) {
    if ((begun & bit(l)) == 0) continue;
    ContactOnset& onset = list.onsets[n][l];
    onset = contact_onset(step_, speeds, l);
    const PairParameters& parameters =
        list.parameters.empty() ? parameters_[static_cast<std::size_t>(g.species_pair[l])]
                                : list.parameters[n];
    if (has_history_)
      begin_law_history(list.optional_histories[n].law_history, parameters, l, onset.approach,
                        *settings_.model.law);
  }
}

void ManyBodySolver::end(Chunk& chunk, ContactPackets& list, std::size_t n, std::uint32_t ended) {
  ContactPacket& g = list.packets[n];
  const bool wall = &list == &chunk.wall;
  for (std::size_t l = 0; l < lanes; ++l) {
    if ((ended & bit(l)) == 0) continue;
    change_contact_count(chunk, g.i[l], -1);
    if (&list == &chunk.own) change_contact_count(chunk, g.j[l], -1);
    const PairParameters& parameters =
        list.parameters.empty() ? parameters_[static_cast<std::size_t>(g.species_pair[l])]
                                : list.parameters[n];
    const double separation = separation_energy(parameters, l, *settings_.model.law);
    g.lost_normal[l] += separation;
    chunk.sums.work.normal[l] += (&list == &chunk.halo ? 0.5 : 1) * separation;
    const bool pressed = !settings_.breakage || g.impulse[l] != 0;  // fragments may only part
    if (pressed && (&list != &chunk.halo || g.i[l] < g.j[l])) record(chunk, list, n, l);
    (wall ? chunk.wall_pairs : chunk.ball_pairs)
        .separated.push_back({g.i[l], wall ? ~g.j[l] : g.j[l]});
    g.touching &= ~bit(l);
    set_lane(g.spring, l, {});
    list.free.push_back(static_cast<std::int32_t>(n * lanes + l));
  }
}

void ManyBodySolver::record(Chunk& chunk, const ContactPackets& list, std::size_t n,
                            std::size_t l) {
  const ContactPacket& g = list.packets[n];
  const bool wall = &list == &chunk.wall;
  const BallRecord& ball = rows_[static_cast<std::size_t>(g.i[l])];
  const ContactOnset& onset = list.onsets[n][l];
  const SpeciesPair& pair = pairs_[g.species_pair[l]];
  const double t = mill_time(step_), duration = time_of(step_ - onset.step);
  const int face = wall ? g.j[l] : -1;
  const TouchingSpheres touch =
      wall ? sphere_at_wall(g.i[l], face) : touching_spheres(g.i[l], g.j[l]);
  const Vec3 of_wall = wall ? get_lane(list.wall_normals[n].normal, l) : Vec3{};
  const Vec3 normal = wall ? (1 / norm(of_wall)) * of_wall : touch.normal,
             where = jar_->within_period(ball.position()) + touch.arm_i + touch.radius_i * normal;
  chunk.finished.push_back(
      {step_,
       {.time = time_of(onset.step),
        .duration = duration,
        .ball = id_[static_cast<std::size_t>(g.i[l])],
        .other = wall ? ~g.j[l] : id_[static_cast<std::size_t>(g.j[l])],
        .where = jar_->to_face_point(where, t, face),
        .normal = jar_->to_face_axes(normal, t, face),
        .mass = contact_mass(list, n, l),
        .approach = onset.approach,
        .slip = onset.slip,
        .glide = onset.glide,
        .impulse = g.impulse[l],
        .lost_normal = g.lost_normal[l],
        .lost_tangential = g.lost_tangential[l],
        .feature = feature_hit(g.i[l], touch.arm_i + touch.radius_i * normal),
        .other_feature = wall ? scene::BodyFeature::none
                              : feature_hit(g.j[l], touch.arm_j - touch.radius_j * normal)}});
  ++chunk.sums.collisions;
  if (is_sustained(duration, onset, pair, *settings_.model.law)) ++chunk.sums.sustained;
}

}  // namespace mahlwerk::soft
