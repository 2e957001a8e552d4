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

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/contact/adhesion.hpp"
#include "mahlwerk/contact/law_field.hpp"
#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/contact/slip_factor.hpp"

// A contact law gives the normal force between two touching bodies, and the tangential stiffness
// and damping of the contact. It is a template on the number type V: one contact (double) or those
// of a register. The overlap is > 0 in contact, its rate is > 0 while the bodies approach (dem.1).
namespace mahlwerk::contact {

/// Two bodies that may touch: the properties of the pair, R* [m] and m* [kg] (dem.4), and their
/// slip factor [1] (hol.4).
struct EffectivePair {
  Pair pair;
  double radius = 0, mass = 0, slip_factor = solid_slip_factor;
};

/// Coefficients that a law precomputes for a pair. Each law defines their meaning.
constexpr int law_coefficient_count = 8;
using LawCoefficients = std::array<double, law_coefficient_count>;
/// Number of history variables that a law stores for each contact.
constexpr int law_history_size = 2;

/// Normal force [N], > 0 repulsive; tangential stiffness [N/m] and damping [N s/m]; the load [N] of
/// friction and rolling resistance, which use its absolute value; < 0 where the bodies pull; the
/// part [N] of the force that dissipates at once (dem.39), the rest being elastic; and the slope
/// [N/m] of the elastic force over the overlap, 0 where nothing dissipates at once.
template <class V>
struct LawForce {
  V force, stiffness, damping, load, damper{}, slope{};
};

/// Power of the overlap with which the elastic force grows at touch.
enum class TouchExponent { one, three_halves };

/// Upper bounds [%] of the error of a collision in steps of 1/25 of `shortest_time`: of rebound
/// speed, tangential speed and spin, each a mean over the time of touch within a step, and the
/// largest error of a single collision. A row for each of these restitutions, for any Poisson ratio
/// (docs/theory/soft.md). tests/verification/soft/step_test.cpp measures the errors and fails
/// where a bound is too small.
constexpr std::array step_error_restitutions{0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0};
using StepErrors = std::array<std::array<double, 4>, step_error_restitutions.size()>;

/// The `shortest_time_name` of most laws.
constexpr std::string_view whole_collision = "the shortest collision";

/// Whether L itself defines its scales. An inherited scale would belong to another law and would be
/// silently wrong.
template <class L>
concept DefinesOwnScales = std::same_as<decltype(&L::largest_overlap),
                                        double (L::*)(const EffectivePair&, double) const> &&
    std::same_as<decltype(&L::shortest_time), double (L::*)(const EffectivePair&, double) const> &&
    std::same_as<decltype(&L::damper_time),
                 double (L::*)(const EffectivePair&, double, double) const>;

/// A contact law: a value type with parameters (`fields()`) and optional `switches()`. `adhesion`
/// lists the adhesion parameters that the law reads; optional. `shortest_time_name` says in words
/// what `shortest_time` is the time of. `has_history` is true where contacts have history
/// variables. `damping(e)` returns the damping coefficient at which a collision ends with
/// restitution e; it may be slow and is called once for each pair. `begin` sets the history
/// variables of a new contact that closes at `approach` [m/s]. `pull_off_distance` [m] is the gap
/// at which a contact breaks. Within an overlap of `onset_overlap` [m] a force rises that a single
/// step may pass over; 0 for most laws. `elastic_energy` [J] is the elastic energy of the normal
/// deformation; a law whose history records plastic deformation has `plastic_energy` [J],
/// dissipated since touch. The elastic force grows from touch on with a power of the overlap,
/// `touch_exponent`. `stiffness_ratio(t)` [1] is the normal stiffness, F/overlap of the spring,
/// over the tangential stiffness. The following are at a speed [m/s]: `largest_overlap` [m],
/// `shortest_time` [s] (duration of the fastest part of a collision) and `damper_time` [s] (time in
/// which the damper alone stops the bodies, where that can be shorter still).
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
  { L::touch_exponent } -> std::convertible_to<TouchExponent>;
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

/// The switches of a law, and the adhesion parameters it reads; empty where the law defines none.
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

/// The damper time of a law that is at most critically damped: `shortest_time` alone limits the
/// step.
constexpr double unbounded_time = std::numeric_limits<double>::infinity();

/// Lower limit of the restitution, for laws whose damper or spring grows without bound as e goes to
/// 0 (dem.10, dem.13, dem.14).
constexpr double min_restitution = 0.01;

/// b = ln e / sqrt(ln^2 e + pi^2) (dem.7); 0 at e = 1, -1 at e = 0.
inline double damping_ratio(double e) {
  if (e <= 0) return -1;
  const double ln = math::log(e);
  return ln / math::hypot(ln, std::numbers::pi);
}

}  // namespace mahlwerk::contact
