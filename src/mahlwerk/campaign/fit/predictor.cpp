// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/predictor.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <thread>

#include "mahlwerk/campaign/run/parallel.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/kinetics.hpp"

namespace mahlwerk::campaign {

bool of_sizes(MeasuredQuantity what) {
  return what == MeasuredQuantity::quantile || what == MeasuredQuantity::passing ||
         what == MeasuredQuantity::specific_surface;
}

namespace {

constexpr double no_prediction = std::numeric_limits<double>::quiet_NaN();

double predicted_value(const powder::SizeEvolution& milling, const Measurement& m, double density) {
  const std::vector<double> shares = milling.at(m.time);
  switch (m.what) {
    case MeasuredQuantity::quantile:
      return powder::quantile(milling.grid, shares, 0.01 * m.percent);
    case MeasuredQuantity::passing:
      return powder::undersize(milling.grid, shares, m.size);
    case MeasuredQuantity::specific_surface:
      return powder::specific_surface(milling.grid, shares, density);
    default:
      break;
  }
  return no_prediction;
}

/// A predicted value of a measurement that is not of sizes.
double predicted_reaction(const cases::Case& mill_case, const powder::MillingConditions& mill,
                          const Measurement& m) {
  if (m.what == MeasuredQuantity::ignition_time) return results::ignition_time(mill_case, mill);
  const powder::ReactionShares shares =
      powder::reaction_shares(*mill_case.kinetics->model, mill, m.time);
  if (m.what == MeasuredQuantity::yield) return shares.product;
  return m.what == MeasuredQuantity::second_yield ? shares.second_product : shares.conversion;
}

/// Whether powder beds are independent of the free parameters: those of [capture] change the
/// captured powder, welding the size classes, a strength that the bed takes from [breakage] both.
bool keeps_beds(const cases::Case& mill_case, const std::vector<FreeParameter>& parameters) {
  if (mill_case.grinding->bed == powder::Bed::mixed) return false;
  const bool lent = powder::has_median_strength(*mill_case.grinding->breakage);
  return std::ranges::none_of(parameters, [&](const FreeParameter& parameter) {
    const bool of_capture =
        parameter.name.starts_with("capture.") && parameter.name != "capture.energy_share";
    return of_capture || parameter.name == "grinding.welding" ||
           (lent && parameter.name.starts_with("breakage."));
  });
}

}  // namespace

Predictor::Predictor(const std::vector<results::Outcome>& mills,
                     std::vector<FreeParameter> parameters, std::vector<Measurement> measurements,
                     int threads, std::optional<std::size_t> only)
    : parameters_(std::move(parameters)),
      measurements_(std::move(measurements)),
      threads_(threads) {
  for (std::size_t i = 0; i < mills.size(); ++i) {
    Mill mill{&mills[i], results::averaged_replicates(mills[i]), {}, {}, false, {}};
    if (only) mill.replicates = {mill.replicates.at(*only)};
    if (mills[i].mill_case.capture || results::kinetics_reads_hits(mills[i].mill_case))
      mill.stresses = results::stress_spectrum(mills[i].mill_case, mill.replicates);
    for (std::size_t k = 0; k < measurements_.size(); ++k)
      if (measurements_[k].condition == i) {
        mill.measurements.push_back(k);
        mill.grinds = mill.grinds || of_sizes(measurements_[k].what);
      }
    if (mill.grinds && keeps_beds(mills[i].mill_case, parameters_))
      mill.beds = results::beds(mills[i].mill_case, mill.stresses);
    mills_.push_back(std::move(mill));
  }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (threads_ <= 0) threads_ = cores;
}

void Predictor::predict(const Mill& mill, const std::vector<double>& values,
                        std::vector<double>& predicted) const {
  cases::Case mill_case = mill.outcome->mill_case;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    cases::set_fit_parameter(mill_case, parameters_[i].name, values[i]);
  const powder::SizeEvolution milling =
      mill.grinds
          ? results::milling_by_balance(mill_case, mill.stresses, mill.beds ? &*mill.beds : nullptr)
          : powder::SizeEvolution{};
  powder::MillingConditions conditions;
  if (mill_case.kinetics)
    conditions = results::milling_conditions(mill_case, mill.replicates, mill.stresses);
  for (const std::size_t k : mill.measurements)
    predicted[k] = of_sizes(measurements_[k].what)
                       ? predicted_value(milling, measurements_[k], *mill_case.powder->density)
                       : predicted_reaction(mill_case, conditions, measurements_[k]);
}

std::vector<double> Predictor::operator()(const std::vector<double>& values) const {
  std::vector<double> predicted(measurements_.size(), no_prediction);
  in_parallel(threads_, mills_.size(),
              [&](std::size_t i) { predict(mills_[i], values, predicted); });
  return predicted;
}

}  // namespace mahlwerk::campaign
