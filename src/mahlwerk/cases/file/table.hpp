// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"

// What a case file says, with the place of every word; overrides are put into the same tree.
namespace mahlwerk::cases {

/// Who said a value; the later ones win where two exclude each other.
enum class Precedence { catalogue, file, sweep, command };

struct Member;

/// One value of a TOML file, or of the command line.
struct Node {
  enum class Kind { text, number, boolean, list, table, other };
  Kind kind = Kind::other;
  std::string text;             ///< of a text: itself; otherwise the value as one would write it
  double number = 0;            ///< of a number
  bool is_integer = false;      ///< the number was written as an integer
  bool boolean = false;         ///< of a boolean
  std::vector<Node> items;      ///< of a list
  std::vector<Member> members;  ///< of a table

  std::string where;   ///< the place a fault cites: "case.toml:14"
  std::string source;  ///< the place an origin cites
  Precedence precedence = Precedence::file;
  bool unverified = false;  ///< its source is weak

  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  bool given_as_text() const {
    return precedence != Precedence::file;
  }  ///< was text before it was TOML
};

struct Member {
  std::string key;
  Node value;
};

/// The tree of a TOML text. `file` is the name faults cite. Throws InputError where it is no TOML.
Node parse_tree(std::string_view text, const std::string& file);

/// A value given as text outside a file: as TOML if it is a value there, otherwise as it stands.
Node value_from_text(std::string_view text, const std::string& where, Precedence precedence);

/// The value under the dotted `key`, see set_value(); null if there is none.
const Node* value_at(const Node& root, std::string_view key);

/// Puts `value` under the dotted `key`, "mill.speed" or "balls.2.diameter" ("balls.diameter" is
/// that of the first set). Returns what hinders it, or an empty text.
std::string set_value(Node& root, std::string_view key, Node value);

}  // namespace mahlwerk::cases
