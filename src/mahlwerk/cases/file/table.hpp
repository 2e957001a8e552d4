// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"

// The tree of a TOML case file, with the location of every value. Overrides are inserted into it.
namespace mahlwerk::cases {

/// Precedence of the source of a value, lowest first, for keys that exclude each other.
enum class Precedence { catalogue, file, sweep, command };

struct Member;

/// One value of a TOML file, or of the command line.
struct Node {
  enum class Kind { text, number, boolean, list, table, other };
  Kind kind = Kind::other;
  std::string text;             ///< the text, or another value as written in TOML
  double number = 0;            ///< of a number
  bool is_integer = false;      ///< whether the number is written as an integer
  bool boolean = false;         ///< of a boolean
  std::vector<Node> items;      ///< of a list
  std::vector<Member> members;  ///< of a table

  std::string where;   ///< location for faults: "case.toml:14"
  std::string source;  ///< location for origins
  Precedence precedence = Precedence::file;
  bool unverified = false;  ///< the source in the catalogue is weak
  bool assumed = false;     ///< a value of the catalogue that is not known of this machine
  std::array<std::string, 2> range = {};  ///< plausible range of an assumed value; or empty

  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  bool given_as_text() const {
    return precedence != Precedence::file;
  }  ///< whether the value comes from a text outside a TOML file
};

struct Member {
  std::string key;
  Node value;
};

/// The tree of a TOML text. Faults cite the name `file`. Throws InputError if the text is not TOML.
Node parse_tree(std::string_view text, const std::string& file);

/// A value given as text outside a file: parsed as a TOML value if possible, otherwise a plain
/// text.
Node value_from_text(std::string_view text, const std::string& where, Precedence precedence);

/// The value under the dotted `key`, see set_value(); null if there is none.
const Node* value_at(const Node& root, std::string_view key);

/// Sets the dotted `key`, "mill.speed" or "balls.2.diameter" ("balls.diameter" belongs to the first
/// set), to `value`. Returns an error message, or an empty text.
std::string set_value(Node& root, std::string_view key, Node value);

/// Removes the value under the dotted `key`, or a whole section. False if there is none.
bool remove_value(Node& root, std::string_view key);

/// The dotted keys of all values and sections, "mill", "mill.speed"; "balls.2.diameter" of lists.
std::vector<std::string> keys_in(const Node& root);

}  // namespace mahlwerk::cases
