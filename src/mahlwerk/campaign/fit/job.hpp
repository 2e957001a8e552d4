// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::campaign {

/// A case with its measurements, and the mills to simulate.
struct FitJob {
  cases::Case base;  ///< of the case file; free parameters anywhere in their ranges
  std::string data_file;
  Measurements data;
  std::vector<FreeParameter> parameters;
  std::vector<cases::Case> mills;  ///< by condition
};

/// Reads a case file with [fit] and a table of measurements. Throws InputError with the faults of
/// all conditions.
FitJob fit_job(const std::filesystem::path& file, const std::string& data_file,
               const cases::Catalogue& known, const std::vector<cases::Override>& set);

/// Fits the parameters of the job to its measurements, with model curves through them. `mills` are
/// the outcomes of those of the job. Throws as `fit` does.
Fit fit(const FitJob& job, const std::vector<results::Outcome>& mills, const FitOptions& options);

/// The case with the fitted values set and the list of parameters to fit cleared.
cases::Case fitted_case(const FitJob& job, const Fit& found);

}  // namespace mahlwerk::campaign
