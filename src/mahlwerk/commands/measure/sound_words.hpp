// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/measure/hits.hpp"

// Options of commands that read a sound.
namespace mahlwerk::commands {

/// As given; empty: not given.
struct SoundWords {
  std::string from, to;         ///< part of the recording: "2 s"
  std::string definition_time;  ///< "1 ms"
  std::string rise;             ///< in dB
  std::string low_cut;          ///< "1 kHz"
};

Options sound_options(SoundWords& words);

/// Throws InputError. `usual`: definition time [s] if none is given.
measure::HitSettings hit_settings(const SoundWords& words, double usual);

/// The part of the file. Throws InputError.
measure::Sound sound_part(const std::string& file, const SoundWords& words);

/// A quantity of an option, from `least` to `most`. Throws InputError.
double option_quantity(const std::string& text, std::string_view unit, std::string_view option,
                       double least, double most = 1e9);

}  // namespace mahlwerk::commands
