// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

// The benchmarks: a row each, a file each. All times are CPU times of this process, medians of
// several runs.
namespace mahlwerk::bench {

struct Row {
  std::string benchmark, what, code, metric;
  double value = 0;
};

std::vector<Row> one_ball();
std::vector<Row> fluid();
std::vector<Row> event();

struct Benchmark {
  std::string_view name, about;
  std::vector<Row> (*run)();
};

inline constexpr std::array benchmarks{
    Benchmark{"one-ball", "one ball in paper A's vibrating vial, event engine", one_ball},
    Benchmark{"fluid", "elastic periodic fluid, 1000 to 97 336 balls, event engine", fluid},
    Benchmark{"event", "many balls in a shaken box with spin, friction and gravity", event},
};

double cpu_seconds();
double median(std::vector<double> values);

}  // namespace mahlwerk::bench
