// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/key_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/sweep_words.hpp"

namespace mahlwerk::cases {
namespace {

bool is_value(const Node& node) {
  return node.kind == Node::Kind::text || node.kind == Node::Kind::number ||
         node.kind == Node::Kind::boolean;
}

/// A formula begins with an equals sign: "= 5 ml / jar.diameter".
bool is_formula(const Node& node) {
  return node.kind == Node::Kind::text && node.text.starts_with('=');
}

bool is_range(const Node& node) {
  return node.kind == Node::Kind::table && (node.find("from") != nullptr || node.find("to"));
}

}  // namespace

void KeyReader::read(const Node& table, const std::set<std::string_view>& own) {
  const std::vector<std::string> words(own.begin(), own.end());
  for (const auto& [key, node] : table.members) {
    const bool dotted = key.find('.') != std::string::npos || node.kind == Node::Kind::table;
    const std::string near = dotted || own.contains(key) ? "" : nearest_word(key, words);
    if (!near.empty())
      fault(node, fmt::format("unknown key `{}` in [{}]", key, section_),
            fmt::format("did you mean `{}`?", near), "unknown-key");
    else if (!own.contains(key))
      read_key(key, node);
  }
}

void KeyReader::fault(const Node& at, std::string what, std::string remedy, const char* code) {
  findings_.faults.push_back({at.where, std::move(what), std::move(remedy), code});
}

void KeyReader::read_key(const std::string& key, const Node& node) {
  if (const std::string section = key.substr(0, key.find('.'));
      section == "sweep" || section == "optimise" || section == "match" || section == "fit" ||
      section == "uncertainty") {
    fault(node, fmt::format("\"{}\" is not a value of a run", key),
          "name a key of the mill, its contents or its run: \"mill.speed\"", "bad-range");
    return;
  }
  if (node.kind == Node::Kind::table && !is_range(node)) {
    for (const auto& [below, value] : node.members) read_key(key + "." + below, value);
    return;
  }
  if (!locations_.emplace(key, node.where).second) return;
  if (is_formula(node))
    derived_.emplace(key, node.text.substr(1));
  else if (is_range(node))
    read_range(key, node);
  else
    read_list(key, node);
}

void KeyReader::read_range(const std::string& key, const Node& node) {
  SectionReader in(&node, section_, findings_);
  SweptKey made{.key = key, .values = {}, .range = true};
  for (const char* end : {"from", "to"}) {
    const Node* at = in.find(end);
    if (at != nullptr && is_value(*at) && !at->text.empty()) {
      made.values.push_back(at->text);
      continue;
    }
    fault(at != nullptr ? *at : node, fmt::format("the range of \"{}\" lacks `{}`", key, end),
          fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key), "bad-range");
  }
  if (const auto steps = in.integer("steps", max_steps, 2)) made.steps = *steps;
  made.logarithmic =
      in.gives("spacing") && in.choice({"spacing", spacing_words(), ""}) == spacing_words().back();
  in.report_unknown_keys();
  // With one end the key still varies, which avoids a second fault for a missing value.
  if (made.values.size() == 1) made.values.push_back(made.values.front());
  if (!made.values.empty()) keys_.push_back(std::move(made));
}

void KeyReader::read_list(const std::string& key, const Node& node) {
  SweptKey made{.key = key, .values = {}};
  for (const Node& item : node.items) made.values.push_back(item.text);
  const bool sound = node.kind == Node::Kind::list && !node.items.empty() &&
                     std::ranges::all_of(node.items, is_value) &&
                     std::ranges::none_of(node.items, &std::string::empty, &Node::text);
  if (!sound)
    fault(node,
          fmt::format(
              "\"{}\" must be a list of values, none of them empty, or a range or a formula", key),
          fmt::format("write \"{0}\" = [\"...\", \"...\"], \"{0}\" = {{ from = \"...\", to = "
                      "\"...\", steps = 5 }} or \"{0}\" = \"= 2 * other.key\"",
                      key),
          "wrong-type");
  std::erase(made.values, "");
  if (!made.values.empty()) keys_.push_back(std::move(made));
}

std::string list_text(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + in_quotes(word);
  return "[" + list + "]";
}

std::string values_text(const SweptKey& key) {
  if (!key.range) return list_text(key.values);
  return fmt::format("{{ from = {}, to = {}{}{} }}", in_quotes(key.values[0]),
                     in_quotes(key.values[1]),
                     key.steps > 0 ? fmt::format(", steps = {}", key.steps) : "",
                     key.logarithmic ? ", spacing = \"logarithmic\"" : "");
}

}  // namespace mahlwerk::cases
