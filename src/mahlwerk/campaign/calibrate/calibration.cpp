// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/calibrate/ensemble_sampler.hpp"
#include "mahlwerk/campaign/calibrate/likelihood.hpp"
#include "mahlwerk/campaign/calibrate/posterior.hpp"
#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "mahlwerk/campaign/points/designs.hpp"

namespace mahlwerk::campaign {
namespace {

using Points = std::vector<DesignPoint>;
using Emulators = std::vector<std::optional<OutcomeEmulator>>;

constexpr double little = 0.15;  // share of the emulators in the variance of a datum
constexpr std::uint32_t outcome_stream = 0x55000000;

/// Sizes of the sample of a posterior.
SamplerSettings sampler(std::size_t coordinates, std::uint64_t seed, bool last) {
  const int walkers = std::max(24, 6 * static_cast<int>(coordinates));
  return {.walkers = walkers + walkers % 2,
          .burn_in = last ? 400 : 150,
          .moves = last ? 2000 : 200,
          .keep_every = 10,
          .seed = seed};
}

/// Where walkers may begin: points spread over the ranges, and the last sample.
Points starts(const Likelihood& likelihood, const Points& last) {
  Points made = sobol_points(likelihood.coordinates(), 64 * likelihood.coordinates());
  made.insert(made.end(), last.begin(), last.end());
  return made;
}

Points positions(const Points& sample, std::size_t keys) {
  Points made;
  for (const auto& point : sample)
    made.emplace_back(point.begin(), point.begin() + static_cast<std::ptrdiff_t>(keys));
  return made;
}

class Calibrator {
 public:
  Calibrator(const CalibrationGoal& goal, const Simulation& simulation,
             const CalibrationOptions& options)
      : goal_(goal), simulation_(simulation), options_(options) {
    if (keys() < 1 || keys() > 8 || goal.data.empty() || goal.replicates < 1)
      throw std::invalid_argument("a calibration has 1 to 8 parameters, data and replicates");
    most_ = goal.settings > 0 ? goal.settings : usual_settings(keys());
  }

  CalibrationResult run() {
    const std::size_t first =
        std::min<std::size_t>(static_cast<std::size_t>(most_), 2 + 10 * keys());
    run_settings(sobol_points(keys(), first));
    int certain = 0;  // rounds in which the emulators added little
    for (;; ++result_.rounds) {
      learn();
      sample(1, false);
      certain = result_.emulator_share < little ? certain + 1 : 0;
      result_.converged = certain == 2;
      if (result_.converged || static_cast<int>(trials_.size()) >= most_) break;
      run_settings(next_settings());
    }
    conclude();
    return std::move(result_);
  }

 private:
  std::size_t keys() const { return goal_.parameters.size(); }

  void run_settings(const Points& points) {
    std::vector<TrialRequest> requests;
    for (const DesignPoint& point : points) {
      const std::size_t number = trials_.size();
      trials_.push_back({.point = goal_.snap ? goal_.snap(point) : point,
                         .replicates = {},
                         .failure = {},
                         .round = result_.rounds});
      // Settings share no random numbers: their scatter must be independent.
      requests.push_back({.setting = number,
                          .point = trials_.back().point,
                          .first = static_cast<int>(number) * goal_.replicates,
                          .count = goal_.replicates});
    }
    if (options_.progress)
      options_.progress({static_cast<int>(trials_.size()), most_, result_.rounds});
    std::vector<TrialResult> given = simulation_(requests);
    for (std::size_t i = 0; i < requests.size(); ++i) {
      trials_[requests[i].setting].replicates = std::move(given[i].replicates);
      trials_[requests[i].setting].failure = std::move(given[i].failure);
    }
  }

  /// Makes the emulators anew.
  void learn() {
    const auto ran = std::ranges::count(trials_, std::string(), &Trial::failure);
    if (ran < static_cast<std::ptrdiff_t>(keys()) + 3) {
      const auto failed =
          std::ranges::find_if(trials_, [](const Trial& t) { return !t.failure.empty(); });
      throw RunError(fmt::format("{} of {} settings ran, which is too few{}", ran, trials_.size(),
                                 failed == trials_.end() ? "" : ": " + failed->failure));
    }
    emulators_ = emulators(goal_, trials_);
    for (const Datum& datum : goal_.data)
      if (!emulators_[datum.outcome])
        throw RunError("no run has a value of a quantity that was measured");
  }

  /// Samples the posterior; errors are `inflation` times as large as given.
  void sample(double inflation, bool last) {
    const Likelihood likelihood(goal_, emulators_, inflation);
    const auto density = [&](const std::vector<double>& point) {
      if (options_.stop != nullptr && *options_.stop) throw Interrupted();
      return likelihood.log_at(point);
    };
    DensitySample drawn = sample_density(density, starts(likelihood, thinned(sample_, 32)),
                                         sampler(likelihood.coordinates(), goal_.seed, last));
    sample_ = std::move(drawn.points);
    shrinkage_ = drawn.shrinkage;
    result_.emulator_share = 0;
    const Points some = thinned(sample_, 100);
    for (std::size_t i = 0; i < goal_.data.size(); ++i) {
      double sum = 0;
      for (const auto& point : some) sum += likelihood.emulator_share(i, point);
      result_.emulator_share =
          std::max(result_.emulator_share, sum / static_cast<double>(some.size()));
    }
  }

  /// The next settings: of the posterior, those where the emulators are least certain.
  Points next_settings() const {
    const Points candidates = thinned(sample_, 200);
    Emulators with = emulators_;
    const std::size_t count =
        std::min<std::size_t>(2 * batch, static_cast<std::size_t>(most_) - trials_.size());
    Points made;
    while (made.size() < count) {
      const Likelihood likelihood(goal_, with);
      std::size_t best = 0;
      double most = -1;
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < goal_.data.size(); ++i)
          sum += likelihood.emulator_share(i, candidates[k]);
        if (sum > most) best = k, most = sum;
      }
      made.push_back(positions({candidates[best]}, keys()).front());
      for (auto& emulator : with)
        if (emulator)
          emulator->model.process =
              emulator->model.process.with_fantasy(made.back(), emulator->model.noise);
    }
    return made;
  }

  /// Degrees of freedom of the data.
  double freedom() const {
    return static_cast<double>(goal_.data.size()) - static_cast<double>(keys());
  }
  bool errors_known() const {
    return std::ranges::none_of(goal_.data, [](const Datum& d) { return std::isnan(d.error); });
  }

  /// Least misfit of the sample, by degrees of freedom (cal.6); NaN without degrees of freedom.
  double misfit() const {
    if (!errors_known() || freedom() < 1) return std::numeric_limits<double>::quiet_NaN();
    const Likelihood likelihood(goal_, emulators_);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& point : sample_) least = std::min(least, likelihood.chi_square(point));
    return std::sqrt(least / freedom());
  }

  void conclude() {
    sample(1, true);
    result_.misfit = misfit();
    if (result_.misfit > 1) sample(result_.misfit, true);
    result_.settings = static_cast<int>(trials_.size());
    result_.failed = static_cast<int>(
        std::ranges::count_if(trials_, [](const Trial& t) { return !t.failure.empty(); }));
    describe_parameters();
    describe_outcomes();
    remark();
  }

  void describe_parameters() {
    result_.posterior = positions(sample_, keys());
    const Points some = thinned(result_.posterior, 500);
    result_.central = some[most_central(some)];
    result_.correlation = correlation_of(result_.posterior, keys());
    for (std::size_t i = 0; i < keys(); ++i) {
      std::vector<double> own;
      for (const auto& point : result_.posterior) own.push_back(point[i]);
      result_.parameters.push_back(
          describe_parameter(goal_.parameters[i], own, result_.central[i]));
    }
    result_.draws = thinned(result_.posterior, goal_.draws);
    if (errors_known()) return;
    const Likelihood likelihood(goal_, emulators_);
    for (std::size_t q = 0; q + keys() < likelihood.coordinates(); ++q) {
      std::vector<double> values;
      for (const auto& point : sample_) values.push_back(likelihood.scatter(q, point));
      result_.scatter.push_back(quantile_of(std::move(values), 0.5));
    }
  }

  void describe_outcomes() {
    Random random(goal_.seed, outcome_stream);
    for (const auto& emulator : emulators_) {
      PredictedOutcome& made = result_.outcomes.emplace_back();
      if (!emulator) continue;
      double mean = 0;
      std::vector<double> values;
      for (const DesignPoint& point : thinned(result_.posterior, 1000)) {
        const Posterior guess = emulator->model.at(point);
        values.push_back(
            emulator->value_of(guess.mean + guess.deviation * standard_normal(random)));
        mean += values.back();
      }
      mean /= static_cast<double>(values.size());
      made.value = {mean, quantile_of(values, 0.025), quantile_of(values, 0.975)};  // (cal.8)
      made.emulator_error = emulator->leave_one_out_error();
    }
  }

  void remark() {
    std::vector<std::string>& all = result_.remarks;
    for (std::size_t i = 0; i < keys(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (std::abs(result_.correlation[i][k]) > 0.9)
          all.push_back(fmt::format(
              "{} and {} are known only together: their correlation is {:.2f}",
              goal_.parameters[k].name, goal_.parameters[i].name, result_.correlation[i][k]));
    if (result_.misfit > 1.5)
      all.push_back(fmt::format(
          "the measurements scatter {:.1f} times as much about the model as their errors say: the "
          "intervals are wider by that, and the model may miss something",
          result_.misfit));
    if (!errors_known() && freedom() < 1)
      all.emplace_back(
          "there are no more values than parameters, and no errors: the scatter of the data is not "
          "known, and the intervals rest on its assumed range");
    if (result_.emulator_share > 2 * little)
      all.push_back(fmt::format(
          "the emulators are up to {:.0f} % of the uncertainty of a value: more --settings, longer "
          "runs or more replicates narrow the intervals",
          100 * result_.emulator_share));
    if (result_.failed > 0)
      all.push_back(fmt::format("{} of {} settings could not be run and are left out",
                                result_.failed, result_.settings));
    if (shrinkage_ > 1.05)
      all.push_back(fmt::format(
          "the sample of the posterior has not converged (its halves differ, {:.2f})", shrinkage_));
  }

  const CalibrationGoal& goal_;
  const Simulation& simulation_;
  const CalibrationOptions& options_;
  int most_ = 0;
  std::vector<Trial> trials_;
  Emulators emulators_;
  Points sample_;
  double shrinkage_ = 1;
  CalibrationResult result_;
};

}  // namespace

int usual_settings(std::size_t parameters) {
  return 20 + 20 * static_cast<int>(parameters);
}

CalibrationResult calibrate(const CalibrationGoal& goal, const Simulation& simulation,
                            const CalibrationOptions& options) {
  return Calibrator(goal, simulation, options).run();
}

}  // namespace mahlwerk::campaign
