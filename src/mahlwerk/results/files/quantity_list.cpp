// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/quantity_list.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/text.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {
namespace {

/// Which cases have it, in words; empty for every case.
std::string only_of(const Measure& m) {
  std::string text(m.group_only);
  if (!text.empty() && !m.traits.only.empty()) text += ", ";
  return text + std::string(m.traits.only);
}

std::string range_in_words(const Measure& m) {
  const Range range = range_of(m.name);
  const std::string unit = m.unit == "1" ? "" : " " + m.unit;
  if (std::isinf(range.least)) return "any value";
  if (std::isinf(range.most)) return fmt::format("from {:g}{}", range.least, unit);
  return fmt::format("{:g} to {:g}{}", range.least, range.most, unit);
}

Json object_of(const Measure& m) {
  const QuantityTraits& shown = traits_of(m.name);
  return Json::object({{"name", m.name},
                       {"unit", m.unit},
                       {"about", m.about},
                       {"label", label_of(m.name)},
                       {"symbol", shown.symbol},
                       {"least", shown.range.least},
                       {"most", shown.range.most},
                       {"heading", m.traits.heading},
                       {"equation", m.traits.equation},
                       {"only", only_of(m)},
                       {"series", m.traits.over_time != nullptr}});
}

}  // namespace

Json quantity_list() {
  Json list = Json::array();
  for (const Measures* some : {&all_measures(), &measures_of_whole()})
    for (const Measure& m : *some) list.push_back(object_of(m));
  return list;
}

Json quantity_record(std::string_view name) {
  const Measure* m = record_of(name);
  return m == nullptr ? Json() : object_of(*m);
}

std::string quantity_index(std::string_view word) {
  std::string text, shown;
  std::string_view heading;
  for (const Measures* some : {&all_measures(), &measures_of_whole()})
    for (const Measure& m : *some) {
      if (!m.traits.heading.empty()) heading = m.traits.heading;
      if (!contains_word(fmt::format("{}\n{}\n{}\n{}", m.name, label_of(m.name), m.about, heading),
                         word))
        continue;
      if (heading != shown) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading);
      shown = heading;
      text += fmt::format("  {:<46} {:<8} {}\n", m.name, m.unit, m.about);
    }
  return text;
}

std::string quantity_in_words(std::string_view name) {
  const Measure* m = record_of(name);
  if (m == nullptr) return "";
  const std::string only = only_of(*m);
  return fmt::format("{} ({}): {}\n  {}{}{}\n", label_of(name), name, range_in_words(*m), m->about,
                     m->traits.equation.empty() ? "" : fmt::format(" ({})", m->traits.equation),
                     only.empty() ? "" : fmt::format("\n  {}", only));
}

}  // namespace mahlwerk::results
