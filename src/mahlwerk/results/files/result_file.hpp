// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::results {

/// Numbers on a grid of any rank, in row-major order (the last axis runs fastest).
struct Matrix {
  std::string name, unit, about;
  std::vector<Column> axes;                ///< quantity of each axis
  std::vector<std::vector<double>> edges;  ///< cell edges of each axis: one more than its cells
  std::vector<std::size_t> shape;          ///< cells along each axis
  std::vector<double> values;
};

/// Writes result.h5, a whole result in one file (docs/formats.md): the quantities as /summary, each
/// table as /NAME, each matrix as /NAME with its cell edges as /NAME_edges/AXIS. The case and the
/// version are attributes. The same content gives the same bytes. Throws InputError on failure,
/// std::invalid_argument if a matrix has a number of values that differs from its shape.
void write_result_file(const std::filesystem::path& file, const std::vector<NamedTable>& tables,
                       const std::vector<Matrix>& matrices, const std::vector<Quantity>& quantities,
                       std::string_view case_text, std::string_view version);

}  // namespace mahlwerk::results
