// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::soft {

constexpr const char* energy_jumped =
    "the energy of the balls jumped: a force was too strong for the step";

/// What is said of a run that physics stopped at `time` [s], by `ball`, counted from 0.
RunError went_wrong(double time, std::size_t ball, const char* why, const Vec3& place,
                    const Vec3& velocity);
/// A start in which `ball` overlaps `with` by `overlap` of its radius.
InputError overlapping(std::size_t ball, const std::string& with, double overlap);

}  // namespace mahlwerk::soft
