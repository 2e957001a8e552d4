// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "mahlwerk/base/error.hpp"

// What was computed is printed even if its files cannot be written.
namespace mahlwerk::commands {

/// The faults of an exception of the operating system or of memory: a file that cannot be written.
/// Rethrows others.
std::vector<Fault> faults_of_system(const std::exception_ptr& thrown);

/// Writes the files of a computed result. Returns why they cannot be written; empty if they are.
std::vector<Fault> write_result(const std::function<void()>& write);

/// Prints a result by `print`, then reports why its files were not written, even if printing
/// throws. Returns the exit code; `ended` if there are no faults.
int print_result(const std::function<void()>& print, const std::vector<Fault>& unwritten,
                 int ended);

}  // namespace mahlwerk::commands
