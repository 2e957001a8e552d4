// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/measurement_columns.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t max_faults = 20;  // a wrong column gives a fault in every row
constexpr std::string_view examples =
    "time, D10, D50, D90, specific_surface, conversion, yield, size";

class Reader {
 public:
  Reader(std::string file, const RunQuantities& known) : file_(std::move(file)), known_(known) {}

  Measurements read(const std::string& text) {
    std::istringstream stream(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      if (const std::string row(trimmed(line)); row.empty() || row.front() == '#')
        continue;
      else if (columns_.empty())
        read_headings(row);
      else if (sound_heading_)
        read_row(cells_of(row, separator_));
    }
    if (columns_.empty())
      fault("the file holds no table", "give a line of headings, and rows under it");
    else if (faults_.empty())
      check_all();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(made_);
  }

 private:
  void fault(std::string what, std::string remedy, std::string code = "bad-data") {
    fault_at(line_, std::move(what), std::move(remedy), std::move(code));
  }
  void fault_at(int line, std::string what, std::string remedy, std::string code = "bad-data") {
    if (faults_.size() < max_faults)
      faults_.push_back({line > 0 ? fmt::format("{}:{}", file_, line) : file_, std::move(what),
                         std::move(remedy), std::move(code)});
  }

  void read_headings(const std::string& line) {
    separator_ = line.find(';') != std::string::npos ? ';' : ',';
    for (const std::string& heading : cells_of(line, separator_)) {
      columns_.push_back(read_heading(heading));
      const Column& made = columns_.back();
      for (std::size_t i = 0; i + 1 < columns_.size(); ++i)
        if (columns_[i].name == made.name && columns_[i].role == made.role && !made.name.empty())
          fault(fmt::format("there are two columns \"{}\"", heading), "keep one of them");
    }
    check_headings();
    sound_heading_ = faults_.empty();
  }

  Column read_heading(const std::string& heading) {
    std::optional<Column> column = column_of(heading, known_);
    if (!column) {
      const std::string near = heading_near(heading, known_);
      fault(fmt::format("unknown column \"{}\"", heading),
            near.empty() ? fmt::format("columns are {}, passing, quantities of summary.json, and "
                                       "keys of the case such as mill.frequency",
                                       examples)
                         : fmt::format("did you mean \"{}\"?", near),
            "unknown-column");
      return {};
    }
    if (column->role != Role::condition) check_unit(*column, heading);
    return *column;
  }
  void check_unit(const Column& column, const std::string& heading) {
    try {
      parse_in(column.unit.empty() ? "1" : "1 " + column.unit, column.stored_unit);
    } catch (const UnitError& error) {
      const std::string unit(column.stored_unit);
      fault(
          fmt::format("column \"{}\": {}", heading,
                      column.unit.empty() ? "the unit is missing" : error.what()),
          fmt::format("write for instance \"{}{} ({})\"", column.name,
                      column.role == Role::error ? "_error" : "",
                      unit.empty() ? "%"
                      : column.role == Role::fall || column.what == MeasuredQuantity::rebound_height
                          ? "mm"
                      : unit == "m" ? "um"
                                    : unit),
          "bad-quantity");
    }
  }

  std::optional<std::size_t> find(Role role, std::string_view name) const {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].role == role && columns_[i].name == name) return i;
    return std::nullopt;
  }

  void check_headings() {
    bool measured = false;
    for (Column& column : columns_) {
      measured = measured || column.role == Role::measured;
      if (column.role == Role::measured) column.error_in = find(Role::error, column.name);
      if (column.role == Role::error && !find(Role::measured, column.name))
        fault(fmt::format("there is a column of errors, but none of \"{}\"", column.name),
              "give the measured values, too");
    }
    const bool sizes = find(Role::size, "size").has_value();
    if (sizes != find(Role::measured, "passing").has_value())
      fault("a distribution needs a column of sizes and a column of the share passing",
            "give \"size (um)\" and \"passing (%)\"");
    if (find(Role::fall, "fall_height").has_value() !=
        find(Role::measured, "rebound_height").has_value())
      fault("a rebound needs the height of the fall",
            "give \"fall_height (mm)\" and \"rebound_height (mm)\"");
    if (!measured && faults_.empty())
      fault("no column holds measured values", fmt::format("columns are {}, passing", examples));
  }

  /// The number in a cell, in SI units; NaN if the cell is empty or wrong.
  double number(const std::string& cell, const Column& column) {
    if (cell.empty()) return no_value;
    std::string text = cell;
    if (separator_ == ';') std::ranges::replace(text, ',', '.');  // decimal comma
    try {
      const double value =
          parse_in(column.unit.empty() ? text : text + " " + column.unit, column.stored_unit);
      const std::string refused = refusal(value, column.range, column.stored_unit);
      if (refused.empty()) return value;
      fault(
          fmt::format("{}{} = {} is {}", column.name, column.role == Role::error ? "_error" : "",
                      text, refused),
          column.stored_unit.empty() && column.what != MeasuredQuantity::of_run
              ? fmt::format("give a share from 0 to 1, or name the column \"{} (%)\"", column.name)
              : "correct the number or its unit",
          "out-of-range");
    } catch (const UnitError&) {
      fault(fmt::format("\"{}\" in column \"{}\" is not a number", cell, column.name),
            "write a number without its unit, or leave the cell empty", "bad-quantity");
    }
    return no_value;
  }

  void read_row(const std::vector<std::string>& cells) {
    const bool rest = std::any_of(
        cells.begin() + static_cast<std::ptrdiff_t>(std::min(columns_.size(), cells.size())),
        cells.end(), [](const std::string& c) { return !c.empty(); });
    if (cells.size() < columns_.size() || rest)
      return fault(fmt::format("{} cells under {} headings", cells.size(), columns_.size()),
                   "give every row a cell for each heading; it may be empty");
    const std::size_t before = faults_.size(), had = made_.values.size();
    std::vector<double> numbers;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      numbers.push_back(columns_[i].role == Role::condition ? no_value
                                                            : number(cells[i], columns_[i]));
    if (faults_.size() > before) return;
    Measurement shared{.condition = condition(cells), .line = line_};
    if (const auto at = find(Role::time, "time")) shared.time = numbers[*at];
    if (const auto at = find(Role::size, "size")) shared.size = numbers[*at];
    if (const auto at = find(Role::fall, "fall_height")) shared.fall = numbers[*at];
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].role == Role::measured) take(shared, i, numbers, cells);
    if (faults_.size() == before && had == made_.values.size())
      fault("the row holds no measured value", "fill it, or remove it");
    check_order(had);
  }

  std::size_t condition(const std::vector<std::string>& cells) {
    std::vector<cases::Override> set;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (const Column& c = columns_[i]; c.role == Role::condition && !cells[i].empty())
        set.push_back({c.name, c.unit.empty() ? cells[i] : cells[i] + " " + c.unit});
    const auto same = [&](const std::vector<cases::Override>& other) {
      return std::ranges::equal(set, other, [](const auto& a, const auto& b) {
        return a.key == b.key && a.value == b.value;
      });
    };
    const auto known = std::ranges::find_if(made_.conditions, same);
    const auto index = static_cast<std::size_t>(known - made_.conditions.begin());
    if (known == made_.conditions.end()) made_.conditions.push_back(std::move(set));
    return index;
  }

  /// Keeps the value in column `i`, if there is one.
  void take(const Measurement& shared, std::size_t i, const std::vector<double>& numbers,
            const std::vector<std::string>& cells) {
    const Column& column = columns_[i];
    Measurement m = shared;
    m.what = column.what;
    m.percent = column.percent;
    m.quantity = column.quantity;
    m.value = numbers[i];
    if (column.error_in) m.error = numbers[*column.error_in];
    const std::size_t before = faults_.size();
    if (m.what == MeasuredQuantity::passing) check_size(cells[i].empty(), cells);
    if (m.what == MeasuredQuantity::rebound_height && !cells[i].empty() && !(m.fall > m.value))
      fault("a ball rebounds to less than the height of its fall",
            "give fall_height and rebound_height in this row, the larger first");
    if (!of_powder(m.what) && !cells[i].empty() && !std::isnan(m.time))
      fault(fmt::format("a time of milling means nothing for {}", m.name()),
            "leave the time of this row empty; run.time is the time that is simulated");
    if (cells[i].empty() && !std::isnan(m.error))
      fault(fmt::format("an error of {}, but no value", column.name), "give both, or none");
    if (faults_.size() == before && !std::isnan(m.value)) made_.values.push_back(m);
  }
  void check_size(bool empty, const std::vector<std::string>& cells) {
    const std::string& size = cells[*find(Role::size, "size")];
    if (size.empty() != empty)
      fault(empty ? "a size, but no share passing" : "a share passing, but no size",
            "give both, or none");
  }

  /// Sizes in a row must rise with the percentage of their quantile, and the share passing with the
  /// size from row to row.
  void check_order(std::size_t first) {
    const std::vector<Measurement>& all = made_.values;
    for (std::size_t i = first; i < all.size(); ++i)
      for (std::size_t k = first; k < all.size(); ++k)
        if (all[i].what == MeasuredQuantity::quantile &&
            all[k].what == MeasuredQuantity::quantile && all[i].percent < all[k].percent &&
            all[i].value > all[k].value)
          fault(fmt::format("D{} is larger than D{}", all[i].percent, all[k].percent),
                "correct one of them");
    for (std::size_t i = first; i < all.size(); ++i)
      if (all[i].what == MeasuredQuantity::passing) {
        const Measurement* last = last_passing_ ? &all[*last_passing_] : nullptr;
        if (last != nullptr && last->condition == all[i].condition &&
            (last->time == all[i].time || std::isnan(last->time + all[i].time)) &&
            (all[i].size - last->size) * (all[i].value - last->value) < 0)
          fault("the share passing falls as the size rises",
                "give the cumulative share, not the share between two sizes");
        last_passing_ = i;
      }
  }

  void check_all() {
    if (made_.values.empty())
      return fault_at(0, "there is no row under the headings", "give the measured values");
    if (made_.errors_known()) return;
    const auto without = std::ranges::count_if(
        made_.values, [](const Measurement& m) { return std::isnan(m.error); });
    if (static_cast<std::size_t>(without) < made_.values.size())
      fault_at(0, fmt::format("{} of {} values have no error", without, made_.values.size()),
               "give the errors of all, or leave out the columns of errors");
  }

  std::string file_;
  const RunQuantities& known_;
  std::vector<Fault> faults_;
  Measurements made_;
  std::vector<Column> columns_;
  char separator_ = ',';
  int line_ = 0;
  bool sound_heading_ = false;
  std::optional<std::size_t> last_passing_;
};

}  // namespace

bool of_powder(MeasuredQuantity what) {
  return what != MeasuredQuantity::of_run && what != MeasuredQuantity::rebound_height;
}

std::string Measurement::name() const {
  return what == MeasuredQuantity::of_run ? quantity.name : name_of(what, percent);
}

std::string Measurement::unit() const {
  return what == MeasuredQuantity::of_run ? quantity.unit : std::string(unit_of(what));
}

RunQuantities run_quantities(const cases::Case& mill_case) {
  RunQuantities made;
  for (const results::Measure& m : results::measures(mill_case))
    made.push_back({m.name, m.unit == "1" ? "" : m.unit});
  return made;
}

bool Measurements::errors_known() const {
  return std::ranges::none_of(values, [](const Measurement& m) { return std::isnan(m.error); });
}

Measurements read_measurements(const std::filesystem::path& file, const RunQuantities& known) {
  std::error_code ignored;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(file, ignored)) stream.open(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw InputError(Fault{file.generic_string(), "there is no such table of measurements",
                           "check the path; it is a .csv file", "no-such-file"});
  return read_measurements_text(text, file.generic_string(), known);
}

Measurements read_measurements_text(const std::string& text, const std::string& file,
                                    const RunQuantities& known) {
  return Reader(file, known).read(text);
}

}  // namespace mahlwerk::campaign
