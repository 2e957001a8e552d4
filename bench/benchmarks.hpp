// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

// The benchmarks: one row and one file each. Times are CPU times, medians of several runs; where
// Mahlwerk stands beside other programs, one clock measures all of them: CPU time in `fluid` and
// `few`, wall time in `crowd`, which also uses two cores.
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
std::vector<Row> bodies();
std::vector<Row> breakage();
std::vector<Row> few();
std::vector<Row> crowd();
inline std::vector<Row> beside_peers() {
  std::vector<Row> rows = few();
  const std::vector<Row> more = crowd();
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}
std::vector<Row> cost_curve();
std::vector<Row> card();
std::vector<Row> mixing();
std::vector<Row> mesh();
std::vector<Row> observers();
std::vector<Row> grinding();
std::vector<Row> campaign();
std::vector<Row> whole_examples();

/// bench/help.txt says what each measures.
struct Benchmark {
  std::string_view name;
  std::vector<Row> (*run)();
  bool only_by_name = false;  ///< too long to run with all the others
};

inline constexpr std::array benchmarks{Benchmark{"one-ball", one_ball},
                                       Benchmark{"fluid", fluid},
                                       Benchmark{"event", event},
                                       Benchmark{"soft", soft},
                                       Benchmark{"bodies", bodies},
                                       Benchmark{"breakage", breakage, true},
                                       Benchmark{"mesh", mesh, true},
                                       Benchmark{"observers", observers},
                                       Benchmark{"grinding", grinding},
                                       Benchmark{"campaign", campaign, true},
                                       Benchmark{"peers", beside_peers},
                                       Benchmark{"few", few, true},
                                       Benchmark{"crowd", crowd, true},
                                       Benchmark{"cost-curve", cost_curve},
                                       Benchmark{"card", card, true},
                                       Benchmark{"mixing", mixing, true},
                                       Benchmark{"examples", whole_examples, true}};

double cpu_seconds();
double median(std::vector<double> values);

}  // namespace mahlwerk::bench
