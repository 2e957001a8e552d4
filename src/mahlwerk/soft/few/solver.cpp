// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/contact_records.hpp"
#include "mahlwerk/soft/diagnostics.hpp"

namespace mahlwerk::soft {
namespace {

constexpr std::int64_t energy_check = 64;  // steps between two looks at the energy
constexpr std::size_t skipping = 32;       // balls: beyond, something touches at nearly all times

}  // namespace

FewBodySolver::FewBodySolver(std::unique_ptr<const MovingWall> jar,
                             const std::vector<scene::Ball>& balls, const Rules& rules,
                             const contact::PairTable& pairs, double start)
    : jar_(std::move(jar)),
      made_of_(balls),
      rules_(rules),
      law_(rules.model.law),
      pairs_(balls, pairs, law_),
      step_block_(std::visit([]<class L>(const L&) { return block_stepper<L>(); }, law_)),
      start_(start),
      skips_(rules.free_flight_skip && balls.size() <= skipping),
      folds_(repeats(jar_->periods())),
      gaps_(balls.size() * static_cast<std::size_t>(jar_->faces())),
      contacts_of_(balls.size()) {
  for (const SpeciesPair& b : pairs_.all()) reach_ = std::max(reach_, b.reach);
  ParticleData& w = particles_;
  w.balls = balls.size();
  w.blocks = (balls.size() + lanes - 1) / lanes;
  for (Columns* c : {&w.velocity, &w.spin, &w.force, &w.torque, &w.list_positions})
    c->resize(w.blocks);
  for (Columns* c : {&w.position, &w.velocity_predicted, &w.spin_predicted})
    c->resize(w.blocks + 1);
  w.half_kick.resize(w.blocks);
  w.half_spin_kick.resize(w.blocks);
  w.moved.resize(w.blocks);
  double smallest = geometry::never;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    w.position.put_one(b, balls[b].position);
    w.velocity.put_one(b, balls[b].velocity);
    w.spin.put_one(b, balls[b].spin);
    w.half_kick[b / lanes].is[b % lanes] = 0.5 * rules.time_step / pairs_.of(b).mass;
    w.half_spin_kick[b / lanes].is[b % lanes] = 0.5 * rules.time_step / pairs_.of(b).inertia;
    smallest = std::min(smallest, balls[b].radius);
    mass_ += pairs_.of(b).mass;
  }
  skin_ = 0.03 * smallest;
  rebuild_neighbour_list();
  refuse_overlaps();
  account_.started_with = 0;
  const scene::Account now = reckoned();
  account_.started_with = now.kinetic + now.potential + now.elastic;
  watch_.begin(now);
}

/// Bodies that overlap much at the start would fly apart.
void FewBodySolver::refuse_overlaps() const {
  const double t = clock(particles_.step);
  for (const NearPair& c : listed_) {
    const auto i = static_cast<std::size_t>(c.i);
    const double radius = made_of_[i].radius;
    const Vec3 x = particles_.position.one(i);
    if (c.face >= 0) {
      const double overlap = (radius - jar_->gap(c.face, x, t, radius).distance) / radius;
      if (overlap > rules_.most_overlap) throw overlapping(i, "the jar", overlap);
      continue;
    }
    const auto j = static_cast<std::size_t>(c.j);
    const double touch = radius + made_of_[j].radius;
    const double overlap = (touch - norm(nearest(particles_.position.one(j) - x))) / radius;
    if (overlap > rules_.most_overlap) throw overlapping(i, fmt::format("ball {}", j + 1), overlap);
  }
}

double FewBodySolver::time_of(std::int64_t step) const {
  return static_cast<double>(step) * rules_.time_step;
}
double FewBodySolver::clock(std::int64_t step) const {
  return start_ + time_of(step);
}

void FewBodySolver::advance(double time, scene::Observer& observer) {
  const auto until = static_cast<std::int64_t>(std::ceil(time / rules_.time_step - 1e-6));
  asked_ = time;
  const auto hand_over = [&] {
    if (!ended_.empty()) observer.collisions(ended_);
    ended_.clear();
  };
  try {
    while (now_ < until) {
      if (stopped()) break;
      if (skip_end_ >= 0) {
        now_ = std::min(skip_end_, until);
        if (now_ == skip_end_) end_skip();
      } else if (!start_skip()) {
        advance_block(until);
        now_ = particles_.step;
      }
      if (ended_.size() > 1000) hand_over();
    }
  } catch (...) {
    now_ = particles_.step;
    hand_over();
    throw;
  }
  hand_over();
}

/// Steps up to `until`, the end of a block, or the first idle step after which to try a skip.
void FewBodySolver::advance_block(std::int64_t until) {
  ParticleData& w = particles_;
  std::int64_t end = std::min(until, (w.step / energy_check + 1) * energy_check);
  const bool waits = skips_ && !touched_ && w.step < next_skip_;
  if (waits) end = std::min(end, next_skip_);
  drive_.resize(static_cast<std::size_t>(end - w.step) + 1);
  jar_->sample_drive(start_, rules_.time_step, w.step, drive_);
  StepBlock s{.particles = w,
              .jar = *jar_,
              .slow_path = *this,
              .frame = frame_of(rules_, jar_->periods()),
              .drive = drive_,
              .start = start_,
              .moved = 0.5 * skin_,
              .swept_since = list_step_,
              .idle_ends = skips_ && !waits};
  const std::int64_t before = w.step;
  touched_ = step_block_(s);
  account_.time_steps += w.step - before;
  if (w.step % energy_check == 0) check_energy();
}

FewBodySolver::Stored FewBodySolver::stored() const {
  Stored energy;
  for (const Packet& p : particles_.packets)
    for (int l = 0; l < lanes; ++l) {
      if (p.touching[l] == 0) continue;
      const double memory[contact::law_memories] = {p.memory[0][l], p.memory[1][l]};
      const Vec3 apart = nearest(particles_.position.one(static_cast<std::size_t>(p.j[l])) -
                                 particles_.position.one(static_cast<std::size_t>(p.i[l])));
      const double overlap = p.radius_i[l] + p.radius_j[l] - norm(apart);
      if (overlap < -p.radius_i[l]) continue;  // it has left this face over an edge
      energy.normal += std::visit(
          [&](const auto& law) { return law.stored(numbers_of(p, l), memory, overlap); }, law_);
      const Vec3 spring{p.spring.x[l], p.spring.y[l], p.spring.z[l]};
      energy.tangential += 0.5 * p.stiffness[l] * squared(spring);
    }
  return energy;
}

scene::Account FewBodySolver::reckoned() const {
  scene::Account a = account_;
  a.time = time_of(now_);
  if (a.time < asked_ && asked_ - a.time < 1e-5 * rules_.time_step) a.time = asked_;  // rounding
  const kinematics::Ride ride = jar_->ride(clock(particles_.step));
  const Flown way = flown(now_ - particles_.step);
  const kinematics::Ride there = way.time > 0 ? jar_->ride(clock(now_)) : ride;
  a.kinetic = a.potential = 0;
  for (std::size_t b = 0; b < particles_.balls; ++b) {
    const Species& of = pairs_.of(b);
    const Vec3 v0 = particles_.velocity.one(b);
    const Vec3 v = v0 + way.gain + there.velocity;
    const Vec3 x = particles_.position.one(b) + way.time * v0 + way.shift + there.centre;
    a.kinetic += 0.5 * (of.mass * squared(v) + of.inertia * squared(particles_.spin.one(b)));
    a.potential -= of.mass * dot(jar_->gravity(), x);
  }
  const Stored kept = stored();
  a.elastic = kept.normal + kept.tangential;
  for (const Packet& p : particles_.packets)
    for (int l = 0; l < lanes; ++l) {
      if (!p.used[static_cast<std::size_t>(l)]) continue;
      a.lost_normal += p.work.normal[l];
      a.lost_tangential += p.work.tangential[l];
      a.lost_rolling += p.work.rolling[l];
      a.lost_open += p.work.normal[l] + p.work.tangential[l] + p.work.rolling[l];
      a.slid += p.work.sliding[l];
      a.wall_work += p.work.wall[l];
      a.deepest_overlap = std::max(a.deepest_overlap, p.work.deepest[l] / p.radius_i[l]);
    }
  a.lost_normal -= kept.normal;  // of what contacts took so far, this can come back
  a.lost_tangential -= kept.tangential;
  a.lost_open -= a.elastic;
  a.contact_time += static_cast<double>(in_touch_) * time_of(particles_.step - in_touch_since_);
  return a;
}

scene::Account FewBodySolver::account() const {
  return reckoned();
}

void FewBodySolver::check_energy() {
  const scene::Account a = reckoned();
  const double t = clock(particles_.step);
  const double wall = jar_->fastest(t);
  const Species& first = pairs_.species(0);
  const double least = first.mass * norm(jar_->gravity()) * first.radius;
  if (!watch_.jumped(a, 0.5 * mass_ * wall * wall, least)) return;
  std::size_t fastest = 0;
  for (std::size_t b = 1; b < particles_.balls; ++b)
    if (!(squared(particles_.velocity.one(b)) <= squared(particles_.velocity.one(fastest))))
      fastest = b;
  stop(fastest, energy_jumped);
}

void FewBodySolver::stop(std::size_t ball, const char* why) const {
  throw unstable_run(time_of(particles_.step), ball, why, particles_.position.one(ball),
                     particles_.velocity.one(ball));
}

std::vector<scene::Ball> FewBodySolver::balls() const {
  std::vector<scene::Ball> all = made_of_;
  const Flown way = flown(now_ - particles_.step);
  for (std::size_t b = 0; b < all.size(); ++b) {
    const Vec3 v = particles_.velocity.one(b);
    all[b].position = particles_.position.one(b) + way.time * v + way.shift;
    all[b].velocity = v + way.gain;
    all[b].spin = particles_.spin.one(b);
  }
  return all;
}

/// Those of the last step; in a skip there are none.
std::vector<Vec3> FewBodySolver::forces() const {
  std::vector<Vec3> all(made_of_.size());
  for (std::size_t b = 0; b < all.size(); ++b) all[b] = particles_.force.one(b);
  return all;
}

void FewBodySolver::carry(Archive& archive) {
  ParticleData& w = particles_;
  archive(w.step)(w.wall_points_due)(now_)(skip_end_)(next_skip_)(list_step_)(touched_);
  for (Columns* c : {&w.position, &w.velocity_predicted, &w.spin_predicted, &w.velocity, &w.spin,
                     &w.force, &w.torque, &w.list_positions})
    archive(c->x)(c->y)(c->z);
  archive(w.packets)(w.near)(contacts_of_)(listed_);
  archive(account_)(in_touch_)(in_touch_since_)(watch_)(asked_);
  if (w.position.x.size() < w.blocks || w.velocity.x.size() != w.blocks) throw Archive::broken();
  if (archive.reading()) find_owners();
}

}  // namespace mahlwerk::soft
