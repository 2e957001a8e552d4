// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "records.hpp"

namespace mahlwerk::python {

/// The outcome of a run in memory, with the records that it was asked to keep.
struct RunResult {
  results::Outcome outcome;
  std::vector<RecordBuffer> records;  ///< by replicate, or empty
};

/// Changes of a case: key and value; without a value the key is taken from the case.
using Changes = std::vector<std::pair<std::string, std::optional<std::string>>>;
std::vector<cases::Override> overrides_of(const Changes& changes);

void bind_outcome(pybind11::module_& m);
void bind_run(pybind11::module_& m);
void bind_case(pybind11::module_& m);
void bind_commands(pybind11::module_& m);
void bind_papers(pybind11::module_& m);

/// (key, values, whether they are the ends of a range) of the keys of [sweep].
pybind11::list swept_keys(const cases::Case& whole);
/// (name, unit) of the quantities that a run of the case gives.
pybind11::list quantities(const cases::Case& whole);

}  // namespace mahlwerk::python
