// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::lammps {

/// How the numbers of a run with LAMMPS were got, and where its model differs from the soft
/// engine's.
Notices notices(const cases::Case& mill_case);

}  // namespace mahlwerk::lammps
