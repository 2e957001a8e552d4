// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/clock_time.hpp"

#include <charconv>
#include <chrono>

namespace mahlwerk::measure {
namespace {

/// Removes a whole number of at most `digits` digits from the front.
std::optional<int> whole_number(std::string_view& text, std::size_t digits) {
  int number = 0;
  const std::string_view part = text.substr(0, digits);
  const auto read = std::from_chars(part.data(), part.data() + part.size(), number);
  if (read.ec != std::errc{} || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - part.data()));
  return number;
}

bool removed(std::string_view& text, char sign) {
  if (!text.starts_with(sign)) return false;
  text.remove_prefix(1);
  return true;
}

/// [s] A date "2026-11-29" at the front, with the blank or T after it.
std::optional<double> date(std::string_view& text) {
  namespace chrono = std::chrono;
  std::string_view rest = text;
  const auto year = whole_number(rest, 4);
  if (!year || !removed(rest, '-')) return std::nullopt;
  const auto month = whole_number(rest, 2);
  if (!month || !removed(rest, '-')) return std::nullopt;
  const auto day = whole_number(rest, 2);
  if (!day || (!removed(rest, ' ') && !removed(rest, 'T'))) return std::nullopt;
  const chrono::year_month_day made{chrono::year(*year),
                                    chrono::month(static_cast<unsigned>(*month)),
                                    chrono::day(static_cast<unsigned>(*day))};
  if (!made.ok()) return std::nullopt;
  text = rest;
  return 86400.0 * static_cast<double>(chrono::sys_days(made).time_since_epoch().count());
}

}  // namespace

std::optional<double> clock_time(std::string_view text) {
  const double days = date(text).value_or(0);
  const auto hours = whole_number(text, 2);
  if (!hours || !removed(text, ':')) return std::nullopt;
  const auto minutes = whole_number(text, 2);
  if (!minutes || *hours > 24 || *minutes > 59) return std::nullopt;
  double seconds = 0;
  if (removed(text, ':')) {
    const auto read =
        std::from_chars(text.data(), text.data() + text.size(), seconds, std::chars_format::fixed);
    if (read.ec != std::errc{} || !(seconds >= 0 && seconds < 61)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  }
  if (!text.empty() && text != "Z") return std::nullopt;
  return days + 3600.0 * *hours + 60.0 * *minutes + seconds;
}

}  // namespace mahlwerk::measure
