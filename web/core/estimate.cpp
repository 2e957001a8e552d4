// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "estimate.hpp"

#include <string>
#include <variant>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/reference/estimate_text.hpp"
#include "session.hpp"

namespace mahlwerk::web {
namespace {

using results::Json;

/// The text of a key; empty if there is none.
std::string text_of(const Json& given, std::string_view key) {
  const Json* found = given.find(key);
  return found == nullptr ? "" : std::get<std::string>(found->value());
}

commands::EstimateWords words_of(const Json& given) {
  commands::EstimateWords words{.mill = text_of(given, "mill"),
                                .jar = text_of(given, "jar"),
                                .material = text_of(given, "material"),
                                .frequency = text_of(given, "frequency"),
                                .speed = text_of(given, "speed"),
                                .powder = text_of(given, "powder"),
                                .time = text_of(given, "time")};
  if (const Json* balls = given.find("balls"))
    for (const Json& one : std::get<Json::Array>(balls->value()))
      words.balls.push_back(std::get<std::string>(one.value()));
  return words;
}

}  // namespace

Json estimate(std::string_view words) {
  std::string cited;  // the text that was read last
  const auto read = [&](const std::string& text) {
    cited = text;
    return read_case(text, {});
  };
  try {
    const commands::EstimateWords given = words_of(Json::parse(words));
    Json made = faults_json({});
    made["text"] = commands::saved_estimate(commands::estimate_text(given, catalogue(), read));
    return made;
  } catch (const InputError& e) {
    Json made = faults_json(e.faults());
    made["text"] = cited;
    return made;
  }
}

}  // namespace mahlwerk::web
