// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <utility>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/files/result_tables.hpp"

namespace mahlwerk::results {

/// The table of that name, of the part that makes it; empty if there is none.
inline Table table_of(const Outcome& outcome, std::string_view name) {
  for (const cases::Part* part : cases::parts_of(outcome.mill_case))
    if (part->tables != nullptr)
      for (NamedTable& one : part->tables(outcome))
        if (one.name == name) return std::move(one.table);
  return {};
}

}  // namespace mahlwerk::results
