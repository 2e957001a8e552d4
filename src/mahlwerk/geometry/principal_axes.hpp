// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace mahlwerk::geometry {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Turns the symmetric matrix `a` to its principal axes by Jacobi's rotations: it becomes diagonal.
/// Returns the eigenvectors as columns.
Matrix3 diagonalise(Matrix3& a);

}  // namespace mahlwerk::geometry
