// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk {

/// Text that neither moves a terminal's cursor nor breaks XML: control characters other than tab
/// and the end of a line are escaped as in TOML ("\u001b"), and bytes that are no UTF-8 as "\xff".
std::string printable(std::string_view text);

/// Whether it holds a control character, tab and the end of a line included.
bool has_control(std::string_view text);

}  // namespace mahlwerk
