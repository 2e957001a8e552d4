// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Claims about measured values: the band of a prediction over all assumed keys is compared with
// the interval of each measured value.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/paper/claim_rules.hpp"
#include "mahlwerk/report/paper/measurements.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

/// Values that the prediction takes over the assumed keys, with the intervals over replicates.
struct Band {
  double low = INFINITY, high = -INFINITY;
  bool complete = true;  ///< every value has an interval
  void add(const LinePoint& p) {
    complete = complete && std::isfinite(p.low()) && std::isfinite(p.high());
    low = std::min(low, p.low());
    high = std::max(high, p.high());
  }
  bool empty() const { return !(low <= high); }
};

Band band_at(const std::vector<ClaimLine>& lines, const std::string& at) {
  Band band;
  for (const ClaimLine& line : lines)
    for (const LinePoint& p : line.points)
      if (at.empty() || same_value(p.text, at)) band.add(p);
  return band;
}

/// A measured value beside the band.
struct Comparison {
  std::string at;               ///< value of the key; empty without a key
  double value = 0, error = 0;  ///< in the unit of the quantity
  Band band;
  double low() const { return band.low / value - 1; }  ///< [1] deviations of its ends
  double high() const { return band.high / value - 1; }
  double largest() const { return std::max(std::abs(low()), std::abs(high())); }
  bool agrees() const { return band.low <= value + error && band.high >= value - error; }
  /// Whether the assumed keys change the prediction so much that they decide.
  bool wide() const {
    constexpr double most = 2;
    return band.low <= 0 || band.high > most * band.low;
  }
};

std::string percent(double share) {
  return fmt::format("{:+.0f} %", 100 * share);
}

/// The value of the key; of a list, as `velocities`, its first number.
std::string short_text(const std::string& at) {
  if (!at.starts_with('[')) return at;
  const std::size_t from = at.find_first_not_of("[\" "), to = at.find_first_of("\",]", from);
  return from == std::string::npos ? at : at.substr(from, to - from);
}

/// "53 to 88 W (-24 % to +25 %)"; one number if both ends round to it.
std::string prediction(const ClaimContext& c, const Comparison& one) {
  const Readable low = readable(one.band.low, NAN, c.unit, one.value),
                 high = readable(one.band.high, NAN, c.unit, one.value);
  if (low.number == high.number) return fmt::format("{} ({})", low.text(), percent(one.low()));
  return fmt::format("{} to {} ({} to {})", low.number, high.text(), percent(one.low()),
                     percent(one.high()));
}

std::string sentence(const ClaimContext& c, const Comparison& one) {
  return fmt::format("{}measured {}, predicted {}", one.at.empty() ? "" : short_text(one.at) + ": ",
                     c.text(one.value, one.error), prediction(c, one));
}

/// Each comparison if there are few; else how many agree, and the range of deviations.
std::string summary(const ClaimContext& c, const std::vector<Comparison>& all) {
  constexpr std::size_t few = 6;
  std::string text;
  if (all.size() <= few) {
    for (const Comparison& one : all) text += (text.empty() ? "" : "; ") + sentence(c, one);
    return text;
  }
  const auto agree = std::ranges::count_if(all, &Comparison::agrees);
  const auto low = std::ranges::min_element(all, {}, &Comparison::low);
  const auto high = std::ranges::max_element(all, {}, &Comparison::high);
  return fmt::format("{} of {} measured values in the band; deviations from {} at {} to {} at {}",
                     agree, all.size(), percent(low->low()), short_text(low->at),
                     percent(high->high()), short_text(high->at));
}

}  // namespace

Verdict judge_measured(ClaimContext c, std::vector<ClaimLine> lines, const Measurement& measured) {
  if (!c.claim.relative_to.empty()) {
    c.unit.clear();
    for (ClaimLine& line : lines) line = relative_line(line, c.claim.relative_to);
  }
  std::vector<Comparison> all;
  for (const Measurement::Value& value : measured.values) {
    all.push_back({value.at, value.in(c.unit), value.error_in(c.unit), band_at(lines, value.at)});
    if (all.back().band.empty() || !all.back().band.complete)
      return {fmt::format("no predicted interval at {}", value.at)};
  }
  Verdict verdict{summary(c, all)};
  if (measured.status == Measurement::Status::unverified) {
    verdict.finding += "; the measured values are unverified and give no verdict";
    return verdict;
  }
  verdict.deviation = std::ranges::max(all, {}, &Comparison::largest).largest();
  const auto agree = std::ranges::count_if(all, &Comparison::agrees);
  if (agree == 0) {
    verdict.holds = Holds::no;
  } else if (std::ranges::any_of(all, &Comparison::wide)) {
    verdict.finding += "; the assumed values change the prediction by more than a factor of 2";
  } else {
    verdict.holds = agree == std::ssize(all) ? Holds::yes : Holds::partly;
  }
  return verdict;
}

}  // namespace mahlwerk::report
