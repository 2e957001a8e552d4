// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::web {

/// The keys and units of a case as `mahlwerk list keys --json` and `list units --json` print them,
/// under "keys" and "units", and the entries of
/// the catalogue as `mahlwerk list --json` does, by category, under "catalogue".
results::Json vocabulary();

}  // namespace mahlwerk::web
