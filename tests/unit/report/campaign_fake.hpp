// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"

// Artificial campaigns with numbers from formulas.
namespace mahlwerk::report {

inline std::vector<Column> fake_columns() {
  return {{"d50", "m", "size of the median grain"}, {"dissipated_power", "W", "of all contacts"}};
}

/// A point of a mill with `speed` [rpm] and balls of `diameter` [mm].
inline void fill(Point& p, double speed, double diameter) {
  const double size = 8e-6 * std::pow(speed / 300, -0.6), power = 12 * std::pow(speed / 300, 3);
  p.value = {size, power * diameter / 10};
  p.ci95 = {0.03 * size, 0.02 * power};
  p.regime = speed * diameter < 2500 ? "cascading" : "cataracting";
}

/// A campaign over speeds from 150 rpm in steps of 50 rpm.
inline Campaign speeds(int number) {
  Campaign c{.title = "Speeds", .keys = {{"mill.speed", "rpm"}}, .columns = fake_columns()};
  for (int i = 0; i < number; ++i) {
    const int speed = 150 + 50 * i;
    Point p{.number = c.points.size() + 1,
            .values = {fmt::format("{} rpm", speed)},
            .folder = fmt::format("point-{:03}", i + 1)};
    fill(p, speed, 10);
    c.points.push_back(std::move(p));
  }
  return c;
}

/// All combinations of the speeds with diameters from 5 mm in steps of 2 mm.
inline Campaign grid(int speeds, int diameters) {
  Campaign c{.title = "Grid",
             .keys = {{"mill.speed", "rpm"}, {"balls.1.diameter", "mm"}},
             .columns = fake_columns()};
  for (int i = 0; i < speeds; ++i)
    for (int j = 0; j < diameters; ++j) {
      const int speed = 150 + 50 * i, diameter = 5 + 2 * j;
      Point p{.number = c.points.size() + 1,
              .values = {fmt::format("{} rpm", speed), fmt::format("{} mm", diameter)}};
      fill(p, speed, diameter);
      c.points.push_back(std::move(p));
    }
  return c;
}

/// Random points in the ranges of three keys.
inline Campaign scattered(int number) {
  Campaign c{.title = "Scattered",
             .keys = {{"mill.speed", "rpm"}, {"balls.1.diameter", "mm"}, {"contact.friction", ""}},
             .columns = fake_columns()};
  Random random(5, 0);
  for (int i = 0; i < number; ++i) {
    const double speed = random.uniform(150, 550), diameter = random.uniform(5, 15);
    Point p{.number = c.points.size() + 1,
            .values = {fmt::format("{:.6g} rpm", speed), fmt::format("{:.6g} mm", diameter),
                       fmt::format("{:.6g}", random.uniform(0.1, 0.9))}};
    fill(p, speed, diameter);
    c.points.push_back(std::move(p));
  }
  return c;
}

inline void fail(Point& p, std::string why) {
  p.value.clear();
  p.ci95.clear();
  p.regime.clear();
  p.folder.clear();
  p.failure = std::move(why);
}

}  // namespace mahlwerk::report
