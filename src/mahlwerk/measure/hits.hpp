// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/measure/finding.hpp"
#include "mahlwerk/measure/wav.hpp"

// Hits in a sound.
namespace mahlwerk::measure {

struct HitSettings {
  double definition_time = 1e-3;  ///< [s] hits with shorter intervals are one, as in [microphone]
  double rise = 12;               ///< [dB] by which a hit rises above what is before it
  double low_cut = 1000;  ///< [Hz] lower frequencies, the hum of the mill, are left out; 0: none
};

/// [s] Times of the hits (mea.9): the level rises by `rise` above its last minimum and above the
/// noise, the level that a fifth of the time is below, and is at most 50 dB below the loudest hit.
/// Throws InputError if the sound has no frequencies above the low cut.
std::vector<double> hit_times(const Sound& sound, const HitSettings& settings);

/// Hits per second as [microphone] counts them, with an interval by batch means, and the rate of
/// impacts that follows if they come at random (sns.3), NaN beyond its limit. Throws InputError for
/// a sound shorter than 0.2 s or with fewer than 5 hits.
Findings hit_rate(const Sound& sound, const HitSettings& settings);

/// [1/s] Rate of impacts at random of which `heard` [1/s] are heard (sns.3); NaN above its limit.
double rate_of_impacts(double heard, double definition_time);

}  // namespace mahlwerk::measure
