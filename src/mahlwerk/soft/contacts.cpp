// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::soft {

PairParameters pair_parameters(const SpeciesPair& pair, const Species& a, const Species* b,
                               double time_step) {
  PairParameters m;
  const Lanes none{};
  m.wall = LaneMask{} - (b == nullptr ? 1 : 0);
  m.radius_i = none + a.radius;
  m.radius_j = none + (b != nullptr ? b->radius : 0.0);
  m.per_radius = none + 1 / a.radius;
  m.share = none + (b != nullptr ? 0.5 : 1.0);
  m.reach = none + pair.reach;
  for (std::size_t n = 0; n < pair.numbers.size(); ++n) m.numbers[n] = none + pair.numbers[n];
  m.friction = none + pair.touching.pair.friction;
  const double arm = pair.touching.pair.rolling_friction * pair.touching.radius;
  m.rolling = none + arm;
  m.roll_spring = none + 2.25 * arm * arm * pair.secant;
  m.lag = none + pair.lag(time_step);
  m.inertia = none + (b == nullptr ? a.inertia : a.inertia * b->inertia / (a.inertia + b->inertia));
  return m;
}

void bend(PairParameters& parameters, int lane, const MovingWall& jar, int face,
          const Vec3& position, double t, const SpeciesPair& pair, const contact::AnyLaw& law) {
  const auto [most, least] = jar.curvatures(face, position, t);
  const double own = 1 / parameters.radius_i[lane];
  const auto flatter = [&](double curvature) { return 1 / std::max(own - curvature, 0.01 * own); };
  contact::Touching touching = pair.touching;
  touching.radius = std::sqrt(flatter(most) * flatter(least));
  const contact::LawNumbers numbers =
      std::visit([&](const auto& l) { return l.numbers(touching, pair.damping); }, law);
  for (std::size_t n = 0; n < numbers.size(); ++n) parameters.numbers[n][lane] = numbers[n];
  const double arm = touching.pair.rolling_friction * touching.radius;
  parameters.rolling[lane] = arm;
  parameters.roll_spring[lane] = 2.25 * arm * arm * pair.secant;
}

Beginning beginning(std::int64_t step, const ContactGeometry& m, const Bodies& b, int lane) {
  const Vec3 n = one(m.n, lane), glide = one(b.relative, lane);
  return {.step = step,
          .approach = std::max(m.rate[lane], 0.0),
          .slip = norm(one(m.slip, lane)),
          .glide = norm(glide - dot(glide, n) * n)};
}

void begin_memory(Lanes (&memory)[contact::law_memories], const PairParameters& parameters,
                  int lane, double approach, const contact::AnyLaw& law) {
  double begun[contact::law_memories] = {};
  std::visit([&](const auto& l) { l.begin(numbers_of(parameters, lane), begun, approach); }, law);
  for (int i = 0; i < contact::law_memories; ++i) memory[i][lane] = begun[i];
}

void add_work(scene::Account& account, const ContactWork& work, int lane) {
  account.lost_normal += work.normal[lane];
  account.lost_tangential += work.tangential[lane];
  account.lost_rolling += work.rolling[lane];
  account.slid += work.sliding[lane];
  account.wall_work += work.wall[lane];
}

bool outlasts(double duration, const Beginning& began, const SpeciesPair& pair,
              const contact::AnyLaw& law) {
  constexpr double lasting = 5;
  const double free = std::visit(
      [&](const auto& l) { return l.shortest_time(pair.touching, std::max(began.approach, 1e-3)); },
      law);
  return duration > lasting * free;
}

Frame frame_of(const Rules& rules, const Vec3& periods) {
  const Lanes none{};
  return Frame{.step = rules.time_step,
               .per_step = 1 / rules.time_step,
               .jar_speed = {},
               .rolling = rules.model.rolling,
               .rolling_damping = rules.model.rolling_damping,
               .rescaled = rules.model.rescaled_unloading,
               .periodic = repeats(periods),
               .periods = {none + periods.x, none + periods.y, none + periods.z}};
}

}  // namespace mahlwerk::soft
