// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/summed_up.hpp"

#include <utility>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/bed.hpp"
#include "mahlwerk/results/quantities/heat_share.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/softening.hpp"

namespace mahlwerk::results {

bool can_be_summed_up(const cases::Case& mill_case) {
  constexpr std::int64_t few = 32;
  return mill_case.run.replicates > few && !mill_case.capture && !mill_case.kinetics &&
         !mill_case.grinding && !cases::has_bodies(mill_case);
}

SummingUp::SummingUp(Outcome& outcome)
    : outcome_(outcome),
      sums_(std::make_shared<SummedUp>()),
      measures_(measures(outcome.mill_case)),
      by_sense_(outcome.mill_case),
      ended_(outcome.replicates.size()) {
  const observe::CollisionStatistics& any = outcome.replicates.front().tally;
  sums_->expected = static_cast<double>(outcome.replicates.size());
  sums_->by_pair.resize(static_cast<std::size_t>(any.by_pair.pairs()));
  sums_->wall = no_wall_rates(any.wall_map.grid());
  sums_->parts = no_part_rates(any);
}

/// Two complete replicates settle that means are over complete ones (averaged_replicates()).
void SummingUp::ended(std::size_t replicate) {
  const std::lock_guard lock(mutex_);
  ended_[replicate] = true;
  for (; next_ < ended_.size() && ended_[next_]; ++next_)
    if (const Replicate& r = outcome_.replicates[next_]; r.complete && r.time() > 0)
      complete_.push_back(next_);
  if (!outcome_.summed_up && complete_.size() < 2) return;
  for (const std::size_t one : complete_) add(one);
  complete_.clear();
  outcome_.summed_up = sums_;
}

ReadBefore SummingUp::read(std::size_t replicate) const {
  const Replicate& r = outcome_.replicates[replicate];
  const cases::Case& c = by_sense_.of(replicate);
  ReadBefore made{.values = {},
                  .speed_in_jar = speed_in_jar(r),
                  .speed_in_carrier = speed_in_carrier(r),
                  .largest_speed = largest_speed(r),
                  .share_by_softening = 0,
                  .heat_in_balls = c.heat ? heat_share_in_balls(c, r) : 0,
                  .bed = bed_profile(outcome_.mill_case, r)};
  for (const Measure& m : measures_) made.values.push_back(m.compute(c, r));
  if (cases::in_time_steps(outcome_.engine) && c.contact.softening < 1)
    made.share_by_softening = share_by_softening(outcome_.mill_case, r);
  return made;
}

void SummingUp::add(std::size_t replicate) {
  Replicate& r = outcome_.replicates[replicate];
  ReadBefore made = read(replicate);
  sums_->spectra.add(r.tally.total_spectra(), r.time());
  for (std::size_t pair = 0; pair < sums_->by_pair.size(); ++pair)
    sums_->by_pair[pair].add(r.tally.by_pair[static_cast<int>(pair)].spectra, r.time());
  add_hits(sums_->wall, r, sums_->expected);
  add_hits(sums_->parts, r, sums_->expected);
  sums_->charge.merge(r.charge);
  r.tally.let_go();
  r.charge.let_go();
  r.read_before = std::move(made);
}

}  // namespace mahlwerk::results
