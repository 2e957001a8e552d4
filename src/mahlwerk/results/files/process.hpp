// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Processes of this machine by their ids (POSIX).
namespace mahlwerk::results {

int own_process_id();

/// Whether there is a process with this id, of whatever user.
bool process_exists(int id);

}  // namespace mahlwerk::results
