// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

// Mass that goes from state to state at constant rates, and the exact step of that.
namespace mahlwerk::powder {

/// A square matrix, column by column. States come in blocks; mass goes within a block or to later
/// ones, so that what is above the blocks at the diagonal is 0 and is left out of the work.
struct Matrix {
  int size = 0, block = 1;  ///< block = size: all of it counts
  std::vector<double> values;

  explicit Matrix(int n = 0, int states_in_block = 1)
      : size(n),
        block(states_in_block),
        values(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}
  int first_row(int column) const { return column / block * block; }  ///< row that may not be 0
  double& at(int row, int column) { return values[index(row, column)]; }
  double at(int row, int column) const { return values[index(row, column)]; }
  const double* column(int j) const { return values.data() + index(0, j); }
  double* column(int j) { return values.data() + index(0, j); }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(row);
  }
};

/// Rates [1/s]: at (i, j) what goes from j to i, i != j, all >= 0. The diagonal is not looked at:
/// what leaves a state is what arrives elsewhere, so no mass is lost.
using RateMatrix = Matrix;

Matrix product(const Matrix& a, const Matrix& b);
std::vector<double> product(const Matrix& a, const std::vector<double>& x);

/// Where the mass of each state is `time` [s] >= 0 later: columns sum to one within 1e-14. No
/// number is ever subtracted (pbm.4), so that the smallest share, too, is right to some roundings.
Matrix transition_matrix(const RateMatrix& rates, double time);

/// Scales each column to the sum one.
void normalize_columns(Matrix& m);

}  // namespace mahlwerk::powder
