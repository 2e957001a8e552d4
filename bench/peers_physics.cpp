// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "peers_physics.hpp"

#include <array>
#include <charconv>
#include <span>

#include "mahlwerk/kinematics/motions.hpp"
#include "peers.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double radius = planetary_case.diameter / 2;

/// The next number of a line; NaN if there is none.
double take(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  double value = NAN;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

void Analysis::add_sample(const Sample& sample) {
  last_sample_time_ = sample.time;
  constexpr double rounding = 1e-9;  // [s] the time may come from a sum or a product
  if (sample.time < from_ - rounding || sample.time > to_ + rounding) return;
  add_means(sample);
  add_touches(sample);
  if (samples_ == 0) first_ = sample.time;
  last_ = sample.time;
  samples_ += 1;
}

void Analysis::add_means(const Sample& sample) {
  const kinematics::Planetary& mill = planetary_case.mill;
  const double mass = planetary_case.ball({}).mass(), inertia = planetary_case.ball({}).inertia();
  const Vec3 carried = mill.frame_motion(sample.time).velocity, disc{0, 0, mill.speed};
  for (const Sample::Ball& ball : sample.balls) {
    const Vec3 moment = cross(ball.position, ball.force) + ball.torque;
    sum_.power += dot(carried, ball.force) + mill.jar_spin() * moment.z;
    sum_.kinetic += 0.5 * mass * squared(ball.velocity + carried);
    sum_.rotational += 0.5 * inertia * squared(ball.spin);
    sum_.kinetic_on_plate += 0.5 * mass * squared(ball.velocity - cross(disc, ball.position));
  }
}

void Analysis::add_touches(const Sample& sample) {
  const std::span balls(sample.balls);
  ball_ball_.now.clear();
  ball_side_.now.clear();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3& place = balls[i].position;
    const double room = planetary_case.vial.diameter / 2 - radius;
    ball_side_.now.push_back(room - std::hypot(place.x, place.y));
    for (const Sample::Ball& other : balls.subspan(i + 1))
      ball_ball_.now.push_back(norm(other.position - place) - 2 * radius);
  }
  for (Gaps* gaps : {&ball_ball_, &ball_side_}) gaps->compare(sample.time - last_);
}

void Analysis::Gaps::compare(double passed) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (now[i] >= 0 || before[i] < 0) continue;
    const double speed = (before[i] - now[i]) / passed;
    touches += 1;
    if (speed <= slowest_impact) continue;
    impacts += 1;
    speeds += speed;
  }
  before.swap(now);
}

Physics::Impacts Analysis::Gaps::over(double duration) const {
  return {impacts / duration, impacts > 0 ? speeds / impacts : 0, touches / duration};
}

Physics Analysis::physics() const {
  Physics mean = sum_;
  for (double* value : {&mean.power, &mean.kinetic, &mean.rotational, &mean.kinetic_on_plate})
    *value /= samples_;
  mean.ball_ball = ball_ball_.over(last_ - first_);
  mean.ball_side = ball_side_.over(last_ - first_);
  return mean;
}

DumpReader::DumpReader(int balls, double step, Analysis& analysis)
    : step_(step), analysis_(analysis) {
  sample_.balls.resize(static_cast<std::size_t>(balls));
}

void DumpReader::line(std::string_view text) {
  if (text.starts_with("ITEM: ")) {
    const bool balls = text.starts_with("ITEM: ATOMS");
    awaiting_ = balls                             ? Awaiting::balls
                : text.starts_with("ITEM: TIMES") ? Awaiting::step
                                                  : Awaiting::header;
    missing_ = balls ? static_cast<int>(sample_.balls.size()) : 0;
  } else if (awaiting_ == Awaiting::step) {
    sample_.time = step_ * take(text);
    awaiting_ = Awaiting::header;
  } else if (awaiting_ == Awaiting::balls) {
    ball(text);
    if (--missing_ == 0) finish();
  }
}

void DumpReader::ball(std::string_view text) {
  const double number = take(text);
  if (!(number >= 1 && number <= static_cast<double>(sample_.balls.size()))) return;
  Sample::Ball& ball = sample_.balls[static_cast<std::size_t>(number) - 1];
  for (Vec3* part : {&ball.position, &ball.velocity, &ball.force, &ball.spin, &ball.torque})
    for (double* value : {&part->x, &part->y, &part->z}) *value = take(text);
}

void DumpReader::finish() {
  const kinematics::FrameMotion frame = planetary_case.mill.frame_motion(sample_.time);
  const Vec3 centre = frame.centre + Vec3{0, 0, planetary_case.vial.height / 2};
  for (Sample::Ball& ball : sample_.balls) {
    ball.position -= centre;
    ball.velocity -= frame.velocity;
  }
  analysis_.add_sample(sample_);
  awaiting_ = Awaiting::header;
}

}  // namespace mahlwerk::bench
