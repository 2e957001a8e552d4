// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/writer.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "mahlwerk/cases/file/stl.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/result_file.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/tables.hpp"

namespace mahlwerk::results {
namespace {

constexpr std::string_view motion_file = "motion.csv", jar_file = "jar.stl", start_folder = "start";

}  // namespace

namespace {

/// The table of a motion of six axes, as cases read it.
Table six_axes(const kinematics::PartMotion& motion) {
  Table table{{{"time", "s", ""},
               {"x", "m", ""},
               {"y", "m", ""},
               {"z", "m", ""},
               {"roll", "rad", ""},
               {"pitch", "rad", ""},
               {"yaw", "rad", ""}},
              {}};
  const auto& path = motion.path.samples();
  const auto& lean = motion.lean.samples();
  for (std::size_t i = 0; i < path.size(); ++i)
    table.rows.push_back({path[i].time, path[i].centre.x, path[i].centre.y, path[i].centre.z,
                          lean[i].centre.x, lean[i].centre.y, path[i].angle});
  return table;
}

/// Writes the files of the parts beside the case: surfaces in m, and measured motions.
void write_part_files(const Folder& folder, const std::string& below,
                      std::vector<cases::MachinePart>& parts) {
  for (cases::MachinePart& part : parts) {
    if (const auto* mesh = std::get_if<geometry::MeshSolid>(&*part.body.solid)) {
      part.file = fmt::format("part-{}.stl", part.name);
      part.unit = "m", part.length = 0, part.rows = 1;
      folder.write(below + part.file, cases::stl_text(mesh->surface()));
    }
    if (part.body.motion.kind == kinematics::PartMotion::Kind::tabulated &&
        part.moves_with.empty()) {
      part.motion_file = fmt::format("part-{}.csv", part.name);
      folder.write(below + part.motion_file, csv(six_axes(part.body.motion)));
    }
  }
}

}  // namespace

std::string write_case(const Folder& folder, cases::Case mill_case, std::string_view name) {
  const std::string below(name.substr(0, name.find_last_of('/') + 1));
  if (const auto* measured = kinematics::as<kinematics::Tabulated>(*mill_case.mill.motion)) {
    folder.write(below + std::string(motion_file), csv(motion_samples(*measured)));
    mill_case.mill.motion_file = motion_file;
  }
  if (const auto* mesh = geometry::as<geometry::Mesh>(*mill_case.jar.shape)) {
    folder.write(below + std::string(jar_file),
                 cases::stl_text(mesh->surface()));  // in m, as moved
    mill_case.jar.mesh = {.file = std::string(jar_file), .unit = "m", .centred = false};
  }
  write_part_files(folder, below, mill_case.machine_parts);
  if (cases::StartStates& start = mill_case.run.start_from; start.states) {
    for (std::size_t k = 0; k < start.states->size(); ++k)
      folder.write(fmt::format("{}{}/{}.csv", below, start_folder, final_name(static_cast<int>(k))),
                   csv(start_state((*start.states)[k])));
    start.file = start_folder;
    start.folder = true;
  }
  std::string text = cases::write(mill_case);
  folder.write(name, text);
  return text;
}

void write(const Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below) {
  const auto put = [&](std::string_view name, const std::string& text) {
    folder.write(std::string(below) + std::string(name), text);
  };
  const std::vector<NamedTable> all = tables(outcome);
  for (const NamedTable& t : all) put(t.name + ".csv", csv(t.table));
  const std::string case_text =
      write_case(folder, outcome.mill_case, std::string(below) + "case.resolved.toml");
  write_result_file(folder.file(std::string(below) + "result.h5"), all, {},
                    outcome.summary.quantities, case_text, version);
  put("summary.json", summary_json(outcome, version));
}

}  // namespace mahlwerk::results
