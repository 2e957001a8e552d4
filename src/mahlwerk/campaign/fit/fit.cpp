// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/search.hpp"
#include "mahlwerk/campaign/run/parallel.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool of_sizes(Measured what) {
  return what != Measured::conversion;
}

/// The first measurement of sizes, or of conversion; null if there is none.
const Measurement* first(const Measurements& data, bool sizes) {
  const auto found = std::ranges::find_if(
      data.values, [&](const Measurement& m) { return of_sizes(m.what) == sizes; });
  return found == data.values.end() ? nullptr : &*found;
}

double told_by(const powder::Milling& milling, const Measurement& m, double density) {
  const std::vector<double> shares = milling.at(m.time);
  switch (m.what) {
    case Measured::quantile:
      return powder::quantile(milling.grid, shares, 0.01 * m.percent);
    case Measured::passing:
      return powder::finer(milling.grid, shares, m.size);
    case Measured::specific_surface:
      return powder::specific_surface(milling.grid, shares, density);
    case Measured::conversion:
      break;
  }
  return nothing;
}

}  // namespace

std::vector<FreeParameter> free_numbers(const cases::Case& what,
                                        const std::vector<std::string>& held) {
  std::vector<FreeParameter> numbers;
  for (const cases::Adjustable& one : cases::adjustables(what)) {
    const auto range = what.fit.find(one.key);
    if (range == what.fit.end() || std::ranges::find(held, one.key) != held.end()) continue;
    const double least = parse_in(range->second[0], one.unit);
    const double most = parse_in(range->second[1], one.unit);
    numbers.push_back({.name = one.key,
                       .least = least,
                       .most = most,
                       .ends_least = least == one.range.least,
                       .ends_most = most == one.range.most});
  }
  return numbers;
}

std::vector<Fault> fit_faults(const cases::Case& what, const Measurements& data,
                              const std::vector<FreeParameter>& numbers, const std::string& file) {
  std::vector<Fault> found;
  if (numbers.empty())
    found.push_back({what.file, "the case leaves no number open",
                     "add [fit] with keys and their ranges, such as \"breakage.f_mat\" = "
                     "[\"0.01 kg/J/m\", \"100 kg/J/m\"]",
                     "nothing-to-fit"});
  const auto lacks = [&](const Measurement* m, const char* section) {
    found.push_back({fmt::format("{}:{}", file, m->line),
                     fmt::format("{} was measured, but the case has no [{}]",
                                 name_of(m->what, m->percent), section),
                     fmt::format("add [{}] to the case", section), "nothing-to-fit"});
  };
  if (const Measurement* m = first(data, true); m != nullptr && !what.grinding)
    lacks(m, "grinding");
  if (const Measurement* m = first(data, false); m != nullptr && !what.kinetics)
    lacks(m, "kinetics");
  for (const FreeParameter& number : numbers)
    if (std::ranges::any_of(data.conditions, [&](const std::vector<cases::Override>& set) {
          return std::ranges::find(set, number.name, &cases::Override::key) != set.end();
        }))
      found.push_back({file, fmt::format("the column {} sets what [fit] is to find", number.name),
                       "take the column or the key of [fit] away", "nothing-to-fit"});
  return found;
}

void fill_times(Measurements& data, const std::vector<cases::Case>& conditions) {
  for (Measurement& m : data.values) {
    const cases::Case& what = conditions[m.condition];
    if (std::isnan(m.time)) m.time = of_sizes(m.what) ? what.grinding->time : what.kinetics->time;
  }
}

cases::Case for_fit(cases::Case what, std::size_t condition, const Measurements& data,
                    const std::vector<FreeParameter>& numbers) {
  what.observe.collisions = false;
  what.observe.frames.reset();
  for (const FreeParameter& number : numbers)
    cases::adjust(what, number.name, value_at(number, 0.5));
  if (!what.grinding) return what;
  what.grinding->method = cases::Grinding::Method::balance;
  double longest = 0;
  for (const Measurement& m : data.values)
    if (m.condition == condition && of_sizes(m.what)) longest = std::max(longest, m.time);
  if (longest > 0) what.grinding->time = longest;
  return what;
}

namespace {

/// Whether beds stay as they are whatever the numbers that are sought: those of [capture] change
/// what is caught, welding the classes there are, a strength that [breakage] lends to the bed both.
bool keeps_beds(const cases::Case& what, const std::vector<FreeParameter>& numbers) {
  if (what.grinding->bed == powder::Bed::mixed) return false;
  const bool lent = powder::knows_strength(*what.grinding->breakage);
  return std::ranges::none_of(numbers, [&](const FreeParameter& number) {
    const bool of_capture =
        number.name.starts_with("capture.") && number.name != "capture.energy_share";
    return of_capture || number.name == "grinding.welding" ||
           (lent && number.name.starts_with("breakage."));
  });
}

}  // namespace

Predictor::Predictor(const std::vector<results::Outcome>& mills, std::vector<FreeParameter> numbers,
                     std::vector<Measurement> asked, int threads, std::optional<std::size_t> only)
    : numbers_(std::move(numbers)), asked_(std::move(asked)), threads_(threads) {
  for (std::size_t i = 0; i < mills.size(); ++i) {
    Mill mill{&mills[i], results::averaged(mills[i]), {}, {}, false, {}};
    if (only) mill.replicates = {mill.replicates.at(*only)};
    if (mills[i].what.capture) mill.stresses = results::stresses(mills[i].what, mill.replicates);
    for (std::size_t k = 0; k < asked_.size(); ++k)
      if (asked_[k].condition == i) {
        mill.asked.push_back(k);
        mill.grinds = mill.grinds || of_sizes(asked_[k].what);
      }
    if (mill.grinds && keeps_beds(mills[i].what, numbers_))
      mill.beds = results::beds(mills[i].what, mill.stresses);
    mills_.push_back(std::move(mill));
  }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (threads_ <= 0) threads_ = cores;
}

void Predictor::tell(const Mill& mill, const std::vector<double>& values,
                     std::vector<double>& told) const {
  cases::Case what = mill.outcome->what;
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    cases::adjust(what, numbers_[i].name, values[i]);
  const powder::Milling milling =
      mill.grinds ? results::milled(what, mill.stresses, mill.beds ? &*mill.beds : nullptr)
                  : powder::Milling{};
  const double dose =
      what.kinetics ? results::dose_rate(what, mill.replicates, mill.stresses) : nothing;
  for (const std::size_t k : mill.asked)
    told[k] = of_sizes(asked_[k].what) ? told_by(milling, asked_[k], *what.powder->density)
                                       : what.kinetics->conversion.at(dose * asked_[k].time);
}

std::vector<double> Predictor::operator()(const std::vector<double>& values) const {
  std::vector<double> told(asked_.size(), nothing);
  in_parallel(threads_, mills_.size(), [&](std::size_t i) { tell(mills_[i], values, told); });
  return told;
}

double residual(const Measurement& measured, double predicted) {
  const bool known = !std::isnan(measured.error);
  if (measured.what == Measured::quantile || measured.what == Measured::specific_surface)
    return std::log(predicted / measured.value) * (known ? measured.value / measured.error : 1);
  return (predicted - measured.value) / (known ? measured.error : 1);
}

namespace {

/// Of what `predict` tells, beside what was measured; counts how often.
Residuals residuals(const Predictor& predict, const Measurements& data, const FitOptions& options,
                    int& milled) {
  return [&](const std::vector<double>& values) {
    if (options.stop != nullptr && *options.stop) throw Interrupted();
    std::vector<double> all = predict(values);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = residual(data.values[i], all[i]);
    ++milled;
    if (options.progress) options.progress(milled);
    return all;
  };
}

std::vector<double> values_of(const Fitted& found) {
  std::vector<double> values;
  for (const FittedParameter& p : found.parameters) values.push_back(p.value);
  return values;
}

/// As places, the half-widths that the replicates' own fits give (fit.10).
std::vector<double> scatter_of_mills(const std::vector<results::Outcome>& mills,
                                     const Measurements& data,
                                     const std::vector<FreeParameter>& numbers, const Fitted& found,
                                     const FitOptions& options, int& milled) {
  std::size_t replicates = results::averaged(mills.front()).size();
  for (const results::Outcome& mill : mills)
    replicates = std::min(replicates, results::averaged(mill).size());
  std::vector<std::vector<double>> places(numbers.size());
  for (std::size_t r = 0; r < replicates && replicates > 1; ++r) {
    const Predictor predict(mills, numbers, data.values, options.threads, r);
    const Residuals own = residuals(predict, data, options, milled);
    Search search(own, numbers);
    std::vector<double> start;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      start.push_back(place_of(numbers[i], found.parameters[i].value));
    const Point best = search.descend(search.look(start));
    for (std::size_t i = 0; i < numbers.size(); ++i) places[i].push_back(best.place[i]);
  }
  std::vector<double> widths;
  for (const std::vector<double>& each : places)
    widths.push_back(each.empty() ? nothing : observe::estimate(each).ci95);
  return widths;
}

/// Ends of intervals that are not open move away by what the mills' scatter adds (fit.11).
void allow_for(double width, const FreeParameter& number, FittedParameter& p) {
  if (!(width > 0) || !p.determined) return;
  const double place = place_of(number, p.value);
  const double below = place - place_of(number, p.low), above = place_of(number, p.high) - place;
  const double low = place - std::hypot(below, width), high = place + std::hypot(above, width);
  if (!p.open_low) p.low = value_at(number, low);
  if (!p.open_high) p.high = value_at(number, high);
  p.open_low = p.open_low || low <= 0;
  p.open_high = p.open_high || high >= 1;
  p.determined = p.determined && !(p.open_low && p.open_high);
  if (width > 0.5 * (below + above))
    p.remarks.emplace_back(
        "it is the scatter of the simulated mill that makes it unsure: a longer "
        "run or more replicates make it surer");
}

}  // namespace

Fit fit(const std::vector<results::Outcome>& mills, const Measurements& data,
        const std::vector<FreeParameter>& numbers, const FitOptions& options) {
  int milled = 0;
  const Predictor predict(mills, numbers, data.values, options.threads);
  const Scatter scatter = data.errors_known() ? Scatter::known : Scatter::estimated;
  Fit made{.found = least_squares(residuals(predict, data, options, milled), numbers, scatter),
           .predicted = {},
           .by_mills = {}};
  made.predicted = predict(values_of(made.found));
  made.by_mills = scatter_of_mills(mills, data, numbers, made.found, options, milled);
  made.found.evaluations = milled;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    FittedParameter& p = made.found.parameters[i];
    const double width = made.by_mills[i], place = place_of(numbers[i], p.value);
    allow_for(width, numbers[i], p);
    made.by_mills[i] =  // places beyond the range are its ends
        0.5 * (value_at(numbers[i], place + width) - value_at(numbers[i], place - width));
  }
  return made;
}

}  // namespace mahlwerk::campaign
