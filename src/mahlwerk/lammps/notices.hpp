// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::lammps {

/// Where LAMMPS's model of the case differs from the soft engine's.
Notices model_notices(const cases::Case& mill_case);
/// The same, and how the numbers of a run with LAMMPS were got.
Notices notices(const cases::Case& mill_case);

/// Of a run whose LAMMPS went on from a restart file so many times.
Notices restart_notices(int restarts);

}  // namespace mahlwerk::lammps
