// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/wear/wear_evolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/wear/wear_step.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/geometry/worn_section.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

WearNumber number(const results::Outcome& outcome, std::string_view name) {
  for (const results::Quantity& q : outcome.summary.quantities)
    if (q.name == name) return {q.value, q.half_width()};
  return {unknown, unknown};
}

void take_spectrum(const results::Outcome& outcome, WearStage& stage) {
  const results::MeanSpectra spectra = results::mean_spectra(outcome);
  const auto part = &observe::Spectra::energy_normal;
  const auto [first, end] = spectra.filled_bins({part});
  for (int bin = first; bin < end; ++bin) {
    stage.spectrum_energies.push_back(observe::LogHistogram::lower(bin));
    stage.spectrum_rates.push_back(spectra.rate(part, bin));
  }
  if (end > first) stage.spectrum_energies.push_back(observe::LogHistogram::lower(end));
}

/// The record of a run with these shapes.
WearStage stage_of(const WornCase& of, const WornState& state, const WearRates& rates,
                   const results::Outcome& outcome) {
  WearStage stage{.state = state,
                  .dissipated_power = number(outcome, "dissipated_power"),
                  .drawn_power = number(outcome, "drawn_power"),
                  .wear_rate_balls = number(outcome, "wear_rate_balls"),
                  .wear_rate_jar = number(outcome, "wear_rate_jar"),
                  .wear_rate_parts = number(outcome, "wear_rate_parts"),
                  .contamination_rate = number(outcome, "contamination_rate"),
                  .ball_rates = rates.balls};
  for (std::size_t k = 0; k < of.profiles().size(); ++k) {
    stage.heights.push_back(of.height(state, k));
    stage.depth_rates.push_back(rates.sections[k]);
    for (std::size_t i = 0; i < stage.depth_rates[k].size(); ++i)
      stage.depth_rates[k][i] /= geometry::length_of(state.sections[k], i);
  }
  take_spectrum(outcome, stage);
  return stage;
}

/// The time at which a profile has lost its share of height: between two stages, or at the last
/// rate of loss.
WearLife life_of(const WearEvolution& all, std::size_t k) {
  WearLife life{.profile = all.profiles[k], .time = unknown};
  const double worn_out = (1 - all.wear.worn_out) * all.fresh_heights[k];
  const auto& stages = all.stages;
  for (std::size_t i = 1; i < stages.size(); ++i) {
    const double t0 = stages[i - 1].state.time, h0 = stages[i - 1].heights[k];
    const double t1 = stages[i].state.time, h1 = stages[i].heights[k];
    const bool last = i + 1 == stages.size();
    if (!(h1 < h0) || !(h1 <= worn_out || last)) continue;
    life.time = t0 + (h0 - worn_out) / (h0 - h1) * (t1 - t0);
    life.extrapolated = h1 > worn_out;
    return life;
  }
  return life;
}

/// The run of a stage, whose hits on the worn bodies are recorded.
results::Outcome run_stage(const WornCase& of, const WornState& state, RunOptions options,
                           RecordedWear& recorded) {
  const cases::Case stage = of.at(state);
  if (std::vector<Fault> wrong = run_faults(stage); !wrong.empty())
    throw InputError(std::move(wrong));
  const auto bodies =
      std::make_shared<const std::vector<observe::WornBody>>(of.bodies(stage, state));
  const auto factors = load_factors(stage);
  recorded.clear();
  for (std::int64_t r = 0; r < stage.run.replicates; ++r)
    recorded.push_back(std::make_shared<observe::WearSums>());
  options.records = [&](std::size_t, int replicate) {
    return std::make_unique<observe::WearRecord>(bodies, factors,
                                                 recorded.at(static_cast<std::size_t>(replicate)));
  };
  return run(stage, options);
}

/// Follows the wear stage by stage.
class Evolving {
 public:
  Evolving(const cases::Case& mill_case, const WearOptions& options)
      : of_(mill_case), options_(options), now_(of_.fresh()) {
    all_.title = mill_case.title;
    all_.wear = of_.wear();
    for (const WornCase::Profile& one : of_.profiles()) {
      all_.profiles.push_back(of_.name_of(one));
      all_.fresh_heights.push_back(one.height);
    }
    for (std::size_t s = 0; s < of_.sets().size(); ++s) {
      all_.sets.push_back(cases::set_name(of_.mill_case(), of_.sets()[s]));
      all_.fresh_sizes.push_back(of_.fresh_size(s));
    }
    if (!options_.kept.empty()) {
      Archive kept(options_.kept);
      serialize(kept);
      kept.finish();
    }
  }

  WearEvolution work() {
    while (!all_.complete && all_.stop_reason.empty() && stage()) {
      Archive state;
      serialize(state);
      if (options_.keep) options_.keep(state.bytes());
    }
    for (std::size_t k = 0; k < all_.profiles.size(); ++k) all_.lives.push_back(life_of(all_, k));
    add_notices();
    return std::move(all_);
  }

 private:
  /// Runs a stage and takes its step. False if it was interrupted or stopped.
  bool stage() {
    const std::size_t number = all_.stages.size();
    if (options_.begin) options_.begin(number, now_.time);
    RecordedWear recorded;
    results::Outcome outcome = run_stage(of_, now_, options_.run, recorded);
    if (outcome.interrupted) return false;
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stop_reason.empty()) all_.stop_reason = r.stop_reason;
    if (!results::complete(outcome)) return false;
    const WearRates rates = wear_rates(of_, now_, outcome, recorded);
    all_.stages.push_back(stage_of(of_, now_, rates, outcome));
    if (options_.done) options_.done(number, outcome);
    const double left = *of_.wear().evolve - now_.time;
    all_.complete = !(left > 0);
    if (!all_.complete) step(rates, left);
    return true;
  }

  void step(const WearRates& rates, double left) {
    const double rate = largest_change_rate(of_, now_, rates);
    double time = rate > 0 ? std::min(left, of_.wear().largest_change / rate) : left;
    constexpr double rest = 1e-9;  // of the time: what rounding leaves
    if (left - time < rest * *of_.wear().evolve) time = left;
    constexpr int halvings = 10;
    for (int i = 0; i < halvings; ++i, time *= 0.5)
      if (auto after = worn_after(of_, now_, rates, time)) {
        if (time == left) after->time = *of_.wear().evolve;
        all_.stages.back().duration = time;
        now_ = std::move(*after);
        if (volume_of_balls() > 0) return;
        all_.stop_reason =
            "all balls are worn below scrap_size; let fresh ones replace them by "
            "make_up = true, or give a shorter time";
        return;
      }
    all_.stop_reason = fmt::format(
        "after {} a body is worn so thin that its surface would cross itself; end the run there by "
        "evolve = \"{}\"",
        show_rounded(now_.time, "s"), show_rounded(now_.time, "s"));
  }

  double volume_of_balls() const {
    double sum = 0;
    for (const powder::BallCharge& charge : now_.charges) sum += powder::volume_of(charge);
    return sum;
  }

  void add_notices() {
    if (!of_.kept().empty())
      all_.notices.push_back(
          note("wear-keeps-shape",
               fmt::format("The wear of {} is counted, but the shape stays: shapes follow their "
                           "wear for bars with a section, lifters, meshes and round jars.",
                           fmt::join(of_.kept(), ", "))));
    if (!all_.stop_reason.empty())
      all_.notices.push_back(
          warning("wear-stopped",
                  fmt::format("The wear was not followed to the end: {}.", all_.stop_reason)));
  }

  void serialize(Archive& archive) {
    auto count = static_cast<std::uint64_t>(all_.stages.size());
    archive(count)(all_.complete);
    constexpr std::uint64_t most = 100'000;
    if (count > most) throw Archive::broken();
    if (archive.reading()) all_.stages.resize(count);
    for (WearStage& one : all_.stages) one.serialize(archive);
    now_.serialize(archive);
  }

  WornCase of_;
  const WearOptions& options_;
  WornState now_;
  WearEvolution all_;
};

void lists(Archive& archive, std::vector<std::vector<double>>& all) {
  auto count = static_cast<std::uint64_t>(all.size());
  archive(count);
  constexpr std::uint64_t most = 1000;
  if (count > most) throw Archive::broken();
  if (archive.reading()) all.resize(count);
  for (std::vector<double>& one : all) archive(one);
}

}  // namespace

void WearStage::serialize(Archive& archive) {
  state.serialize(archive);
  archive(duration)(dissipated_power)(drawn_power)(wear_rate_balls)(wear_rate_jar);
  archive(wear_rate_parts)(contamination_rate)(heights);
  lists(archive, depth_rates);
  lists(archive, ball_rates);
  archive(spectrum_energies)(spectrum_rates);
}

WearEvolution evolve_wear(const cases::Case& mill_case, const WearOptions& options) {
  return Evolving(mill_case, options).work();
}

}  // namespace mahlwerk::campaign
