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

// A database in one file (SQLite).
namespace mahlwerk::campaign {

/// A prepared SQL statement that can be run many times. Not thread-safe. Every failure throws
/// InputError with the cause and a remedy.
class Statement {
 public:
  Statement(sqlite3* database, const std::filesystem::path& file, std::string_view sql);

  /// Binds a value to the question mark number `place`, counted from 1. NaN is bound as NULL.
  Statement& bind(int place, double value);
  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, std::string_view text);
  Statement& bind_null(int place);

  bool step();  ///< advances to the next row; false after the last, then it can run again
  void run();   ///< runs a statement that returns no rows

  int columns() const;
  std::string name(int column) const;
  bool is_null(int column) const;
  bool is_text(int column) const;
  double number(int column) const;  ///< NaN for NULL
  std::int64_t integer(int column) const;
  std::string text(int column) const;  ///< empty for NULL

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
  /// Opens `file`; Access::write creates it if necessary. Throws InputError if the file cannot be
  /// opened, is not a database, or does not exist for Access::read.
  Database(const std::filesystem::path& file, Access access);

  void run(const std::string& sql);  ///< runs statements that return no rows
  Statement prepare(std::string_view sql) const;
  std::string query_text(const std::string& sql) const;  ///< first value; empty if none
  const std::filesystem::path& file() const { return file_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
  std::filesystem::path file_;
};

/// A transaction. commit() keeps all changes since construction; without it the destructor rolls
/// them back.
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

/// `name` as a quoted SQL identifier.
std::string quoted_name(std::string_view name);

}  // namespace mahlwerk::campaign
