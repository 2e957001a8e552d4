// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/measure/draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/uncertainty.hpp"

namespace mahlwerk::commands {
namespace {

constexpr std::size_t usual_draws = 16;
constexpr double half_widths = 1 / 1.959964;  // standard deviation of a 95 % half-width of 1

/// Standard normal numbers whose mean is 0 and whose variance is 1.
std::vector<double> normal_numbers(std::size_t count, std::uint32_t stream) {
  Random random(1, stream);
  std::vector<double> made;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = std::sqrt(-2 * math::log(random.uniform()));
    made.push_back(radius * math::cos(2 * std::numbers::pi * random.uniform()));
  }
  double sum = 0, squares = 0;
  for (const double one : made) sum += one;
  for (double& one : made) {
    one -= sum / static_cast<double>(count);
    squares += one * one;
  }
  for (double& one : made) one /= std::sqrt(squares / static_cast<double>(count));
  return made;
}

/// Products of half-widths of the findings with the indices in `chosen`.
std::vector<std::vector<double>> covariance_of(const measure::Findings& found,
                                               const std::vector<std::size_t>& chosen) {
  std::vector<std::vector<double>> made(chosen.size(), std::vector<double>(chosen.size(), 0));
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      const double own = found.list[chosen[i]].value.ci95;
      if (!found.covariance.empty())
        made[i][j] = found.covariance[chosen[i] * found.list.size() + chosen[j]];
      else if (i == j)
        made[i][j] = own * own;
    }
  return made;
}

/// The lower factor of a covariance (Cholesky); rows without variance of their own are 0.
std::vector<std::vector<double>> lower_factor(std::vector<std::vector<double>> m) {
  for (std::size_t j = 0; j < m.size(); ++j) {
    for (std::size_t k = 0; k < j; ++k) m[j][j] -= m[j][k] * m[j][k];
    m[j][j] = std::sqrt(std::max(0.0, m[j][j]));
    for (std::size_t i = j + 1; i < m.size(); ++i) {
      for (std::size_t k = 0; k < j; ++k) m[i][j] -= m[i][k] * m[j][k];
      m[i][j] = m[j][j] > 0 ? m[i][j] / m[j][j] : 0;
    }
  }
  return m;
}

}  // namespace

void add_draws(const Measured& measured, cases::Case& mill_case) {
  const measure::Findings& found = measured.found;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    const measure::Finding& one = found.list[i];
    for (cases::Origin& origin : mill_case.origins)
      if (origin.key == one.key)
        origin.source =
            fmt::format("{}: {} to {}", measured.source,
                        measured_text(one.value.mean - one.value.ci95, one.value, one.unit),
                        measured_text(one.value.mean + one.value.ci95, one.value, one.unit));
    if (cases::is_key_of_draw(one.key) && one.value.ci95 > 0) chosen.push_back(i);
  }
  if (chosen.empty()) return;
  cases::Uncertainty made;
  if (mill_case.uncertainty) made = *mill_case.uncertainty;
  const std::size_t count = made.count() > 0 ? made.count() : usual_draws;
  made.source += (made.source.empty() ? "" : "; ") + measured.source;
  const auto factor = lower_factor(covariance_of(found, chosen));
  std::vector<std::vector<double>> normal;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    normal.push_back(normal_numbers(count, static_cast<std::uint32_t>(k)));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const measure::Finding& one = found.list[chosen[i]];
    cases::UncertainKey key{one.key, {}};
    for (std::size_t draw = 0; draw < count; ++draw) {
      double value = one.value.mean;
      for (std::size_t k = 0; k <= i; ++k) value += half_widths * factor[i][k] * normal[k][draw];
      if (one.key == "contact.restitution") value = std::clamp(value, 0.01, 1.0);
      key.values.push_back(measured_text(value, one.value, one.unit));
    }
    std::erase_if(made.keys, [&](const cases::UncertainKey& k) { return k.key == key.key; });
    made.keys.push_back(std::move(key));
  }
  std::ranges::sort(made.keys, {}, &cases::UncertainKey::key);
  mill_case.uncertainty = std::move(made);
}

}  // namespace mahlwerk::commands
