// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/nip.hpp"

// Stress spectrum of a mill: rates of hits on the powder by energy.
namespace mahlwerk::powder {

/// Collisions of one energy in one kind of nip.
struct Stress {
  int nip = 0;
  double energy = 0;  ///< [J]
  double rate = 0;    ///< [1/s]
};

/// All collisions of a mill.
struct StressSpectrum {
  std::vector<Nip> nips;
  std::vector<Stress> stresses;
};

}  // namespace mahlwerk::powder
