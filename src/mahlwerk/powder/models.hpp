// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "mahlwerk/powder/breakage/shi_kojovic.hpp"
#include "mahlwerk/powder/breakage/tavares.hpp"
#include "mahlwerk/powder/breakage/threshold.hpp"
#include "mahlwerk/powder/breakage/vogel_peukert.hpp"
#include "mahlwerk/powder/capture/barrios.hpp"
#include "mahlwerk/powder/capture/fixed_mass.hpp"
#include "mahlwerk/powder/capture/surface_layer.hpp"
#include "mahlwerk/powder/capture/trapped_volume.hpp"
#include "mahlwerk/powder/fragments/austin.hpp"
#include "mahlwerk/powder/fragments/binary.hpp"
#include "mahlwerk/powder/fragments/t10.hpp"
#include "mahlwerk/powder/fragments/vogel.hpp"

namespace mahlwerk::powder {

/// The registers. A new model is its file and its name here.

/// `caught(nip, energy [J], grain)` is what a collision catches.
using AnyCapture = std::variant<Barrios, TrappedVolume, SurfaceLayer, FixedMass>;

/// `chance(size [m], energy [J/kg])` that a hit breaks a fresh grain. Those that `tells_fineness`
/// have `t10(size, energy)`; those that `remembers` keep a strength for each grain.
using AnyBreakage = std::variant<VogelPeukert, ShiKojovic, Tavares, Threshold>;

/// `finer(x/y, y [m], t10)` of the mass of a broken grain of size y; `drawn(y, t10, uniform)` is
/// the size of a piece that a random bit of that mass finds itself in.
using AnyFragments =
    std::variant<VogelFragments, AustinFragments, T10Fragments, BinaryFragments, Halves>;

}  // namespace mahlwerk::powder
