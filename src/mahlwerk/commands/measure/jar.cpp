// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure jar: the entry of a jar from a caliper, a balance and water.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/measure/measure.hpp"
#include "mahlwerk/commands/measure/measured.hpp"
#include "mahlwerk/commands/measure/sound_words.hpp"
#include "mahlwerk/measure/jar_sizes.hpp"
#include "mahlwerk/measure/readings.hpp"

namespace mahlwerk::commands {
namespace {

struct JarArguments {
  std::string file, columns, shape, title, material;
  std::string caliper = "0.1 mm", balance = "0.1 g";
  MeasureOutput output;
};

measure::JarReadings jar_readings(const JarArguments& given) {
  const measure::Readings table =
      measure::read_readings(measure::file_contents(given.file), given.file, given.columns);
  measure::JarReadings made;
  struct Use {
    std::string_view name, unit;
    std::vector<double>* values;
  };
  const Use uses[] = {{"diameter", "m", &made.diameter}, {"depth", "m", &made.depth},
                      {"water", "kg", &made.water},      {"empty", "kg", &made.empty},
                      {"full", "kg", &made.full},        {"wall", "m", &made.wall}};
  for (const measure::ReadingColumn& column : table.columns) {
    bool known = false;
    for (const Use& use : uses)
      if (table.find({use.name}) == &column) {
        *use.values = measure::in_unit(table, column, use.unit);
        known = true;
      }
    if (!known)
      measure::missing_column(
          table, "diameter, depth, water, empty, full or wall in place of " + column.name,
          "diameter (mm), depth (mm), water (g)");
  }
  if (!made.full.empty() && made.empty.empty())
    measure::missing_column(table, "empty beside full", "empty (g), full (g)");
  return made;
}

cases::CatalogueEntry jar_entry(const JarArguments& given, const measure::JarFound& found,
                                const std::string& source) {
  cases::CatalogueEntry entry;
  entry.category = "jars";
  entry.kind = given.shape;
  entry.title = given.title.empty() ? "Measured jar" : given.title;
  entry.about = "Written by mahlwerk measure jar: the sizes are those of one jar.";
  entry.name = given.output.entry ? given.output.entry->stem().string() : "measured";
  put_in_entry(found.sizes, "jar.", source, entry);
  if (!std::isnan(found.volume.mean))
    put_in_entry({{{"jar.volume", "", "m3", found.volume}}, {}, {}}, "jar.", source + ", water",
                 entry);
  if (!given.material.empty()) {
    const cases::CatalogueEntry material =
        catalogue().find("materials", given.material, "--material");
    entry.values["material"] = {.text = material.name,
                                .source = "as given to mahlwerk measure jar"};
  }
  return entry;
}

int measure_jar(const JarArguments& given) {
  const measure::JarInstruments instruments{option_quantity(given.caliper, "m", "--caliper", 0),
                                            option_quantity(given.balance, "kg", "--balance", 0)};
  const measure::JarReadings readings = jar_readings(given);
  const measure::JarFound found =
      at_file(given.file, [&] { return measure::jar_sizes(given.shape, readings, instruments); });
  Measured measured{.title = fmt::format("Jar {}, {}", given.file, given.shape),
                    .source = fmt::format("readings {}, 95 % interval",
                                          std::filesystem::path(given.file).filename().string()),
                    .found = found.sizes};
  measured.entry = jar_entry(given, found, measured.source);
  if (!std::isnan(found.volume.mean))
    measured.found.list.push_back({"", "volume by water", "m3", found.volume});
  measured.found.list.push_back({"", "volume by the sizes", "m3", found.by_sizes});
  measured.found.remarks.push_back(
      fmt::format("The intervals hold the scatter of the readings and the errors of caliper, {}, "
                  "and balance, {}.",
                  given.caliper, given.balance));
  return report_measured(given.output, measured);
}

}  // namespace

Command measure_jar_command() {
  const auto given = std::make_shared<JarArguments>();
  return {
      "jar", "sizes and volume of a jar from a caliper, a balance and water",
      joined(
          {{{.name = "FILE",
             .target = &given->file,
             .about = "readings (CSV: diameter, depth, water or empty and full, wall), "
                      "repeated in rows",
             .required = true},
            {.name = "--shape",
             .target = &given->shape,
             .about = "of the inside",
             .required = true,
             .values = {measure::measured_shapes.begin(), measure::measured_shapes.end()}},
            {.name = "--columns",
             .target = &given->columns,
             .about = "headings in place of those of the table"},
            {.name = "--caliper",
             .target = &given->caliper,
             .about = "error of a length (default \"0.1 mm\")"},
            {.name = "--balance",
             .target = &given->balance,
             .about = "error of a mass (default \"0.1 g\")"},
            {.name = "--material",
             .target = &given->material,
             .about = "of the wall, from mahlwerk list materials"},
            {.name = "--title", .target = &given->title, .about = "title of the catalogue entry"}},
           entry_option(given->output),
           case_options(given->output)}),
      [given] { return measure_jar(*given); }};
}

}  // namespace mahlwerk::commands
