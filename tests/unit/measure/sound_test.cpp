// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/measure/hits.hpp"
#include "mahlwerk/measure/sound_spectrum.hpp"
#include "noise.hpp"

namespace mahlwerk::measure::sound_test {
namespace {

constexpr double pi = std::numbers::pi;

void append(std::string& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
}

/// A WAV file; `code` 1 PCM, 3 floating point.
std::string wav_bytes(const std::vector<double>& samples, int code, int bits, int channels = 1) {
  std::string data;
  for (const double sample : samples)
    for (int c = 0; c < channels; ++c) {
      if (code == 3 && bits == 32)
        append(data, std::bit_cast<std::uint32_t>(static_cast<float>(sample)), 4);
      else if (code == 3)
        append(data, std::bit_cast<std::uint64_t>(sample), 8);
      else
        append(
            data,
            static_cast<std::uint64_t>(std::llround(sample * std::ldexp(1, bits - 1) * (1 - 1e-9)) +
                                       (bits == 8 ? 128 : 0)),
            bits / 8);
    }
  std::string bytes = "RIFF";
  append(bytes, 36 + data.size(), 4);
  bytes += "WAVEfmt ";
  append(bytes, 16, 4);
  append(bytes, static_cast<std::uint64_t>(code), 2);
  append(bytes, static_cast<std::uint64_t>(channels), 2);
  append(bytes, 48000, 4);
  append(bytes, 0, 6);
  append(bytes, static_cast<std::uint64_t>(bits), 2);
  bytes += "data";
  append(bytes, data.size(), 4);
  return bytes + data;
}

/// Hits at random with the rate [1/s], which ring for `ring` [s], over noise and a hum.
Sound mill_sound(double rate, double duration, std::uint64_t seed, double ring = 2e-4) {
  Sound sound{48000, std::vector<double>(static_cast<std::size_t>(48000 * duration)), 0};
  tests::Noise noise(seed, 0.002);
  for (std::size_t i = 0; i < sound.samples.size(); ++i)
    sound.samples[i] = noise() + 0.1 * std::sin(2 * pi * 50 * static_cast<double>(i) / 48000);
  for (double t = 0;;) {
    t -= std::log(noise.uniform(1e-12, 1)) / rate;
    const auto begin = static_cast<std::size_t>(t * 48000);
    if (begin >= sound.samples.size()) return sound;
    const double strength = noise.uniform(0.1, 0.6);
    for (std::size_t i = 0; begin + i < sound.samples.size() && i < 2000; ++i) {
      const double after = static_cast<double>(i) / 48000;
      sound.samples[begin + i] +=
          strength * std::exp(-after / ring) * std::sin(2 * pi * 6000 * after);
    }
  }
}

TEST(Wav, of_every_format_has_the_same_samples) {
  const std::vector<double> samples{0, 0.5, -0.5, 0.25, -0.9};
  const std::array<int, 2> formats[] = {{1, 8}, {1, 16}, {1, 24}, {1, 32}, {3, 32}, {3, 64}};
  for (const auto& [code, bits] : formats)
    for (const int channels : {1, 2}) {
      const Sound sound = read_wav(wav_bytes(samples, code, bits, channels), "a.wav");
      EXPECT_EQ(sound.rate, 48000);
      ASSERT_EQ(sound.samples.size(), samples.size()) << bits;
      for (std::size_t i = 0; i < samples.size(); ++i)
        EXPECT_NEAR(sound.samples[i], samples[i], bits == 8 ? 0.01 : 1e-4) << bits << " " << i;
    }
}

TEST(Wav, that_is_damaged_is_refused) {
  const std::string whole = wav_bytes({0.1, 0.2, 0.3}, 1, 16);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(read_wav(whole.substr(0, length), "a.wav"), InputError) << length;
  std::string packed = whole;
  packed[20] = 85;  // MP3 in a WAV file
  EXPECT_THROW(read_wav(packed, "a.wav"), InputError);
  EXPECT_THROW(read_wav(wav_bytes({NAN}, 3, 64), "a.wav"), InputError);
}

TEST(Hits, of_a_sound_are_those_that_were_put_in) {
  Sound sound = mill_sound(1e-9, 2, 1);
  for (const double t : {0.1, 0.35, 0.9, 0.902, 1.7})
    for (int i = 0; i < 500; ++i)
      sound.samples[static_cast<std::size_t>(48000 * t) + static_cast<std::size_t>(i)] +=
          0.4 * std::exp(-i / 10.0) * std::sin(2 * pi * 0.12 * i);
  const std::vector<double> times = hit_times(sound, {});
  ASSERT_EQ(times.size(), 5U);
  EXPECT_NEAR(times[0], 0.1, 5e-4);
  EXPECT_NEAR(times[3], 0.902, 5e-4);
  EXPECT_EQ(hit_times(sound, {.definition_time = 5e-3}).size(), 4U) << "two of them are one";
}

TEST(Hits, have_a_rate_whose_interval_holds_the_truth_in_95_of_100_sounds) {
  for (const double rate : {40.0, 200.0}) {
    int held = 0;
    constexpr int sounds = 60;
    for (int i = 0; i < sounds; ++i) {
      const Findings found = hit_rate(mill_sound(rate, 4, static_cast<std::uint64_t>(i + 1)), {});
      const observe::Estimate impacts = found.list[1].value;
      held += std::abs(impacts.mean - rate) <= impacts.ci95;
    }
    EXPECT_GE(held, 52) << rate;
  }
}

TEST(Hits, that_merge_are_counted_by_the_law_of_random_arrival) {
  EXPECT_NEAR(rate_of_impacts(100 * std::exp(-0.1), 1e-3), 100, 1e-9);
  EXPECT_EQ(rate_of_impacts(50, 0), 50);
  EXPECT_TRUE(std::isnan(rate_of_impacts(400, 1e-3))) << "above 1/(e tau) = 368 /s";
}

TEST(Hits, are_not_in_noise_hum_or_silence) {
  for (std::uint64_t seed = 1; seed < 20; ++seed)
    EXPECT_TRUE(hit_times(mill_sound(1e-9, 5, seed), {}).empty()) << seed;
  EXPECT_TRUE(hit_times({48000, std::vector<double>(96000), 0}, {}).empty());
  EXPECT_THROW(hit_rate(mill_sound(1e-9, 5, 1), {}), InputError);
  EXPECT_THROW(hit_rate(mill_sound(1000, 0.1, 1), {}), InputError);
  EXPECT_THROW(hit_times({2000, std::vector<double>(9600), 0}, {}), InputError)
      << "nothing above 1 kHz";
}

TEST(SoundSpectrum, has_the_power_of_tones_at_their_frequencies) {
  Sound sound{48000, std::vector<double>(48000), 0};
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    const double t = static_cast<double>(i) / 48000;
    sound.samples[i] = std::sqrt(3.0) * std::sin(2 * pi * 3000 * t) + std::sin(2 * pi * 400 * t);
  }
  const SoundSpectrum spectrum = sound_spectrum(sound);
  EXPECT_NEAR(spectrum.main_frequency, 3000, spectrum.interval);
  EXPECT_NEAR(sound_spectrum(sound, 0).main_frequency, 3000, spectrum.interval);
  double three_quarters = 0;
  for (const SoundBand& band : octave_bands(spectrum))
    if (band.low < 3000 && band.high > 3000) three_quarters = band.share;
  EXPECT_NEAR(three_quarters, 0.75, 0.01);
  EXPECT_THROW(sound_spectrum({48000, std::vector<double>(48000), 0}), InputError);
  EXPECT_THROW(sound_spectrum({48000, std::vector<double>(20, 1.0), 0}), InputError);
}

}  // namespace
}  // namespace mahlwerk::measure::sound_test
