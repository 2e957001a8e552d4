// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure film: the motion of a mill from marks in a film.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/commands/measure/film_tracks.hpp"
#include "mahlwerk/commands/measure/measure.hpp"
#include "mahlwerk/commands/measure/measured.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::commands {
namespace {

struct FilmArguments {
  FilmWords film;
  std::string mill, kind, title;
  std::string scale, distance, arm;
  std::string frequency, speed;  ///< as set at the mill, in place of --fps
  std::optional<std::filesystem::path> tracks;
  MeasureOutput output;
};

InputError film_command_fault(std::string where, std::string what, std::string remedy) {
  return InputError(
      Fault{std::move(where), std::move(what), std::move(remedy), "bad-command-line"});
}

/// The catalogue's entry of the mill with a new title, or an empty one of the kind.
cases::CatalogueEntry film_entry(const FilmArguments& given) {
  cases::CatalogueEntry entry;
  if (!given.mill.empty()) {
    entry = catalogue().find("mills", given.mill, "--mill");
    if (!given.kind.empty() && given.kind != entry.kind)
      throw film_command_fault("--kind " + given.kind,
                               fmt::format("the {} is of the kind {}", entry.title, entry.kind),
                               "leave out --kind or --mill");
  } else if (given.kind.empty()) {
    throw film_command_fault("mahlwerk measure film", "the kind of the mill is not given",
                             "give --mill NAME of the catalogue, or --kind arc-shaker (mixer "
                             "mill), vibration, planetary, circular or tumbling");
  } else {
    entry.category = "mills";
    entry.kind = given.kind;
    entry.title = "Measured mill";
  }
  if (!given.mill.empty()) entry.title += ", measured";
  if (!given.title.empty()) entry.title = given.title;
  entry.about =
      fmt::format("{}Written by mahlwerk measure film: the motion is that of one machine.",
                  given.mill.empty() ? "" : "From the entry of " + entry.name + ". ");
  entry.names.clear();
  entry.checks.clear();  // of figures that the measured values replace
  entry.name = given.output.entry ? given.output.entry->stem().string() : "measured";
  return entry;
}

/// The measured motion in the entry. What a user chooses for a run stays a range.
void put_motion(const measure::Findings& found, const std::string& source,
                cases::CatalogueEntry& entry) {
  put_in_entry(found, "mill.", source, entry);
  entry.values.erase("frequency");
  entry.values.erase("speed");
  if (const auto arm = entry.values.find("arm");
      arm != entry.values.end() && !arm->second.range[0].empty() && !arm->second.assumed)
    entry.values.erase("arc_amplitude");
}

measure::FilmSetup film_setup(const FilmArguments& given, bool pixels) {
  measure::FilmSetup setup;
  if (!pixels) setup.scale = observe::Estimate{1, 0};
  if (!pixels && !(given.scale.empty() && given.distance.empty()))
    throw film_command_fault("--scale, --distance", "the positions are lengths already",
                             "leave it out, or give the positions in pixels, \"x1 (px)\"");
  if (!given.scale.empty()) setup.scale = quantity_with_error(given.scale, "m", "--scale");
  if (!given.distance.empty())
    setup.distance = quantity_with_error(given.distance, "m", "--distance");
  if (!given.arm.empty()) setup.arm = quantity_with_error(given.arm, "m", "--arm");
  return setup;
}

/// Replaces the frequency in cycles per frame by that set at the mill.
void put_known_frequency(const FilmArguments& given, measure::Findings& found) {
  measure::Finding& own = found.list.front();
  const bool turns = own.key == "mill.speed";
  const std::string& known = turns ? given.speed : given.frequency;
  if (known.empty())
    throw film_command_fault(given.film.file, "the rate of frames is not known",
                             turns ? "give --fps 800, or --speed \"400 rpm\" as set at the mill"
                                   : "give --fps 800, or --frequency \"25 Hz\" as set at the mill");
  const observe::Estimate set =
      quantity_with_error(known, own.unit, turns ? "--speed" : "--frequency");
  const double per_second = set.mean / own.value.mean;
  found.remarks.push_back(fmt::format("With {} as set, the film has {} frames per second.",
                                      show_rounded(set.mean, own.unit),
                                      show_rounded(per_second, "", 5)));
  own.value = set;
}

void remark_film_errors(const FilmArguments& given, const FilmTracks& film,
                        measure::Findings& found) {
  for (const std::string* length : {&given.scale, &given.distance, &given.arm})
    if (!length->empty() && length->find("+-") == std::string::npos &&
        length->find("\u00b1") == std::string::npos)
      found.remarks.push_back(fmt::format(
          "\"{0}\" counts as exact; lengths follow it. Give its error: \"{0} +- ...\".", *length));
  if (film.left_out > 0)
    found.remarks.push_back(fmt::format("{} of {} rows lack a number and are left out.",
                                        film.left_out, film.left_out + film.tracks.time.size()));
}

int measure_film(const FilmArguments& given) {
  cases::CatalogueEntry entry = film_entry(given);
  if (given.tracks) refuse_existing(*given.tracks, given.output.running.force);
  const FilmTracks film = at_file(given.film.file, [&] { return read_film(given.film); });
  Measured measured{
      .title = fmt::format("{}: {}", given.film.file, entry.title), .source = {}, .found = {}};
  measured.found = at_file(given.film.file, [&] {
    return measure::mill_motion(entry.kind, film.tracks, film_setup(given, film.pixels));
  });
  if (film.in_frames) put_known_frequency(given, measured.found);
  remark_film_errors(given, film, measured.found);
  measured.source = fmt::format("film {}, {} pictures, 95 % interval",
                                std::filesystem::path(given.film.file).filename().string(),
                                film.tracks.time.size());
  put_motion(measured.found, measured.source, entry);
  measured.entry = std::move(entry);
  if (given.tracks) results::write_whole(*given.tracks, tracks_csv(film));
  return report_measured(given.output, measured);
}

Options film_options(FilmArguments& given) {
  return {{.name = "FILE",
           .target = &given.film.file,
           .about = "a table of positions (CSV: time or frame, x1, y1, x2, y2), or the pictures of "
                    "a film, one behind the other (PGM, PPM)",
           .required = true},
          {.name = "--mill",
           .target = &given.mill,
           .about = "mill of the catalogue, whose other values the entry keeps: \"MM 400\""},
          {.name = "--kind",
           .target = &given.kind,
           .about = "kind of a mill that the catalogue does not have",
           .values = {measure::filmed_kinds.begin(), measure::filmed_kinds.end()}},
          {.name = "--fps",
           .target = &given.film.frame_rate,
           .about = "frames per second of the camera, where there are no times"},
          {.name = "--frequency",
           .target = &given.frequency,
           .about = "as set at the mill, where --fps is not known: \"25 Hz\""},
          {.name = "--speed",
           .target = &given.speed,
           .about = "the same of a mill that turns: \"400 rpm\""},
          {.name = "--scale",
           .target = &given.scale,
           .about = "length of a pixel, with its error: \"0.21 +- 0.002 mm\""},
          {.name = "--distance",
           .target = &given.distance,
           .about = "in place of --scale, between marks 1 and 2: \"80 +- 0.5 mm\""},
          {.name = "--arm",
           .target = &given.arm,
           .about = "of a mixer mill with one mark: pivot to middle of the jar, \"136 +- 2 mm\""},
          {.name = "--mark",
           .target = &given.film.marks,
           .about = "place of a mark in the first picture, in pixels from the left and the top; "
                    "once for each mark",
           .type = "X,Y"},
          {.name = "--window",
           .target = &given.film.window,
           .about = "side of the square in which a mark is searched, in pixels (default: an eighth "
                    "of the picture)"},
          {.name = "--columns",
           .target = &given.film.columns,
           .about = "headings in place of those of the table: \"time (s), x1 (px), y1 (px)\""},
          {.name = "--tracks",
           .target = &given.tracks,
           .about = "file for the positions that were found in the pictures"},
          {.name = "--title", .target = &given.title, .about = "title of the catalogue entry"}};
}

}  // namespace

Command measure_film_command() {
  const auto given = std::make_shared<FilmArguments>();
  return {"film", "stroke, arm, swing, radius and ratio of a mill from marks in a film",
          joined({film_options(*given), entry_option(given->output), case_options(given->output)}),
          [given] { return measure_film(*given); }};
}

}  // namespace mahlwerk::commands
