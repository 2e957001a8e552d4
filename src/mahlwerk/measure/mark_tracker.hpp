// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/measure/frames.hpp"
#include "mahlwerk/measure/mill_motion.hpp"

namespace mahlwerk::measure {

/// Follows bright or dark spots through the pictures of a film, each in a square window about the
/// place where the last two pictures let it be expected.
class MarkTracker {
 public:
  /// `starts`: places [pixel] of the marks in the first picture, x to the right and y down;
  /// `window`: side of the square in pixels, at least 6, of which the mark takes a quarter or less.
  MarkTracker(std::vector<std::array<double, 2>> starts, double window);

  /// Finds the marks in the next picture: their centroids to a fraction of a pixel. Throws
  /// InputError if a mark has no contrast, leaves the picture, or jumps out of its window.
  void follow(const Picture& picture);

  /// The places so far, in pixels.
  const std::vector<MarkTracks::Mark>& marks() const { return marks_; }

 private:
  std::array<double, 2> centroid(const Picture& picture, std::size_t mark,
                                 std::array<double, 2> place);
  [[noreturn]] void lose(std::size_t mark, const std::string& why) const;

  std::vector<std::array<double, 2>> starts_;
  double window_;
  std::vector<double> signs_;  ///< of each mark: 1 bright, -1 dark, 0 not yet known
  std::vector<MarkTracks::Mark> marks_;
};

}  // namespace mahlwerk::measure
