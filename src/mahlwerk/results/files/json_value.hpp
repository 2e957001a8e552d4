// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mahlwerk::results {

/// A JSON value to build and write. Only one source file includes the JSON library, whose header
/// takes seconds to compile.
class Json {
 public:
  struct Member;  ///< member of an object: {"key", value}
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string,
                             Array, Object>;

  Json();  ///< null
  Json(std::nullptr_t);
  Json(bool truth);
  Json(int number);
  Json(long number);
  Json(long long number);
  Json(unsigned number);
  Json(unsigned long number);
  Json(unsigned long long number);
  Json(double number);  ///< written as null if it is not finite
  Json(const char* text);
  Json(std::string_view text);
  Json(std::string text);
  template <class T>
  Json(const std::vector<T>& list) : Json(array()) {
    for (const T& one : list) push_back(one);
  }
  Json(char) = delete;         // ambiguous: a text or a number
  Json(const void*) = delete;  // would convert to bool

  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  static Json array(std::initializer_list<Json> values = {});
  /// An object with its members in this order; each key once.
  static Json object(std::initializer_list<Member> members = {});

  /// Reads a text. Throws std::invalid_argument, with the place and the cause, if it is not JSON.
  static Json parse(std::string_view text);

  /// The value of a key of an object. A missing key is added; null becomes an object. Throws
  /// std::bad_variant_access for any other value.
  Json& operator[](std::string_view key);
  /// Appends to an array. Null becomes an array. Throws std::bad_variant_access for any other
  /// value.
  void push_back(Json value);
  Json& back();  ///< last value of a non-empty array

  const Value& value() const { return value_; }
  /// The value of a key, or null if this is no object or has no such key.
  const Json* find(std::string_view key) const;

  /// The text in one line, or with a line for each value if `indent` >= 0. Bytes that are not valid
  /// UTF-8 are replaced.
  std::string text(int indent = -1) const;

 private:
  Value value_;
};

struct Json::Member {
  std::string key;
  Json value;
};

}  // namespace mahlwerk::results
