// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Drums of balls on the graphics card of this machine (soft/device/): ball-steps a second by wall
// time, memory of the card, and the share of each kernel.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "charges.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Measures each kernel of another device, once `measuring`, and its memory.
class MeasuredDevice final : public soft::Device {
 public:
  explicit MeasuredDevice(std::shared_ptr<soft::Device> of) : of_(std::move(of)) {}

  std::string name() const override { return of_->name(); }
  std::size_t free_bytes() const override { return of_->free_bytes(); }
  void* allocate(std::size_t bytes) override {
    void* memory = of_->allocate(bytes);
    sizes_[memory] = bytes;
    used_ += bytes;
    most = std::max(most, used_);
    return memory;
  }
  void release(void* memory) noexcept override {
    used_ -= sizes_[memory];
    of_->release(memory);
  }
  void write(void* to, const void* from, std::size_t bytes) override {
    of_->write(to, from, bytes);
  }
  void read(void* to, const void* from, std::size_t bytes) override { of_->read(to, from, bytes); }
  void zero(void* to, std::size_t bytes) override { of_->zero(to, bytes); }
  void run(const soft::Kernel& kernel, const soft::DeviceArrays& arrays,
           std::int64_t count) override {
    if (kernel.name.starts_with("compute_contact")) listed = count, touch = arrays.list.touch;
    if (!measuring) return of_->run(kernel, arrays, count);
    const auto begin = Clock::now();
    of_->run(kernel, arrays, count);
    of_->read(nullptr, nullptr, 0);  // waits for it
    seconds[kernel.name] += seconds_since(begin);
  }

  /// Pairs that touch, at last.
  std::int64_t touching() {
    std::vector<soft::Touch> all(static_cast<std::size_t>(listed));
    of_->read(all.data(), touch, all.size());
    return std::ranges::count(all, soft::Touch::touching);
  }

  bool measuring = false;
  std::size_t most = 0;                ///< [bytes] used at a time
  std::int64_t listed = 0;             ///< pairs, at last
  const soft::Touch* touch = nullptr;  ///< of each
  std::map<std::string, double> seconds;

 private:
  std::shared_ptr<soft::Device> of_;
  std::map<void*, std::size_t> sizes_;
  std::size_t used_ = 0;
};

/// A drum of `count` balls of 5 mm, of which they fill a third, at 70 % of the critical speed. They
/// start on a lattice in its lower part and fall into a bed.
struct Drum {
  static constexpr double radius = 0.0025, pitch = 2.1 * radius, step = 1e-5;
  double size = 0;  // [m] radius, and length
  std::vector<scene::Ball> balls;

  explicit Drum(int count) {
    const double volume = count * std::pow(pitch, 3) / 0.45;
    size = std::cbrt(volume / std::numbers::pi);
    const double room = size - 1.2 * radius;
    Random random(3, 0);
    for (double z = -size + radius; std::ssize(balls) < count && z < size; z += pitch)
      for (double y = -room; y < room; y += pitch)
        for (double x = -0.5 * size + 1.1 * radius; x < 0.5 * size - 1.1 * radius; x += pitch) {
          if (y * y + z * z > room * room || std::ssize(balls) == count) continue;
          const Vec3 heading = random.direction();
          balls.push_back({radius, 7850, {x, y, z}, 0.2 * heading, {}});
        }
  }
  std::unique_ptr<scene::Engine> engine(std::shared_ptr<soft::Device> device) const {
    const scene::Chamber drum{geometry::Cylinder{2 * size, size},
                              kinematics::Tumbling{0.7 * std::sqrt(9.81 / (size - radius))},
                              scene::mounted_along({1, 0, 0}),
                              {0, 0, -9.81}};
    contact::Pair pair;
    pair.modulus = 5e6, pair.shear_modulus = 1.5e6, pair.restitution = 0.6, pair.friction = 0.4;
    pair.rolling_friction = 0.01;
    soft::Settings settings{{.law = contact::HertzMindlin{}}, step};
    settings.device = [=] { return device; };
    return soft::make_engine(drum, balls, settings, contact::PairTable(1, 3, pair), 0);
  }
};

/// Sizes in the environment variable MAHLWERK_CARD_BALLS, or all that are of interest.
std::vector<int> sizes() {
  const char* said = std::getenv("MAHLWERK_CARD_BALLS");
  std::istringstream words(said != nullptr ? said : "10000 100000 1000000");
  std::vector<int> all;
  for (int count = 0; words >> count;) all.push_back(count);
  return all;
}

void add(std::vector<Row>& rows, int count) {
  constexpr int lead = 8000, steps = 500, turns = 3;
  const auto begin = Clock::now();
  const auto device = std::make_shared<MeasuredDevice>(soft::graphics_card());
  const Drum drum(count);
  const auto engine = drum.engine(device);
  Counter counter;
  engine->advance(Drum::step, counter);
  const double start = seconds_since(begin);
  const std::string what = fmt::format("drum of {} balls", drum.balls.size());
  const auto row = [&](const std::string& metric, double value, double least = NAN,
                       double most = NAN) {
    rows.push_back({"card", what, device->name(), metric, value, least, most});
  };
  double time = lead * Drum::step;
  engine->advance(time, counter);
  std::vector<double> rates;
  const std::int64_t before = counter.count;
  for (int turn = 0; turn < turns; ++turn) {
    const auto from = Clock::now();
    engine->advance(time += steps * Drum::step, counter);
    rates.push_back(static_cast<double>(drum.balls.size()) * steps / seconds_since(from) / 1e6);
  }
  const auto [least, most] = std::ranges::minmax(rates);
  row("million_ball_steps_per_s", median(rates), least, most);
  row("start_s", start);
  row("bytes_per_ball", static_cast<double>(device->most) / static_cast<double>(drum.balls.size()));
  row("listed_pairs_per_ball",
      static_cast<double>(device->listed) / static_cast<double>(drum.balls.size()));
  row("touching_pairs_per_ball",
      static_cast<double>(device->touching()) / static_cast<double>(drum.balls.size()));
  row("collisions_per_ball_step", static_cast<double>(counter.count - before) / (turns * steps) /
                                      static_cast<double>(drum.balls.size()));
  device->measuring = true;
  engine->advance(time += steps * Drum::step, counter);
  double all = 0;
  for (const auto& [name, seconds] : device->seconds) all += seconds;
  for (const auto& [name, seconds] : device->seconds)
    if (seconds > 0.005 * all) row("percent_of_time_in_" + name, 100 * seconds / all);
}

}  // namespace

std::vector<Row> card() {
  std::vector<Row> rows;
  try {
    for (const int count : sizes()) {
      fmt::print(stderr, "card: {} balls\n", count);
      add(rows, count);
    }
  } catch (const std::exception& e) {
    fmt::print(stderr, "card: {}\n", e.what());
  }
  return rows;
}

}  // namespace mahlwerk::bench
