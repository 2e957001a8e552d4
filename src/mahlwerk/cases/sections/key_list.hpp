// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

using ChosenWords = std::map<std::string, std::size_t>;  ///< key -> index of its word

/// Whether the choices of the section `from` may decide which keys the section `of` has.
inline bool decides(std::string_view from, std::string_view of) {
  return from == of || (of.starts_with(from) && of.substr(from.size()).starts_with('.'));
}

/// Lists the keys of one section, under the chosen words.
class KeyList : public CaseVisitor {
 public:
  KeyList(std::string_view of, ChosenWords chosen) : of_(of), chosen_(std::move(chosen)) {}

  void section(std::string_view name, std::size_t) override { now_ = name; }
  void number(const NumberSpec& spec, double&) override {
    add_number(spec, !spec.standard && spec.default_text.empty());
  }
  void optional_number(const NumberSpec& spec, std::optional<double>&) override {
    add_number(spec, false);
  }
  void alternative(const NumberSpec& spec) override { add_number(spec, false); }
  void integer(const IntegerSpec& spec, std::int64_t&) override {
    KeyInfo info = of_type("integer", spec.key, spec.about, spec.presentation);
    info.range = {.least = static_cast<double>(spec.least), .most = static_cast<double>(spec.most)};
    if (spec.standard) info.default_value = std::to_string(*spec.standard);
    info.default_source = spec.default_text.empty() ? spec.source : spec.default_text;
    info.required = !spec.standard && spec.default_text.empty();
    add(std::move(info));
  }
  void flag(const Flag& flag, bool&) override {
    KeyInfo info = of_type("flag", flag.key, flag.about, {}, flag.engines);
    info.words = {"true", "false"};
    info.default_value = flag.standard ? "true" : "false";
    info.default_source = flag.source;
    add(std::move(info));
  }
  void text(const TextSpec& spec, std::string&) override {
    KeyInfo info = of_type("text", spec.key, spec.about);
    info.required = spec.required;
    add(std::move(info), spec.instead);
  }
  void custom(const CustomKey& spec, const std::function<std::string()>&) override {
    KeyInfo info = of_type(spec.type, spec.key, spec.about, spec.presentation);
    info.required = spec.required;
    info.default_source = spec.default_text;
    add(std::move(info), spec.instead);
  }
  bool choose(const Choice& choice, std::size_t& word_index) override {
    if (!decides(now_, of_)) return true;
    KeyInfo info = of_type("word", choice.key, choice.about, choice.presentation, choice.engines);
    const std::string key = info.key;
    const auto own = chosen_.find(key);
    if (own != chosen_.end()) word_index = own->second;
    choices_[key] = {word_index, choice.words};
    info.words = choice.words;
    info.meanings = {choice.meanings.begin(), choice.meanings.end()};
    if (choice.source != of_contact) info.default_value = choice.standard;
    info.default_source = choice.source;
    info.required = choice.standard.empty() && choice.source.empty();
    add(std::move(info));
    return true;
  }
  bool visits_all() override { return true; }
  bool tries_all_words() override { return true; }

  struct Chosen {
    std::size_t word_index = 0;
    std::vector<std::string> words;
  };
  const std::vector<KeyInfo>& keys() const { return keys_; }
  const std::map<std::string, Chosen>& choices() const { return choices_; }

 private:
  KeyInfo of_type(std::string_view type, std::string_view key, std::string_view about,
                  const Presentation& presentation = {}, Engines read_by = {}) const {
    KeyInfo info;
    info.key = dotted(key);
    info.type = type;
    info.about = about;
    info.label = presentation.label.empty() ? key : presentation.label;
    if (presentation.label.empty()) std::ranges::replace(info.label, '_', ' ');
    info.symbol = presentation.symbol;
    info.start = presentation.start;
    info.usual = presentation.usual;
    const std::array reads{read_by.event, read_by.soft, read_by.lammps};
    const std::array names{EngineName::event, EngineName::soft, EngineName::lammps};
    for (std::size_t i = 0; i < reads.size(); ++i)
      if (reads[i]) info.engines.emplace_back(name_of(names[i]));
    return info;
  }
  std::string dotted(std::string_view key) const {
    return now_.empty() ? std::string(key) : now_ + "." + std::string(key);
  }
  void add_number(const NumberSpec& spec, bool required) {
    KeyInfo info = of_type("number", spec.key, spec.about, spec.presentation, spec.engines);
    info.unit = spec.unit;
    info.range = spec.range;
    info.plausible = plausible_magnitude(spec.unit, spec.plausible);
    info.required = required;
    if (!required)
      info.default_source = spec.default_text.empty() ? spec.source : spec.default_text;
    if (spec.standard && spec.default_text.empty() && spec.source != of_contact)
      info.default_value = show(*spec.standard, spec.unit);
    add(std::move(info), spec.instead);
  }
  void add(KeyInfo info, std::string_view instead = {}) {
    if (now_ != of_ || std::ranges::find(keys_, info.key, &KeyInfo::key) != keys_.end()) return;
    if (!instead.empty()) info.instead_of = dotted(instead);
    keys_.push_back(std::move(info));
  }

  std::string_view of_;
  ChosenWords chosen_;
  std::string now_;
  std::vector<KeyInfo> keys_;
  std::map<std::string, Chosen> choices_;
};

}  // namespace mahlwerk::cases
