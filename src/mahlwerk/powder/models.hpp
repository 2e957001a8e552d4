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

namespace mahlwerk::powder {

/// The registers. A new model is its file and its name here. What is chosen of each is a class of
/// its own, so that any_model.hpp can name it.

/// `capture(nip, energy [J], grain)` is what a collision catches.
using CaptureModels = std::variant<Barrios, TrappedVolume, SurfaceLayer, FixedMass>;
struct AnyCapture : CaptureModels {
  using Models = CaptureModels;
  using Models::Models;
};

/// `breakage_probability(size [m], energy [J/kg])` that a hit breaks a fresh grain. Those that
/// `predicts_t10` have `t10(size, energy)`; those that `tracks_strength` keep a strength for each
/// grain.
using BreakageModels = std::variant<VogelPeukert, ShiKojovic, Tavares, Threshold>;
struct AnyBreakage : BreakageModels {
  using Models = BreakageModels;
  using Models::Models;
};

/// Whether M is the one breakage model that remembers: what looks after its grains knows no other.
template <class M, class... Models>
constexpr bool only_one_tracks_strength(std::type_identity<std::variant<Models...>>) {
  return ((Models::tracks_strength == std::is_same_v<Models, M>)&&...);
}
template <class M>
constexpr bool only_strength_model =
    only_one_tracks_strength<M>(std::type_identity<BreakageModels>{});

/// `breakage_function(x/y, y [m], t10)` of the mass of a broken grain of size y; `draw_fragment(y,
/// t10, uniform)` is the size of a piece that a random bit of that mass finds itself in.
using FragmentsModels =
    std::variant<VogelFragments, AustinFragments, T10Fragments, BinaryFragments, Halves>;
struct AnyFragments : FragmentsModels {
  using Models = FragmentsModels;
  using Models::Models;
};

}  // namespace mahlwerk::powder
