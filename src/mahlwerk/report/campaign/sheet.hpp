// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/text/readable.hpp"

// A campaign with the levels of its keys, prepared for plots and tables.
namespace mahlwerk::report {

/// The distinct values (levels) of a key, and the level of each point.
struct Levels {
  std::vector<std::string> texts;  ///< distinct: numbers ascending, words in order of appearance
  std::vector<double> numbers;     ///< the same as numbers in the key's unit; empty for words
  std::vector<std::size_t> of;     ///< by point: its index in `texts`
  std::size_t size() const { return texts.size(); }
  bool numeric() const { return !numbers.empty(); }
};

struct Sheet {
  const Campaign& campaign;
  std::vector<Levels> keys;         ///< of the swept keys, in their order
  std::vector<std::size_t> free;    ///< keys that vary independently
  std::vector<std::size_t> shown;   ///< indices of the columns that the page shows
  std::vector<Multiple> multiples;  ///< by column: of its unit, for all points
  /// The points form a full grid of the free keys: each combination once, up to a few missing ones.
  bool grid = false;
  /// Star design: each point differs from the first in at most one of several free keys.
  bool star = false;

  explicit Sheet(const Campaign& campaign);

  /// Index of the free numeric key with the most values, or the number of keys if there is none.
  std::size_t axis() const;
  /// The point's values of all free keys except `but`: "diameter 5 mm, material steel".
  std::string others(std::size_t point, const std::vector<std::size_t>& but) const;
};

/// Whether the points have different regimes.
bool regimes_differ(const Campaign& campaign);

bool any_warnings(const Campaign& campaign);

/// Name of a key in a sentence: "rolling friction" for contact.rolling_friction.
std::string key_words(std::string_view key);
/// The same, with its section if another key has the same last word: "balls filling".
std::string distinct_key_words(const Campaign& campaign, std::size_t key);

/// "mill.speed (rpm)".
std::string axis_label(const CampaignKey& key);
/// "D50 (µm)", "hits (/s)", with the displayed multiple of the unit.
std::string column_label(const Column& column, const Multiple& multiple);

/// "failed: ..." with the first line of the reason, at most `letters` of it, or "not run yet".
std::string missing_reason(const Point& point, std::size_t letters);

/// A message cut to at most `letters` characters.
std::string shortened(std::string_view message, std::size_t letters);

/// Whether the values need a logarithmic axis: all positive, and the middle nine tenths span at
/// least two decades.
bool over_decades(const std::vector<double>& values);

}  // namespace mahlwerk::report
