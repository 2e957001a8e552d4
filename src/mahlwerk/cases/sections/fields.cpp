// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "mahlwerk/cases/file/register.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::cases {

namespace {

void add_once(std::vector<std::string_view>& keys, std::string_view key) {
  if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
}

}  // namespace

const std::vector<std::string_view>& law_keys() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> found;
    for (const contact::AnyLaw& law : contact::all_laws())
      std::visit(
          [&]<class L>(const L&) {
            for (const auto& s : contact::switches_of<L>()) add_once(found, s.key);
            for (const auto& f : L::fields()) add_once(found, f.key);
          },
          law);
    return found;
  }();
  return keys;
}

bool has_meaning(std::string_view key, const contact::ContactModel& model) {
  if (key == "rolling_friction") return contact::rule_of(model.rolling).resists;
  if (key == rolling_damping.key) return contact::rule_of(model.rolling).damped;
  return std::ranges::any_of(contact::adhesion(*model.law),
                             [&](const auto& parameter) { return parameter.key == key; });
}

std::string_view unit_of(std::string_view key, std::string_view unit,
                         const contact::ContactModel& model) {
  return key == "rolling_friction" ? contact::rule_of(model.rolling).friction_unit : unit;
}

const std::vector<std::string>& contact_laws() {
  static const std::vector<std::string> names =
      model_names(std::type_identity<contact::AnyLaw::Models>{});
  return names;
}

const std::vector<std::string>& rolling_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    for (const contact::RollingRule& r : contact::rolling_rules) names.emplace_back(r.name);
    return names;
  }();
  return words;
}

const std::vector<std::string>& until_quantities() {
  static const std::vector<std::string> words{"dissipated_power", "drawn_power", "collision_rate",
                                              "collision_rate_above_threshold",
                                              "energy_normal_mean"};
  return words;
}

const std::vector<std::string>& engines() {
  static const std::vector<std::string> words{"event", "soft", "auto", "lammps"};
  return words;
}

std::string_view name_of(EngineName engine) {
  return to_word(engine, engines());
}

const std::vector<std::string>& restitution_laws() {
  static const std::vector<std::string> words{"constant", "viscoelastic", "tabulated"};
  return words;
}

// Control characters are escaped, so that a text stays on one line.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

}  // namespace mahlwerk::cases
