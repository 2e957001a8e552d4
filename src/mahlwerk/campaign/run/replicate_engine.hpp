// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "mahlwerk/campaign/run/run_setup.hpp"
#include "mahlwerk/lammps/launch.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::campaign {

/// The balls of a replicate when its mill starts (balls_at_start()), by the engine that run.engine
/// names.
std::vector<scene::Ball> start_of(const RunSetup& setup, int index, int threads = 1,
                                  const std::atomic<bool>* stop = nullptr);

/// The engine of one replicate at its start: run.engine, where "auto" counts as "event". `threads`
/// threads share its work; the result does not depend on their number. `stop` takes effect from the
/// placement of the balls on (scene::Engine::stop_on), where it throws Interrupted. `launch` is for
/// "lammps".
std::unique_ptr<scene::Engine> engine(const RunSetup& setup, int index, int threads = 1,
                                      const std::atomic<bool>* stop = nullptr,
                                      const lammps::Launch& launch = {});
inline std::unique_ptr<scene::Engine> engine(const cases::Case& mill_case, int index,
                                             int threads = 1,
                                             const std::atomic<bool>* stop = nullptr,
                                             const lammps::Launch& launch = {}) {
  return engine(RunSetup(mill_case), index, threads, stop, launch);
}

}  // namespace mahlwerk::campaign
