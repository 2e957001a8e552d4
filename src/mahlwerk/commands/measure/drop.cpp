// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure drop: restitution from the bounces of dropped balls.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/measure/measure.hpp"
#include "mahlwerk/commands/measure/measured.hpp"
#include "mahlwerk/commands/measure/sound_words.hpp"
#include "mahlwerk/measure/readings.hpp"
#include "mahlwerk/measure/restitution.hpp"
#include "mahlwerk/report/aligned.hpp"

namespace mahlwerk::commands {
namespace {

using measure::Bounce;
using results::Json;

struct DropArguments {
  std::vector<std::string> files;
  std::string columns, height;
  SoundWords sound;
  MeasureOutput output;
};

constexpr std::string_view drop_columns =
    "fall_height (mm), rebound_height (mm)\" or \"drop, time (s)";

/// The times of each drop, where a column counts them.
std::vector<std::vector<double>> times_by_drop(const measure::Readings& table,
                                               const measure::ReadingColumn& time) {
  const std::vector<double> seconds = measure::in_unit(table, time, "s", 2);
  const measure::ReadingColumn* drop = table.find({"drop", "run", "n"});
  std::vector<std::vector<double>> made(1);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (drop != nullptr && i > 0 && drop->values[i] != drop->values[i - 1]) made.emplace_back();
    if (!std::isnan(seconds[i])) made.back().push_back(seconds[i]);
  }
  return made;
}

std::vector<Bounce> bounces_of_table(const std::string& file, const std::string& text,
                                     const DropArguments& given, double height) {
  const measure::Readings table = measure::read_readings(text, file, given.columns);
  std::vector<Bounce> made;
  const measure::ReadingColumn *fall = table.find({"fall_height", "fall height", "fall"}),
                               *rebound =
                                   table.find({"rebound_height", "rebound height", "rebound"});
  if (fall != nullptr && rebound != nullptr) {
    const std::vector<double> from = measure::in_unit(table, *fall, "m"),
                              to = measure::in_unit(table, *rebound, "m");
    for (std::size_t i = 0; i < from.size(); ++i)
      if (!std::isnan(from[i] + to[i])) made.push_back(measure::bounce_of_heights(from[i], to[i]));
    return made;
  }
  const measure::ReadingColumn* time = table.find({"time", "t", "zeit"});
  if (time == nullptr) measure::missing_column(table, "fall_height or time", drop_columns);
  for (const std::vector<double>& one : times_by_drop(table, *time))
    for (const Bounce& bounce : measure::bounces_of_times(one, height)) made.push_back(bounce);
  return made;
}

std::vector<Bounce> bounces_of_file(const std::string& file, const DropArguments& given,
                                    double height) {
  const std::string text = measure::file_contents(file);
  if (!text.starts_with("RIFF")) return bounces_of_table(file, text, given, height);
  const measure::Sound sound = sound_part(file, given.sound);
  return measure::bounces_of_times(measure::hit_times(sound, hit_settings(given.sound, 2e-3)),
                                   height);
}

std::string impacts_table(const std::vector<Bounce>& all) {
  constexpr std::size_t most = 20;
  std::vector<std::array<std::string, 3>> lines{{"impact", "speed", "restitution"}};
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
    lines.push_back({all[i].first ? "first" : "later", show_rounded(all[i].speed, "m/s", 3),
                     fmt::format("{:.3f}", all[i].restitution)});
  std::string text = report::aligned(lines);
  if (all.size() > most) text += fmt::format("and {} more\n", all.size() - most);
  return text;
}

Json impacts_json(const std::vector<Bounce>& all) {
  Json list = Json::array();
  for (const Bounce& one : all)
    list.push_back(Json::object(
        {{"speed", one.speed}, {"restitution", one.restitution}, {"first", one.first}}));
  return Json::object({{"impacts", std::move(list)}});
}

int measure_drop(const DropArguments& given) {
  const double height = given.height.empty() ? std::numeric_limits<double>::quiet_NaN()
                                             : option_quantity(given.height, "m", "--height", 1e-3);
  std::vector<Bounce> all;
  for (const std::string& file : given.files)
    at_file(file, [&] {
      const std::vector<Bounce> of_file = bounces_of_file(file, given, height);
      all.insert(all.end(), of_file.begin(), of_file.end());
      return 0;
    });
  Measured measured{
      .title = fmt::format("Drop test, {} impacts", all.size()),
      .source = fmt::format("drop test {}, 95 % interval",
                            std::filesystem::path(given.files.front()).filename().string()),
      .found = at_file(given.files.front(), [&] { return measure::restitution_of(all); })};
  const double e = measured.found.list[0].value.mean, error = measured.found.list[0].value.ci95,
               speed = measured.found.list[1].value.mean;
  const double fall = speed * speed / (2 * measure::standard_gravity);
  measured.row = {
      {"fall_height (mm)", fmt::format("{:.5g}", 1e3 * fall)},
      {"rebound_height (mm)", fmt::format("{:.5g}", 1e3 * e * e * fall)},
      {"rebound_height_error (mm)", fmt::format("{:.4g}", 2e3 * e * fall * error / 1.96)}};
  measured.more = impacts_table(all);
  measured.details = impacts_json(all);
  return report_measured(given.output, measured);
}

}  // namespace

Command measure_drop_command() {
  const auto given = std::make_shared<DropArguments>();
  return {"drop", "restitution from the bounces of a dropped ball",
          joined({{{.name = "FILES",
                    .target = &given->files,
                    .about = "heights or times of bounces (CSV), or recordings (WAV)",
                    .required = true},
                   {.name = "--height",
                    .target = &given->height,
                    .about = "of the fall, where the files have times or sound: \"300 mm\""},
                   {.name = "--columns",
                    .target = &given->columns,
                    .about = "headings in place of those of the tables"}},
                  sound_options(given->sound),
                  data_options(given->output),
                  case_options(given->output)}),
          [given] { return measure_drop(*given); }};
}

}  // namespace mahlwerk::commands
