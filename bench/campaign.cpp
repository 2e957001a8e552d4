// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Overhead of campaigns beside their runs: those of Chen et al. 2016, a large one, one with few
// balls, and the store alone.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "benchmarks.hpp"
#include "child.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;

constexpr int runs = 5;
double share_of_cores(const Timing& t) {
  return t.cpu / t.wall / std::thread::hardware_concurrency();
}

/// Figures 4, 5 and 6: 15 settings, five runs of a minute each.
void vibration_mill(std::vector<Row>& rows) {
  for (const std::string kept : {"all", "summary"}) {
    std::vector<double> walls;
    for (int i = 0; i < runs; ++i) {
      const TemporaryFolder folder;
      double wall = 0;
      for (const std::string figure : {"diameter", "amplitude", "frequency"})
        wall +=
            time_mahlwerk(
                {"sweep",
                 (fs::path(MAHLWERK_HOME) / "papers/vertical-vibration-mill" / (figure + ".toml"))
                     .string(),
                 "--out", (folder.path() / figure).string(), "--quiet", "--results", kept},
                folder.path())
                .wall;
      walls.push_back(wall);
    }
    rows.push_back({"campaign", "Chen et al. 2016, figures 4 to 6, keeps " + kept, "mahlwerk",
                    "seconds", median(walls)});
  }
}

constexpr const char* tiny = R"(
title = "Many runs"
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
[run]
engine = "event"
time = "0.1 s"
replicates = 1
[sweep]
"mill.frequency" = {{ from = "10 Hz", to = "20 Hz", steps = {} }}
)";

/// Large campaigns of one-ball runs: memory must not grow with the number of runs.
void large(std::vector<Row>& rows) {
  for (const int points : {1000, 10'000, 100'000}) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "case.toml") << fmt::format(tiny, points);
    const Timing took = time_mahlwerk(
        {"sweep", "case.toml", "--out", "out", "--quiet", "--results", "summary"}, folder.path());
    const std::string what = fmt::format("{} one-ball runs of 0.1 s", points);
    rows.push_back({"campaign", what, "mahlwerk", "peak MB", took.memory});
    rows.push_back({"campaign", what, "mahlwerk", "ms of a core a run", 1e3 * took.cpu / points});
    rows.push_back(
        {"campaign", what, "mahlwerk", "share of the cores' time", share_of_cores(took)});
    rows.push_back(
        {"campaign", what, "mahlwerk", "store, kB a run",
         static_cast<double>(fs::file_size(folder.path() / "out/campaign.sqlite")) / 1e3 / points});
  }
}

/// The five balls of Mhadhbi 2021 at several speeds.
void few_balls(std::vector<Row>& rows) {
  std::vector<double> shares, walls;
  for (int i = 0; i < 3; ++i) {
    const TemporaryFolder folder;
    const Timing took = time_mahlwerk(
        {"sweep", (fs::path(MAHLWERK_HOME) / "papers/planetary-mill/speed.toml").string(), "--out",
         "out", "--quiet"},
        folder.path());
    shares.push_back(share_of_cores(took));
    walls.push_back(took.wall);
  }
  rows.push_back({"campaign", "Mhadhbi 2021, five balls by speed", "mahlwerk",
                  "share of the cores' time", median(shares)});
  rows.push_back(
      {"campaign", "Mhadhbi 2021, five balls by speed", "mahlwerk", "seconds", median(walls)});
}

/// Cost of a run in the store: its row with a hundred quantities, as one transaction.
void store(std::vector<Row>& rows) {
  constexpr std::size_t points = 2000;
  const TemporaryFolder folder;
  campaign::Store store(folder.path() / "campaign.sqlite", campaign::Store::Access::write);
  campaign::CampaignPlan planned;
  planned.keys = {"mill.speed"};
  for (std::size_t i = 0; i < points; ++i) planned.runs.push_back(i + 1);
  planned.values = [](std::size_t i) { return std::vector<std::string>{fmt::format("{} rpm", i)}; };
  store.plan(planned);
  campaign::RunRecord finished;
  finished.resolved = std::string(4000, 'x');
  for (int i = 0; i < 100; ++i)
    finished.quantities.push_back({fmt::format("quantity_{}", i), 1.0 * i, 0.1, "J", "about"});
  std::vector<double> times;
  for (std::size_t i = 0; i < points; ++i) {
    finished.hash = i + 1;
    const auto began = std::chrono::steady_clock::now();
    store.keep(finished);
    times.push_back(
        1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }
  rows.push_back({"campaign", "store, a run of 100 quantities", "mahlwerk", "ms", median(times)});
}

}  // namespace

std::vector<Row> campaign() {
  std::vector<Row> rows;
  store(rows);
  vibration_mill(rows);
  few_balls(rows);
  large(rows);
  return rows;
}

}  // namespace mahlwerk::bench
