// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/replicate_batch.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace mahlwerk::soft {

bool ReplicateBatch::fits(std::span<FewBodySolver* const> solvers) {
  return std::ranges::all_of(solvers, [&](const FewBodySolver* one) {
    return one->now_ == solvers.front()->now_ && one->loads_.empty();  // loads need own packets
  });
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

void ReplicateBatch::add_liquid_forces(std::size_t charge, const DriveSample& drive) {
  active_[charge]->solver->add_liquid(drive);
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
