// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/many/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/mill_drive.hpp"

namespace mahlwerk::soft {
namespace {

constexpr std::size_t in_cache = 30000;  // balls that fit in a processor's cache, with contacts
constexpr std::int64_t energy_check_interval = 64;  // steps between two checks of the energy
constexpr std::size_t max_records = 2048;  // buffered for the observer, to bound the memory

/// Largest useful number of threads.
int useful_threads(std::size_t balls) {
  constexpr std::size_t each = 1000;
  return static_cast<int>(std::clamp<std::size_t>(balls / each, 1, 1024));
}

}  // namespace

ManyBodySolver::ManyBodySolver(std::unique_ptr<const MovingWall> jar,
                               const std::vector<scene::Ball>& balls, const Settings& settings,
                               const contact::PairTable& pairs, double start)
    : jar_(std::move(jar)),
      settings_(settings),
      body_species_(balls, settings.shapes),
      pairs_(body_species_.empty()
                 ? SpeciesPairs(balls, pairs, *settings.model.law)
                 : SpeciesPairs(body_species_.spheres(balls), pairs, *settings.model.law)),
      step_chunk_(
          std::visit([]<class L>(const L&) { return chunk_stepper<L>(); }, *settings_.model.law)),
      ball_count_(balls.size()),
      start_(start),
      periodic_(is_periodic(jar_->periods())),
      large_(body_species_.sphere_count(balls) > in_cache),
      has_history_(
          std::visit([]<class L>(const L&) { return L::has_history; }, *settings_.model.law) ||
          contact::rule_of(settings.model.rolling).has_history ||
          settings.model.rescaled_unloading),
      has_friction_history_(settings.model.partial_slip ||
                            settings.model.twisting != contact::Twisting::none),
      team_(std::clamp(settings.threads, 1, useful_threads(body_species_.sphere_count(balls)))) {
  const SizeClasses classes(pairs_.all_species(), std::numeric_limits<int>::max());
  class_of_ = classes.of, class_radius_ = class_row_radius_ = classes.radius;
  first_body_class_ = class_radius_.size();
  skin_ = 0.5 * classes.smallest;
  if (settings.breakage) {  // fragments come later
    skin_ = geometry::never;
    for (const scene::Ball& b : balls)
      if (!b.outside) skin_ = std::min(skin_, 0.5 * b.radius);
  }
  if (!body_species_.empty()) assign_body_classes();
  parameters_ = all_pair_parameters(pairs_, pairs.faces(), settings_);
  for (const Species& s : pairs_.all_species()) {
    const double half_kick_factor = 0.5 * settings.time_step / s.mass,
                 half_spin_kick_factor = 0.5 * settings.time_step / s.inertia;
    half_kick_factors_.push_back({half_kick_factor, half_kick_factor, half_kick_factor, 0,
                                  half_spin_kick_factor, half_spin_kick_factor,
                                  half_spin_kick_factor, 0});
  }
  for (const SpeciesPair& b : pairs_.all())
    pull_off_distance_ = std::max(pull_off_distance_, b.pull_off_distance);
  if (settings.liquid) {
    liquid_.emplace(*settings.liquid, settings.time_step);
    pull_off_distance_ = std::max(pull_off_distance_, liquid_->gap_reach(pairs_.all()));
  }
  loads_.resize(jar_->load_count());
  if (kinematics::Drive* drive = jar_->drive()) start_drive(*drive, start, settings.time_step);
  ball_forces_.resize(static_cast<std::size_t>(team_.size()));
  wall_axes_ = jar_->axes(mill_time(0));
  if (settings.breakage) start_breakage(balls);
  initialize_rows(balls);
  energy_balance_.initial_energy = 0;
  const scene::EnergyBalance now = energy_balance();
  energy_balance_.initial_energy = now.kinetic + now.potential + now.elastic;
  watch_.begin(now);
}

/// Initialises the rows of step 0, and of step 1 without contact forces (dem.26).
void ManyBodySolver::initialize_rows(const std::vector<scene::Ball>& balls) {
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    if (!settings_.breakage || !balls[ball].outside) mass_ += balls[ball].mass();
    const auto number = static_cast<std::int32_t>(ball);
    if (balls[ball].outside)
      outside_.push_back({balls[ball].position, number, 0});
    else
      id_.insert(id_.end(), body_species_.sphere_count(ball), number);
  }
  mix_fresh_feed();
  const std::size_t n = id_.size();
  rows_.resize(n), next_rows_.resize(n), reference_positions_.resize(n), spins_.resize(n),
      next_spins_.resize(n);
  half_step_.resize(n), species_.resize(n), contacts_of_.assign(n, 0);
  const std::vector<DriveSample> b = drive_samples(0, 1);
  const double dt = settings_.time_step;
  if (!body_species_.empty()) place_spheres(balls);
  for (std::size_t k = 0; k < n && body_species_.empty(); ++k) {
    const auto number = static_cast<std::size_t>(id_[k]);
    const scene::Ball& ball = balls[number];
    species_[k] = pairs_.species_index(number);
    const Vec3& x = ball.position;
    rows_[k] = {x.x, x.y, x.z, ball.radius, 0, 0, 0, 0};
  }
  rebuild();
  refuse_overlaps();
  for (std::size_t k = 0; k < n; ++k) {
    if (is_member(k)) continue;
    const scene::Ball& ball = balls[static_cast<std::size_t>(id_[k])];
    Vec3 v = ball.velocity + 0.5 * dt * b[0].body_acceleration,
         predicted = v + 0.5 * dt * b[1].body_acceleration;
    Vec3 w = ball.spin, predicted_spin = w;
    if (liquid_ && liquid_->acts_on_balls()) {
      const Species& s = pairs_.species(species_[k]);
      LiquidWork ignored;
      const LiquidLoad load = liquid_->on_ball(liquid_->motion(*jar_, b[0], mill_time(0)), s,
                                               ball.position, ball.velocity, ball.spin, ignored);
      const Vec3 kick = (0.5 * dt / s.mass) * load.force,
                 spin_kick = (0.5 * dt / s.inertia) * load.torque;
      v += kick, predicted += 2.0 * kick;
      w += spin_kick, predicted_spin += 2.0 * spin_kick;
    }
    const Vec3 x = ball.position + dt * v;
    half_step_[k] = {v.x, v.y, v.z, 0, w.x, w.y, w.z, 0};
    next_rows_[k] = {x.x, x.y, x.z, ball.radius, predicted.x, predicted.y, predicted.z, 0};
    next_spins_[k] = {predicted_spin.x, predicted_spin.y, predicted_spin.z, 0};
  }
  initialize_bodies(balls, b);
  for (ChunkDisplacement& d : displacements_)
    d.spread = geometry::never;  // forces a rebuild at the first step
}

/// Blocks end at steps that do not depend on how advance() divides a run.
std::int64_t ManyBodySolver::block_end(std::int64_t until) const {
  const std::int64_t length = jar_->drive() != nullptr ? drive_interval
                              : settings_.breakage     ? stressing_interval
                                                       : energy_check_interval;
  return std::min(until, (step_ / length + 1) * length);
}

void ManyBodySolver::advance_drive() {
  if (step_ % drive_interval != 0) return;
  double impulse = loads_.front().about_mill_axis;
  for (const Chunk& chunk : chunks_)
    if (!chunk.loads.empty()) impulse += chunk.loads.front().about_mill_axis;
  soft::advance_drive(*jar_->drive(), mill_time(step_), impulse,
                      step_ % energy_check_interval == 0);
}

double ManyBodySolver::time_of(std::int64_t step) const {
  return static_cast<double>(step) * settings_.time_step;
}

std::vector<DriveSample> ManyBodySolver::drive_samples(std::int64_t first,
                                                       std::int64_t last) const {
  std::vector<DriveSample> all(static_cast<std::size_t>(last - first) + 1);
  jar_->sample_drive(start_, settings_.time_step, first, all);
  return all;
}

void ManyBodySolver::advance(double time, scene::Observer& observer) {
  const auto until = static_cast<std::int64_t>(std::ceil(time / settings_.time_step - 1e-6));
  target_time_ = time;
  const auto hand_over = [&] {
    collect_records();
    std::vector<scene::Collision> all;
    all.reserve(finished_.size());
    for (const FinishedCollision& e : finished_) all.push_back(e.collision);
    finished_.clear();
    if (!all.empty()) observer.collisions(all);
  };
  try {
    while (step_ < until) {
      if (rest_.at_rest) return pass_rest(until);
      const std::int64_t end = block_end(until);
      const std::vector<DriveSample> all = drive_samples(step_ + 1, end + 1);
      for (std::size_t k = 0; k + 1 < all.size(); ++k) {
        if (stopped()) return hand_over();
        step(all[k], all[k + 1]);
        if (record_count() > max_records) hand_over();
      }
      hand_over();
      if (jar_->drive() != nullptr) advance_drive();
      if (settings_.breakage) break_grains(observer);
      if (step_ % energy_check_interval != 0) continue;
      flush_sums();
      check_energy();
      if (!settings_.flow) {
        if (!settings_.breakage) check_rest();
        continue;
      }
      move_flow(observer);
      hand_over();  // records of the contacts that have ended
    }
  } catch (...) {
    hand_over();
    throw;
  }
}

/// One step: rebuilds the neighbour lists or bins their pairs again if due, then computes every
/// chunk.
void ManyBodySolver::step(const DriveSample& drive, const DriveSample& next_drive) {
  ++step_;
  wall_axes_ = jar_->axes(mill_time(step_));
  rows_.swap(next_rows_);
  spins_.swap(next_spins_);
  bodies_.now.swap(bodies_.next);
  if (!update_bounds())
    rebuild_neighbour_lists();
  else if (rebin_is_due())
    rebin_pairs();
  ChunkStep s{.rows = rows_.data(),
              .spins = spins_.data(),
              .next_rows = next_rows_.data(),
              .next_spins = next_spins_.data(),
              .half_step = half_step_.data(),
              .reference_positions = reference_positions_.data(),
              .half_kick_factors = half_kick_factors_.data(),
              .species = species_.data(),
              .parameters = parameters_.data(),
              .jar = jar_.get(),
              .callbacks = this,
              .time = mill_time(step_),
              .wall_axes = wall_axes_,
              .bin = skin_ * VerletList::width,
              .pull_off_distance = pull_off_distance_,
              .drive = drive,
              .next_drive = next_drive,
              .large = large_,
              .turning = jar_->first_rotor_face() < jar_->faces(),
              .liquid = liquid_.has_value(),
              .loads = !loads_.empty(),
              .body_of = bodies_.has_members() ? bodies_.body_of.data() : nullptr,
              .rounded = body_species_.has_rounded(),
              .has_history = has_history_,
              .stresses = settings_.breakage != nullptr,
              .stored_share = stored_share_,
              .constants = step_constants(settings_, jar_->periods())};
  s.constants.jar_velocity = drive.velocity;
  team_.run_items(share_, [&](int thread, std::int32_t c, std::int32_t next) {
    const auto k = static_cast<std::size_t>(c);
    const Chunk* following =
        large_ && next >= 0 ? &chunks_[static_cast<std::size_t>(next)] : nullptr;
    ChunkDisplacement& d = displacements_[k];
    const Vec3 last = d.mean;
    step_chunk_(s, chunks_[k], following, ball_forces_[static_cast<std::size_t>(thread)], d);
    // Linear extrapolation for the next step. Kept apart until update_bounds(): `spread` was
    // measured from the old predicted_mean.
    predicted_means_[k] = 2.0 * d.mean - last;
    if (s.rounded) chunks_[k].largest_move = largest_move(chunks_[k]);
  });
  if (s.rounded) follow_moves();
  if (!breakage_.new_balls.empty()) end_new_fragments();
}

void ManyBodySolver::rebuild_neighbour_lists() {
  try {
    rebuild();
  } catch (const RunError&) {
    next_rows_ = rows_;  // last valid state of the balls
    next_spins_ = spins_;
    bodies_.next = bodies_.now;
    throw;
  }
}

/// Updates the bounds of the decrease of gaps since the last binning (dem.34). Returns false if a
/// bound exceeds the skin.
bool ManyBodySolver::update_bounds() {
  const double swept = jar_->max_wall_speed() * time_of(step_ - reference_step_);
  const double rounding = 3e-7 * largest_coordinate_;  // of two positions stored as floats
  bool good = true;
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    Chunk& chunk = chunks_[c];
    const ChunkDisplacement& mine = displacements_[c];
    double most = mine.spread;
    for (const std::int32_t other : chunk.neighbour_chunks) {
      const ChunkDisplacement& its = displacements_[static_cast<std::size_t>(other)];
      most = std::max(most, its.spread + norm(its.predicted_mean - mine.predicted_mean));
    }
    chunk.max_gap_decrease = mine.spread + most + rounding;
    chunk.max_wall_gap_decrease = norm(mine.predicted_mean) + mine.spread + swept + rounding;
    good = good && used_skin_ + chunk.max_gap_decrease < skin_ &&
           used_skin_ + chunk.max_wall_gap_decrease < skin_;
  }
  if (good)
    for (std::size_t c = 0; c < chunks_.size(); ++c)
      displacements_[c].predicted_mean = predicted_means_[c];
  return good;
}

std::size_t ManyBodySolver::record_count() const {
  std::size_t all = finished_.size();
  for (const Chunk& chunk : chunks_) all += chunk.finished.size();
  return all;
}

/// Collects the records of the chunks, in the order of their steps.
void ManyBodySolver::collect_records() {
  for (Chunk& chunk : chunks_) {
    finished_.insert(finished_.end(), chunk.finished.begin(), chunk.finished.end());
    chunk.finished.clear();
  }
  std::ranges::stable_sort(finished_, {}, &FinishedCollision::step);
}

void ManyBodySolver::stop(std::size_t row, const char* why) const {
  const auto ball = static_cast<std::size_t>(id_[row]);
  refuse_start_outside(step_, ball, why);
  throw unstable_run_error(time_of(step_), ball, why, rows_[row].position(),
                           velocity_of_row(row, body_kick_change()), settings_.time_step);
}

}  // namespace mahlwerk::soft
