// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/sound_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/measure/fourier.hpp"

namespace mahlwerk::measure {

SoundSpectrum sound_spectrum(const Sound& sound, double lowest) {
  std::size_t length = 4096;
  while (length > sound.samples.size()) length /= 2;
  const auto fault = [](const char* what, const char* remedy) {
    return InputError(Fault{"", what, remedy, "bad-readings"});
  };
  if (length < 64) throw fault("the sound is too short for a spectrum", "record 10 s and more");
  SoundSpectrum made{sound.rate / static_cast<double>(length), {}, 0};
  made.density.assign(length / 2 + 1, 0);
  for (std::size_t begin = 0; begin + length <= sound.samples.size(); begin += length / 2) {
    std::vector<Complex> segment(length);
    for (std::size_t i = 0; i < length; ++i) {
      const double phase =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length);
      segment[i] = sound.samples[begin + i] * 0.5 * (1 - sin_cos(phase).cos);
    }
    fourier_transform(segment);
    for (std::size_t i = 0; i < made.density.size(); ++i) made.density[i] += std::norm(segment[i]);
  }
  double sum = 0;
  for (const double one : made.density) sum += one;
  if (!(sum > 0)) throw fault("the sound is silent", "check the microphone");
  for (double& one : made.density) one /= sum * made.interval;
  const auto first = static_cast<std::size_t>(lowest / made.interval) + 1;
  const auto peak = std::max_element(
      made.density.begin() + static_cast<std::ptrdiff_t>(std::min(first, length / 2)),
      made.density.end());
  made.main_frequency = made.interval * static_cast<double>(peak - made.density.begin());
  return made;
}

std::vector<SoundBand> octave_bands(const SoundSpectrum& spectrum) {
  const double highest = spectrum.interval * static_cast<double>(spectrum.density.size() - 1);
  std::vector<SoundBand> bands;
  for (double middle = 31.25; middle / std::numbers::sqrt2 < highest; middle *= 2) {
    SoundBand band{middle / std::numbers::sqrt2, middle * std::numbers::sqrt2, 0};
    for (std::size_t i = 0; i < spectrum.density.size(); ++i) {
      const double f = spectrum.interval * static_cast<double>(i);
      if (f >= band.low && f < band.high) band.share += spectrum.density[i] * spectrum.interval;
    }
    bands.push_back(band);
  }
  return bands;
}

}  // namespace mahlwerk::measure
