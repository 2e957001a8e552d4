// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/file/register.hpp"

namespace mahlwerk::cases {

/// A number a section may or must give; a Field without the place where it lives.
struct NumberSpec {
  std::string_view key, unit;
  Range range;
  std::string_view about;
  std::optional<double> standard = std::nullopt;
  std::string_view source = "";
  std::string_view instead = "";  ///< another key that would do as well

  constexpr NumberSpec(std::string_view k, std::string_view u, Range r, std::string_view a,
                       std::optional<double> s = std::nullopt, std::string_view from = "")
      : key(k), unit(u), range(r), about(a), standard(s), source(from) {}
  template <class Model>
  constexpr explicit NumberSpec(const Field<Model>& f)
      : key(f.key),
        unit(f.unit),
        range(f.range),
        about(f.about),
        standard(f.standard),
        source(f.source) {}

  NumberSpec with_default(double value, std::string_view from) const {
    NumberSpec made = *this;
    made.standard = value;
    made.source = from;
    return made;
  }
};

/// A word a section may give, one of a few.
struct Choice {
  std::string_view key;
  std::vector<std::string> words;
  std::string standard;  ///< empty: the user must say it
  std::string_view source = "";
};

/// A whole number a section may or must give.
struct IntegerSpec {
  std::string_view key;
  std::int64_t least, most;
  std::string_view about;
  std::optional<std::int64_t> standard = std::nullopt;  ///< none: the user must say it
  std::string_view source = "";
};

/// True or false.
struct Flag {
  std::string_view key;
  bool standard;
  std::string_view source;
};

/// A value with a form of its own, a list for instance.
struct CustomKey {
  std::string_view key, about;
  bool sound = true;  ///< whether the value makes sense
};

class SectionReader;

/// Visits the keys of a section, which a function `describe` of the section names one by one, each
/// with its value. SectionReader reads them, Writer writes them, ValueCheck looks for values out of
/// range, KeyList lists the keys.
class KeyVisitor {
 public:
  virtual ~KeyVisitor() = default;

  virtual void number(const NumberSpec& spec, double& value) = 0;
  virtual void optional_number(const NumberSpec& spec, std::optional<double>& value) = 0;
  virtual void integer(const IntegerSpec& spec, std::int64_t& value) = 0;
  virtual void flag(const Flag& flag, bool& value) = 0;
  virtual void text(std::string_view key, std::string& value) = 0;  ///< empty: left out
  /// `word_index` is that of the word; false after a fault, the first then.
  virtual bool choose(const Choice& choice, std::size_t& word_index) = 0;
  /// `text` is how it is written. Its own function reads it.
  virtual void custom(const CustomKey& key, const std::function<std::string()>& text) = 0;
  /// A number that may be given in place of others, where they are read.
  virtual void alternative(const NumberSpec&) {}

  /// The section, where it is read: some values are found in more ways than they are written. Null
  /// for other visitors.
  virtual SectionReader* reader() { return nullptr; }
  /// Whether the section is read and says something under `key`.
  virtual bool gives(std::string_view) { return false; }
  /// Whether keys are asked for, too, that say nothing under the values there are.
  virtual bool visits_all() { return false; }
  /// What else the section may say depends on a value that had a fault: no key is called unknown.
  virtual void ignore_unknown_keys() {}
  /// Keys that have no meaning `why`: a fault where they are read.
  virtual void refuse(std::initializer_list<std::string_view>, std::string_view /*why*/,
                      const std::string& /*remedy*/) {}

  template <class Model, class Fields>
  void fields(Model& model, const Fields& all) {
    for (const auto& f : all) number(NumberSpec(f), model.*f.value);
  }
  /// A word by its place in an enum; false after a fault.
  template <class Enum>
  bool word(const Choice& choice, Enum& value) {
    auto word_index = static_cast<std::size_t>(value);
    const bool sound = choose(choice, word_index);
    value = static_cast<Enum>(word_index);
    return sound;
  }
  /// The same of a value that is the word itself.
  void word_text(const Choice& choice, std::string& value) {
    auto word_index =
        static_cast<std::size_t>(std::ranges::find(choice.words, value) - choice.words.begin());
    choose(choice, word_index);
    if (word_index < choice.words.size()) value = choice.words[word_index];
  }
  /// One of a register, by its name, with its default numbers where it is read; false after a
  /// fault, `any` is then as it was.
  template <class... Models>
  bool model(std::string_view key, std::variant<Models...>& any, std::string standard = "",
             std::string_view source = "") {
    const auto names = model_names(std::type_identity<std::variant<Models...>>{});
    std::size_t word_index = any.index();
    if (!choose({key, names, std::move(standard), source}, word_index)) return false;
    if (reader() != nullptr || word_index != any.index()) choose_model(any, names[word_index]);
    return true;
  }
};

/// Visits all sections of a case.
class CaseVisitor : public KeyVisitor {
 public:
  /// The keys that follow are those of "mill", of the second of "balls", or of none: "".
  virtual void section(std::string_view name, std::size_t number = 0) = 0;
};

}  // namespace mahlwerk::cases
