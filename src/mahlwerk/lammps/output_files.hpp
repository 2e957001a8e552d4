// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Files that LAMMPS writes, read while it still writes them.
namespace mahlwerk::lammps {

/// Columns of balance.N.txt (deck.cpp).
constexpr std::size_t balance_columns = 11;

/// Part of a run between two starts of LAMMPS: the steps of its files that count, as what a killed
/// process wrote after its last restart file is computed again.
struct Session {
  int number = 0;
  std::int64_t first = 0;         ///< step at its start
  std::int64_t last = INT64_MAX;  ///< step at which the next one starts
};
/// The sessions of a folder, in order; none if LAMMPS has not begun.
std::vector<Session> sessions(const std::filesystem::path& folder);

/// The lines of a file that grows.
class GrowingFile {
 public:
  explicit GrowingFile(const std::filesystem::path& file);
  /// The next line that is complete, without its end; valid until the next call.
  std::optional<std::string_view> line();
  /// Whether at least `count` more complete lines can be read now.
  bool has_lines(std::size_t count);
  /// Reads on behind the lines that line() gave since mark() was called.
  void mark() { mark_ = at_; }
  void back() { at_ = mark_; }

 private:
  bool read_more();
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string text_;  // read, not yet given
  std::size_t at_ = 0, mark_ = 0;
};

/// Numbers of all rows, one after the other.
struct Rows {
  std::int64_t step = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  std::size_t count() const { return columns > 0 ? values.size() / columns : 0; }
  const double* row(std::size_t i) const { return values.data() + i * columns; }
};

/// The snapshots of a dump, or the lines of a table whose first column is the step, in the files
/// NAME.0.txt, NAME.1.txt ... of the sessions.
class OutputFile {
 public:
  enum class Kind { dump, table };
  OutputFile(std::filesystem::path folder, std::string name, Kind kind, std::size_t columns)
      : folder_(std::move(folder)), name_(std::move(name)), kind_(kind), columns_(columns) {}

  /// The next snapshot or line, once it is complete; each step is given once. Throws RunError if
  /// the file is damaged. The result is valid until the next call.
  const Rows* next(const std::vector<Session>& sessions);

 private:
  bool read();
  bool read_snapshot();
  bool read_table_line();
  void read_row(std::string_view line);
  [[noreturn]] void damaged(std::string_view line) const;

  std::filesystem::path folder_;
  std::string name_;
  Kind kind_;
  std::size_t columns_, session_ = 0;
  int number_ = 0;  // of the session
  std::unique_ptr<GrowingFile> file_;
  Rows rows_;
  std::int64_t given_ = -1;
};

}  // namespace mahlwerk::lammps
