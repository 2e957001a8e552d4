// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::soft {
namespace {

/// PairParameters::rolling_coefficient. Under the rule own_spin, each body has a lever of its own.
double rolling_coefficient(const contact::EffectivePair& effective, contact::Rolling rolling) {
  const double mu = effective.pair.rolling_friction;
  return rolling == contact::Rolling::own_spin ? mu : mu * effective.radius;
}

}  // namespace

PairParameters pair_parameters(const SpeciesPair& pair, const Species& a, const Species* b,
                               const Settings& settings) {
  PairParameters parameters;
  const std::int64_t wall = b == nullptr ? -1 : 0;
  parameters.wall = {wall, wall, wall, wall, wall, wall, wall, wall};
  parameters.radius_i = broadcast(a.radius);
  parameters.radius_j = broadcast(b != nullptr ? b->radius : 0.0);
  parameters.inverse_radius = broadcast(1 / min_radius(parameters, 0));
  parameters.overlap_share = broadcast(b != nullptr ? 0.5 : 1.0);
  parameters.pull_off_distance = broadcast(pair.pull_off_distance);
  for (std::size_t n = 0; n < pair.coefficients.size(); ++n)
    parameters.coefficients[n] = broadcast(pair.coefficients[n]);
  parameters.friction = broadcast(pair.effective.pair.friction);
  parameters.twisting_radius = broadcast(pair.effective.radius);
  const double arm = rolling_coefficient(pair.effective, settings.model.rolling);
  parameters.rolling_coefficient = broadcast(arm);
  parameters.rolling_stiffness_ratio = broadcast(2.25 * arm * arm * pair.stiffness_ratio);
  parameters.phase_squared_per_stiffness =
      broadcast(pair.phase_squared_per_stiffness(settings.time_step));
  parameters.half_step_squared_over_mass =
      broadcast(0.5 * settings.time_step * settings.time_step / pair.effective.mass);
  parameters.slip_factor = broadcast(pair.effective.slip_factor);
  parameters.inertia =
      broadcast(b == nullptr ? a.inertia : a.inertia * b->inertia / (a.inertia + b->inertia));
  return parameters;
}

std::vector<PairParameters> all_pair_parameters(const SpeciesPairs& pairs, int faces,
                                                const Settings& settings) {
  std::vector<PairParameters> all(pairs.all().size());
  const auto count = static_cast<std::int32_t>(pairs.all_species().size());
  for (std::int32_t a = 0; a < count; ++a) {
    const auto put = [&](std::int32_t pair, const Species* other) {
      all[static_cast<std::size_t>(pair)] =
          pair_parameters(pairs[pair], pairs.species(a), other, settings);
    };
    for (std::int32_t b = 0; b < count; ++b) put(pairs.ball_pair_index(a, b), &pairs.species(b));
    for (int face = 0; face < faces; ++face) put(pairs.wall_pair_index(a, face), nullptr);
  }
  return all;
}

void apply_effective_radius(PairParameters& parameters, std::size_t lane,
                            const contact::EffectivePair& effective, const SpeciesPair& pair,
                            const contact::ContactModel& model) {
  const contact::LawCoefficients coefficients = std::visit(
      [&](const auto& l) { return l.coefficients(effective, pair.damping); }, *model.law);
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    parameters.coefficients[n][lane] = coefficients[n];
  const double arm = rolling_coefficient(effective, model.rolling);
  parameters.twisting_radius[lane] = effective.radius;
  parameters.rolling_coefficient[lane] = arm;
  parameters.rolling_stiffness_ratio[lane] = 2.25 * arm * arm * pair.stiffness_ratio;
}

void apply_wall_curvature(PairParameters& parameters, std::size_t lane, const MovingWall& jar,
                          int face, const Vec3& position, double t, const SpeciesPair& pair,
                          const contact::ContactModel& model) {
  const auto [max_curvature, min_curvature] = jar.curvatures(face, position, t);
  const double ball_curvature = 1 / parameters.radius_i[lane];
  const auto effective_radius_along = [&](double curvature) {
    return 1 / std::max(ball_curvature - curvature, 0.01 * ball_curvature);
  };
  contact::EffectivePair effective = pair.effective;
  effective.radius =
      std::sqrt(effective_radius_along(max_curvature) * effective_radius_along(min_curvature));
  apply_effective_radius(parameters, lane, effective, pair, model);
}

ContactOnset contact_onset(std::int64_t step, const OnsetSpeeds& speeds, std::size_t lane) {
  return {.step = step,
          .approach = std::max(speeds.approach[lane], 0.0),
          .slip = speeds.slip[lane],
          .glide = speeds.glide[lane]};
}

void begin_law_history(Lanes (&law_history)[contact::law_history_size],
                       const PairParameters& parameters, std::size_t lane, double approach,
                       const contact::AnyLaw& law) {
  double begun[contact::law_history_size] = {};
  std::visit([&](const auto& l) { l.begin(coefficients_of(parameters, lane), begun, approach); },
             law);
  for (int i = 0; i < contact::law_history_size; ++i) law_history[i][lane] = begun[i];
}

StoredEnergy stored_energy(const PairParameters& parameters, std::size_t lane, double overlap,
                           const double* law_history, const Vec3& spring, double twist,
                           const contact::ContactModel& model) {
  return std::visit(
      [&](const auto& law) {
        return stored_energy(law, parameters, lane, overlap, law_history, spring, twist,
                             model.partial_slip);
      },
      *model.law);
}

double energy_at_start(const PairParameters& parameters, double overlap,
                       const contact::AnyLaw& law) {
  if (!(overlap > 0)) return 0;
  const contact::LawCoefficients coefficients = coefficients_of(parameters, 0);
  double history[contact::law_history_size] = {};
  return std::visit(
      [&]<class L>(const L& l) {
        l.begin(coefficients, history, 0.0);
        L::evaluate(coefficients.data(), history, overlap, 0.0);
        double energy = l.elastic_energy(coefficients, history, overlap);
        if constexpr (requires { L::plastic_energy(coefficients.data(), history); })
          energy += L::plastic_energy(coefficients.data(), history);
        return energy;
      },
      law);
}

double separation_energy(const PairParameters& parameters, std::size_t lane,
                         const contact::AnyLaw& law) {
  const double distance = parameters.pull_off_distance[lane];
  if (!(distance > 0)) return 0;
  const double none[contact::law_history_size] = {};
  return std::visit(
      [&](const auto& l) {
        return l.elastic_energy(coefficients_of(parameters, lane), none, -distance);
      },
      law);
}

void add_work(scene::EnergyBalance& energy_balance, const ContactWork& work, std::size_t lane) {
  energy_balance.lost_normal += work.normal[lane];
  energy_balance.lost_tangential += work.tangential[lane];
  energy_balance.lost_rolling += work.rolling[lane];
  energy_balance.slid += work.sliding[lane];
  energy_balance.wall_work += work.wall[lane];
}

bool is_sustained(double duration, const ContactOnset& onset, const SpeciesPair& pair,
                  const contact::AnyLaw& law) {
  constexpr double sustained_ratio = 5;
  const double impact_time = std::visit(
      [&](const auto& l) {
        return l.shortest_time(pair.effective, std::max(onset.approach, 1e-3));
      },
      law);
  return duration > sustained_ratio * impact_time;
}

StepConstants step_constants(const Settings& settings, const Vec3& periods) {
  return StepConstants{.dt = settings.time_step,
                       .inverse_dt = 1 / settings.time_step,
                       .jar_velocity = {},
                       .rolling = settings.model.rolling,
                       .rolling_damping = settings.model.rolling_damping,
                       .rescaled = settings.model.rescaled_unloading,
                       .partial_slip = settings.model.partial_slip,
                       .twisting = settings.model.twisting,
                       .periodic = is_periodic(periods),
                       .periods = periods};
}

}  // namespace mahlwerk::soft
