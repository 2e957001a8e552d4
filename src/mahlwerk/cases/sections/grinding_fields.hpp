// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"

// Field tables of the numbers of grinding that belong to no model, for reader, writer and checks.
namespace mahlwerk::cases {

constexpr std::int64_t max_powder_sieves = 200;
/// Wider distributions are taken for a mistake: a factor of 20 spans four decades of sizes.
constexpr Range feed_spreads(powder::Feed::Law law) {
  return law == powder::Feed::Law::lognormal ? Range{.least = 1, .most = 20, .without_least = true}
                                             : Range{.least = 0.1, .most = 100};
}

constexpr Field<Capture> energy_share{"energy_share",
                                      "",
                                      &Capture::energy_share,
                                      {.least = 0, .most = 1, .without_least = true},
                                      "share of a collision's energy that captured grains receive",
                                      Capture::all,
                                      "all of it: an upper bound; uncalibrated"};

constexpr Field<Grinding> welding_energy{"welding_energy",
                                         "J/kg",
                                         &Grinding::welding_energy,
                                         not_negative,
                                         "specific energy below which nothing welds",
                                         0.0,
                                         "every hit may weld"};
constexpr auto grinding_shares() {
  constexpr Range shares{.least = 0, .most = 1, .without_most = true};
  return std::array{Field<Grinding>{"sticking", "", &Grinding::sticking, shares,
                                    "share of the grains that sticks to the wall and is not hit",
                                    0.0, "nothing sticks"},
                    Field<Grinding>{"welding", "", &Grinding::welding, shares,
                                    "probability that a hit without breakage welds two grains", 0.0,
                                    "nothing welds"}};
}

constexpr double octaves_below = 4096;  ///< largest size of the feed over the default of `smallest`
constexpr std::int64_t size_step = 3;   ///< `classes_per_octave` is a multiple of this, 12 at most
constexpr std::int64_t max_per_octave = 12;
constexpr std::int64_t min_sample = 100, max_sample = 1'000'000;
/// Limits of size classes. A breakage model with memory of earlier hits has many states of strength
/// in each class.
constexpr double max_size_classes = 150, max_strength_tracking_classes = 48;

}  // namespace mahlwerk::cases
