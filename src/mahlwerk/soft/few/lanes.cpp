// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/few/packet_lanes.hpp"
#include "mahlwerk/soft/few/solver.hpp"

// Lane allocation: assigns each pair a lane of a packet, with its parameters and its wall point.
namespace mahlwerk::soft {

/// The pair that has a lane.
FewBodySolver::NearPair FewBodySolver::pair_of(const PairPacket& p, std::size_t lane) {
  const bool wall = p.face[lane] >= 0;
  return {static_cast<std::int32_t>(p.i[lane]), wall ? -1 : static_cast<std::int32_t>(p.j[lane]),
          p.face[lane]};
}

/// Whether the found pairs are not those that have lanes, or a pair that touches is in a later
/// packet than a lane that does not touch.
bool FewBodySolver::lanes_due() const {
  if (found_pairs_ != listed_pairs_) return true;
  bool waiting = false;
  for (const PairPacket& p : particles_.packets) {
    if (waiting && std::ranges::count(p.touching.values, -1) > 0) return true;
    waiting = waiting || std::ranges::count(p.touching.values, -1) < lanes;
  }
  return false;
}

/// Gives the found pairs lanes.
void FewBodySolver::update_lanes() {
  if (found_pairs_ != listed_pairs_) {
    listed_pairs_ = found_pairs_;
    fill_lanes(found_pairs_);
  }
  sort_touching_first();
  allocate_wall_points();
  build_gather_maps();
}

/// Moves touching pairs to the first packets, so that the remaining packets are skipped.
void FewBodySolver::sort_touching_first() {
  std::vector<PairPacket>& packets = particles_.packets;
  std::size_t from = packets.size(), to = 0, lane = 0, other_lane = 0;
  const auto next_waiting = [&] {  // the first lane without contact
    for (; to < packets.size(); ++to, other_lane = 0)
      for (; other_lane < lanes; ++other_lane)
        if (packets[to].touching[other_lane] == 0) return;
  };
  while (from-- > to + 1)
    for (lane = 0; lane < lanes; ++lane) {
      if (packets[from].touching[lane] == 0) continue;
      next_waiting();
      if (to >= from) return;
      swap_lanes(packets[from], lane, packets[to], other_lane);
    }
}

/// Updates the lanes for the sorted neighbour list `wanted`. A pair that remains keeps its lane,
/// other lanes are freed, new pairs take free lanes, and the last packets are merged into the
/// first.
void FewBodySolver::fill_lanes(const std::vector<NearPair>& wanted) {
  std::vector<PairPacket>& packets = particles_.packets;
  std::vector<bool> listed(wanted.size());
  for (PairPacket& p : packets)
    for (std::size_t l = 0; l < lanes; ++l) {
      if (!p.used[l]) continue;
      const NearPair c = pair_of(p, l);
      const auto at = std::ranges::lower_bound(wanted, c);
      if (at != wanted.end() && *at == c) {
        listed[static_cast<std::size_t>(at - wanted.begin())] = true;
        continue;
      }
      if (p.touching[l] != 0) end_lane(p, l);
      flush_work(p, l);
      clear_lane(p, l);
    }
  std::size_t at = 0, lane = 0;
  const auto next_free = [&] {
    for (; at < packets.size(); ++at, lane = 0)
      for (; lane < lanes; ++lane)
        if (!packets[at].used[lane]) return;
    packets.emplace_back();
    lane = 0;
  };
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    if (listed[n]) continue;
    next_free();
    assign_lane(packets[at], lane, wanted[n]);
  }
  while (!packets.empty()) {
    PairPacket& last = packets.back();
    const auto used = std::ranges::find(last.used, true);
    if (used == last.used.end()) {
      packets.pop_back();
      continue;
    }
    next_free();
    if (at + 1 >= packets.size()) break;
    const auto from = static_cast<std::size_t>(used - last.used.begin());
    swap_lanes(last, from, packets[at], lane);
    clear_lane(last, from);
  }
  while (!packets.empty() &&
         std::ranges::find(packets.back().used, true) == packets.back().used.end())
    packets.pop_back();
}

void FewBodySolver::assign_lane(PairPacket& p, std::size_t lane, const NearPair& c) {
  clear_lane(p, lane);
  const auto i = static_cast<std::size_t>(c.i);
  const bool wall = c.face >= 0;
  const std::int32_t mine = pairs_.species_index(i);
  p.species_pair[lane] =
      wall ? pairs_.wall_pair_index(mine, c.face)
           : pairs_.ball_pair_index(mine, pairs_.species_index(static_cast<std::size_t>(c.j)));
  p.used[lane] = true;
  p.face[lane] = c.face;
  p.i[lane] = c.i;
  p.j[lane] = wall ? 0 : c.j;
  copy_lane(pair_parameters(pairs_[p.species_pair[lane]], pairs_.species_of(i),
                            wall ? nullptr : &pairs_.species_of(static_cast<std::size_t>(c.j)),
                            settings_),
            0, p, lane);
  // Unused here: flush_work() itself divides the largest overlap by the radius.
  p.inverse_radius[lane] = 0;
}

/// Allocates a wall point for each pair of a ball and a face, in the order of the lanes.
void FewBodySolver::allocate_wall_points() {
  ParticleData& w = particles_;
  const std::vector<WallNeighbour> before = std::move(w.wall_neighbours);
  w.wall_neighbours.clear();
  for (PairPacket& p : w.packets)
    for (std::size_t l = 0; l < lanes; ++l) {
      if (!p.used[l] || p.face[l] < 0) continue;
      p.j[l] = static_cast<std::int64_t>(w.balls.size() * lanes + w.wall_neighbours.size());
      w.wall_neighbours.push_back({static_cast<std::int32_t>(p.i[l]), p.face[l],
                                   (1 + past_touch) * p.radius_i[l] + pull_off_distance_});
    }
  const std::size_t blocks =
      w.balls.size() + std::max<std::size_t>(1, (w.wall_neighbours.size() + lanes - 1) / lanes);
  w.bodies.resize(std::max(blocks, w.bodies.size()));
  if (jar_->keeps_near_facets()) keep_near_facets(before);
}

/// Gives the wall points the facets that their balls had at the wall points `before`.
void FewBodySolver::keep_near_facets(std::span<const WallNeighbour> before) {
  ParticleData& w = particles_;
  const std::vector<geometry::NearFacets> old = std::move(w.near_facets);
  w.near_facets.assign(w.wall_neighbours.size(), {});
  const auto faces = static_cast<std::size_t>(jar_->faces());
  const auto pair = [&](const WallNeighbour& one) {
    return static_cast<std::size_t>(one.ball) * faces + static_cast<std::size_t>(one.face);
  };
  std::vector<std::size_t> place(w.count * faces, old.size());  // of each pair in `old`
  for (std::size_t k = 0; k < old.size(); ++k) place[pair(before[k])] = k;
  for (std::size_t k = 0; k < w.wall_neighbours.size(); ++k)
    if (const std::size_t at = place[pair(w.wall_neighbours[k])]; at < old.size())
      w.near_facets[k] = old[at];
}

/// Derives from the packets where lanes find their bodies and leave their forces, and which rows
/// are those of a ball; from the wall neighbours, where wall points find their balls.
void FewBodySolver::build_gather_maps() {
  ParticleData& w = particles_;
  w.fits_registers = w.balls.size() == 1 && w.wall_neighbours.size() <= lanes;
  w.gather_maps.assign(w.packets.size(), {});
  w.force_rows.assign(2 * lanes * w.packets.size() + 1, {});
  ForceRow* unused = &w.force_rows.back();
  std::vector<std::vector<std::uint32_t>> rows(w.count);
  for (std::size_t n = 0; n < w.packets.size(); ++n) {
    const PairPacket& p = w.packets[n];
    GatherMap& map = w.gather_maps[n];
    for (std::size_t l = 0; l < lanes; ++l) {
      map.body_i[l] = body_address(p.i[l]), map.body_j[l] = body_address(p.j[l]);
      map.row_i[l] = map.row_j[l] = unused;
      if (!p.used[l]) continue;
      const auto row = static_cast<std::uint32_t>(2 * (n * lanes + l));
      map.row_i[l] = &w.force_rows[row];
      rows[static_cast<std::size_t>(p.i[l])].push_back(row);
      if (p.wall[l] != 0) continue;
      map.row_j[l] = &w.force_rows[row + 1];
      rows[static_cast<std::size_t>(p.j[l])].push_back(row + 1);
    }
    if (w.fits_registers) find_sources(p, map);
  }
  w.wall_point_lanes.assign((w.wall_neighbours.size() + lanes - 1) / lanes, {});
  for (std::size_t k = 0; k < lanes * w.wall_point_lanes.size(); ++k) {
    const WallNeighbour& n = w.wall_neighbours[std::min(k, w.wall_neighbours.size() - 1)];
    WallPointLanes& of = w.wall_point_lanes[k / lanes];
    of.ball[k % lanes] = body_address(n.ball);
    // The jar's own loop computes all lanes; those of parts are overwritten.
    of.face[k % lanes] = n.face < jar_->first_part_face() ? n.face : 0;
  }
  w.near_facets.resize(jar_->keeps_near_facets() ? w.wall_neighbours.size() : 0);
  w.rows_of_ball.clear(), w.row_offsets.clear();
  for (const std::vector<std::uint32_t>& of_ball : rows) {
    w.rows_of_ball.push_back(static_cast<std::uint16_t>(of_ball.size()));
    for (const std::uint32_t row : of_ball)
      w.row_offsets.push_back(row * static_cast<std::uint32_t>(sizeof(ForceRow)));
  }
  if (liquid_) build_liquid_neighbours();
}

const double* FewBodySolver::body_address(std::int64_t body) const {
  const auto at = static_cast<std::size_t>(body);
  return &particles_.bodies[at / lanes].position.x[at % lanes];
}

/// Finds the contacts of each ball among the lanes.
void FewBodySolver::find_sources(const PairPacket& p, GatherMap& map) {
  std::array<std::size_t, lanes> count{};
  for (std::size_t l = 0; l < lanes; ++l) {
    if (!p.used[l]) continue;
    const auto give = [&](std::int64_t body, std::size_t from) {
      const auto ball = static_cast<std::size_t>(body);
      const std::size_t k = count[ball]++;
      map.source[k][ball] = static_cast<std::int64_t>(from);
      map.active[k][ball] = -1;
      map.max_contacts = std::max(map.max_contacts, static_cast<int>(k) + 1);
    };
    give(p.i[l], l);
    if (p.wall[l] == 0) give(p.j[l], lanes + l);
  }
}

}  // namespace mahlwerk::soft
