// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view header = "time_s,x_m,y_m,z_m";
constexpr std::string_view header_with_angle = "time_s,x_m,y_m,z_m,angle_rad";
constexpr std::string_view header_of_six = "time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad";
constexpr FileColumn motion_columns[] = {
    {"time_s", "s"},      {"x_m", "m"},         {"y_m", "m"},        {"z_m", "m"},
    {"angle_rad", "rad"}, {"angle_rad", "rad"}, {"angle_rad", "rad"}};
constexpr std::size_t max_faults = 10;  // one wrong column would give a fault for every row

/// The numbers of a row; no value if a cell is not a finite number.
std::optional<std::vector<double>> numbers(std::string_view row) {
  std::vector<double> out;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(row.find(',', from), row.size());
    const std::string_view cell = trimmed(row.substr(from, to - from));
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
      return std::nullopt;
    out.push_back(value);
    if (to == row.size()) return out;
    from = to + 1;
  }
}

class MotionFile {
 public:
  /// `six_axes`: whether a table may have three angles.
  MotionFile(const std::string& file, Findings& findings, bool six_axes)
      : file_(file), findings_(findings), six_axes_(six_axes) {}

  std::vector<kinematics::Sample> read(std::istream& stream) {
    std::vector<kinematics::Sample> samples;
    for (std::string line; std::getline(stream, line) && faults_ < max_faults;) {
      ++line_;
      const std::string_view row = trimmed(line);
      if (row.empty() || row.front() == '#') continue;
      if (columns_ == 0) {
        if (!read_header(row)) return {};
      } else if (const auto cells = numbers(row); cells && cells->size() == columns_) {
        const auto& c = *cells;
        samples.push_back({c[0], {c[1], c[2], c[3]}, columns_ > 4 ? c.back() : 0.0});
        lean_.push_back({c[0], columns_ == 7 ? Vec3{c[4], c[5], 0} : Vec3{}, 0});
        check_numbers(c);
        if (samples.size() > 1 && !(c[0] > samples[samples.size() - 2].time))
          fault("the time does not increase", "sort the rows by time, each time once");
      } else {
        fault(fmt::format("\"{}\" is not a row of {} numbers", row.substr(0, 60), columns_),
              "give a finite number in every column");
      }
    }
    return samples;
  }
  bool sound() const { return faults_ == 0; }
  /// The angles about x and y as coordinates.
  const std::vector<kinematics::Sample>& lean() const { return lean_; }

 private:
  bool read_header(std::string_view row) {
    columns_ = row == header                       ? 4
               : row == header_with_angle          ? 5
               : six_axes_ && row == header_of_six ? 7
                                                   : 0;
    if (columns_ == 0)
      fault("the first line does not name the columns",
            fmt::format("write {} or {}{}", header, header_with_angle,
                        six_axes_ ? fmt::format(" or {}", header_of_six) : ""));
    return columns_ != 0;
  }
  void check_numbers(const std::vector<double>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (const std::string refused = refusal(cells[i], motion_columns[i]); !refused.empty())
        fault(fmt::format("{} = {} is {}", motion_columns[i].name, cells[i], refused),
              "give times in seconds, positions in metres and angles in radians");
  }
  void fault(std::string what, std::string remedy) {
    ++faults_;
    findings_.faults.push_back({fmt::format("{}:{}", file_, line_), std::move(what),
                                std::move(remedy), "bad-motion-file"});
  }

  const std::string& file_;
  Findings& findings_;
  bool six_axes_;
  std::vector<kinematics::Sample> lean_;
  std::size_t columns_ = 0, line_ = 0, faults_ = 0;
};

}  // namespace

kinematics::Tabulated read_motion_file(const std::string& file, const Vec3& axis, const Node& at,
                                       Findings& findings, kinematics::Tabulated* lean) {
  std::error_code none;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, none)) stream.open(file);  // /dev/zero has no end
  if (!stream.is_open()) {
    findings.faults.push_back({at.where, fmt::format("the motion file {} cannot be read", file),
                               "give its path relative to the case file", "no-such-file"});
    return {};
  }
  MotionFile rows(file, findings, lean != nullptr);
  std::vector<kinematics::Sample> samples = rows.read(stream);
  if (!rows.sound()) return {};
  try {
    if (lean != nullptr) *lean = kinematics::Tabulated(rows.lean());
    return kinematics::Tabulated(std::move(samples), axis);
  } catch (const std::invalid_argument& error) {
    findings.faults.push_back(
        {file, error.what(),
         "see docs/errors.md, \"bad-motion-file\", for the rules of measured motions",
         "bad-motion-file"});
    return {};
  }
}

}  // namespace mahlwerk::cases
