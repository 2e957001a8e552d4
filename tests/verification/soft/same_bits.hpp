// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "soft.hpp"

// Comparison of two runs bit by bit.
namespace mahlwerk::tests {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
inline void expect_same(const scene::Engine& a, const scene::Engine& b) {
  EXPECT_TRUE(same_bits(a.energy_balance(), b.energy_balance()));
  const auto balls = a.balls(), others = b.balls();
  ASSERT_EQ(balls.size(), others.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(balls[i].position, others[i].position) << i;
    EXPECT_EQ(balls[i].velocity, others[i].velocity) << i;
    EXPECT_EQ(balls[i].spin, others[i].spin) << i;
  }
}
inline void expect_same(const Recorder& a, const Recorder& b) {
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t i = 0; i < a.all.size(); ++i) ASSERT_TRUE(same_bits(a.all[i], b.all[i])) << i;
}

}  // namespace mahlwerk::tests
