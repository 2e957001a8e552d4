// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/checked_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"

namespace mahlwerk::campaign {

CheckedPoints::CheckedPoints(const cases::Case& mill_case, const std::filesystem::path& file,
                             const cases::Catalogue& known,
                             const std::vector<cases::Override>& set) {
  if (mill_case.sweep.empty()) {
    add_faults(run_faults(mill_case), "");
    if (faults_.empty()) good_.push_back(mill_case);
    return;
  }
  const Plan plan(mill_case.sweep, mill_case.seed);
  const cases::CaseFile case_file(file);
  size_ = plan.size();
  for (std::size_t i = 0; i < std::min(size_, most); ++i) {
    std::vector<cases::Override> all = set;
    std::ranges::move(plan.overrides(i), std::back_inserter(all));
    const std::string name = fmt::format(" (point {} of {})", i + 1, size_);
    std::vector<Fault> wrong;
    try {
      cases::Case point = case_file.read(known, all);
      point.sweep = {};
      wrong = run_faults(point);
      if (wrong.empty()) good_.push_back(std::move(point));
    } catch (const InputError& e) {
      wrong = e.faults();
    }
    bad_ += wrong.empty() ? 0 : 1;
    add_faults(std::move(wrong), name);
  }
}

void CheckedPoints::add_faults(std::vector<Fault> more, const std::string& point) {
  for (Fault& fault : more) {
    if (!known_.insert({fault.where, fault.what}).second) continue;
    fault.what += point;
    faults_.push_back(std::move(fault));
  }
}

}  // namespace mahlwerk::campaign
