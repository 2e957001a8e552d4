// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/replicate_batch.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "mahlwerk/soft/few/packet_lanes.hpp"

namespace mahlwerk::soft {

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

bool ReplicateBatch::rebuild_neighbour_list(std::size_t charge) {
  Replicate& r = *active_[charge];
  store(r);
  attempt(r, [&] { r.solver->rebuild_neighbour_list(); });
  if (r.failure) {
    deactivate(charge);
    return false;
  }
  load(r, true), load(r, false);
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
    load(r, true), load(r, false);
  }
  block_->pause = next_skip_end();
  return !active_.empty();
}

/// Gives all pairs of active replicates a lane, those that touch the first.
void ReplicateBatch::load_all() {
  std::size_t pairs = 0;
  for (const Replicate* r : active_) pairs += r->solver->listed_pairs_.size();
  const std::size_t packets = (pairs + lanes - 1) / lanes;
  packets_.assign(packets, {});
  gather_maps_.assign(packets, {});
  owners_.assign(packets, {});
  for (std::size_t n = 0; n < packets; ++n)
    for (std::size_t l = 0; l < lanes; ++l) clear(n, l);
  for (Replicate* r : active_) load(*r, true);
  for (Replicate* r : active_) load(*r, false);
}

void ReplicateBatch::clear(std::size_t packet, std::size_t lane) {
  clear_lane(packets_[packet], lane);
  owners_[packet][lane] = {};
  GatherMap& map = gather_maps_[packet];
  map.body_i[lane] = map.body_j[lane] = &no_body_.position.x[0];
  map.row_i[lane] = map.row_j[lane] = &no_row_;
}

/// The first or the last free lane; if there is none, the first of a new packet.
ReplicateBatch::Place ReplicateBatch::free_place(bool first) {
  const std::size_t count = lanes * packets_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = first ? k : count - 1 - k;
    if (owners_[at / lanes][at % lanes].replicate == nullptr) return {at / lanes, at % lanes};
  }
  packets_.emplace_back(), gather_maps_.emplace_back(), owners_.emplace_back();
  for (std::size_t l = 0; l < lanes; ++l) clear(packets_.size() - 1, l);
  return {packets_.size() - 1, 0};
}

/// Gives those pairs of a replicate a lane that touch, or those that do not.
void ReplicateBatch::load(Replicate& r, bool touching) {
  ParticleData& w = r.solver->particles_;
  for (std::size_t n = 0; n < w.packets.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l) {
      const PairPacket& own = w.packets[n];
      if (!own.used[l] || (own.touching[l] != 0) != touching) continue;
      const Place place = free_place(touching);
      copy_lane(own, l, packets_[place.packet], place.lane);
      owners_[place.packet][place.lane] = {&r, n, l};
      const GatherMap& from = w.gather_maps[n];
      GatherMap& to = gather_maps_[place.packet];
      to.body_i[place.lane] = from.body_i[l], to.body_j[place.lane] = from.body_j[l];
      to.row_i[place.lane] = from.row_i[l], to.row_j[place.lane] = from.row_j[l];
      to.filled |= (from.filled >> l & 1) << place.lane;
    }
}

/// Gives the pairs of a replicate back to its own packets.
void ReplicateBatch::store(const Replicate& r) {
  ParticleData& w = r.solver->particles_;
  for (GatherMap& own : w.gather_maps) own.filled = (1U << lanes) - 1;
  for (std::size_t n = 0; n < packets_.size(); ++n)
    for (std::size_t l = 0; l < lanes; ++l) {
      const Owner owner = owners_[n][l];
      if (owner.replicate != &r) continue;
      copy_lane(packets_[n], l, w.packets[owner.packet], owner.lane);
      clear(n, l);
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
    return std::tuple(owner.replicate, owner.packet, owner.lane);
  });
  for (const Place& at : ended_)
    owners_[at.packet][at.lane].replicate->solver->end_lane(packets_[at.packet], at.lane);
  ended_.clear();
}

}  // namespace mahlwerk::soft
