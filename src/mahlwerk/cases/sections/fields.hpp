// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"

// Field tables of the numbers of a case that belong to no model, for reader, writer and checks.
namespace mahlwerk::cases {

constexpr std::int64_t max_jars = 100;
constexpr Range restitution_range{.least = 0, .most = 1};
constexpr Range tilts{.least = -std::numbers::pi / 2, .most = std::numbers::pi / 2};
constexpr Range poisson_ratios{.least = -1, .most = 0.5, .without_least = true};
constexpr Range tangential_range{.least = -1, .most = 1};
constexpr std::int64_t max_replicates = 10000;
constexpr std::int64_t max_balls = 100'000'000;
constexpr double max_grains = 2e6;    ///< of the powder
constexpr std::size_t max_sets = 32;  ///< ball sets, including the powder
constexpr double densest = 0.74;      ///< solid fraction of the densest packing of equal balls

constexpr auto case_fields() {
  return std::array{Field<Case>{"gravity", "m/s2", &Case::gravity, not_negative,
                                "acceleration of free fall", 9.81, "on Earth"}};
}

/// Parameters of a contact besides its bounce rule, for [contact] and for a pair.
template <class Owner>
constexpr auto touch_fields() {
  return std::array{
      Field<Owner>{"rolling_friction", "", &Owner::rolling_friction, not_negative,
                   "rolling resistance over normal force", 0.01, "uncalibrated, 0-0.1"}
          .with({.label = "rolling friction", .symbol = "$µ_{r}$"}),
      Field<Owner>{"surface_energy", "J/m2", &Owner::surface_energy, not_negative,
                   "energy of one surface, half the work of separation"},
      Field<Owner>{"cohesion", "J/m3", &Owner::cohesion, not_negative,
                   "cohesion energy density, adhesive force over contact area"},
      Field<Owner>{"surface_tension", "N/m", &Owner::surface_tension, not_negative,
                   "surface tension of the liquid of capillary bridges; 0: the pair is dry"}
          .plausible_within("0.1 mN/m", "5 N/m")};
}

/// Range of an assumed rolling_friction, with the source of its default.
constexpr Range plausible_rolling_friction{.least = 0, .most = 0.1};

/// Key of [contact] for rolling models with damping.
constexpr Field<contact::ContactModel> rolling_damping{"rolling_damping",
                                                       "",
                                                       &contact::ContactModel::rolling_damping,
                                                       restitution_range,
                                                       "damping of rolling over critical damping",
                                                       0.2,
                                                       "uncalibrated, 0.1-0.3"};
/// Keys of the fields and switches of all contact laws, each once, in the order of the register.
const std::vector<std::string_view>& law_keys();

/// Whether rolling_damping, or a number of touch_fields(), has a meaning for the chosen contact law
/// and rolling model.
bool has_meaning(std::string_view key, const contact::ContactModel& model);
/// The unit of a number of touch_fields(); the unit of rolling_friction depends on the rolling
/// model.
std::string_view unit_of(std::string_view key, std::string_view unit,
                         const contact::ContactModel& model);

const std::vector<std::string>& until_quantities();  ///< quantities for a StopCriterion

constexpr Range step_shares{.least = 0, .most = 1, .without_least = true};
/// The soft engine's time step: by the error it leaves, and at most a share of the Rayleigh time;
/// [run] may give a time instead.
constexpr Range step_errors{.least = 1e-4, .most = 0.1};
constexpr Field<Run> step_error{"step_error",
                                "",
                                &Run::step_error,
                                step_errors,
                                "largest error of a collision by the time step, a mean over the "
                                "time of touch within a step",
                                0.01,
                                "about 20 steps in the shortest collision"};
constexpr Field<Run> step_share{"time_step_fraction",
                                "",
                                &Run::time_step_fraction,
                                step_shares,
                                "time step over the shortest Rayleigh time of the balls, at most",
                                0.25,
                                "usual in DEM: 0.1 to 0.3"};

/// Limits beyond which the interval between frames is taken for a mistake.
constexpr double max_frames = 1e6;       ///< of one replicate
constexpr double largest_frames = 10e9;  ///< [bytes] of one replicate, about

const std::vector<std::string>& engines();        ///< in the order of EngineName
const std::vector<std::string>& contact_laws();   ///< in the order of contact::AnyLaw
const std::vector<std::string>& rolling_words();  ///< in the order of contact::Rolling
/// "constant", "viscoelastic", "tabulated", in the order of contact::Restitution::Law.
const std::vector<std::string>& restitution_laws();

std::string in_quotes(std::string_view text);  ///< as a TOML string

/// The enum value of a word; the first for an unknown word.
template <class Enum>
Enum to_enum(const std::string& word, const std::vector<std::string>& words) {
  const auto at = std::ranges::find(words, word);
  return static_cast<Enum>(at == words.end() ? 0 : at - words.begin());
}
template <class Enum>
const std::string& to_word(Enum value, const std::vector<std::string>& words) {
  return words[static_cast<std::size_t>(value)];
}

}  // namespace mahlwerk::cases
