// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/transition_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/lanes.hpp"

namespace mahlwerk::powder {
namespace {

/// c += a_k b, element by element.
struct AddScaled {
  template <int width>
  [[gnu::always_inline]] static void run(double* c, const double* a, double b, int count) {
    using V = Register<width>;
    int i = 0;
    for (; i + width <= count; i += width) {
      V sum, part;  // not aligned
      std::memcpy(&sum, c + i, sizeof sum);
      std::memcpy(&part, a + i, sizeof part);
      sum += part * b;
      std::memcpy(c + i, &sum, sizeof sum);
    }
    for (; i < count; ++i) c[i] += a[i] * b;
  }
};
auto add_scaled() {
  return Multiversioned<AddScaled, void (*)(double*, const double*, double, int)>::best();
}

/// Matrix P = 1 + A/q of uniformization, with q = `pace` [1/s] at least the largest total rate out
/// of a state, so that no entry is negative (pbm.3).
Matrix uniformized_matrix(const RateMatrix& rates, double pace) {
  Matrix m(rates.size, rates.block);
  for (int j = 0; j < rates.size; ++j) {
    double leaves = 0;
    for (int i = rates.first_row(j); i < rates.size; ++i)
      if (i != j) leaves += m.at(i, j) = rates.at(i, j) / pace;
    m.at(j, j) = 1 - leaves;
  }
  return m;
}

/// [1/s] Largest total rate out of a state.
double uniformization_rate(const RateMatrix& rates) {
  double most = 0;
  for (int j = 0; j < rates.size; ++j) {
    double leaves = 0;
    for (int i = 0; i < rates.size; ++i)
      if (i != j) leaves += rates.at(i, j);
    most = std::max(most, leaves);
  }
  return most;
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  const int n = a.size;
  Matrix c(n, a.block);
  const auto add = add_scaled();
  for (int j = 0; j < n; ++j)
    for (int k = b.first_row(j); k < n; ++k) {
      const double factor = b.at(k, j);
      if (factor == 0) continue;
      const int from = a.first_row(k);
      add(c.column(j) + from, a.column(k) + from, factor, n - from);
    }
  return c;
}

std::vector<double> product(const Matrix& a, const std::vector<double>& x) {
  std::vector<double> y(x.size());
  const auto add = add_scaled();
  for (int j = 0; j < a.size; ++j) {
    const double factor = x[static_cast<std::size_t>(j)];
    if (factor == 0) continue;
    const int from = a.first_row(j);
    add(y.data() + from, a.column(j) + from, factor, a.size - from);
  }
  return y;
}

void normalize_columns(Matrix& m) {
  for (int j = 0; j < m.size; ++j) {
    double sum = 0;
    for (int i = 0; i < m.size; ++i) sum += m.at(i, j);
    for (int i = 0; i < m.size; ++i) m.at(i, j) /= sum;
  }
}

// Uniformization: exp(A t) = exp(-q t) sum (q t)^k/k! P^k with the non-negative matrix P = 1 + A/q.
// Scaling and squaring: a few terms for a short time, then repeated squaring (pbm.4).
Matrix transition_matrix(const RateMatrix& rates, double time) {
  const double pace = uniformization_rate(rates);
  Matrix result(rates.size, rates.block);
  for (int i = 0; i < rates.size; ++i) result.at(i, i) = 1;
  if (!(pace * time > 0)) return result;
  constexpr int terms = 9;
  constexpr double short_time = 0.0625;  // q t; its ninth power over 9! is 4e-17
  const int squarings =
      std::max(0, static_cast<int>(std::ceil(math::log2(pace * time / short_time))));
  const double x = std::ldexp(pace * time, -squarings);
  const Matrix once = uniformized_matrix(rates, pace);
  Matrix power = result;
  double weight = 1;
  for (int k = 1; k <= terms; ++k) {
    power = k == 1 ? once : product(power, once);
    weight *= x / k;
    for (std::size_t i = 0; i < power.values.size(); ++i)
      result.values[i] += weight * power.values[i];
  }
  normalize_columns(result);  // includes the factor exp(-x)
  for (int i = 0; i < squarings; ++i) {
    result = product(result, result);
    normalize_columns(result);
  }
  return result;
}

}  // namespace mahlwerk::powder
