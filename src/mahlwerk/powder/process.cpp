// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/process.hpp"

#include <algorithm>

#include "mahlwerk/powder/models.hpp"

namespace mahlwerk::powder {

Grain Process::grain(double size) const {
  Grain g{size, density, 0};
  const auto* bed_model = std::get_if<Barrios>(&*capture);
  if (bed_model == nullptr) return g;
  g.fracture_energy = bed_model->fracture_energy;
  if (g.fracture_energy > 0) return g;
  std::visit(
      [&](const auto& model) {
        if constexpr (requires { model.median(size); }) g.fracture_energy = model.median(size);
      },
      *breakage);
  return g;
}

Capture Process::capture_per_hit(const Nip& nip, double energy, double size) const {
  const Grain g = grain(size);
  Capture c =
      std::visit([&](const auto& model) { return model.capture(nip, energy, g); }, *capture);
  c.grains = std::min(c.grains, std::max(1.0, mass / g.mass()));
  return c;
}

}  // namespace mahlwerk::powder
