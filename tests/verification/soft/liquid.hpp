// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "crowd.hpp"
#include "statement.hpp"

// Liquids and engines of the tests of a liquid in the soft engine.
namespace mahlwerk::tests::liquid {

using contact::HertzMindlin;
using contact::Liquid;

constexpr double dry_restitution = 0.8;
inline contact::Pair dry_pair() {
  return pair_of({1e9, 0.3}, {1e9, 0.3}, dry_restitution);
}

inline Liquid oil_film() {
  Liquid liquid;
  liquid.viscosity = 0.1;
  liquid.film = 50e-6;
  liquid.roughness = 2e-6;
  return liquid;
}
inline Liquid full_of(double viscosity, double density) {
  Liquid liquid;
  liquid.viscosity = viscosity;
  liquid.density = density;
  liquid.flooded = true;
  return liquid;
}

inline std::unique_ptr<scene::Engine> engine_of(const scene::Chamber& chamber,
                                                const std::vector<scene::Ball>& balls,
                                                const contact::Pair& pair, double step,
                                                const std::optional<Liquid>& liquid,
                                                std::size_t few = 32, int threads = 1,
                                                bool hop = false) {
  soft::Settings settings{of_law(HertzMindlin{}, contact::Rolling::cdt), step, hop, few};
  settings.threads = threads;
  settings.liquid = liquid;
  return soft::make_engine(chamber, balls, settings,
                           contact::PairTable(1, geometry::faces(*chamber.shape), pair), 0.37);
}

}  // namespace mahlwerk::tests::liquid
