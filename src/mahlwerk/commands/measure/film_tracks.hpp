// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/measure/mill_motion.hpp"

// Tracks of marks from a table or from the pictures of a film.
namespace mahlwerk::commands {

/// What is said about the film; empty: not given.
struct FilmWords {
  std::string file;                ///< a table of positions, or pictures (PGM, PPM)
  std::string columns;             ///< headings in place of those of the table
  std::string frame_rate;          ///< "800 Hz"
  std::vector<std::string> marks;  ///< "320,240": places in the first picture
  std::string window;              ///< side of the search window in pixels
};

struct FilmTracks {
  measure::MarkTracks tracks = {};
  bool pixels = false;       ///< positions are in pixels, not in m
  bool in_frames = false;    ///< time counts frames, as no rate of frames was given
  std::size_t left_out = 0;  ///< rows of the table without all numbers
};

/// Throws InputError.
FilmTracks read_film(const FilmWords& words);

/// The tracks as a table.
std::string tracks_csv(const FilmTracks& film);

}  // namespace mahlwerk::commands
