// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/mark_tracker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::measure {
namespace {

constexpr double least_contrast = 0.05;  // of the range from black to white

/// The pixels of a square window.
struct WindowPixels {
  std::size_t left, right, top, bottom;
  double median, least, most;
};

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

WindowPixels window_at(const Picture& picture, std::array<double, 2> place, double side) {
  const auto edge = [](double at, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(size)));
  };
  WindowPixels made{edge(std::round(place[0] - side / 2), picture.width),
                    edge(std::round(place[0] + side / 2) + 1, picture.width),
                    edge(std::round(place[1] - side / 2), picture.height),
                    edge(std::round(place[1] + side / 2) + 1, picture.height),
                    0,
                    0,
                    0};
  std::vector<double> grey;
  for (std::size_t y = made.top; y < made.bottom; ++y)
    for (std::size_t x = made.left; x < made.right; ++x) grey.push_back(picture.at(x, y));
  if (grey.empty()) return made;
  made.least = std::ranges::min(grey);
  made.most = std::ranges::max(grey);
  made.median = median_of(std::move(grey));
  return made;
}

}  // namespace

MarkTracker::MarkTracker(std::vector<std::array<double, 2>> starts, double window)
    : starts_(std::move(starts)),
      window_(window),
      signs_(starts_.size(), 0),
      marks_(starts_.size()) {}

void MarkTracker::lose(std::size_t mark, const std::string& why) const {
  throw InputError(
      Fault{"", fmt::format("mark {}, picture {}: {}", mark + 1, marks_[mark].x.size() + 1, why),
            "give its place in the first picture, --mark X,Y in pixels from the upper left corner, "
            "a larger --window, or a film with more contrast and more frames per second",
            "bad-readings"});
}

std::array<double, 2> MarkTracker::centroid(const Picture& picture, std::size_t mark,
                                            std::array<double, 2> place) {
  const WindowPixels w = window_at(picture, place, window_);
  if (w.right < w.left + 3 || w.bottom < w.top + 3) lose(mark, "it leaves the picture");
  double& sign = signs_[mark];
  if (sign == 0) sign = w.most - w.median >= w.median - w.least ? 1 : -1;
  const double contrast = sign > 0 ? w.most - w.median : w.median - w.least;
  if (contrast < least_contrast) lose(mark, "there is no spot in its window");
  double sum = 0, x_sum = 0, y_sum = 0;
  for (std::size_t y = w.top; y < w.bottom; ++y)
    for (std::size_t x = w.left; x < w.right; ++x) {
      const double weight = sign * (picture.at(x, y) - w.median) - 0.4 * contrast;
      if (weight <= 0) continue;
      sum += weight;
      x_sum += weight * static_cast<double>(x);
      y_sum += weight * static_cast<double>(y);
    }
  return {x_sum / sum, y_sum / sum};
}

void MarkTracker::follow(const Picture& picture) {
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    MarkTracks::Mark& mark = marks_[i];
    const std::size_t n = mark.x.size();
    std::array<double, 2> expected = starts_[i];
    if (n == 1) expected = {mark.x[0], mark.y[0]};
    if (n > 1) expected = {2 * mark.x[n - 1] - mark.x[n - 2], 2 * mark.y[n - 1] - mark.y[n - 2]};
    std::array<double, 2> found = expected;
    for (int round = 0; round < 4; ++round) found = centroid(picture, i, found);
    if (math::hypot(found[0] - expected[0], found[1] - expected[1]) > window_)
      lose(i, "it jumps out of its window");
    mark.x.push_back(found[0]);
    mark.y.push_back(found[1]);
  }
}

}  // namespace mahlwerk::measure
