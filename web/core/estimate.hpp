// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::web {

/// The case of a few words, as `mahlwerk estimate --save` writes it: {"faults": [], "text": "..."}.
/// `words`: JSON with the texts "mill", "jar", "material", "frequency", "speed", "powder", "time"
/// and the list "balls"; what is not there is not given. With faults, "text" is the case whose
/// lines they cite, empty if the words make none. Throws std::invalid_argument if this is no JSON.
results::Json estimate(std::string_view words);

}  // namespace mahlwerk::web
