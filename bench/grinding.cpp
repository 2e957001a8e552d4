// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How long a prediction of sizes takes once a mill has run, and how many hits a sample of grains
// takes in a second.
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
  cases::Case what = cases::read(
      std::filesystem::path(MAHLWERK_HOME) / "examples/03-planetary-mill/case.toml", catalogue, {});
  what.run.engine = cases::EngineName::event;
  what.run.settle = 0.5;
  what.run.time = 2;
  what.run.until.reset();
  what.powder = cases::Powder{.material = "", .mass = 1e-3, .size = 0.5e-3, .density = 2650};
  what.powder->feed = {powder::Feed::Law::rosin_rammler, 0.5e-3, 1.2};
  what.capture = cases::Capture{.model = powder::Barrios{300}};
  what.grinding = cases::Grinding{.breakage = powder::VogelPeukert{1, 0.1},
                                  .fragments = powder::AustinFragments{0.4, 0.8, 3},
                                  .time = 20 * hour,
                                  .smallest = 0.5e-6};
  return what;
}

results::Replicate run_of(const cases::Case& what) {
  campaign::ReplicateRun replica(what, 0);
  while (!replica.done()) replica.run_slice();
  return replica.result();
}

Row time_prediction(const std::string& name, const cases::Case& what,
                    const results::Replicate& run) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    const double began = cpu_seconds();
    const powder::SizeEvolution evolution =
        results::milling_by_balance(what, results::stress_spectrum(what, {&run}));
    seconds.push_back(cpu_seconds() - began);
    if (!(evolution.shares.back().back() >= 0)) return {};
  }
  return {"grinding", name, "mahlwerk", "seconds", median(seconds)};
}

Row time_sample(const std::string& name, const cases::Case& what,
                const powder::AnyBreakage& breakage, const results::Replicate& run, double times) {
  powder::Process process = cases::process(what);
  process.breakage = breakage;
  const powder::StressSpectrum all = results::stress_spectrum(what, {&run});
  std::vector<double> rates;
  for (int i = 0; i < runs; ++i) {
    double seconds = 0, hits = 0;
    while (seconds < 0.5) {  // fresh powder again and again, until its median is a fifth
      powder::Sample grains(process, all.nips, results::size_grid(what), what.powder->feed, 10'000,
                            static_cast<std::uint64_t>(hits) + 1);
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
  cases::Case what = planetary();
  what.grinding->method = cases::Grinding::Method::both;
  what.grinding->time = 1;  // what the run itself grinds is not timed
  const results::Replicate run = run_of(what);
  what.grinding->time = 20 * hour;
  std::vector<Row> rows{time_prediction("20 h from 2 s, beds by size", what, run)};
  what.grinding->bed = powder::Bed::mixed;
  rows.push_back(time_prediction("20 h from 2 s, mixed bed", what, run));
  what.grinding->bed = powder::Bed::by_size;
  const powder::AnyBreakage vogel = *what.grinding->breakage;
  rows.push_back(
      time_sample("sample of 10 000, vogel-peukert, each collision", what, vogel, run, 1));
  rows.push_back(time_sample("sample of 10 000, vogel-peukert, every tenth", what, vogel, run, 10));
  const powder::Tavares tavares{43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03};
  rows.push_back(time_sample("sample of 10 000, tavares, every tenth", what, tavares, run, 10));
  what.grinding->breakage = tavares;
  what.grinding->classes_per_octave = 3;
  rows.push_back(time_prediction("20 h from 2 s, tavares", what, run));
  what.grinding->classes_per_octave = 6;
  what.grinding->breakage = powder::VogelPeukert{1, 0.1};
  what.grinding->welding = 0.01;
  rows.push_back(time_prediction("20 h from 2 s, welding", what, run));
  return rows;
}

}  // namespace mahlwerk::bench
