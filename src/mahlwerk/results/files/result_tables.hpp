// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/kinematics/tabulated.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// A table and the name of its file without extension: "spectrum" for spectrum.csv.
struct NamedTable {
  std::string name, about;
  Table table;
};

/// All tables of a result, those of every result first. Each is a CSV file and a part of result.h5.
std::vector<NamedTable> tables(const Outcome& outcome);

/// The samples of a measured motion, in the form that a case reads.
Table motion_samples(const kinematics::Tabulated& motion);

}  // namespace mahlwerk::results
