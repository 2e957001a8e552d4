// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/lubrication.hpp"
#include "mahlwerk/scene/body_shape.hpp"
#include "mahlwerk/scene/flow.hpp"
#include "mahlwerk/scene/grain_breakage.hpp"

namespace mahlwerk::soft {

class Device;

/// Settings of the soft engine: contact model and time stepping.
struct Settings {
  contact::ContactModel model;
  double time_step = 0;              ///< [s]
  bool free_flight_skip = true;      ///< skip time in which nothing touches or all is at rest
  std::size_t few_ball_limit = 128;  ///< largest number of balls for FewBodySolver
  /// Limit of the initial overlap, as a fraction of the smaller radius.
  double max_initial_overlap = 0.01;
  int threads = 1;  ///< threads of one run; results do not depend on it
  std::optional<contact::Liquid> liquid = std::nullopt;  ///< none: dry
  std::optional<scene::Flow> flow = std::nullopt;        ///< none: all balls stay in the jar
  /// How grains break; null: they do not. Balls of their set that are outside become fragments.
  std::shared_ptr<const scene::GrainBreakage> breakage = nullptr;
  bool breakage_from_start = true;  ///< else from begin_counting() on
  /// The shape of the balls of each Ball::kind; none: all are spheres.
  std::vector<scene::BodyShape> shapes = {};
  /// Makes the device that computes a run; none: the processor.
  std::function<std::shared_ptr<Device>()> device = nullptr;
};

}  // namespace mahlwerk::soft
