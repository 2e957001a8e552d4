// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/contact/pair_table.hpp"

namespace mahlwerk::contact {

/// A number of a pair by which bodies adhere, with its key in a case.
struct AdhesionParameter {
  std::string_view key;
  double Pair::*value;
};
constexpr AdhesionParameter surface_energy{"surface_energy", &Pair::surface_energy};
constexpr AdhesionParameter cohesion{"cohesion", &Pair::cohesion};

}  // namespace mahlwerk::contact
