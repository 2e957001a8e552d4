// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk {

/// `text` made safe for terminals and XML: control characters other than tab and newline are
/// escaped as in TOML ("\u001b"), bytes that are not valid UTF-8 as "\xff".
std::string printable(std::string_view text);

/// Whether `text` contains a control character, including tab and newline.
bool has_control(std::string_view text);

}  // namespace mahlwerk
