// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/key_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/unit_table.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/reporting/terminal.hpp"

namespace mahlwerk::commands {
namespace {

using cases::KeyInfo;
using cases::KeySection;
using results::Json;

constexpr std::size_t longest_line = 110;
constexpr std::size_t below_key = 6;     ///< indent of a meaning below its key
constexpr std::size_t engine_count = 3;  ///< event, soft, lammps

/// "mill"; "top" for the keys outside sections.
std::string_view section_word(const KeySection& section) {
  return section.section.empty() ? "top" : std::string_view(section.section);
}

std::string heading(const KeySection& section) {
  const std::string name = section.section.empty() ? "(top of the file)"
                           : section.several       ? fmt::format("[[{}]]", section.section)
                                                   : fmt::format("[{}]", section.section);
  if (section.kind.empty()) return name;
  return fmt::format("{} {} = \"{}\"", name, section.choice.substr(section.choice.rfind('.') + 1),
                     section.kind);
}

/// As wide as the terminal, but not wider than reads well.
std::size_t page_width() {
  return std::min(longest_line, terminal_width(Stream::output));
}

std::string wrapped(const std::string& text, std::size_t indent) {
  return wrapped_text(text, std::string(indent, ' '), page_width());
}

std::string default_column(const KeyInfo& key) {
  if (key.required) return "required";
  return key.default_value.empty() ? "-" : key.default_value;
}

/// "only with distribution = normal or lognormal".
std::string condition(const KeyInfo& key) {
  std::string all;
  const std::string own = key.key.substr(0, key.key.rfind('.') + 1);
  for (const auto& [choice, words] : key.under)
    all += fmt::format("{}{} = {}", all.empty() ? "only with " : " and ",
                       choice.starts_with(own) ? choice.substr(own.size()) : choice,
                       fmt::join(words, " or "));
  return all;
}

std::string words_of(const KeyInfo& key, std::size_t indent) {
  std::string lines;
  const std::string margin(indent, ' ');
  if (key.type != "word") return lines;
  if (key.meanings.empty())
    return margin + wrapped(fmt::format("{}", fmt::join(key.words, ", ")), indent) + '\n';
  std::size_t width = 0;
  for (const std::string& word : key.words) width = std::max(width, word.size());
  for (std::size_t i = 0; i < key.words.size(); ++i)
    lines += margin + fmt::format("{:<{}}  {}\n", key.words[i], width,
                                  wrapped(key.meanings[i], indent + width + 2));
  return lines;
}

Json end_of(double end) {
  return std::isfinite(end) ? Json(end) : Json();
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json usual_json(const UsualRange& usual) {
  if (usual.most.empty()) return {};
  return Json::object(
      {{"least", std::string(usual.least)}, {"most", std::string(usual.most)}, {"log", usual.log}});
}

Json plausible_json(const KeyInfo& key) {
  const auto& [least, most] = key.plausible;
  if (least == 0 && !std::isfinite(most)) return {};
  return Json::object({{"least", least}, {"most", end_of(most)}});
}

/// "plausible from 0.1 MPa to 2 TPa"; an end beyond the range is left out.
std::string plausible_text(const KeyInfo& key) {
  const auto& [least, most] = key.plausible;
  const bool low = least > 0 && key.range.least < least, high = most < key.range.most;
  std::string text;
  if (low) text += " from " + show_rounded(least, key.unit);
  if (high) text += " to " + show_rounded(most, key.unit);
  return text.empty() ? text : "plausible" + text;
}

Json as_json(const KeyInfo& key, const KeySection& section) {
  const bool number = key.type == "number" || key.type == "integer";
  Json made = Json::object({{"key", std::string(key.name())},
                            {"type", key.type},
                            {"unit", number ? Json(key.unit) : Json()},
                            {"example", key.type == "number" ? Json(example_of(key.unit)) : Json()},
                            {"least", number ? end_of(key.range.least) : Json()},
                            {"most", number ? end_of(key.range.most) : Json()},
                            {"least_excluded", key.range.without_least},
                            {"most_excluded", key.range.without_most},
                            {"default", text_or_null(key.default_value)},
                            {"default_source", text_or_null(key.default_source)},
                            {"words", key.words},
                            {"meanings", key.meanings},
                            {"required", key.required},
                            {"instead_of", text_or_null(key.instead_of)},
                            {"label", key.label},
                            {"symbol", text_or_null(key.symbol)},
                            {"start", text_or_null(key.start)},
                            {"usual", usual_json(key.usual)},
                            {"plausible", plausible_json(key)},
                            {"engines", key.engines}});
  Json others = Json::array(), under = Json::object();
  for (const KeyInfo& other : section.keys)
    if (other.instead_of == key.key) others.push_back(std::string(other.name()));
  for (const auto& [choice, words] : key.under) under[choice] = words;
  made["alternatives"] = others;
  made["under"] = under;
  made["about"] = key.about;
  return made;
}

}  // namespace

std::string wrapped_text(const std::string& text, const std::string& margin, std::size_t width) {
  std::string out;
  const std::size_t indent = margin.size();
  std::size_t column = indent, start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    if (column > indent && column + 1 + word.size() > width) {
      out += '\n' + margin;
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    start = end + 1;
  }
  return out;
}

std::string key_range(const KeyInfo& key) {
  const KeyInfo& k = key;
  const bool low = std::isfinite(k.range.least), high = std::isfinite(k.range.most);
  const auto value = [&](double end) {
    constexpr double long_number = 1e6;
    std::string text = end == 0                       ? "0"
                       : k.type == "integer"          ? fmt::format("{:.0f}", end)
                       : std::abs(end) >= long_number ? fmt::format("{:g} {}", end, k.unit)
                                                      : show_rounded(end, k.unit);
    if (const auto exponent = text.find("e+0"); exponent != std::string::npos)
      text.erase(exponent + 1, 2);  // "1e8 s"
    return text;
  };
  if (k.type != "number" && k.type != "integer") return k.type;
  if (!low && !high) return k.range.without_zero ? "not 0" : "any";
  if (!high) return fmt::format("{} {}", k.range.without_least ? ">" : ">=", value(k.range.least));
  if (!low) return fmt::format("{} {}", k.range.without_most ? "<" : "<=", value(k.range.most));
  return fmt::format("{}{} to {}{}", k.range.without_least ? "> " : "", value(k.range.least),
                     k.range.without_most ? "< " : "", value(k.range.most));
}

std::string key_meaning(const KeyInfo& key, bool brief) {
  std::string text = key.about;
  const auto add = [&](const std::string& more) {
    if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
  };
  if (!key.instead_of.empty())
    add("in place of " + key.instead_of.substr(key.instead_of.rfind('.') + 1));
  if (brief) return text;
  add(plausible_text(key));
  add(condition(key));
  if (!key.default_source.empty()) add("default: " + key.default_source);
  if (key.engines.size() < engine_count)
    add(fmt::format("read by {}", fmt::join(key.engines, ", ")));
  return text;
}

std::vector<std::string> kinds_of(std::string_view section) {
  std::vector<std::string> kinds;
  for (const KeySection& s : cases::key_sections())
    if (s.section == section && !s.kind.empty()) kinds.push_back(s.kind);
  return kinds;
}

KeySections all_sections() {
  KeySections all;
  for (const KeySection& section : cases::key_sections()) all.push_back(&section);
  return all;
}

KeySections sections_named(std::string_view word) {
  KeySections found;
  for (const KeySection& s : cases::key_sections()) {
    const bool section = s.kind.empty() && word == section_word(s);
    const bool kind =
        !s.kind.empty() && (s.kind == word || fmt::format("{}.{}", s.section, s.kind) == word);
    const bool key = std::ranges::find(s.keys, word, &KeyInfo::key) != s.keys.end();
    if (section || kind || key) found.push_back(&s);
  }
  return found;
}

std::vector<std::string> section_words() {
  std::vector<std::string> words;
  for (const KeySection& s : cases::key_sections()) {
    const std::string word(s.kind.empty() ? section_word(s) : s.kind);
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  return words;
}

std::string key_tables(const KeySection& section, std::string_view only) {
  std::vector<const KeyInfo*> keys;
  for (const KeyInfo& key : section.keys)
    if (only.empty() || key.key == only) keys.push_back(&key);
  std::string page = fmt::format("{}  {}\n", heading(section), section.about);
  std::array<std::size_t, 4> widths{3, 4, 5, 7};
  const auto cells = [](const KeyInfo& key) {
    return std::array{std::string(key.name()), key.unit.empty() ? std::string("-") : key.unit,
                      key_range(key), default_column(key)};
  };
  for (const KeyInfo* key : keys) {
    const auto row = cells(*key);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  const auto line = [&](const std::array<std::string, 4>& row) {
    std::string text = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) text += fmt::format("{:<{}}  ", row[i], widths[i]);
    return text;
  };
  if (keys.empty()) return page + "  no keys of its own\n";
  page += '\n' + line({"key", "unit", "range", "default"}) + "meaning\n";
  for (const KeyInfo* key : keys) {
    const std::string row = line(cells(*key));
    const bool below = row.size() > page_width() / 2 + 1;  // no room for the meaning beside the key
    const std::size_t indent = below ? below_key : row.size();
    page += row + (below ? '\n' + std::string(indent, ' ') : "") +
            wrapped(key_meaning(*key), indent) + '\n' + words_of(*key, indent);
  }
  return page;
}

Json keys_as_json(const KeySections& sections) {
  Json all = Json::array();
  for (const KeySection* s : sections) {
    Json keys = Json::array();
    for (const KeyInfo& key : s->keys) keys.push_back(as_json(key, *s));
    all.push_back(Json::object({{"section", s->section},
                                {"kind", text_or_null(s->kind)},
                                {"choice", text_or_null(s->choice)},
                                {"about", s->about},
                                {"keys", std::move(keys)}}));
  }
  return all;
}

std::string key_index() {
  std::string page;
  for (const KeySection& s : cases::key_sections()) {
    std::string names;
    for (const KeyInfo& key : s.keys) names += (names.empty() ? "" : " ") + std::string(key.name());
    page += fmt::format("{}{}  {}\n", s.kind.empty() ? "" : "  ", heading(s), s.about);
    const std::size_t indent = s.kind.empty() ? 2 : 4;
    if (!names.empty()) page += std::string(indent, ' ') + wrapped(names, indent) + '\n';
  }
  return page;
}

std::string unit_table() {
  const auto units = listed_units();
  std::vector<std::string_view> dimensions;  // by their SI units
  for (const ListedUnit& u : units)
    if (std::ranges::find(dimensions, u.si) == dimensions.end()) dimensions.push_back(u.si);
  std::string page;
  for (const std::string_view si : dimensions) {
    page += fmt::format("{:<8}", si.empty() ? "number" : si);
    for (const ListedUnit& u : units)
      if (u.si == si && !u.symbol.empty()) page += fmt::format(" {}", u.symbol);
    page += '\n';
  }
  return page +
         "\nUnits multiply and divide: kg/m3, J/(kg K), kWh/t. \"200 mesh\" is the opening of that "
         "test sieve of ASTM E11.\n";
}

Json units_as_json() {
  Json all = Json::array();
  for (const ListedUnit& u : listed_units())
    all.push_back(Json::object({{"unit", std::string(u.symbol)},
                                {"si", std::string(u.si)},
                                {"factor", u.factor},
                                {"offset", u.offset},
                                {"offered", u.offered}}));
  return all;
}

}  // namespace mahlwerk::commands
