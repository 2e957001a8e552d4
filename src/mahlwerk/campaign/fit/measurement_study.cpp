// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/measurement_study.hpp"

#include <fmt/format.h>

namespace mahlwerk::campaign {

std::string condition_label(const std::vector<cases::Override>& condition) {
  std::string text;
  for (const cases::Override& set : condition)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", set.key, set.value);
  return text;
}

std::string MeasurementStudy::condition_name(std::size_t condition) const {
  return conditions[condition].empty() ? "the case" : conditions[condition];
}

void describe(MeasurementStudy& study, const cases::Case& base, const std::string& data_file,
              const Measurements& data) {
  study.title = base.title;
  study.case_file = base.file;
  study.data_file = data_file;
  study.errors_known = data.errors_known();
  for (const auto& condition : data.conditions)
    study.conditions.push_back(condition_label(condition));
}

}  // namespace mahlwerk::campaign
