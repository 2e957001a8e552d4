// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/table.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::cases {
namespace {

// The sections that are lists of tables.
constexpr std::string_view ball_sets = "balls", machine_parts = "parts";

/// Refuses keys of so many parts ("a.a.a. ...") that parsing them as nested tables would overflow
/// the stack. Counts the dots of each run of key characters outside of texts and comments.
void check_depth(std::string_view text, const std::string& file) {
  constexpr int most = 100;
  int line = 1, dots = 0;
  bool comment = false;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      dots = 0;
      comment = false;
      quote = 0;  // further lines of a multi-line text are scanned like keys, line by line
    } else if (comment) {
      continue;
    } else if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      comment = true;
    } else if (c == '=' || c == ',' || c == '{' || c == '}' || c == '[' || c == ']') {
      dots = 0;
    } else if (c == '.' && ++dots > most) {
      throw InputError(Fault{fmt::format("{}:{}", file, line),
                             fmt::format("a key has more than {} parts", most),
                             "name a value of the case: mill.speed", "not-toml"});
    }
  }
}

void fill(Node& node, const toml::node& from, const std::string& file);

void fill_table(Node& node, const toml::table& from, const std::string& file) {
  node.kind = Node::Kind::table;
  for (const auto& [key, value] : from) {
    node.members.push_back({std::string(key.str()), {}});
    fill(node.members.back().value, value, file);
  }
}

void fill(Node& node, const toml::node& from, const std::string& file) {
  node.where = fmt::format("{}:{}", file, from.source().begin.line);
  const auto slash = node.where.find_last_of("/\\");
  node.source = slash == std::string::npos ? node.where : node.where.substr(slash + 1);
  if (const auto* table = from.as_table()) {
    fill_table(node, *table, file);
  } else if (const auto* list = from.as_array()) {
    node.kind = Node::Kind::list;
    for (const toml::node& item : *list) fill(node.items.emplace_back(), item, file);
  } else if (const auto* text = from.as_string()) {
    node.kind = Node::Kind::text;
    node.text = text->get();
  } else if (const auto* integer = from.as_integer()) {
    node.kind = Node::Kind::number;
    node.is_integer = true;
    node.number = static_cast<double>(integer->get());
    node.text = std::to_string(integer->get());
  } else if (const auto* real = from.as_floating_point()) {
    node.kind = Node::Kind::number;
    node.number = real->get();
    node.text = shortest(node.number);
  } else if (const auto* flag = from.as_boolean()) {
    node.kind = Node::Kind::boolean;
    node.boolean = flag->get();
    node.text = node.boolean ? "true" : "false";
  }
}

void set_place(Node& node, const std::string& where, Precedence precedence) {
  node.where = node.source = where;
  node.precedence = precedence;
  for (Node& item : node.items) set_place(item, where, precedence);
}

/// Splits a dotted key at its dots. No key of a case has a dot within a part.
std::vector<std::string_view> key_parts(std::string_view key) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(key.find('.', from), key.size());
    parts.push_back(key.substr(from, to - from));
    if (to == key.size()) return parts;
    from = to + 1;
  }
}

Node& member(Node& table, std::string_view key) {
  if (Node* found = table.find(key)) return *found;
  table.members.push_back({std::string(key), {}});
  return table.members.back().value;
}

/// Index from 0 of the list entry that a key names. Removes the entry's number, counted from 1,
/// from `rest`; a key without a number names the first entry.
std::optional<std::size_t> entry_of(std::size_t entries, std::vector<std::string_view>& rest) {
  std::size_t number = 1;
  if (rest.size() > 1) {
    const char* end = rest[0].data() + rest[0].size();
    const auto [stop, error] = std::from_chars(rest[0].data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    rest.erase(rest.begin());
  }
  if (number < 1 || number > entries) return std::nullopt;
  return number - 1;
}

/// Descends from a section through lists of tables along the key parts `rest`, and removes the
/// parts it uses. Returns the table of the remaining parts, or null if a list has no such entry;
/// `list` then describes that list.
template <class N>
N* descend(N* table, std::vector<std::string_view>& rest, std::string& list) {
  while (table->kind == Node::Kind::list || rest.size() > 1) {
    if (table->kind == Node::Kind::list) {
      const auto entry = entry_of(table->items.size(), rest);
      if (!entry) {
        list = fmt::format("{} in the case: {}", list, table->items.size());
        return nullptr;
      }
      table = &table->items[*entry];
    } else {
      N* below = table->find(rest.front());
      if (below == nullptr || below->kind != Node::Kind::list) return table;
      list = fmt::format("entries of `{}`", rest.front());
      table = below;
      rest.erase(rest.begin());
    }
  }
  return table;
}

/// The section that a dotted key names; created if the case lacks it.
Node& section_for(Node& root, std::string_view name, const std::string& where) {
  if (Node* found = root.find(name)) return *found;
  Node& made = member(root, name);
  made.kind = Node::Kind::table;
  made.where = where;
  if (name == ball_sets) {
    const Node first = made;
    made.kind = Node::Kind::list;
    made.items.push_back(first);
  }
  return made;
}

}  // namespace

const Node* Node::find(std::string_view key) const {
  const auto at = std::ranges::find(members, key, &Member::key);
  return at == members.end() ? nullptr : &at->value;
}

Node* Node::find(std::string_view key) {
  return const_cast<Node*>(std::as_const(*this).find(key));
}

Node parse_tree(std::string_view text, const std::string& file) {
  Node root;
  try {
    check_depth(text, file);
    fill(root, toml::parse(text, std::string_view(file)), file);
  } catch (const toml::parse_error& error) {
    throw InputError(Fault{
        fmt::format("{}:{}", file, error.source().begin.line), std::string(error.description()),
        "correct the TOML there; texts need quotes: speed = \"400 rpm\"", "not-toml"});
  }
  root.where = root.source = file;
  return root;
}

Node value_from_text(std::string_view text, const std::string& where, Precedence precedence) {
  Node node;
  check_depth(text, where);
  try {
    const toml::table table =
        toml::parse(fmt::format("value = {}", text), std::string_view("value"));
    if (table.size() == 1) fill(node, *table.get("value"), "value");
  } catch (const toml::parse_error&) {
    node.kind = Node::Kind::other;
  }
  const bool in_quotes = node.kind == Node::Kind::text;
  if (node.kind == Node::Kind::other || node.kind == Node::Kind::table) node = {};
  if (node.kind == Node::Kind::other) node.kind = Node::Kind::text;
  if (!in_quotes) node.text = text;
  set_place(node, where, precedence);
  return node;
}

const Node* value_at(const Node& root, std::string_view key) {
  std::vector<std::string_view> parts = key_parts(key);
  const Node* table = &root;
  if (parts.size() > 1) {
    table = root.find(parts.front());
    if (table == nullptr) return nullptr;
    parts.erase(parts.begin());
    std::string ignored;
    table = descend(table, parts, ignored);
  }
  return table != nullptr && parts.size() == 1 ? table->find(parts.front()) : nullptr;
}

bool remove_value(Node& root, std::string_view key) {
  std::vector<std::string_view> parts = key_parts(key);
  Node* table = &root;
  if (parts.size() > 1) {
    table = root.find(parts.front());
    if (table == nullptr) return false;
    parts.erase(parts.begin());
    std::string ignored;
    table = descend(table, parts, ignored);
  }
  if (table == nullptr || parts.size() != 1) return false;
  return std::erase_if(table->members,
                       [&](const Member& one) { return one.key == parts.front(); }) > 0;
}

std::vector<std::string> keys_in(const Node& root) {
  std::vector<std::string> keys;
  const auto add = [&](const std::string& before, const Node& value) {
    for (const std::string& below : keys_in(value))
      keys.push_back(fmt::format("{}.{}", before, below));
  };
  for (const auto& [key, value] : root.members) {
    keys.push_back(key);
    add(key, value);
    for (std::size_t i = 0; i < value.items.size(); ++i)
      add(i == 0 ? key : fmt::format("{}.{}", key, i + 1), value.items[i]);
  }
  return keys;
}

std::string set_value(Node& root, std::string_view key, Node value) {
  std::vector<std::string_view> parts = key_parts(key);
  if (std::ranges::any_of(parts, &std::string_view::empty))
    return fmt::format("\"{}\" is not a key", key);
  Node* table = &root;
  if (parts.size() > 1) {
    const bool of_part = parts.front() == machine_parts;
    std::string list = of_part ? "parts" : "ball sets";
    if (of_part && root.find(machine_parts) == nullptr)
      return fmt::format("\"{}\" names nothing in the case; {} in the case: 0", key, list);
    table = &section_for(root, parts.front(), value.where);
    parts.erase(parts.begin());
    table = descend(table, parts, list);
    if (table == nullptr) return fmt::format("\"{}\" names nothing in the case; {}", key, list);
  }
  if (parts.size() != 1 || table->kind != Node::Kind::table)
    return fmt::format("\"{}\" names nothing in the case", key);
  member(*table, parts.front()) = std::move(value);
  return {};
}

}  // namespace mahlwerk::cases
