// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Cost of the observers: each run once as a bare engine without observers, once as a replicate with
// all of them, in turn.
#include <fmt/format.h>

#include "benchmarks.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::bench {
namespace {

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

struct Example {
  std::string_view name, folder;
  double time;  // [s] simulated, long enough to be timed
};
constexpr Example examples[] = {
    {"one ball, lasting contacts roll, event engine", "01-one-ball", 3000},
    {"one ball, TC rule, event engine", "01-one-ball", 3000},
    {"7 balls in a planetary mill, event engine", "03-planetary-mill", 60},
    {"200 balls in a drum, event engine", "04-tumbling-drum", 2},
    {"5 balls in a planetary mill, soft engine", "05-planetary-soft", 3},
    {"powder as grains, soft engine", "06-powder-as-grains", 0.1},
};
constexpr int runs = 7;

double bare(const cases::Case& mill_case) {
  const double began = cpu_seconds();
  const auto engine = campaign::engine(mill_case, 0);
  NullObserver observer;
  engine->advance(mill_case.run.time, observer);
  return cpu_seconds() - began;
}

double observed(const cases::Case& mill_case, std::int64_t& collisions) {
  const double began = cpu_seconds();
  campaign::ReplicateRun replica(mill_case, 0);
  while (!replica.done()) replica.run_slice();
  const double spent = cpu_seconds() - began;
  collisions = replica.energy_balance().collisions;
  return spent;
}

}  // namespace

std::vector<Row> observers() {
  std::vector<Row> rows;
  const cases::Catalogue catalogue(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  for (const Example& e : examples) {
    const auto file = std::filesystem::path(MAHLWERK_HOME) / "examples" / e.folder / "case.toml";
    cases::Case mill_case = cases::read(file, catalogue, {});
    mill_case.run.settle = 0;
    mill_case.run.time = e.time;
    if (mill_case.run.engine == cases::EngineName::automatic)
      mill_case.run.engine = cases::EngineName::event;
    if (e.name.find("TC") != std::string_view::npos) {
      mill_case.contact.lasting = cases::SustainedContactModel::tc;
      mill_case.contact.contact_time = 1e-4;
    }
    std::int64_t collisions = 0;
    std::vector<double> costs, shares;
    for (int i = 0; i < runs; ++i) {
      const double without = bare(mill_case), with = observed(mill_case, collisions);
      shares.push_back(with / without - 1);
      costs.push_back((with - without) / static_cast<double>(collisions) * 1e9);
    }
    const std::string name(e.name);
    rows.push_back({"observers", name, "mahlwerk", "share_of_the_run's_time", median(shares)});
    rows.push_back({"observers", name, "mahlwerk", "ns_per_collision", median(costs)});
  }
  return rows;
}

}  // namespace mahlwerk::bench
