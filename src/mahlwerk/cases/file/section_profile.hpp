// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/geometry/prism.hpp"

namespace mahlwerk::cases {

/// The corners of a closed section from a table (CSV) whose first line is "x,y"; coordinates are
/// multiplied by `scale`. The first corner may be repeated at the end. Throws MeshFileError.
geometry::Section read_section_profile(std::string_view text, double scale);

}  // namespace mahlwerk::cases
