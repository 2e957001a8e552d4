// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// Parts that `mahlwerk new` writes where neither the user nor the catalogue gives any, besides the
// values of KeyInfo::start. They belong to no machine and are marked as assumed in the case.
namespace mahlwerk::commands {

/// The jar for a mill without a jar in the catalogue, and balls for a jar.
std::string_view start_jar(std::string_view mill_kind);
struct StartBalls {
  std::string_view diameter, key, value;  ///< key: "count" or "filling"
};
StartBalls start_balls(std::string_view jar_kind);

/// Files for the kinds that need one: a measured motion (CSV), and a jar's surface (STL, OBJ, PLY).
std::string sample_motion();
std::string sample_surface();

}  // namespace mahlwerk::commands
