// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/measure/fourier.hpp"
#include "mahlwerk/measure/propagation.hpp"
#include "noise.hpp"

namespace mahlwerk::measure::numerics_test {
namespace {

TEST(FourierTransform, is_its_sum) {
  tests::Noise noise(2, 1);
  std::vector<Complex> values;
  for (int i = 0; i < 32; ++i) {
    const double real = noise(), imaginary = noise();
    values.emplace_back(real, imaginary);
  }
  std::vector<Complex> transformed = values;
  fourier_transform(transformed);
  for (std::size_t j = 0; j < 32; ++j) {
    Complex sum = 0;
    for (std::size_t k = 0; k < 32; ++k)
      sum += values[k] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * k) / 32);
    EXPECT_NEAR(std::abs(sum - transformed[j]), 0, 1e-12);
  }
  std::vector<Complex> one{3.0};
  fourier_transform(one);
  EXPECT_EQ(one[0], 3.0);
}

TEST(PeakFrequency, has_the_sense_of_rotation) {
  std::vector<double> t, x, y;
  for (int i = 0; i < 200; ++i) {
    t.push_back(0.01 * i);
    x.push_back(std::cos(-2 * std::numbers::pi * 7 * t.back()) + 0.5 * t.back());
    y.push_back(std::sin(-2 * std::numbers::pi * 7 * t.back()));
  }
  EXPECT_NEAR(peak_frequency({even_series(t, x, y)}, true), -7, 0.2);
  EXPECT_NEAR(peak_frequency({even_series(t, x, x)}, false), 7, 0.2);
  t.back() = 1e6;
  EXPECT_THROW(even_series(t, x, y), InputError);
}

TEST(Propagation, adds_squares_and_knows_what_results_share) {
  const Propagated made = propagated({{3, 0.3}, {4, 0.8}, {5, NAN}}, [](const auto& in) {
    return std::vector{in[0] * in[1], in[1] / in[2]};
  });
  EXPECT_DOUBLE_EQ(made.results[0].mean, 12);
  EXPECT_NEAR(made.results[0].ci95, std::hypot(4 * 0.3, 3 * 0.8), 1e-12);
  EXPECT_NEAR(made.results[1].ci95, 0.16, 1e-12);
  EXPECT_NEAR(made.covariance[1], 3 * 0.8 * 0.16, 1e-12);
  EXPECT_EQ(made.covariance[1], made.covariance[2]);
}

}  // namespace
}  // namespace mahlwerk::measure::numerics_test
