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
#include <utility>
#include <variant>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/file/register.hpp"

namespace mahlwerk::cases {

/// The engines that may read a value. A value that the engine of a run does not read is no
/// assumption of its results.
struct Engines {
  bool event = true, soft = true, lammps = true;
};
constexpr Engines event_only{.soft = false, .lammps = false};
constexpr Engines soft_only{.event = false, .lammps = false};
constexpr Engines soft_and_lammps{.event = false};

/// A number that a section may or must give: a Field without its pointer to member.
struct NumberSpec {
  std::string_view key, unit;
  Range range;
  std::string_view about;
  std::optional<double> standard = std::nullopt;
  std::string_view source = "";
  std::string_view instead = "";       ///< the other key of two that exclude each other
  std::string_view default_text = "";  ///< default in words, where it follows from other values
  /// Range in which the true value may lie if the default is assumed; its source is that of the
  /// default.
  std::optional<Range> assumed_range = std::nullopt;
  PlausibleMagnitude plausible = {};
  Presentation presentation = {};
  Engines engines = {};

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
        source(f.source),
        plausible(f.plausible),
        presentation(f.presentation) {}

  constexpr NumberSpec with(const Presentation& p) const {
    NumberSpec made = *this;
    made.presentation = p;
    return made;
  }
  constexpr NumberSpec plausible_within(std::string_view least, std::string_view most) const {
    NumberSpec made = *this;
    made.plausible = {least, most};
    return made;
  }
  constexpr NumberSpec read_by(Engines those) const {
    NumberSpec made = *this;
    made.engines = those;
    return made;
  }

  NumberSpec with_default(double value, std::string_view from) const {
    NumberSpec made = *this;
    made.standard = value;
    made.source = from;
    made.assumed_range.reset();
    return made;
  }
  constexpr NumberSpec with_assumed_range(Range ends) const {
    NumberSpec made = *this;
    made.assumed_range = ends;
    return made;
  }
  constexpr NumberSpec with_default_text(std::string_view words) const {
    NumberSpec made = *this;
    made.default_text = words;
    return made;
  }
  constexpr NumberSpec in_place_of(std::string_view other) const {
    NumberSpec made = *this;
    made.instead = other;
    return made;
  }
};

/// A key that takes one of several words.
struct Choice {
  std::string_view key;
  std::vector<std::string> words;
  std::string standard;  ///< default; empty: the user must give the key
  std::string_view source = "";
  std::string_view about = "";
  std::vector<std::string_view> meanings = {};  ///< of the words, in their order
  Presentation presentation = {};
  Engines engines = {};

  Choice read_by(Engines those) && {
    engines = those;
    return std::move(*this);
  }
};

/// An integer that a section may or must give.
struct IntegerSpec {
  std::string_view key;
  std::int64_t least, most;
  std::string_view about;
  std::optional<std::int64_t> standard = std::nullopt;  ///< default; none: the key is required
  std::string_view source = "";
  std::string_view default_text = "";  ///< default in words, where it follows from other values
  Presentation presentation = {};
};

/// A key that takes true or false.
struct Flag {
  std::string_view key;
  bool standard;
  std::string_view source;
  std::string_view about = "";
  Engines engines = {};
};

/// A key that takes a text: a name or a file.
struct TextSpec {
  std::string_view key, about;
  bool required = false;
  std::string_view instead = "";   ///< the other key of two that exclude each other
  std::string_view category = "";  ///< of the catalogue, whose entries the text may name
};

/// A value with a format of its own, for instance a list.
struct CustomKey {
  std::string_view key, about;
  bool sound = true;  ///< whether the value is valid
  std::string_view type = "list";
  bool required = false;
  std::string_view default_text = "";
  std::string_view instead = "";  ///< the other key of two that exclude each other
  Presentation presentation = {};
};

class SectionReader;

/// Visitor of the keys of a section. The section's function `describe` calls it for each key, with
/// a reference to the value. SectionReader reads the values, Writer writes them, ValueCheck finds
/// values out of range, KeyList lists the keys.
class KeyVisitor {
 public:
  virtual ~KeyVisitor() = default;

  virtual void number(const NumberSpec& spec, double& value) = 0;
  virtual void optional_number(const NumberSpec& spec, std::optional<double>& value) = 0;
  virtual void integer(const IntegerSpec& spec, std::int64_t& value) = 0;
  virtual void flag(const Flag& flag, bool& value) = 0;
  virtual void text(const TextSpec& spec, std::string& value) = 0;  ///< an empty text is omitted
  /// `word_index` is the index of the word; false and index 0 after a fault.
  virtual bool choose(const Choice& choice, std::size_t& word_index) = 0;
  /// `text` returns the value as written in a case. The section's own function reads the value.
  virtual void custom(const CustomKey& key, const std::function<std::string()>& text) = 0;
  /// A number that a case file may give instead of another key; it is never written.
  virtual void alternative(const NumberSpec&) {}

  /// The SectionReader if the visitor is one, else null. Some values have more forms when read than
  /// when written.
  virtual SectionReader* reader() { return nullptr; }
  /// Whether the visitor reads a section that gives `key`.
  virtual bool gives(std::string_view) { return false; }
  /// Whether the visitor wants all keys, including keys without meaning under the present values.
  virtual bool visits_all() { return false; }
  /// Whether the visitor chooses every word of every choice, one after the other. It then wants
  /// those keys only that have a meaning under the present words.
  virtual bool tries_all_words() { return false; }
  /// Suppresses faults for unknown keys, after a fault of a value that determines the known keys.
  virtual void ignore_unknown_keys() {}
  /// Keys that have no meaning, for the reason `why`: a fault for each that the section gives.
  virtual void refuse(std::initializer_list<std::string_view>, std::string_view /*why*/,
                      const std::string& /*remedy*/) {}
  /// A flag that has no meaning: its default may stand in a case, another value is a fault.
  void refuse_but_default(const Flag& one, std::string_view why, const std::string& remedy) {
    if (!gives(one.key)) return;
    bool value = one.standard;
    flag(one, value);
    if (value != one.standard) refuse({one.key}, why, remedy);
  }

  template <class Model, class Fields>
  void fields(Model& model, const Fields& all) {
    for (const auto& f : all) number(NumberSpec(f), model.*f.value);
  }
  /// A word for an enum value; false after a fault.
  template <class Enum>
  bool word(const Choice& choice, Enum& value) {
    auto word_index = static_cast<std::size_t>(value);
    const bool sound = choose(choice, word_index);
    value = static_cast<Enum>(word_index);
    return sound;
  }
  /// The same for a value that is stored as the word itself.
  void word_text(const Choice& choice, std::string& value) {
    auto word_index =
        static_cast<std::size_t>(std::ranges::find(choice.words, value) - choice.words.begin());
    choose(choice, word_index);
    if (word_index < choice.words.size()) value = choice.words[word_index];
  }
  /// A model of a register (a variant), by name; the register gives the words of the choice. A
  /// reader sets it to its default numbers. False after a fault; `any` is then unchanged.
  template <class... Models>
  bool model(Choice choice, std::variant<Models...>& any) {
    choice.words = model_names(std::type_identity<std::variant<Models...>>{});
    choice.meanings = {Models::about...};
    std::size_t word_index = any.index();
    if (!choose(choice, word_index)) return false;
    if (reader() != nullptr || word_index != any.index())
      choose_model(any, choice.words[word_index]);
    return true;
  }
};

/// Visitor of all sections of a case.
class CaseVisitor : public KeyVisitor {
 public:
  /// Begins a section: "mill", "balls" with its index from 1, or "" for keys outside sections.
  virtual void section(std::string_view name, std::size_t number = 0) = 0;
};

}  // namespace mahlwerk::cases
