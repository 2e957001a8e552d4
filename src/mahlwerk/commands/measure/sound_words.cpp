// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/measure/sound_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/measure/readings.hpp"

namespace mahlwerk::commands {

double option_quantity(const std::string& text, std::string_view unit, std::string_view option,
                       double least, double most) {
  std::string what;
  try {
    const double value = parse_in(text, unit);
    if (value >= least && value <= most) return value;
    what = "the value is out of range";
  } catch (const UnitError& error) {
    what = error.what();
  }
  throw InputError(Fault{
      fmt::format("{} {}", option, text), what,
      fmt::format("write for instance {} \"{}\"", option, unit.empty() ? "12" : example_of(unit)),
      "bad-quantity"});
}

Options sound_options(SoundWords& words) {
  return {
      {.name = "--from", .target = &words.from, .about = "begin of the part to use: \"2 s\""},
      {.name = "--to", .target = &words.to, .about = "its end"},
      {.name = "--definition-time",
       .target = &words.definition_time,
       .about = "hits with shorter intervals are one (default 1 ms; drop: 2 ms)"},
      {.name = "--rise",
       .target = &words.rise,
       .about = "how far a hit rises above the noise and what is before it, in dB (default 12)"},
      {.name = "--low-cut",
       .target = &words.low_cut,
       .about = "frequencies below are left out (default 1 kHz; \"0 Hz\": none)"}};
}

measure::HitSettings hit_settings(const SoundWords& words, double usual) {
  measure::HitSettings made{.definition_time = usual};
  if (!words.definition_time.empty())
    made.definition_time = option_quantity(words.definition_time, "s", "--definition-time", 1e-5);
  if (!words.rise.empty()) made.rise = option_quantity(words.rise, "", "--rise", 1);
  if (!words.low_cut.empty()) made.low_cut = option_quantity(words.low_cut, "Hz", "--low-cut", 0);
  return made;
}

measure::Sound sound_part(const std::string& file, const SoundWords& words) {
  measure::Sound sound =
      measure::read_wav(measure::file_contents(file, std::size_t{1} << 29U), file);
  const double length = static_cast<double>(sound.samples.size()) / sound.rate;
  const double from = words.from.empty() ? 0 : option_quantity(words.from, "s", "--from", 0);
  const double to = words.to.empty() ? length : option_quantity(words.to, "s", "--to", 0);
  if (!(from < to) || to > length * (1 + 1e-9))
    throw InputError(Fault{
        file,
        fmt::format("there is no part from {} to {}: the sound lasts {}", show_rounded(from, "s"),
                    show_rounded(to, "s"), show_rounded(length, "s")),
        "give other --from and --to", "bad-command-line"});
  const auto index = [&](double t) {
    return static_cast<std::ptrdiff_t>(
        std::min(std::round(t * sound.rate), static_cast<double>(sound.samples.size())));
  };
  sound.samples = {sound.samples.begin() + index(from), sound.samples.begin() + index(to)};
  return sound;
}

}  // namespace mahlwerk::commands
