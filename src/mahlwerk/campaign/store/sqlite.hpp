// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

// A database in one file.
namespace mahlwerk::campaign {

/// One line of SQL, made ready to be run many times. Not for two threads at once. Every failure is
/// an InputError that says what is wrong with the file.
class Statement {
 public:
  Statement(sqlite3* database, const std::filesystem::path& file, std::string_view sql);

  /// Values for the question marks, from 1. NaN is NULL.
  Statement& bind(int place, double value);
  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, std::string_view text);
  Statement& bind_null(int place);

  bool step();  ///< to the next row; false after the last, when it is ready to be run again
  void run();   ///< what gives no rows

  int columns() const;
  std::string name(int column) const;
  bool is_null(int column) const;
  bool is_text(int column) const;
  double number(int column) const;  ///< NaN of NULL
  std::int64_t integer(int column) const;
  std::string text(int column) const;  ///< empty of NULL

 private:
  void check(int code) const;
  struct Close {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Close> statement_;
  sqlite3* database_;
  std::filesystem::path file_;
};

class Database {
 public:
  enum class Access { write, read };
  /// Throws InputError where there is no such file to be read, it is no database, or it cannot be
  /// written to.
  Database(const std::filesystem::path& file, Access access);

  void run(const std::string& sql);  ///< one or more lines that give no rows
  Statement prepare(std::string_view sql) const;
  std::string query_text(const std::string& sql) const;  ///< the first value it gives, or nothing
  const std::filesystem::path& file() const { return file_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
  std::filesystem::path file_;
};

/// Runs what is written within it as one: all of it is kept by commit(), or nothing.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

/// A name as SQL takes it, whatever stands in it.
std::string quoted_name(std::string_view name);

}  // namespace mahlwerk::campaign
