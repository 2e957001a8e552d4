// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/accelerometer/impact_record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/trig.hpp"
#include "statement.hpp"

namespace mahlwerk::parts::accelerometer::impact_record_test {
namespace {

using tests::states;

scene::Collision impact(double time, double duration, double impulse, const Vec3& normal) {
  scene::Collision c;
  c.time = time;
  c.duration = duration;
  c.other = -1;
  c.impulse = impulse;
  c.normal = normal;
  return c;
}

ImpactRecord with(std::initializer_list<scene::Collision> all, const Vec3& axis = {0, 0, 1}) {
  ImpactRecord record(axis, 1, 0.125, 8);  // from 1 s to 2 s
  record.collisions({all.begin(), all.size()});
  return record;
}

double sum(const ImpactRecord& record) {
  return std::accumulate(record.impulses().begin(), record.impulses().end(), 0.0);
}

TEST(ImpactRecord, has_the_impulse_along_its_axis_at_the_time_of_the_impact) {
  const ImpactRecord r = with({impact(1.3, 0, 2, {0, 0.6, -0.8})});
  for (std::size_t i = 0; i < 8; ++i) EXPECT_DOUBLE_EQ(r.impulses()[i], i == 2 ? -1.6 : 0) << i;
}

TEST(ImpactRecord, spreads_the_impulse_over_the_contact) {
  const ImpactRecord r = with({impact(1.1875, 0.25, 4, {0, 0, 1})});
  EXPECT_DOUBLE_EQ(r.impulses()[0], 0);
  EXPECT_DOUBLE_EQ(r.impulses()[1], 1);
  EXPECT_DOUBLE_EQ(r.impulses()[2], 2);
  EXPECT_DOUBLE_EQ(r.impulses()[3], 1);
  EXPECT_DOUBLE_EQ(r.impulses()[4], 0);
}

TEST(ImpactRecord, has_the_part_of_a_contact_within_its_time) {
  states("begun before [N s]", sum(with({impact(0.5, 1, 4, {0, 0, 1})})), 2, 1e-15, "half of it");
  states("ended after [N s]", sum(with({impact(1.75, 1, 4, {0, 0, 1})})), 1, 1e-15, "a quarter");
  states("longer than the record [N s]", sum(with({impact(0, 4, 4, {0, 0, 1})})), 1, 1e-15,
         "a quarter");
  for (const double time : {-1e9, 0.0, 0.9, 2.0, 1e9})
    EXPECT_EQ(sum(with({impact(time, 0, 4, {0, 0, 1})})), 0) << time;
  scene::Collision between = impact(1.5, 0, 4, {0, 0, 1});
  between.other = 2;
  EXPECT_EQ(sum(with({between})), 0);
}

constexpr double bandwidth = 100;  // [Hz]

TEST(ImpactRecord, goes_on_from_its_saved_state_and_refuses_one_of_another_length) {
  ImpactRecord one = with({impact(1.3, 0, 2, {0, 0, 1})}), again = with({});
  ImpactRecord longer({0, 0, 1}, 1, 0.125, 9);
  Archive out;
  one.serialize(out);
  Archive in(out.bytes()), into_longer(out.bytes());
  again.serialize(in);
  in.finish();
  EXPECT_EQ(again.impulses(), one.impulses());
  EXPECT_THROW(longer.serialize(into_longer), RunError);
}

TEST(LowPass, of_a_constant_stays_there) {
  for (const double a : low_pass(std::vector<double>(1000, 3.5), 1e-3, bandwidth, 3.5))
    EXPECT_DOUBLE_EQ(a, 3.5);
}

TEST(LowPass, of_an_impulse_decays_as_the_closed_form) {
  constexpr double step = 1e-6;
  std::vector<double> input(20'000, 0.0);
  input[0] = 1 / step;  // a unit impulse within the first step
  const std::vector<double> output = low_pass(input, step, bandwidth, 0);
  const double sigma = std::numbers::sqrt2 * std::numbers::pi * bandwidth;
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double t = step * (static_cast<double>(i) + 0.5);  // since the middle of the impulse
    const double exact = 2 * sigma * math::exp(-sigma * t) * sin_cos(sigma * t).sin;
    worst = std::max(worst, std::abs(output[i] - exact));
    largest = std::max(largest, output[i]);
  }
  const double omega = 2 * std::numbers::pi * bandwidth;
  states("largest deviation over the peak", worst / largest, 0, (sigma * step) * (sigma * step),
         "second order in the step");
  states("peak [1/s]", largest, omega * math::exp(-std::numbers::pi / 4),
         omega * (sigma * step) * (sigma * step), "omega exp(-pi/4) (sns.6)");
}

TEST(LowPass, of_a_sine_has_the_amplitude_of_butterworth) {
  for (const double frequency : {10.0, 100.0, 300.0}) {
    constexpr double step = 1e-5;
    std::vector<double> input(50'000);
    for (std::size_t i = 0; i < input.size(); ++i)
      input[i] =
          sin_cos(2 * std::numbers::pi * frequency * step * (static_cast<double>(i) + 0.5)).sin;
    const std::vector<double> output = low_pass(input, step, bandwidth, 0);
    const double ratio = frequency / bandwidth;
    const double angle = std::numbers::pi * frequency * step;  // of half a step
    states(fmt::format("amplitude at {} Hz", frequency),
           *std::max_element(output.begin() + 25'000, output.end()),
           1 / std::sqrt(1 + ratio * ratio * ratio * ratio), angle * angle,
           "1/sqrt(1 + (f/f_b)^4), error by the step");
  }
}

TEST(LowPass, does_not_depend_on_the_step_of_a_constant_input) {
  const double fine = low_pass(std::vector<double>(1000, 1.0), 1e-5, bandwidth, 0).back();
  const double coarse = low_pass(std::vector<double>(1, 1.0), 1e-2, bandwidth, 0).back();
  states("response after 10 ms", coarse, fine, 1e-12, "exact for a constant input (sns.6)");
}

}  // namespace
}  // namespace mahlwerk::parts::accelerometer::impact_record_test
