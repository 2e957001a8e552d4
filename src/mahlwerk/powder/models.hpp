// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <variant>

#include "mahlwerk/powder/any_model.hpp"
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
#include "mahlwerk/powder/kinetics/dose.hpp"
#include "mahlwerk/powder/kinetics/ignition.hpp"
#include "mahlwerk/powder/kinetics/impact.hpp"
#include "mahlwerk/powder/kinetics/thermal.hpp"

namespace mahlwerk::powder {

/// Registers of models. To add a model, write its file and add its name here. Each chosen model is
/// a class derived from the variant, so that any_model.hpp can forward-declare it.

/// `capture(nip, energy [J], grain)` returns the capture of one collision.
using CaptureModels = std::variant<Barrios, TrappedVolume, SurfaceLayer, FixedMass>;
struct AnyCapture : CaptureModels {
  using Models = CaptureModels;
  using Models::Models;
};

/// `breakage_probability(size [m], energy [J/kg])`: probability that a hit breaks a fresh grain.
/// Models with `predicts_t10` have `t10(size, energy)`; models with `tracks_strength` keep a
/// strength for each grain.
using BreakageModels = std::variant<VogelPeukert, ShiKojovic, Tavares, Threshold>;
struct AnyBreakage : BreakageModels {
  using Models = BreakageModels;
  using Models::Models;
};

/// Whether M is the only breakage model that tracks strength, as the code of Sample and of
/// strength_levels assumes.
template <class M, class... Models>
constexpr bool only_one_tracks_strength(std::type_identity<std::variant<Models...>>) {
  return ((Models::tracks_strength == std::is_same_v<Models, M>)&&...);
}
template <class M>
constexpr bool only_strength_model =
    only_one_tracks_strength<M>(std::type_identity<BreakageModels>{});

/// `breakage_function(x/y, y [m], t10)`: mass share of a broken grain of size y in fragments finer
/// than x. `draw_fragment(y, t10, uniform)`: size [m] of a fragment drawn by mass.
using FragmentsModels =
    std::variant<VogelFragments, AustinFragments, T10Fragments, BinaryFragments, Halves>;
struct AnyFragments : FragmentsModels {
  using Models = FragmentsModels;
  using Models::Models;
};

/// `shares(mill, time [s])`: shares of reactant and products after a milling time.
using KineticsModels =
    std::variant<DoseKinetics, ImpactKinetics, ThermalKinetics, IgnitionKinetics>;
struct AnyKinetics : KineticsModels {
  using Models = KineticsModels;
  using Models::Models;
};

}  // namespace mahlwerk::powder
