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

}  // namespace mahlwerk::campaign
