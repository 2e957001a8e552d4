// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/cases/catalogue.hpp"

namespace mahlwerk::cases {

/// The catalogue file of an entry: read_entry() of it gives the entry again. A value with a range
/// that is not assumed gets the confidence "measured".
std::string entry_text(const CatalogueEntry& entry);

}  // namespace mahlwerk::cases
