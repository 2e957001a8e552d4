// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::campaign {

/// All that the replicates of one case derive from it, once: their engines, starts and samplers
/// take it from here.
struct RunSetup {
  /// `made` must outlive the setup.
  explicit RunSetup(const cases::Case& made);

  const cases::Case* mill_case;
  scene::Chamber chamber;
  std::optional<SoftSettings> soft;    ///< of a DEM
  std::optional<lammps::Steps> steps;  ///< of LAMMPS
};

}  // namespace mahlwerk::campaign
