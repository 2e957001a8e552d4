// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

// The benchmarks: one row and one file each. All times are CPU times of this process, medians of
// several runs. Times of other programs are those that they report themselves, except in `fluid`,
// which measures their CPU time.
namespace mahlwerk::bench {

struct Row {
  std::string benchmark, what, code, metric;
  double value = 0;
  double least = NAN, most = NAN;  ///< range over the runs that `value` summarises, if reported
};

std::vector<Row> one_ball();
std::vector<Row> fluid();
std::vector<Row> event();
std::vector<Row> soft();
std::vector<Row> few();
std::vector<Row> crowd();
inline std::vector<Row> beside_peers() {
  std::vector<Row> rows = few();
  const std::vector<Row> more = crowd();
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}
std::vector<Row> cost_curve();
std::vector<Row> mixing();
std::vector<Row> observers();
std::vector<Row> grinding();
std::vector<Row> campaign();

struct Benchmark {
  std::string_view name, about;
  std::vector<Row> (*run)();
  bool only_by_name = false;  ///< too long to run with all the others
};

inline constexpr std::array benchmarks{
    Benchmark{"one-ball", "one ball in paper A's vibrating vial, event engine", one_ball},
    Benchmark{"fluid",
              "elastic periodic fluid, 1000 to 97 336 balls, event engine; beside the program that "
              "MAHLWERK_RIVAL names (bench/rival.hpp)",
              fluid},
    Benchmark{"event", "many balls in a shaken box with spin, friction and gravity", event},
    Benchmark{"soft",
              "soft engine: every contact law in a planetary mill, free-flight skip in a vial",
              soft},
    Benchmark{"observers", "cost of all observers, compared with bare engines", observers},
    Benchmark{"grinding", "sizes after 20 hours from 2 s of a run; hits on a sample of grains",
              grinding},
    Benchmark{"campaign", "campaigns: paper A's, the store, use of cores, 100 000 runs; minutes",
              campaign, true},
    Benchmark{"peers",
              "comparison with LAMMPS, LIGGGHTS, YADE: few and crowd; a quarter of an hour",
              beside_peers},
    Benchmark{"few", "part of peers: five balls in a planetary mill; minutes", few, true},
    Benchmark{"crowd",
              "part of peers: drums of 10 000 and 100 000 balls, five balls in powder; minutes",
              crowd, true},
    Benchmark{"cost-curve", "drums of 10 000 to 1 000 000 balls, time and memory; minutes",
              cost_curve},
    Benchmark{"mixing", "two layers of grains in a drum, case 2 of Dosta et al. 2024; half an hour",
              mixing, true},
};

double cpu_seconds();
double median(std::vector<double> values);

}  // namespace mahlwerk::bench
