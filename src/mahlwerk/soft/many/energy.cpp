// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/many/solver.hpp"

// What a crowd tells of itself: energy, balls.
namespace mahlwerk::soft {

Vec3 ManyBodySolver::pulls() const {
  const std::vector<DriveSample> b = drive_samples(step_, step_ + 1);
  return 0.5 * rules_.time_step * (b[1].pull - b[0].pull);
}

/// At the step reached; the rows know half a step more (dem.26).
Vec3 ManyBodySolver::velocity(std::size_t row, const Vec3& pulls) const {
  const VectorPair& half = half_[row];
  const BallRecord& seen = next_[row];
  return 2.0 * Vec3{half.x, half.y, half.z} - Vec3{seen.u, seen.v, seen.w} + pulls;
}
Vec3 ManyBodySolver::spin(std::size_t row) const {
  const VectorPair& half = half_[row];
  const SpinRecord& seen = next_spins_[row];
  return 2.0 * Vec3{half.a, half.b, half.c} - Vec3{seen.x, seen.y, seen.z};
}

/// Of contacts, each counted once, or two times half.
ManyBodySolver::Stored ManyBodySolver::stored(const Chunk& chunk) const {
  Stored energy;
  const double t = clock(step_);
  const auto add = [&](const Grips& list, double weight) {
    for (std::size_t n = 0; n < list.grips.size(); ++n) {
      const Grip& g = list.grips[n];
      for (int l = 0; l < lanes; ++l) {
        if (!g.touches(l)) continue;
        energy.taken += weight * (g.lost_normal[l] + g.lost_across[l]);
        const auto k = static_cast<std::size_t>(l);
        const auto i = static_cast<std::size_t>(g.i[k]);
        const PairParameters& parameters =
            list.parameters.empty() ? parameters_[static_cast<std::size_t>(g.species_pair[k])]
                                    : list.parameters[n];
        const contact::LawNumbers numbers = numbers_of(parameters, l);
        double memory[contact::law_memories] = {};
        if (remembers_)
          for (int a = 0; a < contact::law_memories; ++a) memory[a] = list.memories[n].memory[a][l];
        const Vec3 x = now_[i].position();
        const double distance =
            parameters.wall[l] != 0
                ? jar_->gap(g.j[k], x, t, now_[i].radius + reach_).distance
                : norm(nearest(now_[static_cast<std::size_t>(g.j[k])].position() - x));
        const double overlap = parameters.radius_i[l] + parameters.radius_j[l] - distance;
        if (overlap < -now_[i].radius) continue;  // it has left this face over an edge
        std::visit(
            [&]<class L>(const L& law) {
              energy.normal += weight * law.stored(numbers, memory, overlap);
              const double at = std::max(overlap, 0.0);
              const double stiffness = L::push(numbers.data(), memory, at, 0.0).stiffness;
              const Vec3 spring{g.spring.x[l], g.spring.y[l], g.spring.z[l]};
              energy.tangential += weight * 0.5 * stiffness * squared(spring);
            },
            law_);
      }
    }
  };
  add(chunk.own, 1);
  add(chunk.halo, 0.5);
  add(chunk.wall, 1);
  return energy;
}

scene::Account ManyBodySolver::reckoned() const {
  scene::Account a = account_;
  for (const Chunk& chunk : chunks_) add_sums(a, chunk);
  a.time = time_of(step_);
  a.time_steps = step_;
  if (a.time < asked_ && asked_ - a.time < 1e-5 * rules_.time_step) a.time = asked_;  // rounding
  const kinematics::Ride ride = jar_->ride(clock(step_));
  const Vec3 change = pulls();
  struct Sum {
    double kinetic = 0, potential = 0;
    Stored stored;
  };
  std::vector<Sum> sums(chunks_.size());
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    Sum& sum = sums[static_cast<std::size_t>(c)];
    for (std::int32_t row = chunk.first; row < chunk.last; ++row) {
      const auto k = static_cast<std::size_t>(row);
      const Species& of = pairs_.species(species_[k]);
      const Vec3 v = velocity(k, change) + ride.velocity;
      sum.kinetic += 0.5 * (of.mass * squared(v) + of.inertia * squared(spin(k)));
      sum.potential -= of.mass * dot(jar_->gravity(), now_[k].position() + ride.centre);
    }
    sum.stored = stored(chunk);
  });
  a.kinetic = a.potential = a.elastic = 0;
  for (const Sum& sum : sums) {
    a.kinetic += sum.kinetic;
    a.potential += sum.potential;
    a.elastic += sum.stored.normal + sum.stored.tangential;
    a.lost_open += sum.stored.taken - sum.stored.normal - sum.stored.tangential;
    a.lost_normal -= sum.stored.normal;  // of what contacts took so far, this can come back
    a.lost_tangential -= sum.stored.tangential;
  }
  return a;
}

scene::Account ManyBodySolver::account() const {
  return reckoned();
}

std::vector<scene::Ball> ManyBodySolver::balls() const {
  std::vector<scene::Ball> all(id_.size());
  const Vec3 change = pulls();
  for (std::size_t k = 0; k < id_.size(); ++k) {
    const Species& s = pairs_.species(species_[k]);
    all[static_cast<std::size_t>(id_[k])] = {
        s.radius, s.density, now_[k].position(), velocity(k, change), spin(k), s.kind};
  }
  return all;
}

/// From what the rows know: the velocity seen a step later is that half a step later, half a kick
/// of the contacts, and half a step of the body field then (dem.26).
std::vector<Vec3> ManyBodySolver::forces() const {
  std::vector<Vec3> all(id_.size());
  const double half_step = 0.5 * rules_.time_step;
  const Vec3 pull = half_step * drive_samples(step_ + 1, step_ + 1).front().pull;
  for (std::size_t k = 0; k < id_.size(); ++k) {
    const VectorPair& half = half_[k];
    const BallRecord& seen = next_[k];
    const Vec3 gained = Vec3{seen.u, seen.v, seen.w} - Vec3{half.x, half.y, half.z} - pull;
    all[static_cast<std::size_t>(id_[k])] = pairs_.species(species_[k]).mass / half_step * gained;
  }
  return all;
}

void ManyBodySolver::carry(Archive& archive) {
  const std::size_t balls = now_.size();
  archive(step_)(list_step_)(skin_)(widest_)(spent_)(sorted_at_)(pairs_sorted_)(tuning_);
  archive(now_)(next_)(list_positions_)(spins_)(next_spins_)(half_);
  if (now_.size() != balls) throw Archive::broken();
  archive(id_)(species_)(contacts_of_)(drifts_)(guesses_)(class_first_);
  auto count = static_cast<std::uint64_t>(chunks_.size());
  archive(count);
  if (archive.reading()) {
    if (count > now_.size() + 1) throw Archive::broken();
    chunks_.assign(count, {});
  }
  for (Chunk& c : chunks_) {
    archive(c.first)(c.last)(c.bound)(c.wall_bound)(c.in_touch)(c.sums)(c.neighbours);
    for (Grips* list : {&c.own, &c.halo, &c.wall})
      archive(list->grips)(list->began)(list->memories)(list->parameters)(list->facings)(
          list->free);
    for (VerletList* w : {&c.near, &c.near_wall}) archive(w->pairs)(w->end)(w->separated);
  }
  archive(account_)(watch_)(asked_);
  if (archive.reading()) share_work();
}

}  // namespace mahlwerk::soft
