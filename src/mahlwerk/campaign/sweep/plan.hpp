// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sweep.hpp"

namespace mahlwerk::campaign {

/// The points of a campaign: which values the keys of [sweep] take at each. The same sweep and seed
/// give the same points.
class Plan {
 public:
  /// Throws InputError where the values of a key leave no plan: ends of a range that are no numbers
  /// of one unit, too many points.
  Plan(const cases::Sweep& sweep, std::uint64_t seed);

  std::size_t size() const { return size_; }
  const std::vector<std::string>& keys() const { return keys_; }  ///< by name
  /// Of the keys, those whose lists go side by side with another's.
  const std::vector<std::string>& following_keys() const { return following_keys_; }
  /// Of the keys at a point, as text; empty where a key stays as the case has it.
  std::vector<std::string> values(std::size_t point) const;
  /// What makes the case that of a point: the values it does not have already.
  std::vector<cases::Override> overrides(std::size_t point) const;
  /// By point: where in the ranges it lies, 0 to 1 for each key; none on a grid.
  const std::vector<std::vector<double>>& design() const { return design_; }

  static constexpr std::size_t most_points = 10'000'000;

 private:
  /// Keys that take their values side by side; of a grid.
  struct Group {
    std::vector<std::size_t> keys;
    std::size_t length = 1;
  };
  void make_groups(const cases::Sweep& sweep);

  std::vector<std::string> keys_, following_keys_;
  std::vector<std::vector<std::string>> lists_;  ///< of a grid: by key
  std::vector<cases::SweptKey> ranges_;          ///< of any other design
  std::vector<Group> groups_;
  std::vector<std::vector<double>> design_;
  std::size_t size_ = 0;
};

/// The keys of a plan at a point; those that stay as the case has them, as `own` says, by key.
std::vector<std::string> point_values(const Plan& plan, std::size_t point,
                                      const std::vector<std::string>& own);
/// What the case says of the keys of a plan; empty where it says nothing.
std::vector<std::string> base_values(const Plan& plan, const cases::Case& what);

/// The text of the value at `place`, 0 to 1 from end to end of a range, to `digits` digits; of keys
/// that count something a whole number. Throws InputError where an end is no number, their units do
/// not fit, or a logarithmic range does not lie above 0.
std::string value_in_range(const cases::SweptKey& range, double place, int digits = 6);

}  // namespace mahlwerk::campaign
