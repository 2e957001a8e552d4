// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Colour scales that most colour-blind readers can distinguish.
namespace mahlwerk::report {

/// The viridis colour at `share`, from 0 (dark blue) to 1 (yellow): "#440154".
std::string viridis(double share);

/// Text colour with contrast on viridis at `share`.
std::string_view ink_on_viridis(double share);

/// Categorical colours of Okabe and Ito; they repeat after seven.
std::string_view kind_colour(std::size_t kind);
std::string_view ink_on_kind(std::size_t kind);

}  // namespace mahlwerk::report
