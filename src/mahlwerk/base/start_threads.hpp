// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <system_error>
#include <thread>
#include <vector>

namespace mahlwerk {

/// Starts `count` threads, thread k with `work(k)`, k from 1. Starts fewer if the system has no
/// more: the limit of processes of a user or a container. The work must not depend on their number.
template <class Work>
void start_threads(std::vector<std::jthread>& team, int count, const Work& work) {
  if (count > 0) team.reserve(static_cast<std::size_t>(count));
  try {
    for (int k = 1; k <= count; ++k) team.emplace_back([work, k] { work(k); });
  } catch (const std::system_error&) {  // EAGAIN
  }
}

}  // namespace mahlwerk
