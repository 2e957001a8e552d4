// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/output_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::lammps {
namespace fs = std::filesystem;

std::vector<Session> sessions(const fs::path& folder) {
  std::vector<Session> found;
  for (int number = 0;; ++number) {
    std::ifstream file(folder / fmt::format("from.{}.txt", number));
    std::int64_t first = 0;
    if (!(file >> first)) break;
    if (!found.empty()) found.back().last = first;
    found.push_back({.number = number, .first = first});
  }
  return found;
}

GrowingFile::GrowingFile(const fs::path& file) : path_(file) {}

bool GrowingFile::read_more() {
  if (!file_) file_.reset(std::fopen(path_.c_str(), "rb"));
  if (!file_) return false;
  const std::size_t used = std::min(at_, mark_);
  text_.erase(0, used);
  at_ -= used;
  mark_ -= used;
  constexpr std::size_t block = 1 << 20;
  const std::size_t before = text_.size();
  text_.resize(before + block);
  std::clearerr(file_.get());  // the file may have grown since its end was met
  const std::size_t got = std::fread(text_.data() + before, 1, block, file_.get());
  text_.resize(before + got);
  return got > 0;
}

std::optional<std::string_view> GrowingFile::line() {
  std::size_t end = text_.find('\n', at_);
  while (end == std::string::npos) {
    if (!read_more()) return std::nullopt;
    end = text_.find('\n', at_);
  }
  const std::string_view found(text_.data() + at_, end - at_);
  at_ = end + 1;
  return found;
}

bool GrowingFile::has_lines(std::size_t count) {
  std::size_t at = at_;
  while (count > 0) {
    const std::size_t end = text_.find('\n', at);
    if (end != std::string::npos) {
      at = end + 1;
      --count;
      continue;
    }
    const std::size_t done = at - at_;
    if (!read_more()) return false;
    at = at_ + done;
  }
  return true;
}

void OutputFile::damaged(std::string_view line) const {
  throw RunError(
      fmt::format("{}.{}.txt holds a line that is not LAMMPS's: \"{}\". Begin again with --force",
                  (folder_ / name_).string(), number_, line.substr(0, 60)));
}

void OutputFile::read_row(std::string_view line) {
  const char *at = line.data(), *const end = at + line.size();
  std::size_t count = 0;
  for (;;) {
    while (at < end && *at == ' ') ++at;
    if (at == end) break;
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) damaged(line);
    rows_.values.push_back(value);
    at = rest;
    ++count;
  }
  if (count != columns_) damaged(line);
}

bool OutputFile::read_table_line() {
  const auto line = file_->line();
  if (!line) return false;
  if (line->empty() || line->front() == '#') return read_table_line();
  rows_ = {.step = 0, .columns = columns_, .values = std::move(rows_.values)};
  rows_.values.clear();
  read_row(*line);
  constexpr double most_steps = 9e15;  // whole numbers of a double
  if (!(std::abs(rows_.values.front()) <= most_steps)) damaged(*line);
  rows_.step = static_cast<std::int64_t>(rows_.values.front());
  return true;
}

/// "ITEM: TIMESTEP", the step, "ITEM: NUMBER OF ...", the number of rows, bounds of the box (four
/// lines), "ITEM: ..." and the rows.
bool OutputFile::read_snapshot() {
  constexpr std::size_t head = 9;
  if (!file_->has_lines(head)) return false;
  file_->mark();
  std::array<std::int64_t, 2> numbers{};
  for (std::size_t i = 0; i < head; ++i) {
    const std::string_view line = *file_->line();
    if (i == 0 && line != "ITEM: TIMESTEP") damaged(line);
    if (i != 1 && i != 3) continue;
    const auto [rest, error] =
        std::from_chars(line.data(), line.data() + line.size(), numbers[i / 2]);
    if (error != std::errc{} || numbers[i / 2] < 0) damaged(line);
  }
  const auto count = static_cast<std::size_t>(numbers[1]);
  if (!file_->has_lines(count)) {
    file_->back();
    return false;
  }
  rows_ = {.step = numbers[0], .columns = columns_, .values = std::move(rows_.values)};
  rows_.values.clear();
  for (std::size_t i = 0; i < count; ++i) read_row(*file_->line());
  file_->mark();
  return true;
}

bool OutputFile::read() {
  return kind_ == Kind::dump ? read_snapshot() : read_table_line();
}

const Rows* OutputFile::next(const std::vector<Session>& sessions) {
  while (session_ < sessions.size()) {
    const Session& session = sessions[session_];
    number_ = session.number;
    if (!file_)
      file_ =
          std::make_unique<GrowingFile>(folder_ / fmt::format("{}.{}.txt", name_, session.number));
    if (!read() || rows_.step > session.last) {  // the end of this session's file
      if (session_ + 1 == sessions.size()) return nullptr;
      ++session_;
      file_.reset();
    } else if (rows_.step > given_) {  // not written again at a restart
      given_ = rows_.step;
      return &rows_;
    }
  }
  return nullptr;
}

}  // namespace mahlwerk::lammps
