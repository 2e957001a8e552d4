// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/campaign/search/match.hpp"
#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/report/compare.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// What fits, calibrations and searches find, as JSON (docs/formats.md). `version` is that of the
// program.
namespace mahlwerk::report {

/// An object with the head that the JSON of every study has: what it is ("fit"), the program, its
/// title and its case.
results::Json study_head(std::string_view study, std::string_view version, std::string_view title,
                         std::string_view case_file);
/// The head with further members.
results::Json with(results::Json head, std::initializer_list<results::Json::Member> members);
/// A value with the ends of its interval.
results::Json interval_json(const observe::IntervalEstimate& e);

results::Json fit_json(const campaign::Fit& fit, std::string_view version);  ///< fit.json
/// fit.json of a calibration.
results::Json calibration_json(const campaign::Calibration& found, std::string_view version);
/// optimise.json, and "search" of match.json.
results::Json optimum_json(const campaign::Optimum& found, std::string_view version);
results::Json match_json(const campaign::MatchResult& found, std::string_view version);
results::Json comparison_json(const Comparison& c, std::string_view version);  ///< compare.json

}  // namespace mahlwerk::report
