// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/soft_balls.hpp"

// Contacts that begin and end, and the records they leave.
namespace mahlwerk::soft {
namespace {

Vec3 one(const Vec<Lanes>& a, int lane) {
  return {a.x[lane], a.y[lane], a.z[lane]};
}

void put(Vec<Lanes>& a, int lane, const Vec3& b) {
  a.x[lane] = b.x, a.y[lane] = b.y, a.z[lane] = b.z;
}

/// A contact that outlives its collision this many times has come to last.
constexpr double lasting = 5;

}  // namespace

void SoftBalls::change(Packet& p, const LaneMask& touching, const Meeting& m, const Bodies& b) {
  for (int l = 0; l < lanes; ++l) {
    if (touching[l] == p.touching[l]) continue;
    if (touching[l] != 0)
      begin(p, l, m, b);
    else
      end(p, l);
  }
  p.touching = touching;
}

void SoftBalls::touches(std::int64_t body, int more) {
  std::int32_t& count = contacts_of_[static_cast<std::size_t>(body)];
  const int was = count > 0;
  count += more;
  if ((count > 0) == was) return;
  account_.contact_time += static_cast<double>(in_touch_) * time_of(swarm_.step - in_touch_since_);
  in_touch_since_ = swarm_.step;
  in_touch_ += count > 0 ? 1 : -1;
}

void SoftBalls::begin(Packet& p, int lane, const Meeting& m, const Bodies& b) {
  const auto k = static_cast<std::size_t>(lane);
  touches(p.i[lane], 1);
  if (p.wall[lane] == 0) touches(p.j[lane], 1);
  if (p.wall[lane] != 0 && rules_.law.curved_walls) bend(p, lane);
  const Vec3 n = one(m.n, lane), glide = one(b.vi, lane) - one(b.vj, lane);
  p.began[k] = {.step = swarm_.step,
                .approach = std::max(m.rate[lane], 0.0),
                .slip = norm(one(m.slip, lane)),
                .glide = norm(glide - dot(glide, n) * n)};
  put(p.spring, lane, {});
  put(p.roll, lane, {});
  put(p.normal, lane, n);
  p.stiffness[lane] = 0;
  contact::LawNumbers numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = p.numbers[i][lane];
  double memory[contact::law_memories] = {};
  std::visit([&](const auto& law) { law.begin(numbers, memory, p.began[k].approach); }, law_);
  for (int i = 0; i < contact::law_memories; ++i) p.memory[i][lane] = memory[i];
}

/// The ball at a curved wall: R* from both principal curvatures (dem.4).
void SoftBalls::bend(Packet& p, int lane) {
  const auto k = static_cast<std::size_t>(lane);
  const auto ball = static_cast<std::size_t>(p.i[lane]);
  const auto [most, least] =
      jar_->curvatures(p.face[k], swarm_.place.one(ball), clock(swarm_.step));
  const double own = 1 / made_of_[ball].radius;
  const auto flatter = [&](double curvature) { return 1 / std::max(own - curvature, 0.01 * own); };
  const Breed& breed = breeds_[p.breed[k]];
  contact::Touching touching = breed.touching;
  touching.radius = std::sqrt(flatter(most) * flatter(least));
  const contact::LawNumbers numbers =
      std::visit([&](const auto& law) { return law.numbers(touching, breed.damping); }, law_);
  for (std::size_t i = 0; i < numbers.size(); ++i) p.numbers[i][lane] = numbers[i];
  const double arm = touching.pair.rolling_friction * touching.radius;
  p.rolling[lane] = arm;
  p.roll_spring[lane] = 2.25 * arm * arm * breed.secant;
}

void SoftBalls::end(Packet& p, int lane) {
  const auto k = static_cast<std::size_t>(lane);
  touches(p.i[lane], -1);
  const bool wall = p.wall[lane] != 0;
  if (!wall) touches(p.j[lane], -1);
  const Beginning& began = p.began[k];
  const Breed& breed = breeds_[p.breed[k]];
  const auto ball = static_cast<std::size_t>(p.i[lane]);
  const double t = clock(swarm_.step);
  const Vec3 n = one(p.normal, lane);
  const Vec3 where = swarm_.place.one(ball) + p.radius_i[lane] * n;
  const Deeds& d = p.deeds;
  const double duration = time_of(swarm_.step - began.step);
  ended_.push_back({.time = time_of(began.step),
                    .duration = duration,
                    .ball = static_cast<std::int32_t>(p.i[lane]),
                    .other = wall ? ~p.face[k] : static_cast<std::int32_t>(p.j[lane]),
                    .where = jar_->own(where, t),
                    .normal = jar_->own(n, t),
                    .mass = breed.touching.mass,
                    .approach = began.approach,
                    .slip = began.slip,
                    .glide = began.glide,
                    .impulse = d.impulse[lane],
                    .lost_normal = d.normal[lane],
                    .lost_tangential = d.tangential[lane] + d.rolling[lane]});
  ++account_.collisions;
  const double free = std::visit(
      [&](const auto& law) {
        return law.shortest_time(breed.touching, std::max(began.approach, 1e-3));
      },
      law_);
  if (duration > lasting * free) ++account_.lasting_contacts;
  p.touching[lane] = 0;
  settle(p, lane);
}

void SoftBalls::settle(Packet& p, int lane) {
  Deeds& d = p.deeds;
  account_.lost_normal += d.normal[lane];
  account_.lost_tangential += d.tangential[lane];
  account_.lost_rolling += d.rolling[lane];
  account_.slid += d.sliding[lane];
  account_.wall_work += d.wall[lane];
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
