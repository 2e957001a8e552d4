// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine on a device (DeviceSolver), computed by the host: the same physics as the solvers
// of the processor, and the same bits however a run is cut, stopped or divided among threads.
#include "mahlwerk/soft/device/device.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>
#include <utility>
#include <variant>

#include "crowd.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/mesh_wall.hpp"
#include "mahlwerk/soft/on_device.hpp"
#include "meshes.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::device_test {
namespace {

/// A vessel whose stirrer is at its initial angle when runs begin, at 0.37 s.
World stirred() {
  geometry::Attritor vessel{.diameter = 0.06,
                            .height = 0.05,
                            .shaft_diameter = 0.012,
                            .shaft_clearance = 0.008,
                            .arms = 2,
                            .arm_diameter = 0.006,
                            .arm_span = 0.04,
                            .arm_clearance = 0.014,
                            .arm_spacing = 0.014,
                            .rotor_speed = 8 * std::numbers::pi / 0.37};
  vessel.complete();
  std::vector<scene::Ball> balls = lattice_of(200, 0.0058, {0.0025});
  std::erase_if(balls, [&](const scene::Ball& b) {
    double least = geometry::never;
    for (int face = 0; face < vessel.faces; ++face)
      least = std::min(least, vessel.gap(face, b.position).distance);
    return least < 1.02 * b.radius;
  });
  return {"stirred",
          {vessel, kinematics::Still{}, {}, {0, 0, -gravity}},
          balls,
          of_law(contact::HertzMindlin{}, contact::Rolling::cdt)};
}

/// Jars of triangles: a drum with bars, and dents all round, with few and with many creases.
std::vector<World> mesh_worlds() {
  const Vec3 down{0, 0, -gravity};
  const geometry::Mesh drum = mesh_of(drum_with_lifters(0.05, 0.04, 6, 0.003, 0.004)),
                       smooth = mesh_of(lumpy(0.026)), creased = mesh_of(lumpy(0.026, 2), 0.2);
  const kinematics::Planetary planet{0.07, 40, -2};
  return {{"mesh, drum with bars",
           {drum, kinematics::Tumbling{12}, scene::mounted_along({1, 0, 0}), down},
           lattice_of(60, 0.0055, {0.0025}, 2),
           of_law(contact::HertzMindlin{}, contact::Rolling::cdt)},
          {"mesh, dents",
           {smooth, planet, {}, down},
           lattice_of(60, 0.0055, {0.0025, 0.0015}, 2),
           of_law(contact::WaltonBraun{}, contact::Rolling::epsd)},
          {"mesh, dents with creases, sticking",
           {creased, shaken(20, 0.015), {}, down},
           lattice_of(60, 0.0055, {0.0025, 0.002}, 2),
           of_law(contact::Jkr{}, contact::Rolling::viscous)}};
}

/// Charges that a device computes: all but curved walls.
std::vector<World> device_worlds() {
  std::vector<World> all = worlds();
  std::erase_if(all, [](const World& w) { return w.law.curved_walls; });
  for (World& w : mesh_worlds()) all.push_back(std::move(w));
  all.push_back(stirred());
  World bars = all.front();
  bars.name = "drum with bars";
  geometry::LifterCylinder drum;
  drum.diameter = 0.05, drum.height = 0.04, drum.lifters = 6, drum.lifter_height = 0.003,
  drum.lifter_width = 0.004, drum.lifter_face_angle = 1.2;
  drum.complete();
  bars.mill = {drum, kinematics::Tumbling{12}, scene::mounted_along({1, 0, 0}), {0, 0, -gravity}};
  bars.balls = lattice_of(60, 0.0055, {0.0025}, 2);
  all.push_back(bars);
  return all;
}

using MakeDevice = std::function<std::shared_ptr<soft::Device>()>;

std::unique_ptr<scene::Engine> on_device(const World& w, const MakeDevice& device) {
  const int faces = geometry::faces(*w.mill.shape);
  soft::Settings rules{w.law, w.step, false};
  rules.device = device;
  rules.few_ball_limit = 0;  // the processor takes its states with ManyBodySolver
  return soft::make_engine(w.mill, w.balls, rules, contact::PairTable(1, faces, some_pair()), 0.37);
}
std::unique_ptr<scene::Engine> on_device(const World& w, int threads = 1) {
  return on_device(w, [=] { return soft::host_device(threads); });
}

TEST(DeviceSolver, moves_as_many_balls_do) {
  // Same laws and same steps, but sums in another order: rounding errors grow with each collision.
  // The tolerance follows from a third run whose start is displaced by 1e-13 m.
  for (const World& w : device_worlds()) {
    SCOPED_TRACE(w.name);
    World aside = w;
    for (scene::Ball& b : aside.balls) b.position.x += 1e-13;
    const auto many = crowd(w), device = on_device(w), nudged = on_device(aside);
    Recorder by_many, by_device, by_nudged;
    const double time = 0.03;
    many->advance(time, by_many);
    device->advance(time, by_device);
    nudged->advance(time, by_nudged);
    const auto a = many->balls(), b = device->balls(), c = nudged->balls();
    double off = 0, grown = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      off = max_or_nan(off, norm(a[i].position - b[i].position));
      grown = max_or_nan(grown, norm(c[i].position - b[i].position));
    }
    EXPECT_GT(by_device.all.size(), 30U);
    const auto at_walls = std::ranges::count_if(
        by_device.all, [](const scene::Collision& hit) { return hit.other < 0; });
    EXPECT_GT(at_walls, geometry::faces(*w.mill.shape) > 0 ? 5 : -1);
    EXPECT_EQ(by_many.all.size(), by_device.all.size());
    stays_below(w.name + ": positions off after 30 ms [m]", off, std::max(1e-12, 10 * grown),
                "the same by ManyBodySolver; grown from 1e-13 m");
    const scene::EnergyBalance x = many->energy_balance(), y = device->energy_balance();
    const double scale = x.kinetic + std::abs(x.wall_work) + x.lost();
    for (const auto part :
         {&scene::EnergyBalance::kinetic, &scene::EnergyBalance::potential,
          &scene::EnergyBalance::elastic, &scene::EnergyBalance::wall_work,
          &scene::EnergyBalance::lost_normal, &scene::EnergyBalance::lost_tangential,
          &scene::EnergyBalance::lost_rolling, &scene::EnergyBalance::slid,
          &scene::EnergyBalance::lost_open})
      EXPECT_NEAR(x.*part, y.*part, std::max(1e-9, 1e6 * grown) * scale);
    EXPECT_NEAR(x.contact_time, y.contact_time, 20 * w.step);
    EXPECT_EQ(x.collisions, y.collisions);
    EXPECT_EQ(x.lasting_contacts, y.lasting_contacts);
  }
}

TEST(DeviceSolver, gives_the_same_bits_on_any_number_of_threads) {
  std::vector<World> some = device_worlds();
  some.resize(3);  // threads wait for each other where other tests take the processors
  for (const World& w : some) {
    SCOPED_TRACE(w.name);
    const auto one = on_device(w), two = on_device(w, 2);
    Recorder by_one, by_two;
    one->advance(0.01, by_one);
    two->advance(0.01, by_two);
    EXPECT_GT(by_one.all.size(), 20U);
    expect_same(by_one, by_two);
    expect_same(*one, *two);
  }
}

TEST(DeviceSolver, cuts_do_not_change_a_run_by_a_bit) {
  constexpr double time = 0.03;
  for (const World& w : device_worlds()) {
    SCOPED_TRACE(w.name);
    const auto whole = on_device(w), pieces = on_device(w);
    Recorder in_one, in_many;
    whole->advance(time, in_one);
    Random random(3, 0);
    std::vector<double> cuts{time};
    for (int i = 0; i < 100; ++i) cuts.push_back(random.uniform(0, time));
    std::ranges::sort(cuts);
    for (const double cut : cuts) pieces->advance(cut, in_many);
    expect_same(in_one, in_many);
    expect_same(*whole, *pieces);
  }
}

TEST(DeviceSolver, resumed_runs_go_on_to_the_bit) {
  constexpr double time = 0.02;
  for (const World& w : device_worlds())
    for (const double when : {0.0, 1e-4, 0.0113}) {
      SCOPED_TRACE(fmt::format("{} at {}", w.name, when));
      const auto whole = on_device(w), first = on_device(w), second = on_device(w);
      Recorder in_one, in_two;
      whole->advance(when, in_one);
      whole->advance(time, in_one);
      first->advance(when, in_two);
      copy_state(*first, *second);
      expect_same(*first, *second);
      second->advance(time, in_two);
      expect_same(in_one, in_two);
      expect_same(*whole, *second);
    }
}

/// Continues a run of `first` with `second` at 7 ms, up to 12 ms.
std::vector<scene::Ball> continued(scene::Engine& first, scene::Engine& second, Recorder& all) {
  first.advance(0.007, all);
  copy_state(first, second);
  const scene::EnergyBalance a = first.energy_balance(), b = second.energy_balance();
  const double scale = a.kinetic + std::abs(a.wall_work) + a.lost();
  for (const auto part : {&scene::EnergyBalance::kinetic, &scene::EnergyBalance::elastic,
                          &scene::EnergyBalance::wall_work, &scene::EnergyBalance::lost_normal,
                          &scene::EnergyBalance::lost_tangential, &scene::EnergyBalance::lost_open,
                          &scene::EnergyBalance::slid, &scene::EnergyBalance::initial_energy})
    EXPECT_NEAR(a.*part, b.*part, 1e-9 * scale);
  EXPECT_NEAR(a.contact_time, b.contact_time, 1e-9 * a.contact_time);
  EXPECT_EQ(a.collisions, b.collisions);
  second.advance(0.012, all);
  EXPECT_LT(std::abs(second.energy_balance().residual()), 1e-2 * scale);
  return second.balls();
}

TEST(DeviceSolver, and_the_solver_of_many_balls_continue_each_other) {
  for (World w : device_worlds()) {
    SCOPED_TRACE(w.name);
    const auto whole = crowd(w), many = crowd(w), device = on_device(w), later_many = crowd(w),
               later_device = on_device(w);
    Recorder by_one, by_device, by_many;
    whole->advance(0.012, by_one);
    const auto expected = whole->balls(), to_device = continued(*many, *later_device, by_device),
               to_many = continued(*device, *later_many, by_many);
    // As moves_as_many_balls_do, whose errors grow to some 1e-17 m.
    double off = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
      off = max_or_nan(off, max_or_nan(norm(expected[k].position - to_device[k].position),
                                       norm(expected[k].position - to_many[k].position)));
    stays_below(w.name + ": positions off after a change at 7 ms [m]", off, 1e-12,
                "one solver from the start");
    EXPECT_EQ(by_one.all.size(), by_device.all.size());
    EXPECT_EQ(by_one.all.size(), by_many.all.size());
  }
}

/// What a run says that ends with an error.
std::string error_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

TEST(DeviceSolver, finds_a_ball_outside_a_mesh_as_many_balls_do) {
  // Behind a wall within reach, and beyond the extent.
  for (const World& jar : mesh_worlds())
    for (const double past : {1e-4, 0.02}) {
      SCOPED_TRACE(jar.name);
      World w = jar;
      w.mill.motion = kinematics::Still{}, w.mill.mount = {};
      const auto& mesh = std::get<geometry::Mesh>(*w.mill.shape);
      const double reach = 0.06, step = 1e-6;
      const Vec3 along{0.36, 0.48, 0.8};
      double out = 0;
      while (mesh.wall()->nearest(out * along).gap.distance > 0 && out < reach) out += step;
      w.balls[7].position = (out + past) * along;
      const std::string many = error_of([&] { crowd(w); }),
                        device = error_of([&] { on_device(w); });
      EXPECT_NE(device.find("ball 8, or a part of it, starts outside the jar"), std::string::npos)
          << device;
      EXPECT_EQ(many, device);
    }
}

/// Runs with the pretended card, or with the driver that MAHLWERK_TEST_CARD names
/// (tools/gpu_check).
class GraphicsCard : public testing::Test {
 protected:
  GraphicsCard() {
    setenv("MAHLWERK_CUDA_DRIVER", real() ? std::getenv("MAHLWERK_TEST_CARD") : MAHLWERK_CARD, 1);
  }
  static bool real() { return std::getenv("MAHLWERK_TEST_CARD") != nullptr; }
  ~GraphicsCard() override {
    for (const char* name : {"MAHLWERK_CUDA_DRIVER", "MAHLWERK_CARD_FAILS", "MAHLWERK_CARD_MEMORY"})
      unsetenv(name);
  }
  void SetUp() override {
    if (!real() && !std::filesystem::exists(MAHLWERK_DEVICE_CODE "/common.ptx"))
      GTEST_SKIP() << "no device code: it needs clang";
  }
};

TEST_F(GraphicsCard, computes_the_bits_of_the_host_in_any_order_of_threads) {
  for (const World& w : device_worlds()) {
    SCOPED_TRACE(w.name);
    const auto host = on_device(w), card = on_device(w, soft::graphics_card);
    Recorder by_host, by_card;
    host->advance(0.02, by_host);
    card->advance(0.02, by_card);
    EXPECT_GT(by_host.all.size(), 40U);
    expect_same(by_host, by_card);
    expect_same(*host, *card);
  }
}

TEST_F(GraphicsCard, computes_the_bits_of_the_host_for_ten_thousand_balls) {
  const char* said = std::getenv("MAHLWERK_CARD_STEPS");
  const int steps = said != nullptr ? std::atoi(said) : real() ? 10000 : 60;
  World w = drum_of(10000);
  w.mill.shape = geometry::Sphere{0.09};
  const auto host = on_device(w, 2), card = on_device(w, soft::graphics_card);
  Recorder by_host, by_card;
  host->advance(steps * w.step, by_host);
  card->advance(steps * w.step, by_card);
  expect_same(by_host, by_card);
  expect_same(*host, *card);
}

TEST_F(GraphicsCard, that_fails_ends_a_run_with_its_words_and_loses_no_collision) {
  if (real()) GTEST_SKIP() << "a card does not fail on demand";
  World w = device_worlds().front();
  Recorder whole;
  on_device(w)->advance(0.02, whole);
  const auto card = on_device(w, soft::graphics_card);
  Recorder part;
  card->advance(0.01, part);
  setenv("MAHLWERK_CARD_FAILS", "cuCtxSynchronize 60", 1);
  const std::string words = error_of([&] {
    for (double t = 0.01; t < 0.05; t += 1e-4) card->advance(t, part);
  });
  EXPECT_EQ(words, "the graphics card Pretended Card failed (compute): unspecified launch failure");
  ASSERT_GT(part.all.size(), 10U);
  for (std::size_t k = 0; k < std::min(part.all.size(), whole.all.size()); ++k)
    EXPECT_TRUE(same_bits(part.all[k], whole.all[k])) << k;
}

TEST_F(GraphicsCard, without_enough_memory_is_refused) {
  if (real()) GTEST_SKIP() << "a card has memory";
  setenv("MAHLWERK_CARD_MEMORY", "200000", 1);
  const World w = device_worlds().front();
  const std::string words = error_of([&] { on_device(w, soft::graphics_card); });
  EXPECT_TRUE(words.starts_with("the memory of the graphics card Pretended Card is full")) << words;
}

TEST(GraphicsCards, that_are_not_there_are_named) {
  setenv("MAHLWERK_CUDA_DRIVER", "/nowhere/libcuda.so", 1);
  const std::string words = error_of([] { soft::graphics_card(); });
  unsetenv("MAHLWERK_CUDA_DRIVER");
  EXPECT_NE(words.find("there is no driver library /nowhere/libcuda.so"), std::string::npos)
      << words;
}

}  // namespace
}  // namespace mahlwerk::tests::device_test
