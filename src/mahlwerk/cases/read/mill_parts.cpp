// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The parts of a mill of the catalogue as [[parts]] of the case.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/cases/read/case_tree.hpp"

namespace mahlwerk::cases {
namespace {

/// The part as the table of a case; faults of the table as a whole cite `where`.
Node table_of(const CataloguePart& part, const CatalogueEntry& mill, const std::string& where) {
  Node table;
  table.kind = Node::Kind::table;
  table.where = table.source = where;
  for (const auto& [key, text] : part.keys) {
    Node value = value_from_text(text, mill.file, Precedence::catalogue);
    value.source = fmt::format("catalogue mills/{}: {}", mill.name, part.source);
    value.unverified = part.unverified;
    value.assumed = part.assumed;
    table.members.push_back({key, std::move(value)});
  }
  return table;
}

bool same_name(const Node& one, const Node& other) {
  const Node *a = one.find("name"), *b = other.find("name");
  return a != nullptr && b != nullptr && a->text == b->text;
}

constexpr std::string_view keys_of_motion[] = {"motion", "moves_with", "speed",     "motion_axis",
                                               "pivot",  "amplitude",  "frequency", "phase",
                                               "swing",  "motion_file"};

/// Replaces the values of the keys that `given` has, and adds the others. Another motion leaves
/// nothing of the mill's.
void overlay(Node& table, const Node& given) {
  if (given.find("motion") != nullptr || given.find("moves_with") != nullptr)
    std::erase_if(table.members, [](const Member& own) {
      return std::ranges::find(keys_of_motion, own.key) != std::end(keys_of_motion);
    });
  for (const Member& own : given.members) {
    if (Node* found = table.find(own.key))
      *found = own.value;
    else
      table.members.push_back(own);
  }
}

}  // namespace

void CaseTree::add_parts_of_mill(const std::vector<Override>& overrides) {
  const auto last = [&](std::string_view key) -> std::optional<Node> {
    const auto one = std::ranges::find(overrides.rbegin(), overrides.rend(), key, &Override::key);
    if (one != overrides.rend()) return one->unset ? std::nullopt : std::optional(given(*one));
    const Node* written = value_at(root_, key);
    return written == nullptr ? std::nullopt : std::optional(*written);
  };
  const auto model = last("mill.model"), kind = last("mill.kind");
  if (!model || model->kind != Node::Kind::text) return;
  if (kind && model->precedence <= kind->precedence) return;  // the case has the mill's numbers
  const auto called = findings.catalogue->entries_called("mills", model->text);
  if (called.size() != 1) return;  // a fault of [mill]
  const CatalogueEntry mill = findings.catalogue->find("mills", called.front());
  if (mill.parts.empty()) return;
  Node list;
  list.kind = Node::Kind::list;
  list.where = list.source = model->where;
  for (const CataloguePart& part : mill.parts)
    list.items.push_back(table_of(part, mill, model->where));
  Node* own = root_.find("parts");
  if (own == nullptr) return root_.members.push_back({"parts", std::move(list)});
  if (own->kind != Node::Kind::list) return;  // a fault of [[parts]]
  std::vector<bool> overlaid(list.items.size());
  for (Node& part : own->items) {
    std::size_t k = 0;
    while (k < overlaid.size() && !same_name(part, list.items[k])) ++k;
    if (k < overlaid.size() && !overlaid[k]) {
      overlay(list.items[k], part);
      overlaid[k] = true;
    } else {
      list.items.push_back(std::move(part));  // two of one name are a fault of [[parts]]
    }
  }
  *own = std::move(list);
}

}  // namespace mahlwerk::cases
