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

/// A value of JSON, to be put together and written. It is light: the library that writes it, whose
/// header takes seconds to compile, is read by one file.
class Json {
 public:
  struct Member;  ///< of an object: {"key", value}
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
  Json(char) = delete;         // a text or a number?
  Json(const void*) = delete;  // would be a bool

  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  static Json array(std::initializer_list<Json> values = {});
  /// In this order; every key once.
  static Json object(std::initializer_list<Member> members = {});

  /// The value of a key, which is added if there is none. Null becomes an object; of anything else
  /// this throws std::bad_variant_access.
  Json& operator[](std::string_view key);
  /// To an array. Null becomes one; of anything else this throws std::bad_variant_access.
  void push_back(Json value);
  Json& back();  ///< of an array that is not empty

  const Value& value() const { return value_; }

  /// In one line, or, where `indent` is not negative, a line for each value. Bytes that are not
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
