// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sweep.hpp"

namespace mahlwerk::campaign {

/// The points of a campaign: the values of the keys of [sweep] at each. The same sweep and seed
/// give the same points.
class Plan {
 public:
  /// Throws InputError if the values of a key give no plan: the ends of a range are not numbers of
  /// one unit, or there are too many points.
  Plan(const cases::Sweep& sweep, std::uint64_t seed);

  std::size_t size() const { return size_; }
  const std::vector<std::string>& keys() const { return keys_; }  ///< names of the varied keys
  /// Keys whose lists vary together with the list of another key.
  const std::vector<std::string>& following_keys() const { return following_keys_; }
  /// Values of the keys at a point, as text; empty where a key keeps the value of the case.
  std::vector<std::string> values(std::size_t point) const;
  /// Overrides that turn the case into that of a point.
  std::vector<cases::Override> overrides(std::size_t point) const;
  /// By point: position in the ranges, 0 to 1 for each key; empty for a grid.
  const std::vector<std::vector<double>>& design() const { return design_; }

  static constexpr std::size_t max_points = 10'000'000;

 private:
  /// Keys of a grid whose values vary together.
  struct Group {
    std::vector<std::size_t> keys;
    std::size_t length = 1;
  };
  void make_groups(const cases::Sweep& sweep);

  std::vector<std::string> keys_, following_keys_;
  std::vector<std::vector<std::string>> lists_;  ///< values of a grid, by key
  std::vector<cases::SweptKey> ranges_;          ///< ranges of any other design
  std::vector<Group> groups_;
  std::vector<std::vector<double>> design_;
  std::size_t size_ = 0;
};

/// Values of a plan's keys at a point; a key that keeps the value of the case takes it from `own`,
/// by key.
std::vector<std::string> point_values(const Plan& plan, std::size_t point,
                                      const std::vector<std::string>& own);
/// Values of a plan's keys in the case; empty where it has none.
std::vector<std::string> base_values(const Plan& plan, const cases::Case& mill_case);

/// The unit of a range: that of its upper end; empty: none.
std::string unit_of_range(const cases::SweptKey& range);
/// A value of a range, "412 rpm", as a number in `unit`.
double number_in(const std::string& text, const std::string& unit);

/// The value at `place`, 0 to 1 from end to end of a range, as text with `digits` digits; a whole
/// number for keys that count something. Throws InputError if an end is not a number, the units do
/// not fit, or a logarithmic range is not above 0.
std::string value_in_range(const cases::SweptKey& range, double place, int digits = 6);

}  // namespace mahlwerk::campaign
