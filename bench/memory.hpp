// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Memory of other programs.
namespace mahlwerk::bench {

/// [MB] sum of the peak memories so far of a process and all its descendants; 0 if it is gone. The
/// resource usage of the process is not used: it counts the memory of this process when it started
/// the other.
double peak_memory(int process);

}  // namespace mahlwerk::bench
