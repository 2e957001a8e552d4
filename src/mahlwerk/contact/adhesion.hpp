// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/contact/pair_table.hpp"

namespace mahlwerk::contact {

/// Adhesion parameter of a pair, with its key in a case file.
struct AdhesionParameter {
  std::string_view key;
  double Pair::*value;
};
constexpr AdhesionParameter surface_energy{"surface_energy", &Pair::surface_energy};
constexpr AdhesionParameter cohesion{"cohesion", &Pair::cohesion};
constexpr AdhesionParameter surface_tension{"surface_tension", &Pair::surface_tension};

}  // namespace mahlwerk::contact
