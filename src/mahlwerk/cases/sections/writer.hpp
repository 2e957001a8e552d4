// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"

namespace mahlwerk::cases {

/// Writes the lines of a case file, each value followed by its origin as a comment.
class Writer : public CaseVisitor {
 public:
  explicit Writer(const Case& c) : c_(c) {}

  void section(std::string_view name, std::size_t number = 0) override;
  void number(const NumberSpec& spec, double& value) override;
  void optional_number(const NumberSpec& spec, std::optional<double>& value) override {
    if (value) number(spec, *value);
  }
  void integer(const IntegerSpec& spec, std::int64_t& value) override {
    line(spec.key, std::to_string(value));
  }
  void flag(const Flag& flag, bool& value) override { line(flag.key, value ? "true" : "false"); }
  void text(const TextSpec& spec, std::string& value) override;
  bool choose(const Choice& choice, std::size_t& word_index) override;
  void custom(const CustomKey& key, const std::function<std::string()>& text) override {
    line(key.key, text());
  }

  void plain(std::string_view key, std::string_view value);  ///< without an origin
  std::string text() { return std::move(text_); }

 private:
  void line(std::string_view key, std::string_view value);

  const Case& c_;
  std::string text_, prefix_;
};

}  // namespace mahlwerk::cases
