// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

// Continuous-time Markov chain of mass between states at constant rates, and its exact transition
// matrix.
namespace mahlwerk::powder {

/// A square matrix in column-major order. States form blocks; mass moves within a block or to later
/// blocks. Entries above the diagonal blocks are 0 and are skipped (block lower triangular).
struct Matrix {
  int size = 0, block = 1;  ///< block = size: a full matrix
  std::vector<double> values;

  explicit Matrix(int n = 0, int states_in_block = 1)
      : size(n),
        block(states_in_block),
        values(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}
  int first_row(int column) const {
    return column / block * block;
  }  ///< first row that may not be 0
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

/// Rates [1/s] >= 0: entry (i, j), i != j, is the rate from state j to state i. The diagonal is
/// ignored; it follows from conservation of mass.
using RateMatrix = Matrix;

Matrix product(const Matrix& a, const Matrix& b);
std::vector<double> product(const Matrix& a, const std::vector<double>& x);

/// Transition matrix exp(A t) after `time` [s] >= 0, by uniformization with scaling and squaring
/// (pbm.4). Columns sum to one within 1e-14. The algorithm subtracts no numbers, so that small
/// shares, too, have relative errors of a few roundings.
Matrix transition_matrix(const RateMatrix& rates, double time);

/// Scales each column to a sum of one.
void normalize_columns(Matrix& m);

}  // namespace mahlwerk::powder
