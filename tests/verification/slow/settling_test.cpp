// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The bed of a thousand balls at which the clock of another event-driven program froze.
#include "settling.hpp"

namespace mahlwerk::settling_test {
namespace {

TEST(LastingMany, thousand_balls_settle_under_gravity_and_the_clock_goes_on) {
  tests::check_settling(10, 0.2);
}

}  // namespace
}  // namespace mahlwerk::settling_test
