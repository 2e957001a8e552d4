// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/mill_drive.hpp"

namespace mahlwerk::soft {
namespace {

constexpr std::int64_t energy_check_interval = 64;  // steps between two checks of the energy

}  // namespace

FewBodySolver::FewBodySolver(std::unique_ptr<const MovingWall> jar,
                             const std::vector<scene::Ball>& balls, const Settings& settings,
                             const contact::PairTable& pairs, double start)
    : jar_(std::move(jar)),
      initial_balls_(balls),
      settings_(settings),
      pairs_(balls, pairs, *settings.model.law),
      step_block_(
          std::visit([]<class L>(const L&) { return block_stepper<L>(); }, *settings_.model.law)),
      start_(start),
      skips_(settings.free_flight_skip && jar_->drive() == nullptr),
      periodic_(is_periodic(jar_->periods())),
      gaps_(balls.size() * static_cast<std::size_t>(jar_->faces())),
      contacts_of_(balls.size()) {
  for (const SpeciesPair& b : pairs_.all())
    pull_off_distance_ = std::max(pull_off_distance_, b.pull_off_distance);
  if (settings.liquid) {
    liquid_.emplace(*settings.liquid, settings.time_step);
    pull_off_distance_ = std::max(pull_off_distance_, liquid_->gap_reach(pairs_.all()));
    skips_ = skips_ && !liquid_->acts_on_balls();
  }
  ParticleData& w = particles_;
  w.count = balls.size();
  w.balls.resize((w.count + lanes - 1) / lanes);
  w.bodies.resize(w.balls.size() + 1);
  double smallest = geometry::never;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    BallBlock& block = w.balls[b / lanes];
    const std::size_t l = b % lanes;
    set_lane(w.bodies[b / lanes].position, l, balls[b].position);
    set_lane(block.velocity, l, balls[b].velocity);
    set_lane(block.spin, l, balls[b].spin);
    block.half_kick_factor[l] = 0.5 * settings.time_step / pairs_.species_of(b).mass;
    block.half_spin_kick_factor[l] = 0.5 * settings.time_step / pairs_.species_of(b).inertia;
    block.used[l] = -1;
    smallest = std::min(smallest, balls[b].radius);
    mass_ += pairs_.species_of(b).mass;
  }
  // A wall that moves towards the balls uses up a thin skin within some fifty steps.
  skin_ = (jar_->max_wall_speed() > 0 ? 0.1 : 0.03) * smallest;
  loads_.resize(jar_->load_count());
  if (kinematics::Drive* drive = jar_->drive()) start_drive(*drive, start, settings.time_step);
  if (liquid_) start_in_liquid();
  build_gather_maps();  // of no packets
  rebuild_neighbour_list();
  refuse_overlaps();
  energy_balance_.initial_energy = 0;
  const scene::EnergyBalance now = energy_balance();
  energy_balance_.initial_energy = now.kinetic + now.potential + now.elastic;
  watch_.begin(now);
}

/// Calls `f` with each listed pair and its overlap [m].
template <class F>
void FewBodySolver::each_overlap(const F& f) const {
  const WallAxes axes = jar_->axes(mill_time(particles_.step));
  for (const NearPair& c : listed_pairs_) {
    const auto i = static_cast<std::size_t>(c.i), j = static_cast<std::size_t>(c.j);
    const double radius = initial_balls_[i].radius;
    const Vec3 x = particles_.position(i);
    if (c.face >= 0)
      f(c, radius - jar_->gap(c.face, x, axes, radius).distance);
    else
      f(c, radius + initial_balls_[j].radius - norm(nearest(particles_.position(j) - x)));
  }
}

/// Throws InputError if balls overlap by more than the limit: a large overlap would eject them at
/// high speed.
void FewBodySolver::refuse_overlaps() const {
  each_overlap([&](const NearPair& c, double depth) {
    const auto i = static_cast<std::size_t>(c.i), j = static_cast<std::size_t>(c.j);
    const double radius = initial_balls_[i].radius;
    const double smaller = c.face >= 0 ? radius : std::min(radius, initial_balls_[j].radius);
    const double overlap = depth / smaller;
    if (overlap > settings_.max_initial_overlap)
      throw overlap_error(i, c.face >= 0 ? "the jar" : fmt::format("ball {}", j + 1), overlap,
                          c.face >= 0 ? "its radius" : "the smaller radius");
  });
}

double FewBodySolver::energy_at_start() const {
  double energy = 0;
  each_overlap([&](const NearPair& c, double overlap) {
    if (!(overlap > 0)) return;
    const auto i = static_cast<std::size_t>(c.i);
    const bool wall = c.face >= 0;
    const std::int32_t mine = pairs_.species_index(i),
                       other = wall ? 0 : pairs_.species_index(static_cast<std::size_t>(c.j));
    const SpeciesPair& pair =
        pairs_[wall ? pairs_.wall_pair_index(mine, c.face) : pairs_.ball_pair_index(mine, other)];
    PairParameters parameters = pair_parameters(pair, pairs_.species(mine),
                                                wall ? nullptr : &pairs_.species(other), settings_);
    if (wall && settings_.model.curved_walls)
      apply_wall_curvature(parameters, 0, *jar_, c.face, particles_.position(i),
                           mill_time(particles_.step), pair, settings_.model);
    energy += soft::energy_at_start(parameters, overlap, *settings_.model.law);
  });
  return energy;
}

double FewBodySolver::time_of(std::int64_t step) const {
  return static_cast<double>(step) * settings_.time_step;
}
double FewBodySolver::mill_time(std::int64_t step) const {
  return start_ + time_of(step);
}

/// The step in which the run reaches `time` [s].
std::int64_t FewBodySolver::last_step(double time) const {
  return static_cast<std::int64_t>(std::ceil(time / settings_.time_step - 1e-6));
}

void FewBodySolver::hand_over(scene::Observer& observer) {
  if (!finished_.empty()) observer.collisions(finished_);
  finished_.clear();
}

void FewBodySolver::advance(double time, scene::Observer& observer) {
  const std::int64_t until = last_step(time);
  target_time_ = time;
  try {
    while (now_ < until) {
      if (stopped()) break;
      if (skip_end_ >= 0) {
        now_ = std::min(skip_end_, until);
        if (now_ == skip_end_) end_skip();
      } else if (!start_skip()) {
        advance_block(until);
      }
      if (finished_.size() > 1000) hand_over(observer);
    }
  } catch (...) {
    now_ = particles_.step;
    hand_over(observer);
    throw;
  }
  hand_over(observer);
}

/// Steps to `until` or the end of the block; stops early after a step without contacts, if a skip
/// may start there.
void FewBodySolver::advance_block(std::int64_t until) {
  std::vector<ParticleData*> charges{&particles_};
  sample_drive(block_end(until));
  set_idle_from();
  StepBlock block = step_block(charges, particles_.packets, particles_.gather_maps, *this);
  step_block_(block);
  end_block();
}

/// Blocks end at steps that do not depend on how advance() divides a run.
std::int64_t FewBodySolver::block_end(std::int64_t until) const {
  const std::int64_t length = jar_->drive() != nullptr ? drive_interval : energy_check_interval;
  return std::min(until, (now_ / length + 1) * length);
}

/// Samples the drive from the present step to step `end`.
void FewBodySolver::sample_drive(std::int64_t end) {
  drive_.resize(static_cast<std::size_t>(end - now_) + 1);
  jar_->sample_drive(start_, settings_.time_step, now_, drive_);
}

/// From the step on at which a skip may start, a step without contacts ends the block.
void FewBodySolver::set_idle_from() {
  particles_.idle_from = skips_ ? next_skip_ : std::numeric_limits<std::int64_t>::max();
}

/// The block of steps for which the drive has been sampled.
StepBlock FewBodySolver::step_block(std::vector<ParticleData*>& charges,
                                    std::vector<PairPacket>& packets,
                                    std::vector<GatherMap>& gather_maps,
                                    StepCallbacks& callbacks) const {
  return {.charges = charges,
          .packets = packets,
          .gather_maps = gather_maps,
          .jar = *jar_,
          .callbacks = callbacks,
          .constants = step_constants(settings_, jar_->periods()),
          .drive = drive_,
          .start = start_,
          .max_displacement = 0.5 * skin_,
          .step = particles_.step,
          .loads = !loads_.empty(),
          .liquid = liquid_.has_value()};
}

void FewBodySolver::end_block() {
  now_ = particles_.step;
  if (jar_->drive() != nullptr && now_ % drive_interval == 0)
    soft::advance_drive(*jar_->drive(), mill_time(now_), loads_.front().about_mill_axis,
                        now_ % energy_check_interval == 0);
  if (particles_.step % energy_check_interval != 0) return;
  check_energy();
  check_rest();
}

void FewBodySolver::stop(std::size_t ball, const char* why) const {
  refuse_start_outside(particles_.step, ball, why);
  throw unstable_run_error(time_of(particles_.step), ball, why, particles_.position(ball),
                           particles_.velocity(ball), settings_.time_step);
}

}  // namespace mahlwerk::soft
