// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/contact_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::lammps {
namespace {

/// LAMMPS's damping coefficient for an input e.
double alpha_of(double e) {
  return 1.2728 +
         e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/// A friction that is never reached, for pairs without sliding.
constexpr double no_sliding = 1e6;

/// Normal and tangential stiffness, and the ratio of their damping coefficients.
struct Springs {
  std::string normal;  // model and stiffness
  double alpha;        // damping coefficient of tsuji
  std::string tangential;
  double damping_ratio;
};

Springs springs(const contact::HertzMindlin&, const contact::EffectivePair& t) {
  const double e = contact::damping_ratio(t.pair.restitution);
  return {fmt::format("hertz {:.12g}", 4.0 / 3.0 * t.pair.modulus), -std::sqrt(5.0) * e,
          fmt::format("mindlin {:.12g}", 8 * t.pair.shear_modulus),
          2 * std::sqrt(t.pair.shear_modulus / t.pair.modulus)};
}

Springs springs(const contact::LinearSpring& law, const contact::EffectivePair& t) {
  const double k = law.stiffness_of(t), ratio = contact::tangential_stiffness_ratio;
  return {fmt::format("hooke {:.12g}", k), -2 * contact::damping_ratio(t.pair.restitution),
          fmt::format("linear_history {:.12g}", ratio * k), ratio};
}

/// LAMMPS has one rolling resistance, a spring, dashpot and slider of fixed stiffness: that of the
/// normal spring of a collision at 1 m/s.
std::string rolling(const contact::ContactModel& model, const contact::EffectivePair& t) {
  if (model.rolling == contact::Rolling::none || t.pair.rolling_friction == 0) return "";
  const double stiffness =
      contact::hertz_stiffness(t) * std::sqrt(contact::hertz_overlap(t, 1));  // N/m
  return fmt::format(" rolling sds {:.12g} 0 {:.12g}", stiffness, t.pair.rolling_friction);
}

}  // namespace

double tsuji_input(double alpha) {
  double low = -0.2, high = 1.001;  // alpha_of falls from 2.8 to 0 there
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (alpha_of(middle) > alpha ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::string contact_terms(const contact::ContactModel& model, const contact::EffectivePair& pair) {
  const auto* linear =
      std::get_if<contact::LinearSpring>(&static_cast<const contact::Laws&>(*model.law));
  const Springs s = linear ? springs(*linear, pair) : springs(contact::HertzMindlin{}, pair);
  const bool twists = model.twisting == contact::Twisting::marshall;
  return fmt::format("{} {:.12g} tangential {} {:.12g} {:.12g}{}{} damping tsuji", s.normal,
                     tsuji_input(s.alpha), s.tangential, s.damping_ratio,
                     std::min(pair.pair.friction, no_sliding), rolling(model, pair),
                     twists ? " twisting marshall" : "");
}

}  // namespace mahlwerk::lammps
