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

/// Of a ball or a jar, for the soft engine.
constexpr Range poisson_ratios{.least = -1, .most = 0.5, .without_least = true};
constexpr auto elastic_fields() {
  using E = contact::Elastic;
  return std::array{Field<E>{"youngs_modulus", "Pa", &E::youngs_modulus, positive,
                             "Young's modulus of the material", steel.youngs_modulus,
                             "steel, handbook; uncalibrated"},
                    Field<E>{"poisson_ratio", "", &E::poisson_ratio, poisson_ratios,
                             "Poisson's ratio of the material", steel.poisson_ratio,
                             "steel, handbook; uncalibrated"}};
}

/// Of a ball or a jar, for wear and heat.
constexpr auto substance_fields() {
  using S = Substance;
  constexpr std::string_view source = "hardened steel (1.4034), handbook; uncalibrated";
  return std::array{Field<S>{"hardness", "", &S::hardness, positive, "Vickers hardness number",
                             hardened_steel.hardness, source},
                    Field<S>{"conductivity", "W/m/K", &S::conductivity, positive,
                             "thermal conductivity", hardened_steel.conductivity, source},
                    Field<S>{"heat_capacity", "J/kg/K", &S::heat_capacity, positive,
                             "specific heat capacity", hardened_steel.heat_capacity, source}};
}

/// Of a jar's wall.
constexpr Field<Jar> wall_density{"density",
                                  "kg/m3",
                                  &Jar::density,
                                  positive,
                                  "density of the jar's wall",
                                  hardened_steel_density,
                                  "hardened steel (1.4034), handbook; uncalibrated"};
constexpr Field<Jar> wall_thickness{"wall",
                                    "m",
                                    &Jar::wall,
                                    positive,
                                    "thickness of the jar's wall",
                                    usual_wall,
                                    "a small steel jar's; uncalibrated, 3-15 mm"};

constexpr auto ball_fields() {
  return std::array{
      Field<BallSet>{"diameter", "m", &BallSet::diameter, positive, "diameter of a ball"},
      Field<BallSet>{"density", "kg/m3", &BallSet::density, positive, "density of a ball"}};
}

/// Real balls touch for less than a millisecond; longer times make true collisions elastic.
constexpr Range contact_times{.least = 0, .most = 1e-3, .without_least = true};

constexpr Range softenings{.least = 0, .most = 1, .without_least = true};

constexpr auto contact_fields() {
  return std::array{
      Field<Contact>{
          "lasting_friction", "", &Contact::lasting_friction, not_negative,
          "Coulomb's friction coefficient of lasting contacts", 0.3,
          "uncalibrated, 0.1-0.6; lasting contacts need a limit where bounces have none"},
      Field<Contact>{"lasting_speed", "m/s", &Contact::lasting_speed, not_negative,
                     "a rebound slower than this, pressed to the wall, has come to stay", 1e-4,
                     "far below the speeds that count"},
      Field<Contact>{"contact_time", "s", &Contact::contact_time, contact_times,
                     "bounces that follow sooner are elastic under lasting = \"tc\"", 1e-4,
                     "a few times a steel ball's contact time, at 1 g or less"},
      Field<Contact>{"softening", "", &Contact::softening, softenings,
                     "multiplies every Young's modulus: below 1 steps are longer, overlaps deeper",
                     1.0, "moduli as they are"}};
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

/// Three years; what a mill does, it does in minutes.
constexpr Range run_times{.least = 0, .most = 1e8, .without_least = true};
constexpr Range settle_times{.least = 0, .most = 1e8};
/// No mill throws its balls faster than sound travels in air three times over.
constexpr Range start_speeds{.least = 0, .most = 1000};
constexpr Range start_spins{.least = 0, .most = 1e6};

constexpr auto run_fields() {
  return std::array{
      Field<Run>{"time", "s", &Run::time, run_times, "simulated time that counts"},
      Field<Run>{"settle", "s", &Run::settle, settle_times,
                 "time before that, left out of the statistics", 0.0, "statistics from the start"},
      Field<Run>{"start_speed", "m/s", &Run::start_speed, start_speeds,
                 "starting speeds are uniform between 0 and this", 0.1, "paper A"},
      Field<Run>{"start_spin", "rad/s", &Run::start_spin, start_spins,
                 "starting spins are uniform between 0 and this", 0.1, "paper A"}};
}

/// Of [run] time = "until 2 %".
constexpr Range until_range{.least = 0, .most = 1, .without_least = true};
constexpr Field<Run> longest{"longest",
                             "s",
                             &Run::time,
                             run_times,
                             "the counted time at which a run ends that is not sure by then",
                             100.0,
                             "a limit that few runs need"};
const std::vector<std::string>& until_words();  ///< quantities that a run can wait for

constexpr Range step_shares{.least = 0, .most = 1, .without_least = true};
/// Of the soft engine's step, which [run] gives as a time or as a share of the Rayleigh time.
constexpr Field<Run> step_share{"time_step_fraction",
                                "",
                                &Run::time_step_fraction,
                                step_shares,
                                "time step over the Rayleigh time of the quickest ball",
                                0.125,
                                "as paper B: 1 us for its balls"};

constexpr auto observe_fields() {
  return std::array{Field<Observe>{"threshold", "m/s", &Observe::threshold, not_negative,
                                   "slower touches are left out of the rates above the threshold",
                                   0.1, "project convention; rates are given with and without it"}};
}

constexpr Field<Wear> wear_coefficient{"coefficient",
                                       "",
                                       &Wear::coefficient,
                                       positive,
                                       "volume worn over force times way over hardness",
                                       Wear().coefficient,
                                       "uncalibrated, 1e-6 to 1e-2"};

/// The numbers of [heat] besides its times.
constexpr auto heat_fields() {
  return std::array{
      Field<Heat>{"ambient", "K", &Heat::ambient, positive,
                  "temperature of the air, and of everything at the start", Heat().ambient,
                  "a room"},
      Field<Heat>{"cooling", "W/m2/K", &Heat::cooling, positive,
                  "heat from the jar's wall to the air, by area and kelvin", Heat().cooling,
                  "natural to mild forced convection of air, textbooks: 5-50; uncalibrated"},
      Field<Heat>{"ball_exchange", "W/m2/K", &Heat::ball_exchange, positive,
                  "heat from the balls to the jar, by area of the balls and kelvin",
                  Heat().ball_exchange,
                  "gas between balls in motion and the wall, 10-200 (hea.6); uncalibrated"},
      Field<Heat>{"share_in_balls", "", &Heat::share_in_balls, restitution_range,
                  "share of the lost power that heats the balls, the rest the jar",
                  Heat().share_in_balls, "contacts of bodies alike; uncalibrated"}};
}
/// Times of [heat]; without any of them and without cycles the mill mills for an hour.
constexpr Field<Heat> cycle_milling{"milling",
                                    "s",
                                    &Heat::milling,
                                    positive,
                                    "how long the mill mills in each cycle",
                                    Heat().milling,
                                    "an hour without a pause"};
constexpr Field<Heat> pause_time{
    "pause", "s", &Heat::pause, not_negative, "rest after each milling", Heat().pause, "none"};
constexpr std::int64_t most_cycles = 10'000;

/// More frames than these are taken for a mistake.
constexpr double most_frames = 1e6;      ///< of one replicate
constexpr double largest_frames = 10e9;  ///< [bytes] of one replicate, about

const std::vector<std::string>& engines();        ///< in the order of EngineName
const std::vector<std::string>& wear_models();    ///< in the order of Wear::Model
const std::vector<std::string>& powder_words();   ///< "mass", "grains"
const std::vector<std::string>& contact_laws();   ///< in the order of contact::AnyLaw
const std::vector<std::string>& rolling_words();  ///< in the order of contact::Rolling
/// "laboratory", "jar", in the order of StartFrame.
const std::vector<std::string>& start_frames();
/// "both", "xyz", "vtk", in the order of FramesFormat.
const std::vector<std::string>& frames_formats();
/// "roll", "tc", "none", in the order of Lasting.
const std::vector<std::string>& lasting_words();

/// "constant", "viscoelastic", "tabulated", in the order of contact::Restitution::Law.
const std::vector<std::string>& restitution_laws();

std::string table_text(const contact::Restitution& tabulated);  ///< as a case writes it
std::string between_text(const PairRule& pair);                 ///< as a case writes it
std::string places_text(const std::vector<Vec3>& positions);    ///< as a case writes it
std::string in_quotes(std::string_view text);                   ///< as a TOML string

/// The vertical and the horizontal axis a jar can be mounted along.
std::string axis_word(const Vec3& axis);  ///< empty for any other

/// The first for a word that is none of them.
template <class Enum>
Enum word_of(const std::string& word, const std::vector<std::string>& words) {
  const auto at = std::ranges::find(words, word);
  return static_cast<Enum>(at == words.end() ? 0 : at - words.begin());
}
template <class Enum>
const std::string& word_for(Enum value, const std::vector<std::string>& words) {
  return words[static_cast<std::size_t>(value)];
}

}  // namespace mahlwerk::cases
