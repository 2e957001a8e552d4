// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/section_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::cases {
namespace {

/// The key and its value as written in the file, for messages; a long value is cut.
std::string as_written(std::string_view key, const Node& node) {
  constexpr std::size_t most = 80;
  std::string text = node.text.substr(0, most);
  if (node.text.size() > most) text += "...";
  const bool quoted = node.kind == Node::Kind::text;
  return quoted ? fmt::format("{} = \"{}\"", key, text) : fmt::format("{} = {}", key, text);
}

/// The word of `words` that has hyphens where `word` has underscores; empty if there is none.
std::string respelt(std::string word, const std::vector<std::string>& words) {
  if (word.find('_') == std::string::npos || std::ranges::find(words, word) != words.end())
    return {};
  std::ranges::replace(word, '_', '-');
  return std::ranges::find(words, word) != words.end() ? word : std::string();
}

}  // namespace

std::string quoted_list(const std::vector<std::string>& words) {
  std::string line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) line += i + 1 == words.size() ? " or " : ", ";
    line += "\"" + words[i] + "\"";
  }
  return line;
}

SectionReader::SectionReader(const Node* table, std::string name, Findings& findings)
    : table_(table), name_(std::move(name)), findings_(findings) {}

void SectionReader::add_defaults(const CatalogueEntry& entry) {
  const std::string place = fmt::format("catalogue {}/{}", entry.category, entry.name);
  entry_title_ = entry.title;
  for (const auto& [key, value] : entry.values) {
    Node node = value_from_text(value.text, entry.file, Precedence::catalogue);
    const bool measured = !value.assumed && !value.range[0].empty();
    node.source = fmt::format(
        "{}: {}{}", place,
        measured ? fmt::format("measured, {} to {}: ", value.range[0], value.range[1]) : "",
        value.source);
    node.unverified = value.unverified;
    node.assumed = value.assumed;
    if (value.assumed) node.range = value.range;
    catalogue_values_.insert_or_assign(key, std::move(node));
  }
}

std::string SectionReader::dotted(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

std::string SectionReader::heading() const {
  if (name_.empty()) return "the case";
  const auto dot = name_.rfind('.');  // "balls.2", "contact.pairs.1"
  return dot == std::string::npos ? fmt::format("[{}]", name_)
                                  : fmt::format("[[{}]]", name_.substr(0, dot));
}

void SectionReader::mark(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
}

const Node* SectionReader::find(std::string_view key) {
  mark(key);
  const Node* own = table_ ? table_->find(key) : nullptr;
  if (own != nullptr) return own;
  const auto from_catalogue = catalogue_values_.find(key);
  return from_catalogue == catalogue_values_.end() ? nullptr : &from_catalogue->second;
}

std::string_view SectionReader::one_of(std::initializer_list<std::string_view> keys) {
  std::string_view best;
  const Node* by = nullptr;
  for (const std::string_view key : keys) {
    const Node* node = find(key);
    if (node == nullptr) continue;
    if (by != nullptr && node->precedence == by->precedence &&
        node->precedence != Precedence::catalogue)
      fault(*node,
            fmt::format("both `{}` and `{}` are given, but one follows from the other", best, key),
            fmt::format("remove one of them"), "too-much");
    if (by == nullptr || node->precedence > by->precedence) {
      best = key;
      by = node;
    }
  }
  return best;
}

void SectionReader::fault(const Node& at, std::string what, std::string remedy,
                          std::string_view code) {
  findings_.faults.push_back({at.where, std::move(what), std::move(remedy), std::string(code)});
}

void SectionReader::missing(std::string_view key, std::string_view about, std::string remedy) {
  if (findings_.fitted_keys.contains(dotted(key))) return;
  const Node nowhere;
  fault(table_ ? *table_ : nowhere,
        about.empty() ? fmt::format("{} lacks `{}`", heading(), key)
                      : fmt::format("{} lacks `{}`: {}", heading(), key, about),
        std::move(remedy), "missing-value");
}

void SectionReader::refuse(std::initializer_list<std::string_view> keys, std::string_view why,
                           const std::string& remedy) {
  for (const std::string_view key : keys)
    if (const Node* at = find(key); at != nullptr)
      fault(*at, fmt::format("{} has no meaning {}", key, why), remedy, "too-much");
}

void SectionReader::record_origin(std::string_view key, std::string value, const Node* from,
                                  std::string_view how) {
  std::string source = from ? from->source : "";
  if (!how.empty()) source += fmt::format(": {}", how);
  findings_.origins.push_back(
      {.key = dotted(key),
       .value = std::move(value),
       .source = std::move(source),
       .assumed = from != nullptr && from->assumed,
       .unverified = from != nullptr && from->unverified,
       .range = from != nullptr ? from->range : std::array<std::string, 2>{}});
}

void SectionReader::record_default(std::string_view key, std::string value,
                                   std::string_view source) {
  findings_.origins.push_back({.key = dotted(key),
                               .value = std::move(value),
                               .source = fmt::format("default: {}", source),
                               .assumed = true});
}

double SectionReader::quantity(const Node& at, const NumberSpec& spec) {
  if (at.kind != Node::Kind::text && at.kind != Node::Kind::number) {
    fault(at, fmt::format("`{}` must be a quantity: {}", spec.key, spec.about),
          fmt::format("write for instance {} = \"{}\"", spec.key, example_of(spec.unit)),
          "wrong-type");
    return invalid_value;
  }
  try {
    const double v = parse_in(at.text, spec.unit);
    const std::string refused = refusal(v, spec.range, spec.unit);
    if (refused.empty()) return v;
    fault(at, fmt::format("{} is {}", as_written(spec.key, at), refused),
          (is_percentage(v, spec.range, spec.unit) && at.kind == Node::Kind::number
               ? fmt::format("write {} = \"{} %\" if you mean a percentage; ", spec.key, at.text)
               : "") +
              fmt::format("{} is: {}", spec.key, spec.about),
          "out-of-range");
  } catch (const UnitError& error) {
    fault(at, fmt::format("{}: {}", as_written(spec.key, at), error.what()),
          fmt::format("{} is: {}", spec.key, spec.about), "bad-quantity");
  }
  return invalid_value;
}

std::optional<double> SectionReader::optional_number(const NumberSpec& spec) {
  const Node* node = find(spec.key);
  if (node == nullptr) return std::nullopt;
  const double v = quantity(*node, spec);
  if (!std::isnan(v)) record_origin(spec.key, show(v, spec.unit), node);
  return v;
}

double SectionReader::value(const NumberSpec& spec) {
  if (const auto given = optional_number(spec)) return *given;
  if (spec.standard) {
    record_default(spec.key, show(*spec.standard, spec.unit), spec.source);
    if (spec.assumed_range)
      findings_.origins.back().range = {show(spec.assumed_range->least, spec.unit),
                                        show(spec.assumed_range->most, spec.unit)};
    return *spec.standard;
  }
  std::string remedy = remedy_for(spec);
  if (!spec.instead.empty()) remedy += fmt::format(", or give `{}`", spec.instead);
  missing(spec.key, spec.about, std::move(remedy));
  return invalid_value;
}

std::string SectionReader::remedy_for(const NumberSpec& spec) const {
  const auto least = catalogue_values_.find(fmt::format("{}_least", spec.key)),
             most = catalogue_values_.find(fmt::format("{}_most", spec.key));
  if (most == catalogue_values_.end())
    return fmt::format("write for instance {} = \"{}\"", spec.key, example_of(spec.unit));
  const std::string from = least == catalogue_values_.end() ? "up to" : least->second.text + " to";
  return fmt::format("{} offers {} {}: write for instance {} = \"{}\"", entry_title_, from,
                     most->second.text, spec.key, most->second.text);
}

std::optional<std::string> SectionReader::text(std::string_view key) {
  const Node* node = find(key);
  if (node == nullptr) return std::nullopt;
  auto found = text_at(key, *node);
  if (found) record_origin(key, fmt::format("\"{}\"", *found), node);
  return found;
}

std::optional<std::string> SectionReader::text_at(std::string_view key, const Node& node) {
  if (node.kind != Node::Kind::text && !(node.given_as_text() && node.kind != Node::Kind::list)) {
    fault(node, fmt::format("`{}` must be a text", key), fmt::format("write {} = \"...\"", key),
          "wrong-type");
    return std::nullopt;
  }
  if (trimmed(node.text).empty() && key != "title") {
    fault(node, fmt::format("`{}` of {} is empty", key, heading()),
          fmt::format("give it a value, or remove the key; an unset variable of a script, as in "
                      "{}=$NAME, is a usual reason",
                      dotted(key)),
          "empty-text");
    return std::nullopt;
  }
  return node.text;
}

std::optional<std::string> SectionReader::entry_name(std::string_view key,
                                                     std::string_view category) {
  const Node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto word = text_at(key, *node);
  if (!word) return std::nullopt;
  std::vector<std::string> entries = catalogue().entries_called(category, *word);
  if (entries.size() > 1 && category == "jars")
    std::erase_if(entries, [&](const std::string& jar) {
      const auto& fit = findings_.jars_of_mill;
      return !fit.empty() && std::ranges::find(fit, jar) == fit.end();
    });
  if (entries.size() > 1) {
    fault(*node, fmt::format("{} = \"{}\" may be any of {}", key, *word, quoted_list(entries)),
          "write one of these names", "ambiguous-name");
    return std::nullopt;
  }
  const std::string name = entries.empty() ? *word : entries.front();
  record_origin(key, fmt::format("\"{}\"", name), node,
                name == *word ? "" : fmt::format("written as \"{}\"", *word));
  return name;
}

std::string SectionReader::choice(const Choice& choice) {
  const Node* node = find(choice.key);
  if (node == nullptr) {
    if (choice.standard.empty())
      missing(choice.key, "",
              fmt::format("write {} = ..., one of {}", choice.key, quoted_list(choice.words)));
    else
      record_default(choice.key, fmt::format("\"{}\"", choice.standard), choice.source);
    return choice.standard;
  }
  auto word = text_at(choice.key, *node);
  if (!word) return "";
  if (const std::string now = respelt(*word, choice.words); !now.empty()) {
    findings_.remarks.push_back(note(
        "old-spelling", fmt::format("{}: {} = \"{}\" is an old spelling, which the next version "
                                    "refuses. Write \"{}\".",
                                    node->where, choice.key, *word, now)));
    word = now;
  }
  record_origin(choice.key, fmt::format("\"{}\"", *word), node);
  if (std::ranges::find(choice.words, *word) != choice.words.end()) return *word;
  const std::string near = nearest_word(*word, choice.words);
  fault(*node, fmt::format("there is no {} = \"{}\"", choice.key, *word),
        (near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near)) +
            fmt::format("known: {}", quoted_list(choice.words)),
        "unknown-word");
  return {};
}

std::optional<std::int64_t> SectionReader::integer(std::string_view key, std::int64_t most,
                                                   std::int64_t least) {
  const Node* node = find(key);
  if (node == nullptr) return std::nullopt;
  std::int64_t n = 0;
  const char* end = node->text.data() + node->text.size();
  const bool from_text = node->given_as_text() && node->kind == Node::Kind::text;
  const auto [stop, error] = std::from_chars(node->text.data(), end, n);
  if (!(node->is_integer || from_text) || error != std::errc{} || stop != end || n < least ||
      n > most) {
    fault(
        *node,
        fmt::format("{} must be a whole number from {} to {}", as_written(key, *node), least, most),
        fmt::format("write for instance {} = {}", key, std::max<std::int64_t>(least, 5)),
        "out-of-range");
    return 0;
  }
  record_origin(key, std::to_string(n), node);
  return n;
}

void SectionReader::integer(const IntegerSpec& spec, std::int64_t& value) {
  if (const auto given = integer(spec.key, spec.most, spec.least)) {
    value = *given;
  } else if (spec.standard) {
    value = *spec.standard;
    record_default(spec.key, std::to_string(value), spec.source);
  } else {
    missing(spec.key, spec.about, fmt::format("write for instance {} = 10", spec.key));
  }
}

bool SectionReader::choose(const Choice& choice, std::size_t& word_index) {
  const auto at = std::ranges::find(choice.words, this->choice(choice));
  const bool sound = at != choice.words.end();
  word_index = sound ? static_cast<std::size_t>(at - choice.words.begin()) : 0;
  return sound;
}

void SectionReader::flag(const Flag& flag, bool& value) {
  const Node* node = find(flag.key);
  value = flag.standard;
  if (node == nullptr) {
    record_default(flag.key, flag.standard ? "true" : "false", flag.source);
  } else if (node->kind != Node::Kind::boolean) {
    fault(*node, fmt::format("`{}` must be true or false", flag.key),
          fmt::format("write {} = true, without quotes", flag.key), "wrong-type");
  } else {
    record_origin(flag.key, node->text, node);
    value = node->boolean;
  }
}

void SectionReader::report_unknown_keys() {
  if (table_ == nullptr || unknown_keys_ignored_) return;
  for (const auto& [key, node] : table_->members) {
    if (std::ranges::find(known_, key) != known_.end()) continue;
    const std::string near = nearest_word(key, known_);
    fault(node, fmt::format("unknown key `{}` in {}", key, heading()),
          near.empty() ? fmt::format("known here: {}", quoted_list(known_))
                       : fmt::format("did you mean `{}`?", near),
          "unknown-key");
  }
}

}  // namespace mahlwerk::cases
