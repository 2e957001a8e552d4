// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/measure/film_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/measure/mark_tracker.hpp"
#include "mahlwerk/measure/readings.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::commands {
namespace {

using measure::ReadingColumn;
using measure::Readings;

constexpr std::string_view example_columns = "time (s), x1 (mm), y1 (mm), x2 (mm), y2 (mm)";

InputError film_option_fault(std::string where, std::string what, std::string remedy) {
  return InputError(
      Fault{std::move(where), std::move(what), std::move(remedy), "bad-command-line"});
}

/// [Hz] The rate of frames; 1 if none was given, so that time counts frames.
double frame_rate(const FilmWords& words) {
  if (words.frame_rate.empty()) return 1;
  const NumberText read = number_text(words.frame_rate);
  double rate = read.number;
  try {
    if (!read.rest.empty() && read.rest != "fps") rate = parse_in(words.frame_rate, "Hz");
  } catch (const UnitError&) {
    rate = 0;
  }
  if (rate > 0 && rate < 1e8) return rate;
  throw film_option_fault("--fps " + words.frame_rate, "this is no rate of frames",
                          "write for instance --fps 800, the frames per second of the camera");
}

bool is_pixel(std::string_view unit) {
  static constexpr std::array<std::string_view, 4> words{"px", "pixel", "pixels", "Pixel"};
  return std::ranges::find(words, unit) != words.end();
}

/// The columns x1, y1, x2, y2, ... or x, y.
std::vector<std::array<const ReadingColumn*, 2>> mark_columns(const Readings& table) {
  std::vector<std::array<const ReadingColumn*, 2>> found;
  for (int i = 1; i <= 9; ++i) {
    const ReadingColumn* x = table.find({fmt::format("x{}", i), fmt::format("x_{}", i)});
    const ReadingColumn* y = table.find({fmt::format("y{}", i), fmt::format("y_{}", i)});
    if (i == 1 && x == nullptr && y == nullptr) x = table.find({"x"}), y = table.find({"y"});
    if (x == nullptr && y == nullptr) break;
    if (x == nullptr || y == nullptr)
      measure::missing_column(table, fmt::format("{}{}", x == nullptr ? "x" : "y", i),
                              example_columns);
    found.push_back({x, y});
  }
  if (found.empty()) measure::missing_column(table, "x1", example_columns);
  return found;
}

std::vector<double> positions(const Readings& table, const ReadingColumn& column, bool pixels) {
  if (is_pixel(column.unit) != pixels)
    throw InputError(Fault{table.file, "some positions are in pixels, others are not",
                           "give all in pixels, \"x1 (px)\", or all as lengths", "bad-readings"});
  return pixels ? column.values : measure::in_unit(table, column, "m", 12);
}

/// [s] The times of the rows.
std::vector<double> times(const Readings& table, const FilmWords& words, FilmTracks& film) {
  if (const ReadingColumn* time = table.find({"time", "t", "zeit"}))
    return measure::in_unit(table, *time, "s");
  const ReadingColumn* frame = table.find({"frame", "frames", "frame number", "n", "bild"});
  if (frame == nullptr) measure::missing_column(table, "time or frame", example_columns);
  film.in_frames = words.frame_rate.empty();
  std::vector<double> made;
  for (const double n : frame->values) made.push_back(n / frame_rate(words));
  return made;
}

FilmTracks tracks_of_table(const std::string& text, const FilmWords& words) {
  const Readings table = measure::read_readings(text, words.file, words.columns);
  FilmTracks film;
  const auto columns = mark_columns(table);
  film.pixels = is_pixel(columns[0][0]->unit);
  const std::vector<double> time = times(table, words, film);
  std::vector<measure::MarkTracks::Mark> whole;
  for (const auto& [x, y] : columns)
    whole.push_back({positions(table, *x, film.pixels), positions(table, *y, film.pixels)});
  film.tracks.marks.resize(whole.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    double all = time[i];
    for (const measure::MarkTracks::Mark& mark : whole) all += mark.x[i] + mark.y[i];
    if (std::isnan(all)) {
      ++film.left_out;
      continue;
    }
    film.tracks.time.push_back(time[i]);
    for (std::size_t m = 0; m < whole.size(); ++m) {
      film.tracks.marks[m].x.push_back(whole[m].x[i]);
      film.tracks.marks[m].y.push_back(whole[m].y[i]);
    }
  }
  return film;
}

std::array<double, 2> place_of(const std::string& word) {
  const std::size_t comma = word.find(',');
  const NumberText x = number_text(trimmed(std::string_view(word).substr(0, comma)));
  const NumberText y =
      number_text(comma == std::string::npos ? std::string_view()
                                             : trimmed(std::string_view(word).substr(comma + 1)));
  if (x.rest.empty() && y.rest.empty() && x.number >= 0 && y.number >= 0 && x.number < 1e6 &&
      y.number < 1e6)
    return {x.number, y.number};
  throw film_option_fault("--mark " + word, "this is no place in a picture",
                          "write for instance --mark 320,240: pixels from the left and the top");
}

double window_of(const FilmWords& words, const measure::Picture& picture) {
  if (words.window.empty())
    return std::max(12.0, 0.125 * static_cast<double>(std::min(picture.width, picture.height)));
  const NumberText read = number_text(words.window);
  if (read.rest.empty() && read.number >= 6 && read.number < 1e5) return read.number;
  throw film_option_fault("--window " + words.window, "this is no number of pixels from 6 on",
                          "write for instance --window 60");
}

FilmTracks tracks_of_pictures(const FilmWords& words) {
  if (words.marks.empty())
    throw film_option_fault("--mark", "the marks in the film's first picture are not given",
                            "write --mark X,Y in pixels from the left and the top, once for each");
  std::vector<std::array<double, 2>> starts;
  for (const std::string& word : words.marks) starts.push_back(place_of(word));
  measure::FrameReader reader(words.file);
  std::optional<measure::Picture> picture = reader.next();
  measure::MarkTracker tracker(starts, window_of(words, *picture));
  FilmTracks film{.pixels = true, .in_frames = words.frame_rate.empty()};
  for (std::size_t n = 0; picture; ++n, picture = reader.next()) {
    tracker.follow(*picture);
    film.tracks.time.push_back(static_cast<double>(n) / frame_rate(words));
  }
  film.tracks.marks = tracker.marks();
  return film;
}

}  // namespace

FilmTracks read_film(const FilmWords& words) {
  std::ifstream stream(words.file, std::ios::binary);
  std::array<char, 2> first{};
  stream.read(first.data(), first.size());
  if (first[0] == 'P' && (first[1] == '5' || first[1] == '6')) return tracks_of_pictures(words);
  if (!words.marks.empty() && stream)
    throw film_option_fault(words.file, "--mark is for pictures, but this is no PGM or PPM file",
                            "make one: ffmpeg -i film.mp4 -f image2pipe -c:v pgm film.pgm");
  return tracks_of_table(measure::file_contents(words.file), words);
}

std::string tracks_csv(const FilmTracks& film) {
  const char* unit = film.pixels ? "px" : "m";
  std::vector<std::string> cells{film.in_frames ? "frame" : "time (s)"};
  for (std::size_t m = 1; m <= film.tracks.marks.size(); ++m)
    for (const char* axis : {"x", "y"}) cells.push_back(fmt::format("{}{} ({})", axis, m, unit));
  std::string text = results::csv_line(cells);
  for (std::size_t i = 0; i < film.tracks.time.size(); ++i) {
    cells = {results::csv_cell(film.tracks.time[i])};
    for (const measure::MarkTracks::Mark& mark : film.tracks.marks) {
      cells.push_back(results::csv_cell(mark.x[i]));
      cells.push_back(results::csv_cell(mark.y[i]));
    }
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::commands
