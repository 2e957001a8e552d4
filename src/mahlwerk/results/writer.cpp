// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/writer.hpp"

#include <string>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/json.hpp"
#include "mahlwerk/results/tables.hpp"

namespace mahlwerk::results {

void write(const Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below) {
  const auto put = [&](std::string_view name, const std::string& text) {
    folder.write(std::string(below) + std::string(name), text);
  };
  put("case.resolved.toml", cases::write(outcome.what));
  put("spectrum.csv", csv(spectrum(outcome)));
  put("speeds.csv", csv(speeds(outcome)));
  put("angles.csv", csv(angles(outcome)));
  put("timeseries.csv", csv(time_series(outcome)));
  put("replicates.csv", csv(replicates(outcome)));
  put("summary.json", summary_json(outcome, summarise(outcome), version));
}

}  // namespace mahlwerk::results
