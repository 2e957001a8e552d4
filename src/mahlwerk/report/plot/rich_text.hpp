// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// Symbols in the labels of plots: "$E_{n}$" is an italic E with the upright subscript n, "f^{2}" a
// superscript. A mark without its counterpart is drawn as it stands.
namespace mahlwerk::report {

/// The text without marks.
std::string plain_text(std::string_view text);

}  // namespace mahlwerk::report
