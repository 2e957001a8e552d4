// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Time of a size prediction after a run of a mill, and number of hits per second on a sample of
// grains.
#include "mahlwerk/cases/grinding.hpp"

#include <cmath>

#include "benchmarks.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/powder/sample.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int runs = 7;
constexpr double hour = 3600;

/// Seven balls in a planetary mill, a gram of a quartz-like powder of half a millimetre, 20 hours.
cases::Case planetary() {
  const cases::Catalogue catalogue(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  cases::Case mill_case = cases::read(
      std::filesystem::path(MAHLWERK_HOME) / "examples/03-planetary-mill/case.toml", catalogue, {});
  mill_case.run.engine = cases::EngineName::event;
  mill_case.run.settle = 0.5;
  mill_case.run.time = 2;
  mill_case.run.until.reset();
  mill_case.powder = cases::Powder{.material = "", .mass = 1e-3, .size = 0.5e-3, .density = 2650};
  mill_case.powder->feed = {powder::Feed::Law::rosin_rammler, 0.5e-3, 1.2};
  mill_case.capture = cases::Capture{.model = powder::Barrios{300}};
  mill_case.grinding = cases::Grinding{.breakage = powder::VogelPeukert{1, 0.1},
                                       .fragments = powder::AustinFragments{0.4, 0.8, 3},
                                       .time = 20 * hour,
                                       .smallest = 0.5e-6};
  return mill_case;
}

results::Replicate run_of(const cases::Case& mill_case) {
  campaign::ReplicateRun replica(mill_case, 0);
  while (!replica.done()) replica.run_slice();
  return replica.result();
}

Row time_prediction(const std::string& name, const cases::Case& mill_case,
                    const results::Replicate& run) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    const double began = cpu_seconds();
    const powder::SizeEvolution evolution =
        results::milling_by_balance(mill_case, results::stress_spectrum(mill_case, {&run}));
    seconds.push_back(cpu_seconds() - began);
    if (!(evolution.shares.back().back() >= 0)) return {};
  }
  return {"grinding", name, "mahlwerk", "seconds", median(seconds)};
}

Row time_sample(const std::string& name, const cases::Case& mill_case,
                const powder::AnyBreakage& breakage, const results::Replicate& run, double times) {
  powder::Process process = cases::process(mill_case);
  process.breakage = breakage;
  const powder::StressSpectrum all = results::stress_spectrum(mill_case, {&run});
  std::vector<double> rates;
  for (int i = 0; i < runs; ++i) {
    double seconds = 0, hits = 0;
    while (seconds < 0.5) {  // fresh powder each time, until its median is a fifth
      powder::Sample grains(process, all.nips, results::size_grid(mill_case),
                            mill_case.powder->feed, 10'000, static_cast<std::uint64_t>(hits) + 1);
      struct Event {
        int kind;
        double energy;
      };
      std::vector<Event> events;
      for (const auto& hit : run.stream.hits())
        if (hit.energy > 0)
          if (const int kind = grains.kind(hit.pair, hit.energy); grains.has_effect(kind))
            events.push_back({kind, hit.energy});
      const double began = cpu_seconds(), feed = median(grains.sizes());
      for (std::size_t n = 0; n % 4096 != 0 || median(grains.sizes()) > feed / 5; ++n)
        grains.hit(events[n % events.size()].kind, events[n % events.size()].energy, times);
      seconds += cpu_seconds() - began;
      hits += static_cast<double>(grains.grain_hits());
    }
    rates.push_back(hits / seconds / 1e6);
  }
  return {"grinding", name, "mahlwerk", "million_grain_hits_per_s", median(rates)};
}

}  // namespace

std::vector<Row> grinding() {
  cases::Case mill_case = planetary();
  mill_case.grinding->method = cases::Grinding::Method::both;
  mill_case.grinding->time = 1;  // grinding during the run itself is not timed
  const results::Replicate run = run_of(mill_case);
  mill_case.grinding->time = 20 * hour;
  std::vector<Row> rows{time_prediction("20 h from 2 s, beds by size", mill_case, run)};
  mill_case.grinding->bed = powder::Bed::mixed;
  rows.push_back(time_prediction("20 h from 2 s, mixed bed", mill_case, run));
  mill_case.grinding->bed = powder::Bed::by_size;
  const powder::AnyBreakage vogel = *mill_case.grinding->breakage;
  rows.push_back(
      time_sample("sample of 10 000, vogel-peukert, each collision", mill_case, vogel, run, 1));
  rows.push_back(
      time_sample("sample of 10 000, vogel-peukert, every tenth", mill_case, vogel, run, 10));
  const powder::Tavares tavares{43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03};
  rows.push_back(
      time_sample("sample of 10 000, tavares, every tenth", mill_case, tavares, run, 10));
  mill_case.grinding->breakage = tavares;
  mill_case.grinding->classes_per_octave = 3;
  rows.push_back(time_prediction("20 h from 2 s, tavares", mill_case, run));
  mill_case.grinding->classes_per_octave = 6;
  mill_case.grinding->breakage = powder::VogelPeukert{1, 0.1};
  mill_case.grinding->welding = 0.01;
  rows.push_back(time_prediction("20 h from 2 s, welding", mill_case, run));
  return rows;
}

}  // namespace mahlwerk::bench
