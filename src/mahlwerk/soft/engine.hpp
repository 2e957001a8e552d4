// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <memory>
#include <span>
#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/settings.hpp"

namespace mahlwerk::soft {

/// A soft-sphere DEM engine, which resolves every contact in small time steps, from `start` [s] on
/// the mill's clock. `pairs` has an entry for every Ball::kind and every face of the jar. Throws
/// InputError where balls overlap each other or the jar by more than Settings::max_initial_overlap.
std::unique_ptr<scene::Engine> make_engine(const scene::Chamber& chamber,
                                           const std::vector<scene::Ball>& balls,
                                           const Settings& settings,
                                           const contact::PairTable& pairs, double start = 0);

/// Advances the engines of replicates of one case to `time` [s], each with its observer and with
/// the same bits as alone. Charges that FewBodySolver computes step side by side, if all engines
/// are at the same time. Returns for each engine the exception that stopped it
/// (scene::Engine::advance), or null.
std::vector<std::exception_ptr> advance_together(std::span<scene::Engine* const> engines,
                                                 double time,
                                                 std::span<scene::Observer* const> observers);

/// Largest number of balls for which advance_together() is faster than one engine after the other:
/// larger charges fill the registers themselves (docs/performance.md).
constexpr std::size_t side_by_side_limit = 8;

/// Limits of the time step for collisions at up to `speed` [m/s], the smallest over all pairs
/// (dem.28 to dem.31, dem.33). In s unless stated otherwise.
struct TimeSteps {
  /// Rayleigh time: shortest time of a surface wave from pole to pole of a ball (dem.28)
  double rayleigh = 0;
  double contact = 0;  ///< duration of the shortest collision (dem.29)
  double dashpot = 0;  ///< shortest time in which a contact's dashpot alone stops a ball (dem.33)
  double limit = 0;    ///< longer steps are unstable (dem.31)
  /// [1] Largest overlap over radius; of bodies over that of their spheres, or over their rounding.
  double overlap = 0;
  /// The recommended step [s]: `fraction` of rayleigh, at most contact / `steps_per_collision` and
  /// dashpot / 5 (dem.30).
  double recommended(double fraction, double steps_per_collision) const;
};
/// With a liquid, `dashpot` is also at most the time in which it stops a ball (liq.9). Balls whose
/// kind has one of `shapes` count by the lightest of their contacts (bod.13).
TimeSteps time_steps(const std::vector<scene::Ball>& balls, const contact::AnyLaw& law,
                     const contact::PairTable& pairs, double speed,
                     const std::optional<contact::Liquid>& liquid = std::nullopt,
                     const std::vector<scene::BodyShape>& shapes = {});

}  // namespace mahlwerk::soft
