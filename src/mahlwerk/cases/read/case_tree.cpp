// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read/case_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/cases/file/formula.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view no_such_key = "unknown-key";

std::string remedy_for(std::string_view key) {
  if (key.starts_with("parts."))
    return "name a value of a part by the number of its [[parts]] in the case, from 1: "
           "parts.1.speed; a further part needs a [[parts]] of its own in the case file";
  return "name a value of the case: mill.speed, balls.2.diameter";
}

}  // namespace

CaseTree::CaseTree(Node root, std::filesystem::path file, const Catalogue& catalogue)
    : findings{.catalogue = &catalogue, .folder = file.parent_path().generic_string()},
      root_(std::move(root)),
      file_(std::move(file)) {}

std::pair<std::string, std::string> section_of(ValueSource source) {
  if (source == ValueSource::optimise) return {"optimise", "optimise.over."};
  if (source == ValueSource::match) return {"match", "match.over."};
  if (source == ValueSource::fit) return {"fit", "fit."};
  return {"uncertainty", "uncertainty."};
}

Node CaseTree::given(const Override& one) const {
  const auto& [key, value, source, unset] = one;
  if (source == ValueSource::command)
    return value_from_text(value, "--set " + key, Precedence::command);
  if (source == ValueSource::sweep)
    return value_from_text(value, fmt::format("[sweep] {} = {}", key, value), Precedence::sweep);
  const auto& [section, place] = section_of(source);
  const auto range =
      std::ranges::find(findings.origins, fmt::format("{}{}", place, key), &Origin::key);
  const std::string line = range == findings.origins.end() ? section : range->source;
  const std::string where = fmt::format("{}: [{}] {} = {}", line, section, key, value);
  Node node = value_from_text(value, where, Precedence::command);
  node.source = fmt::format("{}: found by {}", line, section);
  return node;
}

void CaseTree::apply(const std::vector<Override>& overrides, ValueSource source) {
  for (const Override& one : overrides) {
    if (one.source != source) continue;
    if (one.unset) {
      remove(one.key);
      continue;
    }
    Node value = given(one);
    const std::string where = value.where, trouble = set_value(root_, one.key, std::move(value));
    if (!trouble.empty())
      findings.faults.push_back({where, trouble, remedy_for(one.key), std::string(no_such_key)});
  }
}

void CaseTree::remove(const std::string& key) {
  if (remove_value(root_, key)) return;
  const std::string near = nearest_word(key, keys_in(root_));
  findings.faults.push_back({"--unset " + key, fmt::format("the case file gives no {}", key),
                             near.empty()
                                 ? "leave it out: what the file does not give needs no --unset"
                                 : fmt::format("did you mean {}?", near),
                             std::string(no_such_key)});
}

void CaseTree::fill_from_sweep(const Sweep& sweep,
                               const std::map<std::string, std::string>& locations) {
  for (const SweptKey& swept : sweep.keys) {
    const std::string& key = swept.key;
    if (value_at(root_, key) != nullptr) continue;
    const std::string& where = locations.at(key);
    Node value = value_from_text(swept.values.front(), where, Precedence::sweep);
    value.source = fmt::format("first value of [sweep] \"{}\"", key);
    const std::string trouble = set_value(root_, key, std::move(value));
    if (!trouble.empty())
      findings.faults.push_back({where, trouble, "sweep over a value of the case: \"mill.speed\"",
                                 std::string(no_such_key)});
  }
}

void CaseTree::apply_formulas(const Sweep& sweep,
                              const std::map<std::string, std::string>& locations) {
  for (const auto& entry : sweep.derived) {
    const std::string &key = entry.first, &formula = entry.second;
    const std::string& where = locations.at(key);
    const auto fault = [&](std::string what, std::string remedy) {
      findings.faults.push_back({where, fmt::format("the formula of \"{}\": {}", key, what),
                                 std::move(remedy), "bad-formula"});
    };
    try {
      Node value = value_from_text(text_of(derived(sweep, key, 0)), where, Precedence::sweep);
      value.source = fmt::format("[sweep]: ={}", formula);
      if (std::string trouble = set_value(root_, key, std::move(value)); !trouble.empty())
        fault(std::move(trouble), "name a value of the case: \"jar.height\"");
    } catch (const FormulaError& error) {
      fault(error.what(), "write for instance \"= 5 ml / (pi/4 * jar.diameter^2)\"");
    }
  }
}

/// The value of a key, from its formula if it has one.
Quantity CaseTree::derived(const Sweep& sweep, std::string_view key, std::size_t depth) const {
  if (depth > sweep.derived.size()) throw FormulaError(fmt::format("{} depends on itself", key));
  const auto formula = sweep.derived.find(std::string(key));
  if (formula != sweep.derived.end())
    return evaluate(formula->second,
                    [&](std::string_view other) { return derived(sweep, other, depth + 1); });
  const Node* node = value_at(root_, key);
  if (const auto gravity = case_fields().front(); node == nullptr && key == gravity.key)
    return parse_quantity(show(*gravity.standard, gravity.unit));
  if (node == nullptr || (node->kind != Node::Kind::text && node->kind != Node::Kind::number))
    throw FormulaError(fmt::format("the case gives no quantity for {}", key));
  try {
    return parse_quantity(node->text);
  } catch (const UnitError& error) {
    throw FormulaError(fmt::format("{} = \"{}\": {}", key, node->text, error.what()));
  }
}

const Node* CaseTree::section(std::string_view name, bool needed) {
  const Node* found = root_.find(name);
  if (found != nullptr && found->kind == Node::Kind::table) return found;
  if (found != nullptr)
    findings.faults.push_back({found->where, fmt::format("`{}` must be a section", name),
                               fmt::format("write [{}] and its values below", name), "wrong-type"});
  else if (needed)
    findings.faults.push_back({file_.generic_string(), fmt::format("there is no [{}]", name),
                               fmt::format("add the section [{}]", name), "missing-value"});
  return nullptr;
}

}  // namespace mahlwerk::cases
