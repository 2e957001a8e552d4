// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "records.hpp"

namespace mahlwerk::python {

/// The outcome of a run in memory, with the records that it was asked to keep.
struct RunResult {
  results::Outcome outcome;
  std::vector<RecordBuffer> records;  ///< by replicate, or empty
};

void bind_outcome(pybind11::module_& m);
void bind_run(pybind11::module_& m);
void bind_case(pybind11::module_& m);
void bind_commands(pybind11::module_& m);

}  // namespace mahlwerk::python
