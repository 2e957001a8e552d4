// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::measure {
namespace {

constexpr double range_of_hits = 50;  // [dB] below the loudest

/// The samples without frequencies below `cut` [Hz]: a Butterworth high-pass of second order.
std::vector<double> high_pass(const std::vector<double>& samples, double cut, double rate) {
  if (!(cut > 0)) return samples;
  const double k = math::tan(std::numbers::pi * cut / rate), root = std::numbers::sqrt2 * k;
  const double norm = 1 / (1 + root + k * k);
  const double a1 = 2 * (k * k - 1) * norm, a2 = (1 - root + k * k) * norm;
  std::vector<double> made;
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (const double x : samples) {
    const double y = norm * (x - 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = x, y2 = y1, y1 = y;
    made.push_back(y);
  }
  return made;
}

/// [dB] Levels of consecutive windows of `length` samples.
std::vector<double> levels_of(const std::vector<double>& samples, std::size_t length) {
  std::vector<double> levels;
  for (std::size_t begin = 0; begin + length <= samples.size(); begin += length) {
    double sum = 0;
    for (std::size_t i = begin; i < begin + length; ++i) sum += samples[i] * samples[i];
    levels.push_back(10 * math::log10(sum / static_cast<double>(length) + 1e-14));
  }
  return levels;
}

double noise_level(std::vector<double> levels) {
  const auto at = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 5);
  std::ranges::nth_element(levels, at);
  return *at;
}

/// Indices of the windows in which hits begin.
std::vector<std::size_t> onsets(const std::vector<double>& levels, double rise) {
  const double least =
      std::max(noise_level(levels) + rise, std::ranges::max(levels) - range_of_hits);
  std::vector<std::size_t> found;
  double low = levels.front(), high = low;
  bool rising = false;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double level = levels[i];
    if (rising && level < high - rise / 2) {  // the hit fades
      rising = false;
      low = level;
    }
    if (rising) {
      high = std::max(high, level);
    } else if (level >= least && level >= low + rise) {
      found.push_back(i);
      rising = true;
      high = level;
    }
    if (!rising) low = std::min(low, level);
  }
  return found;
}

/// Hits per second by batch means, never sharper than by chance alone if there are few.
observe::Estimate rate_in_batches(const std::vector<double>& times, double duration) {
  constexpr std::size_t batches = 40;
  std::vector<double> rates(batches, 0);
  const double length = duration / batches;
  for (const double t : times)
    rates[std::min(batches - 1, static_cast<std::size_t>(t / length))] += 1 / length;
  observe::Estimate made = observe::time_series_estimate(rates);
  const auto count = static_cast<double>(times.size());
  made.mean = count / duration;
  if (count < 20 || std::isnan(made.ci95)) made.ci95 = 1.96 * std::sqrt(count) / duration;
  return made;
}

}  // namespace

std::vector<double> hit_times(const Sound& sound, const HitSettings& settings) {
  if (settings.low_cut > 0.4 * sound.rate)
    throw InputError(
        Fault{"",
              fmt::format("with {} samples per second nothing is left above {}",
                          show_rounded(sound.rate, ""), show_rounded(settings.low_cut, "Hz")),
              "record with 44.1 or 48 kHz, or give a smaller --low-cut", "bad-readings"});
  const auto length = static_cast<std::size_t>(
      std::max(8.0, std::round(0.25 * settings.definition_time * sound.rate)));
  const std::vector<double> levels =
      levels_of(high_pass(sound.samples, settings.low_cut, sound.rate), length);
  if (levels.size() < 10) return {};
  std::vector<double> times;
  double last = -std::numeric_limits<double>::infinity();
  for (const std::size_t i : onsets(levels, settings.rise)) {
    const double t = static_cast<double>(i * length) / sound.rate;
    if (t - last >= settings.definition_time) times.push_back(t);
    last = t;
  }
  return times;
}

double rate_of_impacts(double heard, double definition_time) {
  if (!(heard * definition_time * std::numbers::e < 1))
    return std::numeric_limits<double>::quiet_NaN();
  double rate = heard;
  for (int i = 0; i < 200; ++i) rate = heard * math::exp(rate * definition_time);
  return rate;
}

Findings hit_rate(const Sound& sound, const HitSettings& settings) {
  const double duration = static_cast<double>(sound.samples.size()) / sound.rate;
  const auto fault = [](std::string what, std::string remedy) {
    return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
  };
  if (duration < 0.2)
    throw fault(fmt::format("the sound lasts {} only", show_rounded(duration, "s", 2)),
                "record 10 s and more");
  const std::vector<double> times = hit_times(sound, settings);
  if (times.size() < 5)
    throw fault(fmt::format("{} hits rise by {} dB above the noise, too few for a rate",
                            times.size(), settings.rise),
                "record longer and nearer to the jar, or give a smaller --rise");
  const observe::Estimate heard = rate_in_batches(times, duration);
  const auto impacts = [&](double rate) { return rate_of_impacts(rate, settings.definition_time); };
  Findings found{{{"", "hits heard", "1/s", heard}}, {}, {}};
  const double rate = impacts(heard.mean);
  if (std::isnan(rate) || std::isnan(impacts(heard.mean + heard.ci95)))
    found.remarks.push_back(fmt::format(
        "Hits follow each other so fast that most of those within the definition time of {} are "
        "heard as one: the rate says little.",
        show_rounded(settings.definition_time, "s")));
  else
    found.list.push_back({"",
                          "impacts, if they come at random",
                          "1/s",
                          {rate, 0.5 * (impacts(heard.mean + heard.ci95) -
                                        impacts(std::max(0.0, heard.mean - heard.ci95)))}});
  if (sound.clipped > 1e-4)
    found.remarks.push_back(
        fmt::format("{:.2g} % of the samples are clipped: set the recorder to a lower gain.",
                    100 * sound.clipped));
  if (sound.rate < 8 * settings.low_cut)
    found.remarks.emplace_back(
        "The rate of samples is low for short hits: 44.1 or 48 kHz is usual.");
  return found;
}

}  // namespace mahlwerk::measure
