// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/few/solver.hpp"

namespace mahlwerk::soft {

FewBodySolver::Stored FewBodySolver::stored() const {
  Stored energy;
  for (const PairPacket& p : particles_.packets)
    for (int l = 0; l < lanes; ++l) {
      if (p.touching[l] == 0) continue;
      const double memory[contact::law_memories] = {p.memory[0][l], p.memory[1][l]};
      const Vec3 apart = nearest(particles_.position.one(static_cast<std::size_t>(p.j[l])) -
                                 particles_.position.one(static_cast<std::size_t>(p.i[l])));
      const double overlap = p.radius_i[l] + p.radius_j[l] - norm(apart);
      if (overlap < -p.radius_i[l]) continue;  // it has left this face over an edge
      energy.normal +=
          std::visit([&](const auto& law) { return law.stored(numbers_of(p, l), memory, overlap); },
                     *rules_.model.law);
      energy.tangential += 0.5 * p.stiffness[l] * squared(one(p.spring, l));
    }
  return energy;
}

scene::Account FewBodySolver::account() const {
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
  for (const PairPacket& p : particles_.packets)
    for (int l = 0; l < lanes; ++l) {
      if (!p.used[static_cast<std::size_t>(l)]) continue;
      add_work(a, p.work, l);
      a.lost_open += p.work.normal[l] + p.work.tangential[l] + p.work.rolling[l];
      a.deepest_overlap = std::max(a.deepest_overlap, p.work.deepest[l] / p.radius_i[l]);
    }
  a.lost_normal -= kept.normal;  // of what contacts took so far, this can come back
  a.lost_tangential -= kept.tangential;
  a.lost_open -= a.elastic;
  a.contact_time += static_cast<double>(in_touch_) * time_of(particles_.step - in_touch_since_);
  return a;
}

void FewBodySolver::check_energy() {
  const scene::Account a = account();
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

}  // namespace mahlwerk::soft
