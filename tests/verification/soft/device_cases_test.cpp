// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Random cases on a device, computed by the host, beside both solvers of the processor; and the
// code for graphics cards as text.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "crowd.hpp"
#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/device/kernels.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::device_cases_test {
namespace {

template <class T>
const T& one_of(Random& random, const std::vector<T>& all) {
  const double at = random.uniform(0, static_cast<double>(all.size()));
  return all[std::min(static_cast<std::size_t>(at), all.size() - 1)];
}

/// A jar, a motion, a law with its switches, and balls of one or two sizes.
World random_world(std::uint32_t number) {
  Random random(77, number);
  const Vec3 down{0, 0, -gravity};
  const std::vector<geometry::AnyShape> shapes{
      geometry::Cylinder{0.04, 0.04}, geometry::Sphere{0.05}, geometry::Box{0.04, 0.04, 0.04},
      geometry::Capsule{0.04, 0.02}, geometry::RoundedCylinder{0.045, 0.045, 0.008}};
  const std::vector<kinematics::AnyMotion> motions{shaken(20, 0.015), kinematics::Tumbling{12},
                                                   kinematics::Planetary{0.07, 40, -2}};
  const std::vector<contact::AnyLaw> laws{contact::HertzMindlin{}, contact::HertzTsuji{},
                                          contact::LinearSpring{}, contact::WaltonBraun{},
                                          contact::Jkr{},          contact::ThorntonNing{},
                                          contact::Sjkr{},         contact::AdamsImpact{}};
  const std::vector<contact::Rolling> rolling{contact::Rolling::none, contact::Rolling::cdt,
                                              contact::Rolling::viscous, contact::Rolling::epsd,
                                              contact::Rolling::own_spin};
  World w;
  w.mill = {one_of(random, shapes), one_of(random, motions), {}, down};
  w.law = of_law(one_of(random, laws), one_of(random, rolling));
  w.law.partial_slip = random.uniform(0, 1) < 0.3;
  w.law.rescaled_unloading = !w.law.partial_slip && random.uniform(0, 1) < 0.3;
  if (random.uniform(0, 1) < 0.3) w.law.twisting = contact::Twisting::marshall;
  const double small = random.uniform(0.0004, 0.002);
  w.balls = lattice_of(64, 0.0048, {0.002, small}, random.uniform(0.1, 2));
  w.name = fmt::format("{} of {}, {} of {}", number, geometry::name_of(*w.mill.shape),
                       contact::name_of(*w.law.law), small);
  return w;
}

TEST(DeviceCases, random_ones_have_the_power_rates_and_books_of_both_solvers) {
  double worst = 0;
  std::int64_t collisions = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    const World w = random_world(number);
    SCOPED_TRACE(w.name);
    const int faces = geometry::faces(*w.mill.shape);
    soft::Settings rules{w.law, w.step, false};
    rules.device = [] { return soft::host_device(); };
    const auto device =
        soft::make_engine(w.mill, w.balls, rules, contact::PairTable(1, faces, some_pair()), 0.37);
    const auto few = crowd(w, 1, 1000), many = crowd(w);
    constexpr double time = 0.02;
    Recorder by_device, by_few, by_many;
    device->advance(time, by_device);
    few->advance(time, by_few);
    many->advance(time, by_many);
    const scene::EnergyBalance a = device->energy_balance(), b = few->energy_balance(),
                               c = many->energy_balance();
    const double scale = b.kinetic + std::abs(b.wall_work) + b.lost();
    // The solvers round sums in different orders, which collisions amplify: the solvers of the
    // processor part from each other as far as each from the device.
    const auto off = [&](double scene::EnergyBalance::*part) {
      worst = max_or_nan(worst, std::abs(a.*part - c.*part) / scale);
      EXPECT_NEAR(a.*part, c.*part, std::max(1e-9 * scale, 10 * std::abs(b.*part - c.*part)));
    };
    for (const auto part :
         {&scene::EnergyBalance::kinetic, &scene::EnergyBalance::wall_work,
          &scene::EnergyBalance::lost_normal, &scene::EnergyBalance::lost_tangential,
          &scene::EnergyBalance::lost_rolling, &scene::EnergyBalance::elastic})
      off(part);
    EXPECT_EQ(by_device.all.size(), by_many.all.size());
    EXPECT_EQ(a.lasting_contacts, c.lasting_contacts);
    collisions += a.collisions;
  }
  EXPECT_GT(collisions, 2000);
  stays_below("books of 40 cases off, largest over the energy", worst, 1e-6,
              "the same by ManyBodySolver");
}

TEST(DeviceCases, a_collision_of_two_balls_has_the_record_of_the_processor) {
  for (const contact::AnyLaw& law :
       {contact::AnyLaw(contact::HertzMindlin{}), contact::AnyLaw(contact::Jkr{}),
        contact::AnyLaw(contact::ThorntonNing{})}) {
    const scene::Ball left{0.004, 7850, {-0.0046, 0, 0}, {1, 0.2, 0}, {0, 0, 30}},
        right{0.005, 7850, {0.0046, 0.001, 0}, {-1, 0, 0.1}, {}};
    const World w{"two", still_box(0.1), {left, right}, of_law(law, contact::Rolling::epsd), 2e-7};
    soft::Settings rules{w.law, w.step, false};
    rules.device = [] { return soft::host_device(); };
    const auto device =
        soft::make_engine(w.mill, w.balls, rules, contact::PairTable(1, 6, some_pair()), 0.37);
    const auto many = crowd(w);
    Recorder by_device, by_many;
    device->advance(0.005, by_device);
    many->advance(0.005, by_many);
    ASSERT_EQ(by_device.all.size(), 1U);
    expect_same(by_device, by_many);
  }
}

/// The text of each module of device code.
std::vector<std::pair<std::string, std::string>> modules() {
  std::vector<std::pair<std::string, std::string>> all;
  if (!std::filesystem::exists(MAHLWERK_DEVICE_CODE)) return all;
  for (const auto& entry : std::filesystem::directory_iterator(MAHLWERK_DEVICE_CODE)) {
    std::ifstream in(entry.path());
    all.emplace_back(entry.path().stem().string(), std::string(std::istreambuf_iterator(in), {}));
  }
  return all;
}

TEST(DeviceCode, rounds_each_operation_and_calls_nothing_that_is_not_there) {
  const auto all = modules();
  if (all.empty()) GTEST_SKIP() << "no device code: it needs clang";
  // A product and a sum without .rn may become one operation, which rounds once.
  const std::regex operation(
      R"(\b(add|sub|mul|div|sqrt|fma|mad|rcp|rsqrt)(\.[a-z.]*)?\.f(64|32)\b)");
  for (const auto& [name, text] : all) {
    SCOPED_TRACE(name);
    EXPECT_NE(text.find(".visible .entry"), std::string::npos);
    EXPECT_EQ(text.find(".extern .func"), std::string::npos);
    int operations = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), operation), end; at != end; ++at) {
      const std::string which = (*at)[1], rounding = (*at)[2];
      ++operations;
      EXPECT_TRUE(rounding == ".rn" && which != "fma" && which != "mad") << at->str();
    }
    if (name != "periodic_box") {
      EXPECT_GT(operations, 10);
    }
  }
}

}  // namespace
}  // namespace mahlwerk::tests::device_cases_test
