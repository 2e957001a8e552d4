// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

// The terminal and the standard streams (POSIX).
namespace mahlwerk::app {

/// Whether stderr is a terminal.
bool stderr_is_terminal();

/// Columns of the terminal at stderr; 80 if unknown.
std::size_t terminal_width();

/// Opens closed standard streams, so that no file gets their descriptors. Each read or write of
/// them fails.
void open_closed_streams();

}  // namespace mahlwerk::app
