// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/measure/mill_motion.hpp"
#include "noise.hpp"

// Tracks of marks as a camera would see them.
namespace mahlwerk::tests {

struct SyntheticFilm {
  int frames = 400;
  double rate = 800;  // frames per second
  double noise = 0;   // in the unit of the tracks
  double memory = 0;  // of the noise
  std::uint64_t seed = 1;
};

/// Noise of coordinates, independent of each other.
inline std::vector<Noise> noise_of(const SyntheticFilm& film, std::size_t coordinates) {
  std::vector<Noise> made;
  for (std::size_t i = 0; i < coordinates; ++i)
    made.emplace_back(film.seed, film.noise, film.memory, static_cast<std::uint32_t>(i));
  return made;
}

/// A mixer mill: an arm that swings by `swing` [rad] at `frequency`; marks at `places` on the arm
/// at rest, seen from the pivot; the picture is turned by 30 degrees.
inline measure::MarkTracks mixer_film(const SyntheticFilm& film, double frequency, double swing,
                                      const std::vector<std::array<double, 2>>& places) {
  measure::MarkTracks made;
  made.marks.resize(places.size());
  std::vector<Noise> noise = noise_of(film, 2 * places.size());
  for (int n = 0; n < film.frames; ++n) {
    const double t = n / film.rate;
    const double angle = swing * std::sin(2 * std::numbers::pi * frequency * t + 0.7) + 0.5;
    made.time.push_back(t);
    for (std::size_t m = 0; m < places.size(); ++m) {
      const auto [x, y] = places[m];
      made.marks[m].x.push_back(500 + x * std::cos(angle) - y * std::sin(angle) + noise[2 * m]());
      made.marks[m].y.push_back(300 + x * std::sin(angle) + y * std::cos(angle) +
                                noise[2 * m + 1]());
    }
  }
  return made;
}

/// A planetary mill: mark 1 on the jar at `mark` from its middle, mark 2 on the disc.
inline measure::MarkTracks planetary_film(const SyntheticFilm& film, double speed, double radius,
                                          double ratio, double mark) {
  measure::MarkTracks made;
  made.marks.resize(2);
  std::vector<Noise> noise = noise_of(film, 4);
  for (int n = 0; n < film.frames; ++n) {
    const double t = n / film.rate, disc = speed * t + 0.3, jar = speed * (1 + ratio) * t + 1.1;
    made.time.push_back(t);
    made.marks[0].x.push_back(radius * std::cos(disc) + mark * std::cos(jar) + noise[0]());
    made.marks[0].y.push_back(radius * std::sin(disc) + mark * std::sin(jar) + noise[1]());
    made.marks[1].x.push_back(0.4 * radius * std::cos(disc + 2) + noise[2]());
    made.marks[1].y.push_back(0.4 * radius * std::sin(disc + 2) + noise[3]());
  }
  return made;
}

}  // namespace mahlwerk::tests
