// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/further_runs.hpp"

namespace mahlwerk::campaign {

cases::Case without_records(cases::Case mill_case) {
  mill_case.observe = {.threshold = mill_case.observe.threshold};
  mill_case.capture.reset();
  mill_case.grinding.reset();
  mill_case.kinetics.reset();
  return mill_case;
}

RunOptions without_files(RunOptions options) {
  options.records = {};
  options.frames = {};
  options.checkpoint = nullptr;
  options.progress = {};
  return options;
}

}  // namespace mahlwerk::campaign
