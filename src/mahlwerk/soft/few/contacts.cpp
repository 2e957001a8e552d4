// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/few/solver.hpp"

// Contacts that begin and end, and their records.
namespace mahlwerk::soft {

void FewBodySolver::begin(PairPacket& p, const LaneMask& begun, const ContactGeometry& m,
                          const Bodies& b) {
  for (int l = 0; l < lanes; ++l)
    if (begun[l] != 0) begin(p, l, m, b);
  p.touching |= begun;
}
void FewBodySolver::end(PairPacket& p, const LaneMask& ended) {
  for (int l = 0; l < lanes; ++l)
    if (ended[l] != 0) end(p, l);
}

void FewBodySolver::touches(std::int64_t body, int more) {
  std::int32_t& count = contacts_of_[static_cast<std::size_t>(body)];
  const int was = count > 0;
  count += more;
  if ((count > 0) == was) return;
  account_.contact_time +=
      static_cast<double>(in_touch_) * time_of(particles_.step - in_touch_since_);
  in_touch_since_ = particles_.step;
  in_touch_ += count > 0 ? 1 : -1;
}

void FewBodySolver::begin(PairPacket& p, int lane, const ContactGeometry& m, const Bodies& b) {
  const auto k = static_cast<std::size_t>(lane);
  touches(p.i[lane], 1);
  if (p.wall[lane] == 0) touches(p.j[lane], 1);
  if (p.wall[lane] != 0 && rules_.model.curved_walls)
    bend(p, lane, *jar_, p.face[k], particles_.position.one(static_cast<std::size_t>(p.i[lane])),
         clock(particles_.step), pairs_[p.species_pair[k]], *rules_.model.law);
  p.began[k] = beginning(particles_.step, m, b, lane);
  put(p.spring, lane, {});
  put(p.roll, lane, {});
  p.stiffness[lane] = 0;
  p.pulls[lane] = 0;
  begin_memory(p.memory, p, lane, p.began[k].approach, *rules_.model.law);
}

void FewBodySolver::end(PairPacket& p, int lane) {
  const auto k = static_cast<std::size_t>(lane);
  touches(p.i[lane], -1);
  const bool wall = p.wall[lane] != 0;
  if (!wall) touches(p.j[lane], -1);
  const Beginning& began = p.began[k];
  const SpeciesPair& pair = pairs_[p.species_pair[k]];
  const auto ball = static_cast<std::size_t>(p.i[lane]);
  const double t = clock(particles_.step);
  const int face = wall ? p.face[k] : -1;
  const Vec3 x = particles_.position.one(ball);
  const Vec3 apart =
      wall ? one(p.normal, lane)
           : nearest(particles_.position.one(static_cast<std::size_t>(p.j[lane])) - x);
  const Vec3 n = (1 / norm(apart)) * apart;
  const Vec3 where = x + p.radius_i[lane] * n;
  const ContactWork& d = p.work;
  const double duration = time_of(particles_.step - began.step);
  ended_.push_back({.time = time_of(began.step),
                    .duration = duration,
                    .ball = static_cast<std::int32_t>(p.i[lane]),
                    .other = wall ? ~p.face[k] : static_cast<std::int32_t>(p.j[lane]),
                    .where = jar_->own(where, t, face),
                    .normal = jar_->own(n, t, face),
                    .mass = pair.touching.mass,
                    .approach = began.approach,
                    .slip = began.slip,
                    .glide = began.glide,
                    .impulse = d.impulse[lane],
                    .lost_normal = d.normal[lane],
                    .lost_tangential = d.tangential[lane] + d.rolling[lane]});
  ++account_.collisions;
  if (outlasts(duration, began, pair, *rules_.model.law)) ++account_.lasting_contacts;
  p.touching[lane] = 0;
  settle(p, lane);
}

void FewBodySolver::settle(PairPacket& p, int lane) {
  ContactWork& d = p.work;
  add_work(account_, d, lane);
  const double radius = p.radius_i[lane];
  if (radius > 0)
    account_.deepest_overlap = std::max(account_.deepest_overlap, d.deepest[lane] / radius);
  for (Lanes* sum :
       {&d.impulse, &d.normal, &d.tangential, &d.rolling, &d.sliding, &d.wall, &d.deepest})
    (*sum)[lane] = 0;
  put(p.spring, lane, {});
  put(p.roll, lane, {});
  p.stiffness[lane] = 0;
}

}  // namespace mahlwerk::soft
