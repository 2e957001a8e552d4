// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::cases {

/// Lines of a case file, with the origin of each value behind it.
class Writer {
 public:
  explicit Writer(const Case& c) : c_(c) {}

  /// Keys below it have their origins under `prefix`: "mill.".
  void section(std::string_view heading, std::string prefix);
  void line(std::string_view key, std::string_view value);
  void word(std::string_view key, std::string_view value);
  void name(std::string_view key, std::string_view value);  ///< nothing if it is empty
  void number(std::string_view key, double value, std::string_view unit);
  template <class Model, class Fields>
  void fields(const Model& model, const Fields& all) {
    for (const auto& f : all) number(f.key, model.*f.value, f.unit);
  }
  void plain(std::string_view text) { text_ += text; }
  std::string text() { return std::move(text_); }

 private:
  const Case& c_;
  std::string text_, prefix_;
};

/// The sizes of the powder, within its section.
void write_feed(Writer& out, const Powder& powder);
/// [sweep], [optimise] and [match], those that there are.
void write_sweep(Writer& out, const Case& c);
/// The sections of grinding and [kinetics], those that there are.
void write_grinding(Writer& out, const Case& c);

}  // namespace mahlwerk::cases
