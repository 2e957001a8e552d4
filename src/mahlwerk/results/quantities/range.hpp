// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string_view>

namespace mahlwerk::results {

/// The values that a quantity can have, in SI units (angles in degrees).
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Range of a quantity of summary.json by its name: rates, energies, sizes and powers are at least
/// 0, shares of a whole are in [0, 1]. A mill in its steady state draws what the charge dissipates;
/// a drawn power below 0 is that of a charge that still slows down. Unbounded for signed quantities
/// (imbalance, angles of the charge, temperatures in degC, the property of [kinetics]) and
/// for unknown names.
Range range_of(std::string_view quantity);

}  // namespace mahlwerk::results
