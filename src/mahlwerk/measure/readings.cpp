// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/measure/clock_time.hpp"

namespace mahlwerk::measure {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = 1e30;  // beyond all that an instrument shows
constexpr std::size_t max_faults = 10, max_columns = 1000;
constexpr std::string_view how =
    "write a line of headings, \"time (s), x (mm)\", and rows of numbers below it";

std::string lower(std::string_view text) {
  std::string made(text);
  std::ranges::transform(made, made.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return made;
}

/// Separator of a line; ' ' for any number of blanks.
char separator_of(std::string_view line) {
  if (line.find(';') != line.npos) return ';';
  if (line.find('\t') != line.npos) return '\t';
  if (line.find(',') == line.npos) return ' ';
  // "0,5 1,2" has decimal commas, "0.5, 1.2" and "0,5" are two columns
  const bool blanks_alone =
      line.find(' ') != line.npos && line.find(", ") == line.npos && line.find('.') == line.npos;
  return blanks_alone ? ' ' : ',';
}

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  const auto end_cell = [&] {
    cells.emplace_back(trimmed(cell));
    cell.clear();
  };
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c != separator || quoted) {
      cell += c;
    } else if (separator != ' ' || !cell.empty()) {
      end_cell();
    }
  }
  if (separator != ' ' || !cell.empty()) end_cell();
  return cells;
}

/// A cell without a value, as instruments write it.
bool is_empty(std::string_view cell) {
  static constexpr std::string_view words[] = {"", "-", "--", "---", "nan", "na", "n/a", "ol"};
  return std::ranges::find(words, lower(cell)) != std::end(words);
}

struct Cell {
  double number = no_number;
  bool clock = false;  ///< a time of day, in s
};

/// The number in a cell, NaN for an empty one; none if it holds neither.
std::optional<Cell> cell_of(std::string_view cell, char separator) {
  if (is_empty(cell)) return Cell{};
  std::string text(cell);
  if (separator != ',' && text.find('.') == text.npos) std::ranges::replace(text, ',', '.');
  if (text.starts_with('+')) text.erase(0, 1);
  const NumberText read = number_text(text);
  if (read.rest.empty() && std::abs(read.number) < largest) return Cell{read.number};
  const auto time = clock_time(text);
  return time ? std::optional(Cell{*time, true}) : std::nullopt;
}

bool is_row(std::string_view line) {
  const char separator = separator_of(line);
  const std::vector<std::string> cells = split(line, separator);
  bool found = false;
  for (const std::string& cell : cells) {
    const auto read = cell_of(cell, separator);
    if (!read) return false;
    found = found || !std::isnan(read->number);
  }
  return found;
}

/// "x (mm)", "x [mm]", "x/mm" as name and unit.
ReadingColumn column_of(std::string_view heading) {
  const auto made = [](std::string_view name, std::string_view unit) {
    return ReadingColumn{std::string(trimmed(name)), std::string(trimmed(unit)), {}};
  };
  const std::size_t open = heading.find_first_of("([");
  if (open != heading.npos) {
    const std::size_t close = heading.find_last_of(")]");
    if (close != heading.npos && close > open)
      return made(heading.substr(0, open), heading.substr(open + 1, close - open - 1));
  }
  const std::size_t slash = heading.find('/');
  if (slash != heading.npos && slash > 0)
    return made(heading.substr(0, slash), heading.substr(slash + 1));
  return made(heading, "");
}

class ReadingsReader {
 public:
  ReadingsReader(std::string file, std::string_view headings) : given_(headings) {
    made_.file = std::move(file);
  }

  Readings read(std::string_view text) {
    check_text(text);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (std::size_t begin = 0; begin < text.size() && faults_.size() < max_faults;) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      ++line_;
      take(trimmed(text.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (faults_.empty() && made_.lines.empty())
      fault(0, "the file holds no row of numbers", std::string(how));
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(made_);
  }

 private:
  void fault(int line, std::string what, std::string remedy) {
    faults_.push_back({line > 0 ? fmt::format("{}:{}", made_.file, line) : made_.file,
                       std::move(what), std::move(remedy), "bad-readings"});
  }

  /// A file of another kind, such as a picture.
  void check_text(std::string_view text) const {
    if (text.find('\0') == text.npos) return;
    throw InputError(Fault{made_.file, "this is no text file of numbers",
                           "save the readings as CSV in UTF-8; a sound must be a WAV file, a film "
                           "a file of PGM pictures (docs/measure.md)",
                           "bad-readings"});
  }

  void take(std::string_view line) {
    if (line.empty() || line.front() == '#') return;
    if (made_.columns.empty() && !is_row(line)) {
      heading_ = line;
      return;
    }
    if (made_.columns.empty()) begin_table(line);
    if (faults_.empty() || !made_.lines.empty()) take_row(line);
  }

  void begin_table(std::string_view first_row) {
    separator_ = separator_of(first_row);
    const std::size_t count = split(first_row, separator_).size();
    std::vector<std::string> headings = split(given_, ',');
    if (given_.empty()) headings = split(heading_, separator_);
    if (given_.empty() && heading_.empty()) headings.clear();
    if (given_.empty() && heading_.empty())
      for (std::size_t i = 0; i < count; ++i) headings.push_back(fmt::format("{}", i + 1));
    if (given_.empty() && separator_ == ' ' && headings.size() != count)
      headings = split(heading_, separator_of(heading_));  // "x (mm), y (mm)" above "1 2"
    for (const std::string& heading : headings) made_.columns.push_back(column_of(heading));
    if (count > max_columns || headings.size() != count)
      fault(line_, fmt::format("{} numbers under {} headings", count, headings.size()),
            "give each column a heading: in the file, or by --columns \"time (s), x (mm), ...\"");
    for (std::size_t i = 0; i < made_.columns.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (lower(made_.columns[i].name) == lower(made_.columns[j].name))
          fault(line_, fmt::format("two columns are called \"{}\"", printable(headings[i])),
                "give them different names in the file, or by --columns");
  }

  void take_row(std::string_view line) {
    const std::vector<std::string> cells = split(line, separator_);
    if (cells.size() != made_.columns.size())
      return fault(line_,
                   fmt::format("{} cells under {} headings", cells.size(), made_.columns.size()),
                   "give every row a cell for each heading; where the decimal sign is a comma, "
                   "separate the columns by semicolons");
    std::vector<Cell> read;
    for (const std::string& cell : cells) {
      const auto one = cell_of(cell, separator_);
      if (!one)
        return fault(line_, fmt::format("\"{}\" is not a number", printable(cell.substr(0, 40))),
                     "write a number without its unit, or leave the cell empty; remove lines that "
                     "are no readings, or begin them with #");
      read.push_back(*one);
    }
    for (std::size_t i = 0; i < read.size(); ++i) {
      made_.columns[i].values.push_back(read[i].number);
      if (read[i].clock && made_.columns[i].unit.empty()) made_.columns[i].unit = "s";
    }
    made_.lines.push_back(line_);
  }

  Readings made_;
  std::string_view given_, heading_;
  std::vector<Fault> faults_;
  char separator_ = ',';
  int line_ = 0;
};

}  // namespace

const ReadingColumn* Readings::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names)
    for (const ReadingColumn& column : columns)
      if (lower(column.name) == name) return &column;
  return nullptr;
}

Readings read_readings(std::string_view text, const std::string& file, std::string_view headings) {
  return ReadingsReader(file, headings).read(text);
}

std::string file_contents(const std::string& file, std::size_t most) {
  namespace fs = std::filesystem;
  const auto fault = [&](std::string what, std::string remedy, const char* code) {
    return InputError(Fault{file, std::move(what), std::move(remedy), code});
  };
  std::error_code none;
  const fs::file_status status = fs::status(file, none);
  if (!fs::exists(status)) throw fault("there is no such file", "check the path", "no-such-file");
  if (fs::is_directory(status)) throw fault("this is a folder", "give a file", "no-such-file");
  const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(file, none) : 0;
  if (size > most)
    throw fault(fmt::format("the file has {:.0f} MB, more than {:.0f} MB",
                            1e-6 * static_cast<double>(size), 1e-6 * static_cast<double>(most)),
                "cut a part of some seconds or minutes out of it", "bad-readings");
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  for (char part[1U << 16U]; stream && text.size() <= most;) {
    stream.read(part, sizeof part);
    text.append(part, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad() || (!stream.eof() && text.size() <= most))
    throw fault("the file cannot be read", "check its permissions", "no-such-file");
  if (text.size() > most)
    throw fault("the file does not end", "give a file with some readings", "bad-readings");
  if (text.empty()) throw fault("the file is empty", "record it again", "bad-readings");
  return text;
}

std::vector<double> in_unit(const Readings& readings, const ReadingColumn& column,
                            std::string_view unit, std::size_t least) {
  const auto fault = [&](std::string what, std::string remedy) {
    return InputError(Fault{readings.file, std::move(what), std::move(remedy), "bad-readings"});
  };
  std::vector<double> made;
  std::size_t numbers = 0;
  for (const double value : column.values) numbers += std::isnan(value) ? 0 : 1;
  if (numbers < least)
    throw fault(fmt::format("numbers in the column {}: {}; at least {} are needed",
                            printable(column.name), numbers, least),
                "record more");
  try {
    const double zero = parse_in("0 " + column.unit, unit),
                 one = parse_in("1 " + column.unit, unit);
    for (const double value : column.values) made.push_back(zero + (one - zero) * value);
  } catch (const UnitError& error) {
    throw fault(fmt::format("column {}: {}", printable(column.name),
                            column.unit.empty() ? "the heading has no unit" : error.what()),
                fmt::format("write the heading with a unit, such as \"{} ({})\", in the file or by "
                            "--columns for all columns",
                            printable(column.name), unit == "m" ? "mm" : unit));
  }
  return made;
}

void missing_column(const Readings& readings, std::string_view name, std::string_view example) {
  std::string has;
  for (std::size_t i = 0; i < std::min<std::size_t>(readings.columns.size(), 10); ++i)
    has += (i > 0 ? ", " : "") + printable(readings.columns[i].name);
  throw InputError(Fault{
      readings.file, fmt::format("there is no column {}; the file has {}", name, has),
      fmt::format("name the columns in the file or by --columns \"{}\"", example), "bad-readings"});
}

}  // namespace mahlwerk::measure
