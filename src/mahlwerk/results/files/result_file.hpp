// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::results {

/// A table under the name of its file, "spectrum" for spectrum.csv.
struct NamedTable {
  std::string name, about;
  Table table;
};

/// Numbers on a grid, of any rank: the last axis runs fastest.
struct Matrix {
  std::string name, unit, about;
  std::vector<Column> axes;                ///< what each axis is of
  std::vector<std::vector<double>> edges;  ///< of each axis: one more than it has cells
  std::vector<std::size_t> shape;          ///< cells along each axis
  std::vector<double> values;
};

/// result.h5, everything a result holds in one file (docs/formats.md): the quantities as /summary,
/// every table as /NAME, every matrix as /NAME with the edges of its cells as /NAME_edges/AXIS. The
/// case and the version travel inside. The same content gives the same bytes. Throws InputError if
/// it cannot be written, std::invalid_argument if a matrix and its shape are not of one size.
void write_result_file(const std::filesystem::path& file, const std::vector<NamedTable>& tables,
                       const std::vector<Matrix>& matrices, const std::vector<Quantity>& quantities,
                       std::string_view case_text, std::string_view version);

}  // namespace mahlwerk::results
