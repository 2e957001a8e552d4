// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/writer.hpp"

#include <string>
#include <variant>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/stl.hpp"
#include "mahlwerk/results/csv.hpp"
#include "mahlwerk/results/json.hpp"
#include "mahlwerk/results/pairs.hpp"
#include "mahlwerk/results/spectra.hpp"
#include "mahlwerk/results/tables.hpp"

namespace mahlwerk::results {
namespace {

constexpr std::string_view motion_file = "motion.csv", jar_file = "jar.stl";

/// A measured motion travels with the result: its samples, as a case can read them again.
std::string samples(const kinematics::Tabulated& motion) {
  Table table{{{"time", "s", "of the sample"},
               {"x", "m", "the jar's centre in the laboratory"},
               {"y", "m", "likewise"},
               {"z", "m", "likewise"},
               {"angle", "rad", "by which the jar has turned"}},
              {}};
  for (const kinematics::Sample& s : motion.samples())
    table.rows.push_back({s.time, s.centre.x, s.centre.y, s.centre.z, s.angle});
  return csv(table);
}

}  // namespace

void write(const Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below) {
  const auto put = [&](std::string_view name, const std::string& text) {
    folder.write(std::string(below) + std::string(name), text);
  };
  cases::Case resolved = outcome.what;
  if (const auto* measured = std::get_if<kinematics::Tabulated>(&resolved.mill.motion)) {
    put(motion_file, samples(*measured));
    resolved.mill.motion_file = motion_file;
  }
  if (const auto* mesh = std::get_if<geometry::Mesh>(&resolved.jar.shape)) {
    put(jar_file, cases::stl_text(mesh->surface()));  // in m, as it was moved
    resolved.jar.mesh = {.file = std::string(jar_file), .unit = "m", .centred = false};
  }
  put("case.resolved.toml", cases::write(resolved));
  put("spectrum.csv", csv(spectrum(outcome)));
  const std::vector<PairSummary> pairs = by_pair(outcome);
  if (!pairs.empty()) {
    put("collisions_by_pair.csv", csv(collisions_by_pair(pairs)));
    put("spectra_by_pair.csv", csv(spectra_by_pair(outcome)));
  }
  if (const Table many = sizes(outcome.what); !many.rows.empty()) put("sizes.csv", csv(many));
  put("speeds.csv", csv(speeds(outcome)));
  put("angles.csv", csv(angles(outcome)));
  put("timeseries.csv", csv(time_series(outcome)));
  put("replicates.csv", csv(replicates(outcome)));
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i)
    if (const Replicate& r = outcome.replicates[i]; !r.at_stop.empty())
      put(stopped_name(static_cast<int>(i)), csv(balls_at_stop(r)));
  put("summary.json", summary_json(outcome, summarise(outcome), version));
}

}  // namespace mahlwerk::results
