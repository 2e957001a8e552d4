// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/measure/wav.hpp"

namespace mahlwerk::measure {

/// Power of a sound by frequency (mea.10).
struct SoundSpectrum {
  double interval = 0;          ///< [Hz] between two frequencies; the first is 0
  std::vector<double> density;  ///< [1/Hz] of the power of all; sums to 1 times 1/interval
  double main_frequency = 0;    ///< [Hz] of the largest density from `lowest` on
};

/// Mean over segments of at most 4096 samples that overlap by half, each weighted by a Hann window
/// (Welch 1967). A sound of at least 64 samples that is not silent; throws InputError for
/// others. `lowest` [Hz]: of the main frequency.
SoundSpectrum sound_spectrum(const Sound& sound, double lowest = 20);

struct SoundBand {
  double low = 0, high = 0;  ///< [Hz]
  double share = 0;          ///< of the power
};

/// Octave bands up to half the rate of samples, named by their middle: 31.5, 63, 125, ... Hz.
std::vector<SoundBand> octave_bands(const SoundSpectrum& spectrum);

}  // namespace mahlwerk::measure
