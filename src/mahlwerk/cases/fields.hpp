// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"

// The numbers of a case that belong to no model: reader, writer and checks share these tables.
namespace mahlwerk::cases {

constexpr Range restitution_range{.least = 0, .most = 1};
constexpr Range tangential_range{.least = -1, .most = 1};
constexpr std::int64_t most_replicates = 10000;
constexpr std::int64_t most_balls = 100'000'000;
constexpr double densest = 0.74;  ///< share of space that equal balls fill at best

constexpr auto case_fields() {
  return std::array{Field<Case>{"gravity", "m/s2", &Case::gravity, not_negative,
                                "acceleration of free fall, downwards", 9.81, "on the ground"}};
}

constexpr auto ball_fields() {
  return std::array{
      Field<BallSet>{"diameter", "m", &BallSet::diameter, positive, "diameter of a ball"},
      Field<BallSet>{"density", "kg/m3", &BallSet::density, positive, "density of a ball"}};
}

/// Real balls touch for less than a millisecond; longer times make true collisions elastic.
constexpr Range contact_times{.least = 0, .most = 1e-3, .without_least = true};

constexpr auto contact_fields() {
  return std::array{
      Field<Contact>{
          "lasting_friction", "", &Contact::lasting_friction, not_negative,
          "Coulomb's friction coefficient of lasting contacts", 0.3,
          "uncalibrated, 0.1-0.6; lasting contacts need a limit where bounces have none"},
      Field<Contact>{"rolling_friction", "", &Contact::rolling_friction, not_negative,
                     "rolling resistance over normal force", 0.01, "uncalibrated, 0-0.1"},
      Field<Contact>{"lasting_speed", "m/s", &Contact::lasting_speed, not_negative,
                     "a rebound slower than this, pressed to the wall, has come to stay", 1e-4,
                     "far below the speeds that count"},
      Field<Contact>{"contact_time", "s", &Contact::contact_time, contact_times,
                     "bounces that follow sooner are elastic under lasting = \"tc\"", 1e-4,
                     "a few times a steel ball's contact time"}};
}

constexpr auto run_fields() {
  return std::array{
      Field<Run>{"time", "s", &Run::time, positive, "simulated time that counts"},
      Field<Run>{"settle", "s", &Run::settle, not_negative,
                 "time before that, left out of the statistics", 0.0, "statistics from the start"},
      Field<Run>{"start_speed", "m/s", &Run::start_speed, not_negative,
                 "starting speeds are uniform between 0 and this", 0.1, "paper A"},
      Field<Run>{"start_spin", "rad/s", &Run::start_spin, not_negative,
                 "starting spins are uniform between 0 and this", 0.1, "paper A"}};
}

constexpr auto observe_fields() {
  return std::array{Field<Observe>{"threshold", "m/s", &Observe::threshold, not_negative,
                                   "slower touches are left out of the rates above the threshold",
                                   0.1, "project convention; rates are given with and without it"}};
}

const std::vector<std::string>& contact_laws();
const std::vector<std::string>& engines();
/// "roll", "tc", "none", in the order of Lasting.
const std::vector<std::string>& lasting_words();

/// "constant", "viscoelastic", "tabulated", in the order of contact::Restitution::Law.
const std::vector<std::string>& restitution_laws();

std::string table_text(const contact::Restitution& tabulated);  ///< as a case writes it
std::string between_text(const PairRule& pair);                 ///< as a case writes it
std::string in_quotes(std::string_view text);                   ///< as a TOML string

/// The vertical and the horizontal axis a jar can be mounted along.
std::string axis_word(const Vec3& axis);  ///< empty for any other

}  // namespace mahlwerk::cases
