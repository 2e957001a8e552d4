// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/wear/wear_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/worn_section.hpp"
#include "mahlwerk/powder/wear.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/wear_rates.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::size_t most_cohorts = 10;  // of a set: each is a ball set of the runs

/// [m3/s] of the cells of a recorded body of this Vickers hardness: means over the replicates.
std::vector<double> cell_rates(const WornCase& of, std::size_t body, double hardness,
                               const results::Outcome& outcome, const RecordedWear& recorded,
                               const std::vector<const results::Replicate*>& chosen) {
  std::vector<double> rates;
  for (const results::Replicate* r : chosen) {
    const auto& cells = recorded[results::number_of(outcome, *r) - 1]->of_body[body];
    rates.resize(cells.size());
    const double per = 1 / (r->time() * static_cast<double>(chosen.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
      rates[i] +=
          per * cases::worn_volume(
                    of.wear(), {cells[i].load_distance, cells[i].erosion, cells[i].lost}, hardness);
  }
  return rates;
}

/// Rates of the profiles and meshes, smoothed.
void set_shape_rates(const WornCase& of, const WornState& state, const results::Outcome& outcome,
                     const RecordedWear& recorded,
                     const std::vector<const results::Replicate*>& chosen, WearRates& rates) {
  const auto& parts = of.mill_case().machine_parts;
  for (std::size_t k = 0; k < of.profiles().size(); ++k) {
    const WornCase::Profile& one = of.profiles()[k];
    std::vector<double> sides =
        cell_rates(of, k, parts[one.part].substance.hardness, outcome, recorded, chosen);
    for (double& area : sides) area /= one.rows * one.length;
    rates.sections.push_back(geometry::spread_along(state.sections[k], std::move(sides),
                                                    of.exposed(state, k), of.smoothing()));
  }
  for (std::size_t k = 0; k < of.meshes().size(); ++k) {
    const auto& part = of.meshes()[k].part;
    const double hardness =
        part ? parts[*part].substance.hardness : of.mill_case().jar.substance.hardness;
    rates.surfaces.push_back(geometry::spread_over(
        state.surfaces[k],
        cell_rates(of, of.profiles().size() + k, hardness, outcome, recorded, chosen),
        of.smoothing()));
  }
}

/// [m3/s] Wear of each ball of the cohorts; one without balls wears as its neighbour, linearly.
std::vector<std::vector<double>> ball_rates(const WornCase& of, const WornState& state,
                                            const cases::Case& stage,
                                            const std::vector<const results::Replicate*>& chosen) {
  std::vector<std::vector<double>> rates;
  for (const powder::BallCharge& charge : state.charges) rates.emplace_back(charge.size(), -1.0);
  const auto cohorts = of.cohorts(state);
  for (std::size_t i = 0; i < cohorts.size(); ++i) {
    const double all = results::mean_over(chosen, [&](const results::Replicate& r) {
      return results::set_wear_rate(stage, r, static_cast<int>(i));
    });
    rates[cohorts[i].first][cohorts[i].second] = all / static_cast<double>(stage.balls[i].count);
  }
  for (std::size_t s = 0; s < rates.size(); ++s)
    for (std::size_t k = 0; k < rates[s].size(); ++k) {
      if (rates[s][k] >= 0) continue;
      std::size_t like = k;
      for (std::size_t far = 1; far < rates[s].size() && rates[s][like] < 0; ++far)
        if (k >= far && rates[s][k - far] >= 0)
          like = k - far;
        else if (k + far < rates[s].size() && rates[s][k + far] >= 0)
          like = k + far;
      const double ratio = state.charges[s][k].diameter / state.charges[s][like].diameter;
      rates[s][k] = std::max(0.0, rates[s][like]) * ratio * ratio;
    }
  return rates;
}

/// The diameter and height of a round jar after its faces have lost these volumes [m3] (wea.18).
void wear_jar(const WornCase& of, const WornState& before, double shell, double ends,
              WornState& after) {
  const geometry::AnyShape& shape = *of.mill_case().jar.shape;
  if (geometry::as<geometry::Sphere>(shape) != nullptr) {
    const double d = before.diameter;
    after.diameter = math::cbrt(d * d * d + 6 / std::numbers::pi * shell);
    return;
  }
  const auto* slice = geometry::as<geometry::PeriodicCylinder>(shape);
  const double length = slice != nullptr ? slice->length : before.height;
  if (!(length > 0)) return;
  const double bare = std::max(of.bare_share(before), 1e-3), d = before.diameter;
  after.diameter = std::sqrt(d * d + 4 * shell / (std::numbers::pi * bare * length));
  if (before.height > 0)
    after.height = before.height + 4 * ends / (std::numbers::pi * after.diameter * after.diameter);
}

}  // namespace

std::shared_ptr<const observe::LoadFactors> load_factors(const cases::Case& stage) {
  auto made = std::make_shared<observe::LoadFactors>();
  for (const std::int32_t kind : cases::kinds_of_balls(stage)) made->kind_of_ball.push_back(kind);
  const contact::BounceTable rules = cases::bounce_table(stage);
  for (int kind = 0; kind < rules.kinds(); ++kind) {
    made->of_kind.emplace_back();
    for (int face = 0; face < rules.faces(); ++face)
      made->of_kind.back().push_back(
          powder::load_distance(1, cases::sliding_friction(stage, rules.wall(kind, face))));
  }
  return made;
}

WearRates wear_rates(const WornCase& of, const WornState& state, const results::Outcome& outcome,
                     const RecordedWear& recorded) {
  WearRates rates;
  const cases::Case& stage = outcome.mill_case;
  const std::vector<const results::Replicate*> chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return rates;
  set_shape_rates(of, state, outcome, recorded, chosen, rates);
  const observe::StatisticsByPair& pairs = chosen.front()->tally.by_pair;
  const int of_jar = results::distinguished_jar_faces(stage, pairs);
  for (int face = 0; face < pairs.faces(); ++face) {
    const double volume = results::mean_over(chosen, [&](const results::Replicate& r) {
      return results::face_wear_rate(stage, r, face);
    });
    (face < of_jar ? rates.jar : rates.parts) += volume;
    if (face < of_jar) (face == 0 ? rates.shell : rates.ends) += volume;
  }
  rates.balls = ball_rates(of, state, stage, chosen);
  return rates;
}

double largest_change_rate(const WornCase& of, const WornState& state, const WearRates& rates) {
  double largest = 0;
  for (std::size_t k = 0; k < of.profiles().size(); ++k)
    for (std::size_t i = 0; i < state.sections[k].size(); ++i)
      largest = std::max(largest, rates.sections[k][i] / geometry::length_of(state.sections[k], i) /
                                      of.profiles()[k].height);
  double largest_ball = 0;
  for (std::size_t s = 0; s < state.charges.size(); ++s) {
    largest_ball = std::max(largest_ball, of.fresh_size(s));
    for (std::size_t k = 0; k < state.charges[s].size(); ++k) {
      const double d = state.charges[s][k].diameter;
      largest =
          std::max(largest, 2 * rates.balls[s][k] / (std::numbers::pi * d * d) / of.fresh_size(s));
    }
  }
  for (std::size_t k = 0; k < state.surfaces.size(); ++k) {
    const std::vector<double> areas = geometry::vertex_areas(state.surfaces[k]);
    for (std::size_t i = 0; i < areas.size(); ++i)
      if (areas[i] > 0) largest = std::max(largest, rates.surfaces[k][i] / areas[i] / largest_ball);
  }
  constexpr double trial = 1;  // [s]
  WornState jar = state;
  wear_jar(of, state, trial * rates.shell, trial * rates.ends, jar);
  const double moved = std::max(jar.diameter - state.diameter, jar.height - state.height) / 2;
  return std::max(largest, moved / largest_ball);
}

std::optional<WornState> worn_after(const WornCase& of, const WornState& state,
                                    const WearRates& rates, double time) {
  WornState after = state;
  after.time += time;
  constexpr double shortest = 0.3;  // of a piece
  for (std::size_t k = 0; k < of.profiles().size(); ++k) {
    std::vector<double> lost = rates.sections[k];
    for (double& area : lost) area *= time;
    auto worn = geometry::worn_section(state.sections[k], lost);
    if (!worn) return std::nullopt;
    const double piece = of.profiles()[k].piece;
    after.sections[k] = geometry::cut_into_pieces(
        geometry::without_short_sides(std::move(*worn), shortest * piece), 1.5 * piece);
  }
  for (std::size_t k = 0; k < of.meshes().size(); ++k) {
    std::vector<double> lost = rates.surfaces[k];
    for (double& volume : lost) volume *= time;
    auto worn = geometry::worn_surface(state.surfaces[k], lost, of.meshes()[k].side);
    if (!worn) return std::nullopt;
    after.surfaces[k] = std::move(*worn);
  }
  wear_jar(of, state, time * rates.shell, time * rates.ends, after);
  after.lost.jar += time * rates.jar;
  after.lost.parts += time * rates.parts;
  for (std::size_t s = 0; s < after.charges.size(); ++s) {
    powder::BallCharge& charge = after.charges[s];
    std::vector<double> volumes = rates.balls[s];
    for (double& volume : volumes) volume *= time;
    const double worn = powder::wear_down(charge, volumes);
    const double scrapped = powder::scrap_below(charge, of.wear().scrap_size);
    const double added = of.wear().make_up ? worn + scrapped : 0;
    powder::add_fresh(charge, of.fresh_size(s), added);
    powder::join_cohorts(charge, most_cohorts);
    after.lost.balls += worn;
    after.lost.scrapped += scrapped;
    after.lost.added += added;
  }
  return after;
}

}  // namespace mahlwerk::campaign
