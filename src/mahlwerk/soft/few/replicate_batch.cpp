// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/replicate_batch.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>
#include <utility>

#include "mahlwerk/soft/few/packet_lanes.hpp"

namespace mahlwerk::soft {
namespace {

/// Index of a member of a sorted list.
template <class T>
std::size_t index_in(const std::vector<T>& sorted, const T& member) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sorted, member) - sorted.begin());
}

}  // namespace

bool ReplicateBatch::fits(std::span<FewBodySolver* const> solvers) {
  return std::ranges::all_of(
      solvers, [&](const FewBodySolver* one) { return one->now_ == solvers.front()->now_; });
}

ReplicateBatch::ReplicateBatch(std::span<FewBodySolver* const> solvers)
    : step_(solvers.front()->now_) {
  for (FewBodySolver* solver : solvers) replicates_.push_back({solver});
}

std::vector<std::exception_ptr> ReplicateBatch::advance(
    double time, std::span<scene::Observer* const> observers) {
  const std::int64_t until = replicates_.front().solver->last_step(time);
  for (Replicate& r : replicates_) r.solver->target_time_ = time;
  const auto hand_over = [&](std::size_t least) {
    for (std::size_t k = 0; k < replicates_.size(); ++k) {
      FewBodySolver& solver = *replicates_[k].solver;
      if (solver.finished_.size() >= least) solver.hand_over(*observers[k]);
    }
  };
  while (step_ < until && !replicates_.front().solver->stopped()) {
    if (std::ranges::all_of(replicates_, [](const Replicate& r) { return r.failure != nullptr; }))
      break;
    advance_block(until);
    hand_over(1000);
  }
  hand_over(1);
  std::vector<std::exception_ptr> failures;
  for (const Replicate& r : replicates_) failures.push_back(r.failure);
  return failures;
}

/// Calls `f`. If it throws, the replicate has failed: it keeps its state and steps no more.
template <class F>
void ReplicateBatch::attempt(Replicate& r, const F& f) {
  try {
    f();
  } catch (...) {
    r.failure = std::current_exception();
    r.solver->now_ = r.solver->particles_.step;
  }
}

/// Advances all to the end of a block of steps, at most to `until`. What a replicate does at a step
/// does not depend on the others, and is what FewBodySolver::advance() does.
void ReplicateBatch::advance_block(std::int64_t until) {
  active_.clear(), charges_.clear();
  for (Replicate& r : replicates_) {
    if (r.failure || r.sleeps() || r.solver->start_skip()) continue;
    active_.push_back(&r);
    charges_.push_back(&r.solver->particles_);
  }
  if (active_.empty())
    step_ = std::min(until, next_skip_end());
  else
    step_active(active_.front()->solver->block_end(until));
  for (Replicate& r : replicates_) {
    if (r.failure) continue;
    r.solver->now_ = step_;
    if (r.solver->skip_end_ == step_) attempt(r, [&] { r.solver->end_skip(); });
  }
}

/// The first step at which a free-flight skip ends.
std::int64_t ReplicateBatch::next_skip_end() const {
  std::int64_t first = std::numeric_limits<std::int64_t>::max();
  for (const Replicate& r : replicates_)
    if (!r.failure && r.sleeps()) first = std::min(first, r.solver->skip_end_);
  return first;
}

/// Steps those that are not in a skip to step `end`, or until all are in skips.
void ReplicateBatch::step_active(std::int64_t end) {
  FewBodySolver& any = *active_.front()->solver;
  any.sample_drive(end);
  StepBlock block = any.step_block(charges_, packets_, gather_maps_, *this);
  block.shared = true;
  block.pause = next_skip_end();
  for (Replicate* r : active_) r->solver->set_idle_from();
  load_all();
  block_ = &block;
  any.step_block_(block);
  step_ = block.step;
  for (Replicate* r : active_) {
    store(*r);
    attempt(*r, [&] { r->solver->end_block(); });
  }
}

/// Rebuilds the list of a replicate. Pairs that remain keep their lanes of the shared packets.
bool ReplicateBatch::rebuild_neighbour_list(std::size_t charge) {
  Replicate& r = *active_[charge];
  attempt(r, [&] { r.solver->find_pairs(); });
  if (r.failure) {
    store(r);
    deactivate(charge);
    return false;
  }
  store_touching(r);
  if (r.solver->lanes_due()) {
    store_missing(r);
    r.solver->update_lanes();
    reload(r);
  }
  r.solver->update_slacks();
  return true;
}

void ReplicateBatch::deactivate(std::size_t charge) {
  active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(charge));
  charges_.erase(charges_.begin() + static_cast<std::ptrdiff_t>(charge));
}

/// Skips begin and end.
bool ReplicateBatch::pause() {
  const std::int64_t step = block_->step;
  for (std::size_t c = 0; c < active_.size();) {
    Replicate& r = *active_[c];
    const bool idle = !charges_[c]->touched && step >= charges_[c]->idle_from;
    if (idle && r.solver->start_skip()) {
      store(r);
      deactivate(c);
      continue;
    }
    if (idle) r.solver->set_idle_from();
    ++c;
  }
  for (Replicate& r : replicates_) {
    if (r.failure || r.solver->skip_end_ != step) continue;
    attempt(r, [&] { r.solver->end_skip(); });
    if (r.failure) continue;
    r.solver->set_idle_from();
    active_.push_back(&r);
    charges_.push_back(&r.solver->particles_);
    load(r);
  }
  block_->pause = next_skip_end();
  return !active_.empty();
}

/// Gives all pairs of active replicates a lane of empty packets, those that touch the first.
void ReplicateBatch::load_all() {
  std::size_t pairs = 0;
  for (const Replicate* r : active_) pairs += r->solver->listed_pairs_.size();
  packets_.clear(), gather_maps_.clear(), owners_.clear(), free_lanes_.clear();
  add_packets((pairs + lanes - 1) / lanes);
  for (Replicate* r : active_) load(*r);
}

void ReplicateBatch::add_packets(std::size_t count) {
  const std::size_t first = packets_.size(), end = first + count;
  packets_.resize(end), gather_maps_.resize(end), owners_.resize(end), free_lanes_.resize(end);
  for (std::size_t n = first; n < end; ++n)
    for (std::size_t l = 0; l < lanes; ++l) clear({n, l});
}

void ReplicateBatch::clear(const Place& place) {
  clear_lane(packets_[place.packet], place.lane);
  owners_[place.packet][place.lane] = {};
  free_lanes_[place.packet] |= 1U << place.lane;
  GatherMap& map = gather_maps_[place.packet];
  map.body_i[place.lane] = map.body_j[place.lane] = &no_body_.position.x[0];
  map.row_i[place.lane] = map.row_j[place.lane] = &no_row_;
}

/// The first or the last free lane; if there is none, the first of a new packet.
ReplicateBatch::Place ReplicateBatch::free_place(bool first) {
  const std::size_t count = packets_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t n = first ? k : count - 1 - k;
    const std::uint32_t free = free_lanes_[n];
    if (free == 0) continue;
    return {n, static_cast<std::size_t>(first ? std::countr_zero(free) : std::bit_width(free) - 1)};
  }
  add_packets(1);
  return {count, 0};
}

/// Calls `f` with the place of each pair among the replicate's own packets.
template <class F>
void ReplicateBatch::each_own(const Replicate& r, const F& f) {
  const std::vector<PairPacket>& packets = r.solver->particles_.packets;
  for (std::size_t n = 0; n < packets.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l)
      if (packets[n].used[l]) f(Place{n, l});
}

/// Gives all pairs of a replicate lanes.
void ReplicateBatch::load(Replicate& r) {
  r.pairs.clear();
  reload(r);
}

/// Gives pairs lanes that have none; updates the lanes of the others, which may have moved among
/// the replicate's own packets.
void ReplicateBatch::reload(Replicate& r) {
  const std::vector<Pair> before = std::exchange(r.pairs, r.solver->listed_pairs_);
  const std::vector<Place> places = std::exchange(r.places, std::vector<Place>(r.pairs.size()));
  const std::vector<PairPacket>& packets = r.solver->particles_.packets;
  each_own(r, [&](const Place& own) {
    const PairPacket& p = packets[own.packet];
    const Pair pair = FewBodySolver::pair_of(p, own.lane);
    const auto old = std::ranges::lower_bound(before, pair);
    Place& place = r.places[index_in(r.pairs, pair)];
    if (old != before.end() && *old == pair) {
      place = places[static_cast<std::size_t>(old - before.begin())];
    } else {
      place = free_place(p.touching[own.lane] != 0);
      copy_lane(p, own.lane, packets_[place.packet], place.lane);
    }
    connect(r, own, place);
  });
}

/// Connects a lane of a shared packet with the bodies and force rows of its replicate.
void ReplicateBatch::connect(Replicate& r, const Place& own, const Place& place) {
  const ParticleData& w = r.solver->particles_;
  owners_[place.packet][place.lane] = {&r, own};
  free_lanes_[place.packet] &= ~(1U << place.lane);
  packets_[place.packet].j[place.lane] = w.packets[own.packet].j[own.lane];
  const GatherMap& from = w.gather_maps[own.packet];
  GatherMap& to = gather_maps_[place.packet];
  to.body_i[place.lane] = from.body_i[own.lane], to.body_j[place.lane] = from.body_j[own.lane];
  to.row_i[place.lane] = from.row_i[own.lane], to.row_j[place.lane] = from.row_j[own.lane];
  to.filled |= (from.filled >> own.lane & 1) << place.lane;
}

/// Gives a pair back to the packets of its replicate.
void ReplicateBatch::store_lane(const Place& place) {
  const Owner& owner = owners_[place.packet][place.lane];
  ParticleData& w = owner.replicate->solver->particles_;
  copy_lane(packets_[place.packet], place.lane, w.packets[owner.own.packet], owner.own.lane);
  w.gather_maps[owner.own.packet].filled |= 1U << owner.own.lane;
  clear(place);
}

void ReplicateBatch::store(Replicate& r) {
  for (const Place& place : r.places) store_lane(place);
  r.pairs.clear(), r.places.clear();
}

/// Gives back the pairs that were not found.
void ReplicateBatch::store_missing(const Replicate& r) {
  for (std::size_t k = 0; k < r.pairs.size(); ++k)
    if (!std::ranges::binary_search(r.solver->found_pairs_, r.pairs[k])) store_lane(r.places[k]);
}

/// Tells the replicate's own packets which pairs touch.
void ReplicateBatch::store_touching(const Replicate& r) {
  for (const Place& place : r.places) {
    const Place& own = owners_[place.packet][place.lane].own;
    r.solver->particles_.packets[own.packet].touching[own.lane] =
        packets_[place.packet].touching[place.lane];
  }
}

void ReplicateBatch::begin(const PacketLanes& begun) {
  each_lane(begun, [&](std::size_t lane) {
    owners_[begun.packet][lane].replicate->solver->begin_lane(packets_[begun.packet], lane);
  });
}

void ReplicateBatch::record_onset(const PacketLanes& begun, const OnsetSpeeds& speeds) {
  each_lane(begun, [&](std::size_t lane) {
    owners_[begun.packet][lane].replicate->solver->record_onset(packets_[begun.packet], lane,
                                                                speeds);
  });
}

void ReplicateBatch::end(const PacketLanes& ended) {
  each_lane(ended, [&](std::size_t lane) { ended_.push_back({ended.packet, lane}); });
}

/// Ends contacts in the order of the replicate's own lanes: that of its records and sums.
void ReplicateBatch::forces_done() {
  std::ranges::sort(ended_, {}, [&](const Place& at) {
    const Owner& owner = owners_[at.packet][at.lane];
    return std::tuple(owner.replicate, owner.own.packet, owner.own.lane);
  });
  for (const Place& at : ended_)
    owners_[at.packet][at.lane].replicate->solver->end_lane(packets_[at.packet], at.lane);
  ended_.clear();
}

}  // namespace mahlwerk::soft
