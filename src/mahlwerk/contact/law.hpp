// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/contact/adhesion.hpp"
#include "mahlwerk/contact/law_field.hpp"
#include "mahlwerk/contact/pair_table.hpp"

// A contact law says what force two bodies that touch exert on each other along their normal, and
// how stiff and how damped the contact is across it. Written for a number type V: one contact, or
// eight side by side. Overlap and its rate are > 0 in contact and while approaching (dem.1).
namespace mahlwerk::contact {

/// Two bodies that may touch: their pair's properties, R* [m] and m* [kg] (dem.4).
struct EffectivePair {
  Pair pair;
  double radius = 0, mass = 0;
};

/// What a law makes of them, once; what each number means is the law's own business.
constexpr int law_coefficient_count = 8;
using LawCoefficients = std::array<double, law_coefficient_count>;
/// What a law remembers of one contact.
constexpr int law_history_size = 2;

/// Force along the normal, > 0 repulsive [N]; stiffness [N/m] and damping [N s/m] across it; and
/// the load [N] under which the bodies rub and roll, < 0 where they pull: its size counts.
template <class V>
struct LawForce {
  V force, stiffness, damping, load;
};

/// What steps of a fiftieth of `shortest_time` leave a collision off by at most: [%] of rebound,
/// speed across and spin, a row for each of these restitutions, at a Poisson ratio of 0.3
/// (docs/theory/soft.md). tests/verification/soft/step_test.cpp finds them, and refuses less.
constexpr std::array step_error_restitutions{0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0};
using StepErrors = std::array<std::array<double, 3>, step_error_restitutions.size()>;

/// The `shortest_time_name` of most laws.
constexpr std::string_view whole_collision = "the shortest collision";

/// Whether L itself states its scales: one inherited is another law's, and wrong without a word.
template <class L>
concept DefinesOwnScales = std::same_as<decltype(&L::largest_overlap),
                                        double (L::*)(const EffectivePair&, double) const> &&
    std::same_as<decltype(&L::shortest_time), double (L::*)(const EffectivePair&, double) const> &&
    std::same_as<decltype(&L::damper_time),
                 double (L::*)(const EffectivePair&, double, double) const>;

/// A contact law: a value with its own numbers, `fields()`, and `switches()` if it has any.
/// `adhesion` lists the adhesion parameters it reads; a law that reads none need not say so.
/// `shortest_time_name` names what `shortest_time` is the time of. `has_history` tells whether
/// contacts have a memory. `damping(e)` is the number that makes a collision end with restitution
/// e; it may take a while and is asked once for each pair. `begin` sets the memory of a new contact
/// that closes at `approach` [m/s]. `pull_off_distance` [m] is how far a contact holds beyond
/// touch. Within an overlap of `onset_overlap` [m] a force comes up that steps may pass over; most
/// laws have none. `elastic_energy` [J] is the elastic energy of the normal deformation.
/// `stiffness_ratio(t)` [1] is the stiffness along the normal, F/overlap of the spring, over that
/// across it. `largest_overlap` [m], `shortest_time` [s] (that of the swiftest part of a collision)
/// and `damper_time` [s] (in which the damper alone would stop the bodies, where that may be
/// shorter still) are those at a speed [m/s].
template <class L>
concept Law = std::default_initializable<L> && std::equality_comparable<L> && DefinesOwnScales<L> &&
    requires(const L law, const EffectivePair& t, const LawCoefficients& k, double x, double* m,
             const double* v) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::about } -> std::convertible_to<std::string_view>;
  { L::shortest_time_name } -> std::convertible_to<std::string_view>;
  { L::step_errors } -> std::convertible_to<StepErrors>;
  { L::fields()[0] } -> std::convertible_to<LawField<L>>;
  { L::has_history } -> std::convertible_to<bool>;
  { law.damping(x) } -> std::same_as<double>;
  { law.coefficients(t, x) } -> std::same_as<LawCoefficients>;
  { law.begin(k, m, x) } -> std::same_as<void>;
  { L::evaluate(v, m, x, x) } -> std::same_as<LawForce<double>>;
  { law.pull_off_distance(t) } -> std::same_as<double>;
  { L::onset_overlap(v) } -> std::same_as<double>;
  { law.stiffness_ratio(t) } -> std::same_as<double>;
  { law.elastic_energy(k, v, x) } -> std::same_as<double>;
  { law.largest_overlap(t, x) } -> std::same_as<double>;
  { law.shortest_time(t, x) } -> std::same_as<double>;
  { law.damper_time(t, x, x) } -> std::same_as<double>;  // damping, speed
};

/// The switches of a law, and the adhesion parameters it reads; none where it does not say.
template <class L>
constexpr auto switches_of() {
  if constexpr (requires { L::switches(); })
    return L::switches();
  else
    return std::array<LawSwitch<L>, 0>{};
}
template <class L>
constexpr std::span<const AdhesionParameter> adhesion_of() {
  if constexpr (requires { L::adhesion; })
    return L::adhesion;
  else
    return {};
}

/// The damper time of a law damped critically at most: a collision takes no longer.
constexpr double unbounded_time = std::numeric_limits<double>::infinity();

/// Restitutions below this are taken as this by laws whose damper or spring would grow without
/// bound (dem.10, dem.13, dem.14).
constexpr double least_restitution = 0.01;

/// ln e / sqrt(ln^2 e + pi^2), from 0 at e = 1 to -1 at e = 0 (dem.7).
inline double damping_ratio(double e) {
  if (e <= 0) return -1;
  const double ln = std::log(e);
  return ln / std::hypot(ln, std::numbers::pi);
}

}  // namespace mahlwerk::contact
