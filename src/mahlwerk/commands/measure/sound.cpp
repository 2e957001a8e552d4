// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure sound: hits per second and spectrum of a recording.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/measure/measure.hpp"
#include "mahlwerk/commands/measure/measured.hpp"
#include "mahlwerk/commands/measure/sound_words.hpp"
#include "mahlwerk/measure/sound_spectrum.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::commands {
namespace {

using results::Json;

struct SoundArguments {
  std::string file;
  SoundWords words;
  std::optional<std::filesystem::path> spectrum;
  MeasureOutput output;
};

std::string decibels(double share) {
  return share > 0 ? fmt::format("{:.1f} dB", 10 * math::log10(share)) : "-";
}

std::string bands_table(const std::vector<measure::SoundBand>& bands) {
  std::vector<std::array<std::string, 2>> lines{{"octave band", "part of the sound"}};
  for (const measure::SoundBand& band : bands)
    lines.push_back(
        {fmt::format("{} to {}", show_rounded(band.low, "Hz", 3), show_rounded(band.high, "Hz", 3)),
         decibels(band.share)});
  return report::aligned(lines);
}

std::string spectrum_csv(const measure::SoundSpectrum& spectrum) {
  std::string text = results::csv_line({"frequency_Hz", "density_per_Hz"});
  for (std::size_t i = 0; i < spectrum.density.size(); ++i)
    text += results::csv_line({results::csv_cell(spectrum.interval * static_cast<double>(i)),
                               results::csv_cell(spectrum.density[i])});
  return text;
}

Json bands_json(const std::vector<measure::SoundBand>& bands) {
  Json list = Json::array();
  for (const measure::SoundBand& band : bands)
    list.push_back(
        Json::object({{"low_hz", band.low}, {"high_hz", band.high}, {"share", band.share}}));
  return Json::object({{"bands", std::move(list)}});
}

int measure_sound(const SoundArguments& given) {
  if (given.spectrum) refuse_existing(*given.spectrum, given.output.running.force);
  const measure::HitSettings settings = hit_settings(given.words, 1e-3);
  const measure::Sound sound = sound_part(given.file, given.words);
  Measured measured{
      .title =
          fmt::format("Sound {}, {} at {}", given.file,
                      show_rounded(static_cast<double>(sound.samples.size()) / sound.rate, "s", 3),
                      show_rounded(sound.rate, "Hz", 4)),
      .source = "",
      .found = at_file(given.file, [&] { return measure::hit_rate(sound, settings); })};
  const double lowest = std::max(20.0, settings.low_cut);
  const measure::SoundSpectrum spectrum =
      at_file(given.file, [&] { return measure::sound_spectrum(sound, lowest); });
  measured.found.list.push_back({"",
                                 fmt::format("main frequency above {}", show_rounded(lowest, "Hz")),
                                 "Hz",
                                 {spectrum.main_frequency, 0.5 * spectrum.interval}});
  const observe::Estimate& heard = measured.found.list.front().value;
  measured.row = {{"heard_hit_rate (1/s)", fmt::format("{:.6g}", heard.mean)},
                  {"heard_hit_rate_error (1/s)", fmt::format("{:.4g}", heard.ci95 / 1.96)}};
  const std::vector<measure::SoundBand> bands = octave_bands(spectrum);
  measured.more =
      bands_table(bands) +
      fmt::format(
          "\nA case hears the same with [microphone] definition_time = \"{}\"; its "
          "threshold follows by mahlwerk fit\nfrom heard_hit_rate, or from a ball that is "
          "dropped onto the jar.\n",
          show_rounded(settings.definition_time, "s"));
  measured.details = bands_json(bands);
  if (given.spectrum) results::write_whole(*given.spectrum, spectrum_csv(spectrum));
  return report_measured(given.output, measured);
}

}  // namespace

Command measure_sound_command() {
  const auto given = std::make_shared<SoundArguments>();
  return {"sound", "hits per second and spectrum of the sound of a mill",
          joined({{{.name = "FILE",
                    .target = &given->file,
                    .about = "a recording: WAV, PCM or floating point",
                    .required = true}},
                  sound_options(given->words),
                  {{.name = "--spectrum",
                    .target = &given->spectrum,
                    .about = "file for the spectrum (CSV)"}},
                  data_options(given->output),
                  case_options(given->output)}),
          [given] { return measure_sound(*given); }};
}

}  // namespace mahlwerk::commands
