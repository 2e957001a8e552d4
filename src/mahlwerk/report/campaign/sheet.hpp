// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/readable.hpp"

// A campaign sorted by what its keys take, ready to be drawn and tabled.
namespace mahlwerk::report {

/// What a key takes, and what of it each point has.
struct Levels {
  std::vector<std::string> texts;  ///< each once: numbers by size, words as they come
  std::vector<double> numbers;     ///< the same as numbers in the key's unit; empty for words
  std::vector<std::size_t> of;     ///< by point: its place in `texts`
  std::size_t size() const { return texts.size(); }
  bool numeric() const { return !numbers.empty(); }
};

struct Sheet {
  const Campaign& campaign;
  std::vector<Levels> keys;         ///< of the swept keys, in their order
  std::vector<std::size_t> free;    ///< keys that vary and follow no other
  std::vector<std::size_t> shown;   ///< columns that the page shows
  std::vector<Multiple> multiples;  ///< by column: of its unit, for all points
  /// Each combination of the free keys is there once, but for a few that are missing.
  bool grid = false;
  /// Each point differs from the first in one free key at most, and there are several of them.
  bool star = false;

  explicit Sheet(const Campaign& campaign);

  /// The key with most values among those that can be an axis, or the number of keys.
  std::size_t axis() const;
  /// What of the keys `but` leaves out a point has: "diameter 5 mm, material steel".
  std::string others(std::size_t point, const std::vector<std::size_t>& but) const;
};

/// NaN where a point has none.
double value_at(const Point& point, std::size_t column);
double half_width_at(const Point& point, std::size_t column);

/// Points with different words for how the charge moves.
bool regimes_differ(const Campaign& campaign);

bool any_warnings(const Campaign& campaign);

/// What a key is called in a sentence: "rolling friction" for contact.rolling_friction.
std::string key_words(std::string_view key);
/// With its section where another key has the same last word: "balls filling".
std::string distinct_key_words(const Campaign& campaign, std::size_t key);

/// "mill.speed (rpm)".
std::string axis_label(const CampaignKey& key);
/// "D50 (µm)", "hits (/s)", in the multiple that the numbers are shown in.
std::string column_label(const Column& column, const Multiple& multiple);

/// "failed: ..." with the first line of the reason, at most `letters` of it, or "not run yet".
std::string missing_reason(const Point& point, std::size_t letters);

/// At most `letters` of a message.
std::string shortened(std::string_view message, std::size_t letters);

/// Positive numbers, nine in ten of which span two decades and more, are told apart on a
/// logarithmic axis alone.
bool over_decades(const std::vector<double>& values);

}  // namespace mahlwerk::report
