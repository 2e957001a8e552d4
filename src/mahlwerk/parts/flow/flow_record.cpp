// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/flow/flow_record.hpp"

#include <cmath>

namespace mahlwerk::parts::flow {

FlowRecord::FlowRecord(const Setup& setup)
    : interval_(setup.interval),
      fresh_(setup.fresh),
      returns_(setup.returns),
      entered_at_(setup.balls, -1),
      waiting_(setup.fresh) {
  for (const Amount& set : setup.inside) sets_.push_back({{}, {}, set});
}

/// Also called when a state is read, which serialize() then replaces.
void FlowRecord::begin(double time) {
  begin_ = summed_until_ = time;
  sum_ = {};
  waited_ = busy_ = 0;
  for (Holdup& set : sets_) set.left = set.entered = {};
}

/// Balls are followed from the start of the run: what is inside when counting begins must be known.
void FlowRecord::passages(std::span<const scene::Passage> passed) {
  for (const scene::Passage& p : passed) {
    sum_until(p.time);
    Holdup& set = sets_[static_cast<std::size_t>(p.kind)];
    double& since = entered_at_[static_cast<std::size_t>(p.ball)];
    const bool enters = p.entered != 0;
    set.inside.add(enters ? 1 : -1, p.mass);
    (enters ? set.entered : set.left).add(1, p.mass);
    waiting_ += enters ? -1 : returns_ ? 1 : 0;
    if (enters) last_entry_ = p.time;
    if (!enters && since >= 0) stayed_.push_back(p.time - since);
    since = enters && p.time >= begin_ ? p.time : -1;
  }
}

void FlowRecord::sum_until(double time) {
  if (!(time > summed_until_)) return;
  const Amount inside = all().inside;
  sum_.count += inside.count * (time - summed_until_);
  sum_.mass += inside.mass * (time - summed_until_);
  waited_ += waiting_ * (time - summed_until_);
  busy_ += waiting_ > 0 ? time - summed_until_ : 0;
  summed_until_ = time;
}

Holdup FlowRecord::all() const {
  Holdup sum;
  const auto add = [](Amount& to, const Amount& more) {
    to.count += more.count, to.mass += more.mass;
  };
  for (const Holdup& set : sets_)
    add(sum.left, set.left), add(sum.entered, set.entered), add(sum.inside, set.inside);
  return sum;
}

Amount FlowRecord::mean_inside(double end) const {
  const Amount inside = all().inside;
  const double since = end - summed_until_, time = end - begin_;
  return {(sum_.count + inside.count * since) / time, (sum_.mass + inside.mass * since) / time};
}

Queue FlowRecord::queue(double end) const {
  const double since = end - summed_until_;
  return {(waited_ + waiting_ * since) / (end - begin_), busy_ + (waiting_ > 0 ? since : 0)};
}

std::vector<Tracer> FlowRecord::tracers(double end) const {
  std::vector<Tracer> all;
  for (const double time : stayed_) all.push_back({time, true});
  for (const double since : entered_at_)
    if (since >= 0) all.push_back({end - since, false});
  return all;
}

void FlowRecord::take(const scene::EnergyBalance& now) {
  while (next() <= now.time) {
    samples_.insert(samples_.end(), sets_.begin(), sets_.end());
    times_.push_back(next() - begin_);
  }
}

void FlowRecord::serialize(Archive& archive) {
  const std::size_t sets = sets_.size(), balls = entered_at_.size();
  archive(begin_)(sets_)(
      entered_at_)(stayed_)(summed_until_)(sum_)(waiting_)(waited_)(busy_)(last_entry_)(times_)(samples_);
  if (sets_.size() != sets || entered_at_.size() != balls ||
      samples_.size() != times_.size() * sets)
    throw Archive::broken();
}

}  // namespace mahlwerk::parts::flow
