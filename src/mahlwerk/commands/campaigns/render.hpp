// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mahlwerk/base/error.hpp"

// PDF and PNG files of figures, by the program rsvg-convert of librsvg.
namespace mahlwerk::commands {

/// Writes the PDF and PNG files of SVG files beside them; PNG files have 300 px per inch at the
/// figure's natural size. Returns why files are missing, with the remedy; nothing if none is.
std::optional<Fault> render_figures(const std::vector<std::filesystem::path>& svg_files);

}  // namespace mahlwerk::commands
