// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/capture/barrios.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {
namespace {

// As printed in Mhadhbi 2021; not checked against the original.
constexpr double max_deformation = 0.362, bed_factor = 0.152, bed_exponent = 0.413;

}  // namespace

double bed_deformation(double energy_over_fracture_energy) {
  return -max_deformation *
         math::expm1(-bed_factor * math::pow(energy_over_fracture_energy, bed_exponent));
}

double capture_radius(const Nip& nip, double energy, double deformation) {
  const double depth = std::min(deformation, nip.radius);
  return contact_radius(nip, energy) + std::sqrt(depth * (2 * nip.radius - depth));
}

double grains_in_bed(double radius, double size) {
  const double across = 2 * radius / size;
  return across < 1 ? 1 : 0.25 + 0.75 * across * across;
}

Capture Barrios::capture(const Nip& nip, double energy, const Grain& grain) const {
  const double scale = energy / (grain.mass() * grain.fracture_energy);
  const double touch = contact_radius(nip, energy);
  const auto radius = [&](double deformation) {
    const double depth = std::min(deformation * grain.size, nip.radius);
    return touch + std::sqrt(depth * (2 * nip.radius - depth));
  };
  // Deformation of a bed with the mass at the given deformation. A larger deformation means a
  // larger mass and a lower specific energy, so that two iterates bracket the fixed point.
  const auto yields = [&](double deformation) {
    return bed_deformation(scale / grains_in_bed(radius(deformation), grain.size));
  };
  double high = yields(0), low = yields(high), at_high = low - high, at_low = yields(low) - low;
  if (!(at_low > 0)) return {1, grains_in_bed(radius(low), grain.size), radius(low)};
  // Regula falsi, Illinois variant.
  constexpr double close = 1e-13;
  double found = low;
  for (int side = 0, i = 0; i < 100 && high - low > close; ++i) {
    found = (low * at_high - high * at_low) / (at_high - at_low);
    const double at = yields(found) - found;
    if (std::abs(at) < close) break;
    if (at > 0) {
      low = found, at_low = at;
      if (side == 1) at_high *= 0.5;
      side = 1;
    } else {
      high = found, at_high = at;
      if (side == -1) at_low *= 0.5;
      side = -1;
    }
  }
  const double spot = radius(found);
  return {1, grains_in_bed(spot, grain.size), spot};
}

}  // namespace mahlwerk::powder
