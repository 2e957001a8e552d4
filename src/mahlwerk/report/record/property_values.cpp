// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/property_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/report/record/ucum.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;

/// A value of a case as written: a number with or without unit, or a text.
struct WrittenValue {
  std::optional<double> number = std::nullopt;
  std::string unit = {};  ///< "1" of a pure number
  std::string text = {};  ///< without a number
};

WrittenValue written_value(std::string text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return {.text = text};
  const std::string rest = text.substr(static_cast<std::size_t>(end - text.data()));
  if (rest.empty()) return {.number = number, .unit = "1"};
  if (rest.front() != ' ' || ucum(rest.substr(1)).empty()) return {.text = text};
  return {.number = number, .unit = rest.substr(1)};
}

Json property(std::string_view id, std::string_view key, std::string_view name) {
  return Json::object(
      {{"@id", id}, {"@type", "PropertyValue"}, {"name", name}, {"propertyID", key}});
}

void add_unit(Json& entity, std::string_view unit) {
  if (const std::string code = ucum(unit); !code.empty()) entity["unitCode"] = "UCUM:" + code;
  entity["unitText"] = unit;
}

Json condition(const cases::Origin& origin) {
  const cases::KeyInfo* key = cases::find_key(origin.key);
  Json entity = property("#condition-" + origin.key, origin.key,
                         key == nullptr || key->label.empty() ? origin.key : key->label);
  const WrittenValue value = written_value(origin.value);
  entity["value"] = value.number ? Json(*value.number) : Json(value.text);
  if (value.number) add_unit(entity, value.unit);
  entity["description"] =
      fmt::format("{}{}Source: {}{}", key == nullptr ? "" : key->about, key == nullptr ? "" : ". ",
                  origin.assumed ? "assumed, not measured; " : "", origin.source);
  return entity;
}

std::optional<double> finite_number(const Json& of, std::string_view name) {
  const Json* found = of.find(name);
  if (found == nullptr) return std::nullopt;
  if (const auto* real = std::get_if<double>(&found->value())) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&found->value()))
    return static_cast<double>(*whole);
  if (const auto* count = std::get_if<std::uint64_t>(&found->value()))
    return static_cast<double>(*count);
  return std::nullopt;
}

std::string text_of_member(const Json& of, std::string_view name) {
  const Json* found = of.find(name);
  const auto* text = found == nullptr ? nullptr : std::get_if<std::string>(&found->value());
  return text == nullptr ? "" : *text;
}

/// Adds the interval, cut at the range of the quantity.
void add_interval(Json& entity, const Json& quantity, double value) {
  const auto over_replicates = finite_number(quantity, "ci95");
  const auto half = over_replicates ? over_replicates : finite_number(quantity, "ci95_time");
  if (!half) return;
  const double least = finite_number(quantity, "least").value_or(-INFINITY),
               most = finite_number(quantity, "most").value_or(INFINITY);
  entity["minValue"] = std::max(value - *half, std::min(least, value));
  entity["maxValue"] = std::min(value + *half, std::max(most, value));
  entity["measurementTechnique"] =
      fmt::format("Simulation; minValue to maxValue is the 95 % confidence interval over {}",
                  over_replicates ? "replicates (Student's t)" : "time (batch means)");
}

/// Without a value: null.
Json result(const std::string& name, const Json& quantity) {
  const auto value = finite_number(quantity, "value");
  if (!value) return {};
  Json entity = property("#result-" + name, name, text_of_member(quantity, "label"));
  entity["value"] = *value;
  add_unit(entity, text_of_member(quantity, "unit"));
  add_interval(entity, quantity, *value);
  entity["description"] = text_of_member(quantity, "about");
  return entity;
}

/// The names of quantities, the key quantities first.
std::vector<std::string> ordered_names(const Json& summary) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  const Json* keys = summary.find("_key_quantities");
  if (keys != nullptr && std::holds_alternative<Json::Array>(keys->value()))
    for (const Json& one : std::get<Json::Array>(keys->value()))
      if (const auto* name = std::get_if<std::string>(&one.value())) add(*name);
  if (const auto* members = std::get_if<Json::Object>(&summary.value()))
    for (const Json::Member& one : *members)
      if (!one.key.starts_with('_')) add(one.key);
  return names;
}

}  // namespace

std::vector<Json> condition_values(const cases::Case& c) {
  std::vector<Json> values;
  for (const cases::Origin& origin : c.origins)
    if (origin.key != "jar.volume") values.push_back(condition(origin));
  Json volume = property("#condition-jar.volume", "jar.volume", "jar volume");
  constexpr double ml_per_m3 = 1e6;
  volume["value"] = ml_per_m3 * geometry::volume(*c.jar.shape);
  add_unit(volume, "ml");
  volume["description"] = "volume of the jar. Source: follows from its shape";
  values.push_back(std::move(volume));
  return values;
}

std::vector<Json> result_values(const Json& summary) {
  std::vector<Json> values;
  for (const std::string& name : ordered_names(summary)) {
    const Json* quantity = summary.find(name);
    if (quantity == nullptr) continue;
    Json made = result(name, *quantity);
    if (!std::holds_alternative<std::nullptr_t>(made.value())) values.push_back(std::move(made));
  }
  return values;
}

}  // namespace mahlwerk::report
