// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run.start_from: the state of the balls at the end of another run.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view code = "bad-start-state";
/// Columns of a state, among others (docs/formats.md, final-1.csv).
constexpr Range kinds{.least = 1, .most = 1e6, .without_most = true};
constexpr std::array state_columns{
    FileColumn{"kind", "", kinds},
    FileColumn{"radius_m", "m", positive},
    FileColumn{"x_m", "m"},
    FileColumn{"y_m", "m"},
    FileColumn{"z_m", "m"},
    FileColumn{"velocity_x_m_per_s", "m/s"},
    FileColumn{"velocity_y_m_per_s", "m/s"},
    FileColumn{"velocity_z_m_per_s", "m/s"},
    FileColumn{"spin_x_rad_per_s", "rad/s"},
    FileColumn{"spin_y_rad_per_s", "rad/s"},
    FileColumn{"spin_z_rad_per_s", "rad/s"},
};

std::vector<std::string_view> cells_of(std::string_view row) {
  std::vector<std::string_view> cells;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(row.find(',', from), row.size());
    cells.push_back(trimmed(row.substr(from, to - from)));
    if (to == row.size()) return cells;
    from = to + 1;
  }
}

/// Reads one state; ends at the first fault.
class StateFile {
 public:
  StateFile(std::string file, Findings& findings) : file_(std::move(file)), findings_(findings) {}

  std::vector<BallState> read() {
    std::ifstream stream(file_);
    std::vector<BallState> balls;
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      const std::string_view row = trimmed(line);
      if (row.empty() || row.front() == '#') continue;
      const auto cells = cells_of(row);
      if (width_ == 0) {
        if (!read_header(cells)) return {};
      } else if (const auto ball = ball_of(cells)) {
        balls.push_back(*ball);
      } else {
        fault(fmt::format("\"{}\" is not the row of a ball", row.substr(0, 60)),
              "give a finite number in every column, a radius above 0 and a kind from 1 on");
        return {};
      }
    }
    if (balls.empty()) fault("the file has no balls", "take a final-1.csv of another run");
    return balls;
  }

 private:
  bool read_header(const std::vector<std::string_view>& cells) {
    width_ = cells.size();
    for (std::size_t i = 0; i < state_columns.size(); ++i) {
      const auto at = std::ranges::find(cells, state_columns[i].name);
      if (at == cells.end()) {
        fault(fmt::format("the first line has no column {}", state_columns[i].name),
              "take a final-1.csv of a run with observe.final_state = true");
        return false;
      }
      column_[i] = static_cast<std::size_t>(at - cells.begin());
    }
    return true;
  }
  std::optional<BallState> ball_of(const std::vector<std::string_view>& cells) const {
    std::array<double, state_columns.size()> v{};
    if (cells.size() != width_) return std::nullopt;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::string_view cell = cells[column_[i]];
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), v[i]);
      if (error != std::errc{} || end != cell.data() + cell.size() ||
          !refusal(v[i], state_columns[i]).empty())
        return std::nullopt;
    }
    return BallState{v[1],
                     static_cast<std::int32_t>(v[0]) - 1,
                     {v[2], v[3], v[4]},
                     {v[5], v[6], v[7]},
                     {v[8], v[9], v[10]}};
  }
  void fault(std::string what, std::string remedy) {
    findings_.faults.push_back({fmt::format("{}:{}", file_, line_), std::move(what),
                                std::move(remedy), std::string(code)});
  }

  std::string file_;
  Findings& findings_;
  std::size_t width_ = 0, line_ = 0;
  std::array<std::size_t, state_columns.size()> column_{};
};

}  // namespace

StartStates read_start_states(const std::string& file, const Node& at, Findings& findings) {
  namespace fs = std::filesystem;
  const fs::path path = fs::path(findings.folder) / file;
  std::error_code ignored;
  StartStates start{.file = file, .folder = fs::is_directory(path, ignored)};
  std::vector<fs::path> files;
  if (!start.folder) files.push_back(path);
  for (int k = 1; start.folder; ++k) {
    const fs::path next = path / fmt::format("final-{}.csv", k);
    if (!fs::exists(next, ignored)) break;
    files.push_back(next);
  }
  if (files.empty() || !fs::is_regular_file(files.front(), ignored)) {  // /dev/zero has no end
    findings.faults.push_back(
        {at.where,
         start.folder ? fmt::format("the folder {} has no final-1.csv", path.generic_string())
                      : fmt::format("there is no file or folder {}", path.generic_string()),
         start.folder ? "run that case with observe.final_state = true"
                      : "give a result folder, or a final-1.csv in it, relative to the case file",
         start.folder ? std::string(code) : "no-such-file"});
    return start;
  }
  std::vector<std::vector<BallState>> states;
  for (const fs::path& one : files) {
    states.push_back(StateFile(one.generic_string(), findings).read());
    if (states.back().empty()) return start;
  }
  start.states = std::make_shared<const std::vector<std::vector<BallState>>>(std::move(states));
  return start;
}

}  // namespace mahlwerk::cases
