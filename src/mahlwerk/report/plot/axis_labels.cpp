// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/axis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mahlwerk::report {
namespace {

struct Named {
  std::string_view name, words, symbol;
  std::string_view unit = "";  // of values without unit
};

/// Keys whose last word alone is ambiguous, or that have a symbol.
constexpr std::array keys{Named{"mill.frequency", "vibration frequency", "$f$"},
                          Named{"mill.amplitude", "vibration amplitude", "$A$"},
                          Named{"mill.speed", "speed of the mill", "$ω$"},
                          Named{"mill.ratio", "speed ratio", "$k$", "–"},
                          Named{"jar.diameter", "jar diameter", "$D$"},
                          Named{"balls.diameter", "ball diameter", "$d$"},
                          Named{"balls.count", "number of balls", "$N$", "–"},
                          Named{"balls.filling", "solid filling of balls", ""},
                          Named{"balls.bulk_filling", "bulk filling of balls", "$J$"},
                          Named{"powder.void_filling", "powder filling of the voids", "$U$"},
                          Named{"powder.filling", "powder filling", ""},
                          Named{"contact.friction", "friction coefficient", "$µ$", "–"},
                          Named{"contact.rolling_friction", "rolling friction", "$µ_{r}$", "–"},
                          Named{"contact.restitution", "coefficient of restitution", "$e$", "–"},
                          Named{"breakage.f_mat", "", "$f_{Mat}$"},
                          Named{"breakage.x_w_min", "", "$xW_{m,min}$"},
                          Named{"run.time", "simulated time", "$t$"},
                          Named{"grinding.time", "milling time", "$t$"}};

template <class List>
Named entry(const List& list, std::string_view name) {
  const auto at = std::ranges::find(list, name, &Named::name);
  return at == list.end() ? Named{} : *at;
}

std::string axis_text(std::string words, std::string_view symbol, std::string_view unit) {
  if (!symbol.empty()) words += fmt::format(", {}", symbol);
  return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

}  // namespace

std::string symbol_of_quantity(std::string_view quantity) {
  return std::string(results::traits_of(quantity).symbol);
}

std::string symbol_of_key(std::string_view key) {
  return std::string(entry(keys, key).symbol);
}

std::string quantity_axis(std::string_view quantity, const Multiple& m) {
  std::string unit = m.unit == "1" ? "–" : m.unit == "deg" ? "°" : m.unit == "degC" ? "°C" : m.unit;
  if (unit == "m2/kg") unit = "m²/kg";
  return axis_text(label(quantity), symbol_of_quantity(quantity), unit);
}

std::string key_axis(std::string_view key, std::string_view unit) {
  const Named known = entry(keys, key);
  std::string words(known.words);
  if (words.empty()) {
    words = key.substr(key.rfind('.') + 1);
    std::ranges::replace(words, '_', ' ');
  }
  return axis_text(std::move(words), known.symbol, unit.empty() ? known.unit : unit);
}

}  // namespace mahlwerk::report
