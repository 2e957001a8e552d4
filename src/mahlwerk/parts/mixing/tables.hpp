// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/parts/mixing/mixing_record.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::parts::mixing {

inline const std::vector<MixingSample>& samples_of(const results::Replicate& r) {
  return r.recorders.find<MixingRecord>()->samples();
}

/// Means over the replicates at each time: mixing.csv.
results::Table series(const results::Outcome& outcome);
/// Means over the points of the samples of the second half, of all replicates.
results::Table packing_profile(const results::Outcome& outcome);

}  // namespace mahlwerk::parts::mixing
