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
  const Lanes zero{};
  m.wall = LaneMask{} - (b == nullptr ? 1 : 0);
  m.radius_i = zero + a.radius;
  m.radius_j = zero + (b != nullptr ? b->radius : 0.0);
  m.inverse_radius = zero + 1 / a.radius;
  m.share = zero + (b != nullptr ? 0.5 : 1.0);
  m.pull_off_distance = zero + pair.pull_off_distance;
  for (std::size_t n = 0; n < pair.coefficients.size(); ++n)
    m.coefficients[n] = zero + pair.coefficients[n];
  m.friction = zero + pair.effective.pair.friction;
  const double arm = pair.effective.pair.rolling_friction * pair.effective.radius;
  m.rolling = zero + arm;
  m.roll_spring = zero + 2.25 * arm * arm * pair.stiffness_ratio;
  m.stiffness_correction = zero + pair.stiffness_correction(time_step);
  m.inertia = zero + (b == nullptr ? a.inertia : a.inertia * b->inertia / (a.inertia + b->inertia));
  return m;
}

void apply_wall_curvature(PairParameters& parameters, int lane, const MovingWall& jar, int face,
                          const Vec3& position, double t, const SpeciesPair& pair,
                          const contact::AnyLaw& law) {
  const auto [max_curvature, min_curvature] = jar.curvatures(face, position, t);
  const double ball_curvature = 1 / parameters.radius_i[lane];
  const auto effective_radius_along = [&](double curvature) {
    return 1 / std::max(ball_curvature - curvature, 0.01 * ball_curvature);
  };
  contact::EffectivePair effective = pair.effective;
  effective.radius =
      std::sqrt(effective_radius_along(max_curvature) * effective_radius_along(min_curvature));
  const contact::LawCoefficients coefficients =
      std::visit([&](const auto& l) { return l.coefficients(effective, pair.damping); }, law);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    parameters.coefficients[n][lane] = coefficients[n];
  const double arm = effective.pair.rolling_friction * effective.radius;
  parameters.rolling[lane] = arm;
  parameters.roll_spring[lane] = 2.25 * arm * arm * pair.stiffness_ratio;
}

ContactOnset contact_onset(std::int64_t step, const ContactGeometry& m, const PairMotion& b,
                           int lane) {
  const Vec3 n = get_lane(m.n, lane), glide = get_lane(b.relative, lane);
  return {.step = step,
          .approach = std::max(m.rate[lane], 0.0),
          .slip = norm(get_lane(m.slip, lane)),
          .glide = norm(glide - dot(glide, n) * n)};
}

void begin_law_history(Lanes (&law_history)[contact::law_history_size],
                       const PairParameters& parameters, int lane, double approach,
                       const contact::AnyLaw& law) {
  double begun[contact::law_history_size] = {};
  std::visit([&](const auto& l) { l.begin(coefficients_of(parameters, lane), begun, approach); },
             law);
  for (int i = 0; i < contact::law_history_size; ++i) law_history[i][lane] = begun[i];
}

void add_work(scene::EnergyBalance& energy_balance, const ContactWork& work, int lane) {
  energy_balance.lost_normal += work.normal[lane];
  energy_balance.lost_tangential += work.tangential[lane];
  energy_balance.lost_rolling += work.rolling[lane];
  energy_balance.slid += work.sliding[lane];
  energy_balance.wall_work += work.wall[lane];
}

bool is_lasting(double duration, const ContactOnset& onset, const SpeciesPair& pair,
                const contact::AnyLaw& law) {
  constexpr double lasting_ratio = 5;
  const double impact_time = std::visit(
      [&](const auto& l) {
        return l.shortest_time(pair.effective, std::max(onset.approach, 1e-3));
      },
      law);
  return duration > lasting_ratio * impact_time;
}

StepConstants step_constants(const Settings& settings, const Vec3& periods) {
  const Lanes zero{};
  return StepConstants{.dt = settings.time_step,
                       .inverse_dt = 1 / settings.time_step,
                       .jar_velocity = {},
                       .rolling = settings.model.rolling,
                       .rolling_damping = settings.model.rolling_damping,
                       .rescaled = settings.model.rescaled_unloading,
                       .periodic = is_periodic(periods),
                       .periods = {zero + periods.x, zero + periods.y, zero + periods.z}};
}

}  // namespace mahlwerk::soft
