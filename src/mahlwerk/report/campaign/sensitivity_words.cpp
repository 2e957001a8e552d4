// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/report/campaign/plots.hpp"

namespace mahlwerk::report {
namespace {

using Names = std::vector<std::string>;

bool is_significant(const Effect& e) {
  return e.significant.value_or(false);
}

bool is_insignificant(const Effect& e) {
  return !e.significant.value_or(true);
}

std::string how_much(const Effect& e, const Sensitivity& s) {
  const double size = magnitude(e, s);
  if (s.design == Design::sobol_indices)
    return fmt::format("{} of the variance, with interactions",
                       readable(size, e.total.half_width(), "").text());
  if (s.design == Design::morris)
    return fmt::format("on average {} over its range",
                       readable(size, e.mean_absolute.half_width(), s.unit).text());
  return fmt::format("changes it by {} over its range", readable(size, NAN, s.unit).text());
}

/// The key that matters most. A key whose effect is not significant is not said to matter.
std::string foremost(const Effect& largest, const Effect* significant, const Sensitivity& s) {
  if (significant && significant != &largest)
    return fmt::format(
        "of the effects that differ significantly from zero, that of {} is the largest ({}).",
        significant->key, how_much(*significant, s));
  if (is_insignificant(largest))
    return fmt::format(
        "the largest effect, that of {} ({}), does not differ significantly from zero.",
        largest.key, how_much(largest, s));
  return fmt::format("{} matters most ({}).", largest.key, how_much(largest, s));
}

/// A quantity without variance to attribute to keys.
std::string without_variance(const Sensitivity& s) {
  if (!(s.noise > 0)) return "is the same at all points.";
  return "does not vary more than the errors of its points: more replicates or points are needed.";
}

}  // namespace

std::string joined(const Names& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

Names inactive_keys(const std::vector<Sensitivity>& sensitivities) {
  Names keys;
  if (sensitivities.empty()) return keys;
  for (const Effect& e : sensitivities.front().effects) {
    const bool always = std::ranges::all_of(sensitivities, [&](const Sensitivity& s) {
      const auto same = std::ranges::find(s.effects, e.key, &Effect::key);
      return same != s.effects.end() && same->inactive;
    });
    if (always) keys.push_back(e.key);
  }
  return keys;
}

std::string sensitivity_words(const Sensitivity& s, const Names& inactive) {
  const std::string name = label(s.quantity) + ": ";
  if (s.variance <= 0) return name + without_variance(s);
  const std::vector<Effect> effects = largest_first(s);
  if (effects.empty() || !std::isfinite(magnitude(effects.front(), s))) return "";
  if (std::ranges::all_of(effects, is_insignificant))
    return name + "no key has an effect that differs significantly from zero.";
  const auto first = std::ranges::find_if(effects, is_significant);
  const Effect* significant = first == effects.end() ? nullptr : &*first;
  std::string text = name + foremost(effects.front(), significant, s);
  Names larger, none;
  for (const Effect& e : effects) {
    if (significant && magnitude(e, s) > magnitude(*significant, s))
      larger.push_back(e.key);
    else if (is_insignificant(e) && (significant || &e != &effects.front()) &&
             std::ranges::find(inactive, e.key) == inactive.end())
      none.push_back(e.key);
  }
  if (!larger.empty())
    text += fmt::format(" Larger, but not significant: that of {}.", joined(larger));
  if (!none.empty()) text += fmt::format(" Not significant: the effect of {}.", joined(none));
  return text;
}

}  // namespace mahlwerk::report
