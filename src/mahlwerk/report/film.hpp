// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// film.json: the frames of the replicates that stand for all (representatives.hpp), as positions
/// in the plane of motion, for pictures. Balls have their positions at every frame, grains those at
/// the last one. Each position is given in two frames of reference, whose origin is the centre of
/// the jar: that of the jar's carrier (the disc; in other mills it does not rotate) and that of the
/// jar. Numbers have six digits (docs/formats.md).
std::string film_json(const results::Outcome& outcome);

}  // namespace mahlwerk::report
