// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"

namespace mahlwerk::cases {
namespace {

/// A comment's text on one line.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace

void Writer::section(std::string_view heading, std::string prefix) {
  text_ += fmt::format("\n{}\n", heading);
  prefix_ = std::move(prefix);
}

void Writer::line(std::string_view key, std::string_view value) {
  const auto origin = std::ranges::find(c_.origins, prefix_ + std::string(key), &Origin::key);
  const std::string said = fmt::format("{} = {}", key, value);
  if (origin == c_.origins.end() || origin->source.empty()) {
    text_ += said + "\n";
    return;
  }
  text_ += fmt::format("{:<36} # {}{}\n", said, one_line(origin->source),
                       origin->unverified ? " (unverified)" : "");
}

void Writer::word(std::string_view key, std::string_view value) {
  line(key, in_quotes(value));
}

void Writer::name(std::string_view key, std::string_view value) {
  if (!value.empty()) word(key, value);
}

void Writer::number(std::string_view key, double value, std::string_view unit) {
  line(key, unit.empty() ? shortest(value) : in_quotes(show(value, unit)));
}

}  // namespace mahlwerk::cases
