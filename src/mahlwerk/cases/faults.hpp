// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::cases {

/// Faults of a complete case, read or constructed: values out of range, a ball that does not fit
/// its jar. Empty for a valid case. read() calls it; bindings and tests call it directly.
std::vector<Fault> faults(const Case& c);

/// File and line, or option, that gave the value of `key`; the key itself for a default. The key of
/// a search range is "optimise.over." followed by the key searched over.
std::string location_of(const Case& c, const std::string& key);

/// Faults of a valid case that the engines of this version cannot run. read() does not call it, so
/// that such a case can still be checked.
std::vector<Fault> engine_faults(const Case& c);

/// Whether the diameters of two balls sum to the width of the jar, to 1e-6 of it: hard spheres that
/// lie across the jar then have no room to bounce.
bool fits_exactly(const Case& c);
/// Whether the case has a liquid that only the soft engine takes: around the balls, or one that
/// resists the rebound.
bool liquid_needs_soft(const Case& c);

}  // namespace mahlwerk::cases
