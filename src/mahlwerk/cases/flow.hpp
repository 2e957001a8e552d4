// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/scene/flow.hpp"

namespace mahlwerk::cases {

/// Balls that leave the jar and enter it; absent from a case without [flow]. In the jar's own axes
/// at the start of the run; outlet and inlet do not turn with the jar.
struct Flow {
  using Feed = scene::Flow::Feed;
  Vec3 outlet;                   ///< [m] a point of the plane beyond which balls have left
  Vec3 outlet_normal{0, 0, -1};  ///< unit vector, out of the jar
  Feed feed = Feed::none;
  Vec3 inlet, inlet_size;  ///< [m] middle and edges of the box in which balls enter
  double feed_rate = 1;    ///< [1/s] with Feed::rate
  std::optional<double> feed_mass_rate = std::nullopt;  ///< [kg/s] in place of feed_rate
  std::vector<std::string> fresh_feed = {};  ///< names of ball sets that are outside at the start
  bool recirculate = false;  ///< with fresh_feed and Feed::rate: what has left is fed again
  std::optional<double> interval = std::nullopt;  ///< [s] between samples; none: a hundredth
  bool operator==(const Flow&) const = default;
};

struct BallSet;
struct Case;
/// By ball set: whether its balls are outside at the start, waiting to be fed.
std::vector<bool> fresh_sets(const Case& c);
/// The ball sets whose balls are in the jar at the start: all but the fresh feed.
std::vector<BallSet> sets_at_start(const Case& c);

}  // namespace mahlwerk::cases
