// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::soft {

constexpr const char* energy_jump_message =
    "the energy of the balls jumped: a force was too strong for the step";

constexpr const char* not_finite_message = "its position or velocity is not a finite number";
constexpr const char* outside_message = "it is outside the jar";

/// The error of a run that stops at `time` [s] because of `ball`, counted from 0. Position [m] and
/// velocity [m/s] in the jar frame. `time_step` [s]: the one that was too long.
RunError unstable_run_error(double time, std::size_t ball, const char* why, const Vec3& position,
                            const Vec3& velocity, double time_step);
/// Throws the error of an initial state in which `ball`, counted from 0, or a part of it is
/// outside, if a run stops before its first step with outside_message.
void refuse_start_outside(std::int64_t step, std::size_t ball, std::string_view why);
/// The error of an initial state in which `ball`, counted from 0, overlaps `with` by `overlap`
/// times `length`, a phrase for the smaller radius of the two.
InputError overlap_error(std::size_t ball, const std::string& with, double overlap,
                         const char* length);

}  // namespace mahlwerk::soft
