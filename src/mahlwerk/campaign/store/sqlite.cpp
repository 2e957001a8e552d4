// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/store/sqlite.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int patience = 10'000;  // [ms] wait for a lock that another process holds

std::string remedy_for(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "free space on the disk and start again: finished work is kept";
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return "check that you may write to the file and to its folder";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another process writes to it: wait until it ends, then start again";
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      return "the file is not a store, or it is damaged: move it away, then start again";
    case SQLITE_IOERR:
      return "check the disk and its free space, then start again: finished work is kept";
    case SQLITE_NOMEM:
      return "free memory, then start again: finished work is kept";
    default:
      return "start again: finished work is kept";
  }
}

[[noreturn]] void fail(sqlite3* database, int code, const std::filesystem::path& file) {
  const char* why = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  throw InputError(Fault{file.generic_string(),
                         fmt::format("the campaign's store cannot be used: {}", why),
                         remedy_for(code), "store"});
}

}  // namespace

void Statement::Close::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Statement::Statement(sqlite3* database, const std::filesystem::path& file, std::string_view sql)
    : database_(database), file_(file) {
  sqlite3_stmt* made = nullptr;
  const int code =
      sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &made, nullptr);
  statement_.reset(made);
  check(code);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(database_, code, file_);
}

Statement& Statement::bind(int place, double value) {
  check(std::isnan(value) ? sqlite3_bind_null(statement_.get(), place)
                          : sqlite3_bind_double(statement_.get(), place, value));
  return *this;
}

Statement& Statement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), place, value));
  return *this;
}

Statement& Statement::bind(int place, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_null(int place) {
  check(sqlite3_bind_null(statement_.get(), place));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  sqlite3_reset(statement_.get());
  if (code != SQLITE_DONE) fail(database_, code, file_);
  return false;
}

void Statement::run() {
  while (step()) continue;
}

int Statement::columns() const {
  return sqlite3_column_count(statement_.get());
}
std::string Statement::name(int column) const {
  return sqlite3_column_name(statement_.get(), column);
}
bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}
bool Statement::is_text(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT;
}
double Statement::number(int column) const {
  return is_null(column) ? std::numeric_limits<double>::quiet_NaN()
                         : sqlite3_column_double(statement_.get(), column);
}
std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}
std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int count = sqlite3_column_bytes(statement_.get(), column);
  return bytes != nullptr ? std::string(bytes, static_cast<std::size_t>(count)) : std::string();
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

Database::Database(const std::filesystem::path& file, Access access) : file_(file) {
  // Read access opens the file for writing, too: SQLite must be able to roll back the journal of a
  // killed process. SQLite opens a file that is not writable read-only.
  const int flags = SQLITE_OPEN_READWRITE | (access == Access::read ? 0 : SQLITE_OPEN_CREATE);
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &made, flags | SQLITE_OPEN_FULLMUTEX, nullptr);
  database_.reset(made);
  if (code != SQLITE_OK) fail(made, code, file_);
  sqlite3_busy_timeout(made, patience);
  if (access == Access::read) run("PRAGMA query_only=1");
  query_text("SELECT count(*) FROM sqlite_master");  // fails if the file is not a database
}

void Database::run(const std::string& sql) {
  const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(database_.get(), code, file_);
}

Statement Database::prepare(std::string_view sql) const {
  return {database_.get(), file_, sql};
}

std::string Database::query_text(const std::string& sql) const {
  Statement asked = prepare(sql);
  return asked.step() ? asked.text(0) : "";
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) try {
      database_.run("ROLLBACK");
    } catch (const InputError&) {
      // SQLite has already rolled back.
    }
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

std::string quoted_name(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace mahlwerk::campaign
