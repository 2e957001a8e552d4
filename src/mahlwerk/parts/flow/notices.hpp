// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/parts/flow/flow_record.hpp"
#include "mahlwerk/parts/flow/residence.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::parts::flow {

inline const FlowRecord& record_of(const results::Replicate& r) {
  return *r.recorders.find<FlowRecord>();
}
inline bool is_fed(const cases::Case& c) {
  return c.flow && c.flow->feed != cases::Flow::Feed::none;
}
inline ResidenceTimes of_tracers(const results::Replicate& r) {
  return residence_times(record_of(r).tracers(r.energy_balance.time));
}

/// What limits the numbers of the flow: nothing left, the feed ran out, the inlet is too small.
Notices notices(const results::Outcome& outcome);

}  // namespace mahlwerk::parts::flow
