// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::cases {
namespace {

/// The value as it stands in the file, for a message.
std::string said(std::string_view key, const Node& node) {
  const bool quoted = node.kind == Node::Kind::text;
  return quoted ? fmt::format("{} = \"{}\"", key, node.text)
                : fmt::format("{} = {}", key, node.text);
}

}  // namespace

std::string in_words(const Range& range, std::string_view unit) {
  const auto end = [&](double v) { return show(v, unit); };
  const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
  if (low && high)
    return fmt::format("{} {} and {} {}", range.without_least ? "above" : "at least",
                       end(range.least), range.without_most ? "below" : "at most", end(range.most));
  if (low)
    return fmt::format("{} {}", range.without_least ? "above" : "at least", end(range.least));
  return fmt::format("{} {}", range.without_most ? "below" : "at most", end(range.most));
}

std::string listed(const std::vector<std::string>& words) {
  std::string line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) line += i + 1 == words.size() ? " or " : ", ";
    line += "\"" + words[i] + "\"";
  }
  return line;
}

Section::Section(const Node* table, std::string name, Findings& findings)
    : table_(table), name_(std::move(name)), findings_(findings) {}

void Section::lend(const CatalogueEntry& entry) {
  const std::string place = fmt::format("catalogue {}/{}", entry.room, entry.name);
  for (const auto& [key, value] : entry.values) {
    Node node = loose_value(value.text, entry.file, Rank::catalogue);
    node.source = fmt::format("{}: {}", place, value.source);
    node.unverified = value.unverified;
    lent_.insert_or_assign(key, std::move(node));
  }
}

std::string Section::dotted(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

std::string Section::heading() const {
  if (name_.empty()) return "the case";
  const auto dot = name_.rfind('.');  // "balls.2", "contact.pairs.1"
  return dot == std::string::npos ? fmt::format("[{}]", name_)
                                  : fmt::format("[[{}]]", name_.substr(0, dot));
}

void Section::mark(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
}

const Node* Section::find(std::string_view key) {
  mark(key);
  const Node* own = table_ ? table_->find(key) : nullptr;
  if (own != nullptr) return own;
  const auto borrowed = lent_.find(key);
  return borrowed == lent_.end() ? nullptr : &borrowed->second;
}

std::string_view Section::one_of(std::initializer_list<std::string_view> keys) {
  std::string_view best;
  const Node* by = nullptr;
  for (const std::string_view key : keys) {
    const Node* node = find(key);
    if (node == nullptr) continue;
    if (by != nullptr && node->rank == by->rank && node->rank != Rank::catalogue)
      fault(*node,
            fmt::format("both `{}` and `{}` are given, but one follows from the other", best, key),
            fmt::format("remove one of them"), "too-much");
    if (by == nullptr || node->rank > by->rank) {
      best = key;
      by = node;
    }
  }
  return best;
}

void Section::fault(const Node& at, std::string what, std::string remedy, std::string_view code) {
  findings_.faults.push_back({at.where, std::move(what), std::move(remedy), std::string(code)});
}

void Section::missing(std::string_view key, std::string_view about, std::string remedy) {
  if (findings_.awaited.contains(dotted(key))) return;
  const Node nowhere;
  fault(table_ ? *table_ : nowhere,
        about.empty() ? fmt::format("{} lacks `{}`", heading(), key)
                      : fmt::format("{} lacks `{}`: {}", heading(), key, about),
        std::move(remedy), "missing-value");
}

void Section::refuse(std::initializer_list<std::string_view> keys, std::string_view why,
                     const std::string& remedy) {
  for (const std::string_view key : keys)
    if (const Node* at = find(key); at != nullptr)
      fault(*at, fmt::format("{} has no meaning {}", key, why), remedy, "too-much");
}

void Section::note(std::string_view key, std::string value, const Node* from,
                   std::string_view how) {
  std::string source = from ? from->source : "";
  if (!how.empty()) source += fmt::format(": {}", how);
  findings_.origins.push_back(
      {dotted(key), std::move(value), std::move(source), false, from && from->unverified});
}

void Section::note_default(std::string_view key, std::string value, std::string_view source) {
  findings_.origins.push_back(
      {dotted(key), std::move(value), fmt::format("default: {}", source), true, false});
}

double Section::quantity(const Node& at, const Wanted& wanted) {
  if (at.kind != Node::Kind::text && at.kind != Node::Kind::number) {
    fault(at, fmt::format("`{}` must be a quantity: {}", wanted.key, wanted.about),
          fmt::format("write for instance {} = \"{}\"", wanted.key, example_of(wanted.unit)),
          "wrong-type");
    return unread;
  }
  try {
    const double v = parse_in(at.text, wanted.unit);
    if (wanted.range.holds(v)) return v;
    fault(at,
          fmt::format("{} is out of range: it must be {}", said(wanted.key, at),
                      in_words(wanted.range, wanted.unit)),
          fmt::format("{} is: {}", wanted.key, wanted.about), "out-of-range");
  } catch (const UnitError& error) {
    fault(at, fmt::format("{}: {}", said(wanted.key, at), error.what()),
          fmt::format("{} is: {}", wanted.key, wanted.about), "bad-quantity");
  }
  return unread;
}

std::optional<double> Section::maybe(const Wanted& wanted) {
  const Node* node = find(wanted.key);
  if (node == nullptr) return std::nullopt;
  const double v = quantity(*node, wanted);
  if (!std::isnan(v)) note(wanted.key, show(v, wanted.unit), node);
  return v;
}

double Section::value(const Wanted& wanted) {
  if (const auto given = maybe(wanted)) return *given;
  if (wanted.standard) {
    note_default(wanted.key, show(*wanted.standard, wanted.unit), wanted.source);
    return *wanted.standard;
  }
  std::string remedy =
      fmt::format("write for instance {} = \"{}\"", wanted.key, example_of(wanted.unit));
  if (!wanted.instead.empty()) remedy += fmt::format(", or give `{}`", wanted.instead);
  missing(wanted.key, wanted.about, std::move(remedy));
  return unread;
}

std::optional<std::string> Section::text(std::string_view key) {
  const Node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (node->kind != Node::Kind::text && !(node->loose() && node->kind != Node::Kind::list)) {
    fault(*node, fmt::format("`{}` must be a text", key), fmt::format("write {} = \"...\"", key),
          "wrong-type");
    return std::nullopt;
  }
  note(key, fmt::format("\"{}\"", node->text), node);
  return node->text;
}

std::string Section::choice(const Choice& choice) {
  const Node* node = find(choice.key);
  if (node == nullptr) {
    if (choice.standard.empty())
      missing(choice.key, "",
              fmt::format("write {} = ..., one of {}", choice.key, listed(choice.words)));
    else
      note_default(choice.key, fmt::format("\"{}\"", choice.standard), choice.source);
    return choice.standard;
  }
  const auto word = text(choice.key);
  if (!word || std::ranges::find(choice.words, *word) != choice.words.end())
    return word.value_or("");
  const std::string near = nearest_word(*word, choice.words);
  fault(*node, fmt::format("there is no {} = \"{}\"", choice.key, *word),
        (near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near)) +
            fmt::format("known: {}", listed(choice.words)),
        "unknown-word");
  return {};
}

std::optional<std::int64_t> Section::whole(std::string_view key, std::int64_t most,
                                           std::int64_t least) {
  const Node* node = find(key);
  if (node == nullptr) return std::nullopt;
  std::int64_t n = 0;
  const char* end = node->text.data() + node->text.size();
  const bool loose = node->loose() && node->kind == Node::Kind::text;
  const auto [stop, error] = std::from_chars(node->text.data(), end, n);
  if (!(node->whole || loose) || error != std::errc{} || stop != end || n < least || n > most) {
    fault(*node,
          fmt::format("{} must be a whole number from {} to {}", said(key, *node), least, most),
          fmt::format("write for instance {} = {}", key, std::max<std::int64_t>(least, 5)),
          "out-of-range");
    return 0;
  }
  note(key, std::to_string(n), node);
  return n;
}

void Section::whole(const Whole& wanted, std::int64_t& value) {
  if (const auto given = whole(wanted.key, wanted.most, wanted.least)) {
    value = *given;
  } else if (wanted.standard) {
    value = *wanted.standard;
    note_default(wanted.key, std::to_string(value), wanted.source);
  } else {
    missing(wanted.key, wanted.about, fmt::format("write for instance {} = 10", wanted.key));
  }
}

bool Section::choose(const Choice& choice, std::size_t& place) {
  const auto at = std::ranges::find(choice.words, this->choice(choice));
  const bool sound = at != choice.words.end();
  place = sound ? static_cast<std::size_t>(at - choice.words.begin()) : 0;
  return sound;
}

void Section::flag(const Flag& flag, bool& value) {
  const Node* node = find(flag.key);
  value = flag.standard;
  if (node == nullptr) {
    note_default(flag.key, flag.standard ? "true" : "false", flag.source);
  } else if (node->kind != Node::Kind::boolean) {
    fault(*node, fmt::format("`{}` must be true or false", flag.key),
          fmt::format("write {} = true, without quotes", flag.key), "wrong-type");
  } else {
    note(flag.key, node->text, node);
    value = node->boolean;
  }
}

void Section::close() {
  if (table_ == nullptr || open_) return;
  for (const auto& [key, node] : table_->members) {
    if (std::ranges::find(known_, key) != known_.end()) continue;
    const std::string near = nearest_word(key, known_);
    fault(node, fmt::format("unknown key `{}` in {}", key, heading()),
          near.empty() ? fmt::format("known here: {}", listed(known_))
                       : fmt::format("did you mean `{}`?", near),
          "unknown-key");
  }
}

}  // namespace mahlwerk::cases
