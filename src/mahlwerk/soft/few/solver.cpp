// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"

namespace mahlwerk::soft {
namespace {

constexpr std::int64_t energy_check_interval = 64;  // steps between two checks of the energy
constexpr std::size_t max_skip_balls = 32;  // balls: with more, contacts exist nearly always

}  // namespace

FewBodySolver::FewBodySolver(std::unique_ptr<const MovingWall> jar,
                             const std::vector<scene::Ball>& balls, const Settings& settings,
                             const contact::PairTable& pairs, double start)
    : jar_(std::move(jar)),
      initial_balls_(balls),
      settings_(settings),
      pairs_(balls, pairs, *settings.model.law),
      step_batch_(
          std::visit([]<class L>(const L&) { return batch_stepper<L>(); }, *settings_.model.law)),
      start_(start),
      skips_(settings.free_flight_skip && balls.size() <= max_skip_balls),
      periodic_(is_periodic(jar_->periods())),
      gaps_(balls.size() * static_cast<std::size_t>(jar_->faces())),
      contacts_of_(balls.size()) {
  for (const SpeciesPair& b : pairs_.all())
    pull_off_distance_ = std::max(pull_off_distance_, b.pull_off_distance);
  ParticleData& w = particles_;
  w.count = balls.size();
  w.balls.resize((w.count + lanes - 1) / lanes);
  w.bodies.resize(w.balls.size() + 1);
  w.force_rows.resize(w.balls.size() * lanes + 1);
  double smallest = geometry::never;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    BallBlock& block = w.balls[b / lanes];
    const std::size_t l = b % lanes;
    set_lane(w.bodies[b / lanes].position, l, balls[b].position);
    set_lane(block.velocity, l, balls[b].velocity);
    set_lane(block.spin, l, balls[b].spin);
    block.half_kick_factor[l] = 0.5 * settings.time_step / pairs_.species_of(b).mass;
    block.half_spin_kick_factor[l] = 0.5 * settings.time_step / pairs_.species_of(b).inertia;
    smallest = std::min(smallest, balls[b].radius);
    mass_ += pairs_.species_of(b).mass;
  }
  skin_ = 0.03 * smallest;
  rebuild_neighbour_list();
  refuse_overlaps();
  energy_balance_.initial_energy = 0;
  const scene::EnergyBalance now = energy_balance();
  energy_balance_.initial_energy = now.kinetic + now.potential + now.elastic;
  watch_.begin(now);
}

/// Throws InputError if balls overlap by more than the limit: a large overlap would eject them at
/// high speed.
void FewBodySolver::refuse_overlaps() const {
  const double t = mill_time(particles_.step);
  for (const NearPair& c : listed_pairs_) {
    const auto i = static_cast<std::size_t>(c.i);
    const double radius = initial_balls_[i].radius;
    const Vec3 x = particles_.position(i);
    if (c.face >= 0) {
      const double overlap = (radius - jar_->gap(c.face, x, t, radius).distance) / radius;
      if (overlap > settings_.max_initial_overlap)
        throw overlap_error(i, "the jar", overlap, "its radius");
      continue;
    }
    const auto j = static_cast<std::size_t>(c.j);
    const double other_radius = initial_balls_[j].radius;
    const double overlap = (radius + other_radius - norm(nearest(particles_.position(j) - x))) /
                           std::min(radius, other_radius);
    if (overlap > settings_.max_initial_overlap)
      throw overlap_error(i, fmt::format("ball {}", j + 1), overlap, "the smaller radius");
  }
}

double FewBodySolver::time_of(std::int64_t step) const {
  return static_cast<double>(step) * settings_.time_step;
}
double FewBodySolver::mill_time(std::int64_t step) const {
  return start_ + time_of(step);
}

void FewBodySolver::advance(double time, scene::Observer& observer) {
  const auto until = static_cast<std::int64_t>(std::ceil(time / settings_.time_step - 1e-6));
  target_time_ = time;
  const auto hand_over = [&] {
    if (!finished_.empty()) observer.collisions(finished_);
    finished_.clear();
  };
  try {
    while (now_ < until) {
      if (stopped()) break;
      if (skip_end_ >= 0) {
        now_ = std::min(skip_end_, until);
        if (now_ == skip_end_) end_skip();
      } else if (!start_skip()) {
        advance_batch(until);
        now_ = particles_.step;
      }
      if (finished_.size() > 1000) hand_over();
    }
  } catch (...) {
    now_ = particles_.step;
    hand_over();
    throw;
  }
  hand_over();
}

/// Steps to `until` or the end of the batch; stops early after a step without contacts, if a skip
/// may start there.
void FewBodySolver::advance_batch(std::int64_t until) {
  ParticleData& w = particles_;
  std::int64_t end = std::min(until, (w.step / energy_check_interval + 1) * energy_check_interval);
  const bool waits = skips_ && !touched_ && w.step < next_skip_;
  if (waits) end = std::min(end, next_skip_);
  drive_.resize(static_cast<std::size_t>(end - w.step) + 1);
  jar_->sample_drive(start_, settings_.time_step, w.step, drive_);
  StepBatch s{.particles = w,
              .jar = *jar_,
              .callbacks = *this,
              .constants = step_constants(settings_, jar_->periods()),
              .drive = drive_,
              .start = start_,
              .max_displacement = 0.5 * skin_,
              .list_step = list_step_,
              .stop_when_idle = skips_ && !waits};
  const std::int64_t before = w.step;
  touched_ = step_batch_(s);
  energy_balance_.time_steps += w.step - before;
  if (w.step % energy_check_interval == 0) check_energy();
}

void FewBodySolver::stop(std::size_t ball, const char* why) const {
  throw unstable_run_error(time_of(particles_.step), ball, why, particles_.position(ball),
                           particles_.velocity(ball));
}

}  // namespace mahlwerk::soft
