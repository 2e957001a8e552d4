// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The call that shall fail (inject.cpp): the environment chooses it, all calls are counted.
namespace faults {

enum Kind {
  file_open,
  file_write,
  file_sync,
  file_rename,
  folder_make,
  map,
  memory,
  thread,
  kinds
};

void read_environment();  ///< the fault that the environment asks for
void begin_to_count();
void end_counting();
void log_calls();  ///< writes the number of all calls to the log

/// Whether `caller` is code whose allocations count.
bool is_counted(const void* caller);
/// Whether the next call of the kind is the one that shall fail.
bool is_next(Kind kind);
/// Counts a call; true if it shall fail, with errno set. `what` is for the log.
bool fails(Kind kind, const char* what = "");

}  // namespace faults
