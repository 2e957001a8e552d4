// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Colours that most colour-blind readers tell apart.
namespace mahlwerk::report {

/// Viridis at `share` of its scale, 0 (dark blue) to 1 (yellow): "#440154".
std::string viridis(double share);

/// What is read on viridis at `share`.
std::string_view ink_on_viridis(double share);

/// The colours of Okabe and Ito for things of different kinds, again from the first after seven.
std::string_view kind_colour(std::size_t kind);
std::string_view ink_on_kind(std::size_t kind);

}  // namespace mahlwerk::report
