// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"

// The numbers of a case that belong to no model: reader, writer and checks share these tables.
namespace mahlwerk::cases {

constexpr std::int64_t most_jars = 100;
constexpr Range restitution_range{.least = 0, .most = 1};
/// Of materials.
constexpr Range poisson_ratios{.least = -1, .most = 0.5, .without_least = true};
constexpr Range tangential_range{.least = -1, .most = 1};
constexpr std::int64_t most_replicates = 10000;
constexpr std::int64_t most_balls = 100'000'000;
constexpr double most_grains = 2e6;    ///< of the powder
constexpr std::size_t most_sets = 32;  ///< of balls, powder included
constexpr double densest = 0.74;       ///< share of space that equal balls fill at best

constexpr auto case_fields() {
  return std::array{Field<Case>{"gravity", "m/s2", &Case::gravity, not_negative,
                                "acceleration of free fall, downwards", 9.81, "on the ground"}};
}

/// What two that touch have besides the rule of their bounce: of [contact], and of a pair.
template <class Owner>
constexpr auto touch_fields() {
  return std::array{
      Field<Owner>{"rolling_friction", "", &Owner::rolling_friction, not_negative,
                   "rolling resistance over normal force", 0.01, "uncalibrated, 0-0.1"},
      Field<Owner>{"surface_energy", "J/m2", &Owner::surface_energy, not_negative,
                   "energy of one surface, half the work to part two"},
      Field<Owner>{"cohesion", "J/m3", &Owner::cohesion, not_negative,
                   "energy density of cohesion, pull over area of contact"}};
}

/// Of the contact model, under a rolling resistance that is damped.
constexpr Field<contact::ContactModel> rolling_damping{
    "rolling_damping",
    "",
    &contact::ContactModel::rolling_damping,
    restitution_range,
    "damping of rolling, share of the critical one",
    0.2,
    "uncalibrated, 0.1-0.3"};
/// Keys of the laws' own fields and switches, each once, in the order of the register.
const std::vector<std::string_view>& law_keys();

/// Whether rolling_damping, or a number of touch_fields(), says anything under the chosen law and
/// rolling.
bool has_meaning(std::string_view key, const contact::ContactModel& model);
/// The unit of a number of touch_fields(): that of rolling_friction depends on the rule.
std::string_view unit_of(std::string_view key, std::string_view unit,
                         const contact::ContactModel& model);

const std::vector<std::string>& until_quantities();  ///< quantities that a run can wait for

constexpr Range step_shares{.least = 0, .most = 1, .without_least = true};
/// Of the soft engine's step, which [run] gives as a time or as a share of the Rayleigh time.
constexpr Field<Run> step_share{"time_step_fraction",
                                "",
                                &Run::time_step_fraction,
                                step_shares,
                                "time step over the Rayleigh time of the quickest ball",
                                0.125,
                                "as paper B: 1 us for its balls"};

/// More frames than these are taken for a mistake.
constexpr double most_frames = 1e6;      ///< of one replicate
constexpr double largest_frames = 10e9;  ///< [bytes] of one replicate, about

const std::vector<std::string>& engines();        ///< in the order of EngineName
const std::vector<std::string>& contact_laws();   ///< in the order of contact::AnyLaw
const std::vector<std::string>& rolling_words();  ///< in the order of contact::Rolling
/// "constant", "viscoelastic", "tabulated", in the order of contact::Restitution::Law.
const std::vector<std::string>& restitution_laws();

std::string in_quotes(std::string_view text);  ///< as a TOML string

/// The first for a word that is none of them.
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
