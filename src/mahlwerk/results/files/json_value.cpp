// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/json_value.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace mahlwerk::results {
namespace {

using NlohmannJson = nlohmann::ordered_json;

/// The text of a value that is no list.
template <class Value>
std::string scalar_text(const Value& value) {
  return NlohmannJson(value).dump(-1, ' ', false, NlohmannJson::error_handler_t::replace);
}

/// Begins a line in pretty text.
void new_line(std::string& text, int indent, int level) {
  if (indent < 0) return;
  text += '\n';
  text.append(static_cast<std::size_t>(indent) * static_cast<std::size_t>(level), ' ');
}

void append(const Json& json, int indent, int level, std::string& text);

/// Appends a list between its brackets; `one` appends an element.
template <class List, class AppendOne>
void append_list(const List& list, std::string_view brackets, int indent, int level,
                 std::string& text, const AppendOne& one) {
  text += brackets.front();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += ',';
    new_line(text, indent, level + 1);
    one(list[i]);
  }
  if (!list.empty()) new_line(text, indent, level);
  text += brackets.back();
}

/// Appends a value. Lists are not given to the JSON library: it allocates while it destroys them,
/// and without memory that would end the program.
void append(const Json& json, int indent, int level, std::string& text) {
  const auto write = [&](const auto& value) {
    using Kind = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Kind, Json::Array>)
      append_list(value, "[]", indent, level, text,
                  [&](const Json& one) { append(one, indent, level + 1, text); });
    else if constexpr (std::is_same_v<Kind, Json::Object>)
      append_list(value, "{}", indent, level, text, [&](const Json::Member& one) {
        text += scalar_text(one.key) + (indent < 0 ? ":" : ": ");
        append(one.value, indent, level + 1, text);
      });
    else
      text += scalar_text(value);
  };
  std::visit(write, json.value());
}

Json from_nlohmann(const NlohmannJson& json) {
  if (json.is_object()) {
    Json made = Json::object();
    for (const auto& [key, value] : json.items()) made[key] = from_nlohmann(value);
    return made;
  }
  if (json.is_array()) {
    Json made = Json::array();
    for (const auto& value : json) made.push_back(from_nlohmann(value));
    return made;
  }
  if (json.is_string()) return json.get<std::string>();
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_float()) return json.get<double>();
  if (json.is_number_unsigned()) return json.get<std::uint64_t>();
  if (json.is_number()) return json.get<std::int64_t>();
  return nullptr;
}

}  // namespace

Json Json::parse(std::string_view text) {
  try {
    const auto shallow = [](int depth, NlohmannJson::parse_event_t, NlohmannJson&) {
      constexpr int deepest = 100;  // values are read by recursion
      if (depth > deepest) throw std::invalid_argument("the values are nested too deeply");
      return true;
    };
    return from_nlohmann(NlohmannJson::parse(text, shallow));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

const Json* Json::find(std::string_view key) const {
  const Object* members = std::get_if<Object>(&value_);
  if (members == nullptr) return nullptr;
  const auto there = std::ranges::find(*members, key, &Member::key);
  return there == members->end() ? nullptr : &there->value;
}

Json::Json() : value_(nullptr) {}
Json::Json(std::nullptr_t) : value_(nullptr) {}
Json::Json(bool truth) : value_(truth) {}
Json::Json(int number) : value_(std::int64_t{number}) {}
Json::Json(long number) : value_(std::int64_t{number}) {}
Json::Json(long long number) : value_(std::int64_t{number}) {}
Json::Json(unsigned number) : value_(std::uint64_t{number}) {}
Json::Json(unsigned long number) : value_(std::uint64_t{number}) {}
Json::Json(unsigned long long number) : value_(std::uint64_t{number}) {}
Json::Json(double number) : value_(number) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}

/// By assignment. In libstdc++ 12 the copy constructor of a variant that a vector may be in
/// destroys a value that does not exist if the copy throws (std::bad_alloc).
Json::Json(const Json& other) : Json() {
  value_ = other.value_;
}
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json Json::array(std::initializer_list<Json> values) {
  Json made;
  made.value_ = Array(values);
  return made;
}

Json Json::object(std::initializer_list<Member> members) {
  Json made;
  made.value_ = Object(members);
  return made;
}

Json& Json::operator[](std::string_view key) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Object();
  Object& members = std::get<Object>(value_);
  const auto there = std::ranges::find(members, key, &Member::key);
  if (there != members.end()) return there->value;
  members.push_back({std::string(key), Json()});
  return members.back().value;
}

void Json::push_back(Json value) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Array();
  std::get<Array>(value_).push_back(std::move(value));
}

Json& Json::back() {
  return std::get<Array>(value_).back();
}

std::string Json::text(int indent) const {
  std::string made;
  append(*this, indent, 0, made);
  return made;
}

}  // namespace mahlwerk::results
