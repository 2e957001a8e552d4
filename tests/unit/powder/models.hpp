// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/powder/process.hpp"

// One of every model of the registers, with numbers that make it do something.
namespace mahlwerk::tests {

inline std::vector<powder::AnyBreakage> every_breakage() {
  return {powder::VogelPeukert{2, 0.05}, powder::ShiKojovic{0.5, 2, 0.05},
          powder::Tavares{43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03},
          powder::Threshold{200, 1e-3, 0.5}};
}
inline std::vector<powder::AnyFragments> every_fragments() {
  return {powder::VogelFragments{1.2, 20e-6}, powder::AustinFragments{0.4, 0.8, 3},
          powder::T10Fragments{0.3, 1}, powder::BinaryFragments{}, powder::Halves{}};
}
inline std::vector<powder::AnyCapture> every_capture() {
  return {powder::Barrios{300}, powder::TrappedVolume{1e-4, 0.6}, powder::SurfaceLayer{0.3},
          powder::FixedMass{2e-6}};
}

}  // namespace mahlwerk::tests
