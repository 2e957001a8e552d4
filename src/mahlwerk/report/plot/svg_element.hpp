// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk::report {

/// Beginning of an SVG picture of `width` times `height` [px]: the opening tag, by which
/// results::foreign_files recognises pictures, and a white ground. `font`: font size [px].
std::string svg_head(double width, double height, std::string_view title, double font = 12);

}  // namespace mahlwerk::report
