// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/run_setup.hpp"

#include "mahlwerk/campaign/run/lammps_runs.hpp"
#include "mahlwerk/cases/build.hpp"

namespace mahlwerk::campaign {

RunSetup::RunSetup(const cases::Case& made) : mill_case(&made), chamber(cases::chamber(made)) {
  if (cases::in_time_steps(made.run.engine)) soft = soft_settings(made);
  if (made.run.engine == cases::EngineName::lammps) steps = lammps_steps(made, *soft);
}

}  // namespace mahlwerk::campaign
