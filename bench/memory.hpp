// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How much memory other programs take.
namespace mahlwerk::bench {

/// [MB] the most that a process and those it started, and they in turn, have held in memory so far,
/// each by itself and summed; 0 if it is gone. Not from its resource usage: that counts what this
/// process held when it started the other.
double peak_memory(int process);

}  // namespace mahlwerk::bench
