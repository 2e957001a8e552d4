// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/commands/arguments.hpp"

namespace mahlwerk::commands {

/// What `fit` is given.
struct FitArguments : CaseArguments {
  std::string data;                  ///< the table of measurements
  int settings = 0;                  ///< largest number of settings; 0: as many as usual
  std::optional<double> checkpoint;  ///< [s]
};

/// `fit` of a case whose [fit] has keys of the mill: calibrates them with runs.
int calibrate(const FitArguments& given, const std::filesystem::path& file);

}  // namespace mahlwerk::commands
