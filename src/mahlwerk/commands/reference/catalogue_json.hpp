// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::commands {

/// An entry of the catalogue as `mahlwerk list --json` and `describe --json` print it.
results::Json entry_json(const cases::CatalogueEntry& entry);

}  // namespace mahlwerk::commands
