// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::web {

/// The keys of a case as `mahlwerk list keys --json` prints them, under "keys", and the entries of
/// the catalogue as `mahlwerk list --json` does, by category, under "catalogue".
results::Json vocabulary();

}  // namespace mahlwerk::web
