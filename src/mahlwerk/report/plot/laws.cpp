// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/laws.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::report {
namespace {

/// Points with weights, normalised to sum to the number of points.
struct Data {
  std::vector<double> x, y, weight;
  double number() const { return static_cast<double>(x.size()); }
};

Data data_of(const std::vector<double>& x, const std::vector<double>& y,
             const std::vector<double>& ci95) {
  Data d;
  bool weighs = true;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    const double half = i < ci95.size() ? ci95[i] : NAN;
    weighs = weighs && std::isfinite(half) && half > 0;
    d.x.push_back(x[i]);
    d.y.push_back(y[i]);
    d.weight.push_back(half);
  }
  double sum = 0;
  const double least = d.weight.empty() || !weighs ? 1 : *std::ranges::min_element(d.weight);
  for (double& w : d.weight) {
    w = weighs ? (least / w) * (least / w) : 1;
    sum += w;
  }
  for (double& w : d.weight) w *= d.number() / sum;
  return d;
}

/// Normal equations with at most three unknowns.
struct Normal {
  std::size_t size = 0;
  std::array<std::array<double, 3>, 3> matrix{};
  std::array<double, 3> right{};
};

/// Inverts the matrix by Gauss-Jordan elimination; false if it is singular. The unknowns are of
/// similar scale, so no pivoting is needed.
bool invert(Normal& n) {
  std::array<std::array<double, 6>, 3> rows{};
  for (std::size_t i = 0; i < n.size; ++i) {
    std::copy_n(n.matrix[i].begin(), n.size, rows[i].begin());
    rows[i][n.size + i] = 1;
  }
  for (std::size_t k = 0; k < n.size; ++k) {
    const double pivot = rows[k][k];
    if (!(pivot > 1e-14 * n.matrix[k][k])) return false;
    for (double& v : rows[k]) v /= pivot;
    for (std::size_t i = 0; i < n.size; ++i) {
      const double factor = i == k ? 0 : rows[i][k];
      for (std::size_t j = 0; j < 2 * n.size; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (std::size_t i = 0; i < n.size; ++i)
    std::copy_n(rows[i].begin() + static_cast<std::ptrdiff_t>(n.size), n.size, n.matrix[i].begin());
  return true;
}

using Row = std::array<double, 3>;  // the derivatives of y with respect to the coefficients

/// Result of a least-squares step: the change of the coefficients and the inverse matrix.
struct Step {
  bool solved = false;
  std::array<double, 3> change{};
  std::array<std::array<double, 3>, 3> inverse{};
};
Step step(const Data& d, std::size_t size, const std::vector<double>& residuals,
          const std::function<Row(std::size_t)>& row_of) {
  Normal n{.size = size};
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const Row row = row_of(i);
    for (std::size_t j = 0; j < size; ++j) {
      n.right[j] += d.weight[i] * row[j] * residuals[i];
      for (std::size_t k = 0; k < size; ++k) n.matrix[j][k] += d.weight[i] * row[j] * row[k];
    }
  }
  Step s;
  s.solved = invert(n);
  s.inverse = n.matrix;
  for (std::size_t j = 0; j < size; ++j)
    for (std::size_t k = 0; k < size; ++k) s.change[j] += n.matrix[j][k] * n.right[k];
  return s;
}

double weighted_mean(const Data& d, const std::vector<double>& of) {
  double sum = 0;
  for (std::size_t i = 0; i < of.size(); ++i) sum += d.weight[i] * of[i];
  return sum / d.number();
}

double sum_of_squares(const Data& d, const std::function<double(double)>& y_of) {
  double sum = 0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const double off = d.y[i] - y_of(d.x[i]);
    sum += d.weight[i] * off * off;
  }
  return sum;
}

/// Sets the half-widths of the coefficients and the goodness of fit from the residuals.
/// `variance` holds the diagonal of (cam.22) for s = 1.
void judge(FittedLaw& law, const Data& d, const std::vector<double>& variance) {
  const double n = d.number(), p = static_cast<double>(law.coefficients.size());
  const double mean = weighted_mean(d, d.y);
  const double total = sum_of_squares(d, [&](double) { return mean; });
  const double zero = sum_of_squares(d, [](double) { return 0.0; });
  // Lower bound: the residuals of an exact law are rounding errors.
  constexpr double rounding = 1e-13;
  const double left =
      std::max(sum_of_squares(d, [&](double x) { return law.at(x); }), rounding * rounding * zero);
  const int spare = static_cast<int>(n - p);
  const double scatter = spare > 0 ? std::sqrt(left / spare) : NAN;
  for (const double v : variance)
    law.ci95.push_back(spare > 0 ? observe::student95(spare) * scatter * std::sqrt(v) : NAN);
  law.r_squared = 1 - left / total;                            // (cam.24)
  law.adjusted = 1 - (1 - law.r_squared) * (n - 1) / (n - p);  // (cam.25)
  const double k = p + 1;                                      // the scatter is a parameter, too
  law.aicc = n > k + 1 ? n * std::log(left / n) + 2 * k * n / (n - k - 1) : NAN;  // (cam.26)
}

/// Polynomial fit y = sum c_j u^j with u = (x - middle)/half, converted to powers of x.
FittedLaw polynomial(const Data& d, LawForm form) {
  const std::size_t size = form == LawForm::line ? 2 : 3;
  const double middle = weighted_mean(d, d.x);
  double half = 0;
  for (const double x : d.x) half = std::max(half, std::abs(x - middle));
  const Step s = step(d, size, d.y, [&](std::size_t i) {  // (cam.21)
    const double u = (d.x[i] - middle) / half;
    return Row{1, u, u * u};
  });
  if (!s.solved) return {};
  // Coefficients in x are linear combinations of those in u.
  const double m = middle / half, h = half;
  const std::array<Row, 3> by{Row{1, -m, size == 3 ? m * m : 0},
                              Row{0, 1 / h, size == 3 ? -2 * m / h : 0}, Row{0, 0, 1 / (h * h)}};
  FittedLaw law{.form = form};
  std::vector<double> variance;
  for (std::size_t j = 0; j < size; ++j) {
    double value = 0, spread = 0;
    for (std::size_t k = 0; k < size; ++k) {
      value += by[j][k] * s.change[k];
      for (std::size_t l = 0; l < size; ++l) spread += by[j][k] * s.inverse[k][l] * by[j][l];
    }
    law.coefficients.push_back(value);
    variance.push_back(std::max(spread, 0.0));
  }
  judge(law, d, variance);
  return law;
}

/// Rounds to three digits, for display.
double rounded(double value) {
  const double scale = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::round(value / scale) * scale;
}

/// Start value of the power law: a straight line of ln y over ln x.
FittedLaw first_power(const Data& d) {
  double x = 0, y = 0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    x += std::log(d.x[i]) / d.number();
    y += std::log(d.y[i]) / d.number();
  }
  double uu = 0, uv = 0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const double u = std::log(d.x[i]) - x;
    uu += u * u;
    uv += u * std::log(d.y[i]);
  }
  const double slope = uv / uu, reference = rounded(std::exp(x));
  return {.form = LawForm::power,
          .coefficients = {std::exp(y + slope * (std::log(reference) - x)), slope},
          .reference = reference};
}

/// Power law by Gauss-Newton iteration in c and p; each step is halved until it decreases the sum
/// of squares.
FittedLaw power(const Data& d) {
  constexpr int max_steps = 100, max_halvings = 40;
  FittedLaw law = first_power(d);
  const auto left = [&](const FittedLaw& l) {
    return sum_of_squares(d, [&](double x) { return l.at(x); });
  };
  // The relative change of c is the unknown, so that both unknowns have the same scale.
  const auto next = [&](const FittedLaw& l) {
    std::vector<double> residuals;
    for (std::size_t i = 0; i < d.x.size(); ++i) residuals.push_back(d.y[i] - l.at(d.x[i]));
    return step(d, 2, residuals, [&](std::size_t i) {
      const double y = l.at(d.x[i]);
      return Row{y, y * std::log(d.x[i] / l.reference), 0};
    });
  };
  double now = left(law);
  for (int i = 0; i < max_steps; ++i) {
    const Step s = next(law);
    if (!s.solved) return {};
    bool went = false;
    double share = 1;
    for (int h = 0; h < max_halvings && !went; ++h, share /= 2) {
      FittedLaw tried = law;
      tried.coefficients[0] *= std::exp(share * s.change[0]);
      tried.coefficients[1] += share * s.change[1];
      const double then = left(tried);
      went = then < now;
      if (went) law = tried, now = then;
    }
    if (!went) break;
  }
  const Step end = next(law);
  if (!end.solved) return {};
  const double c = law.coefficients[0];
  judge(law, d, {c * c * end.inverse[0][0], end.inverse[1][1]});
  return law;
}

}  // namespace

std::string_view name_of(LawForm form) {
  constexpr std::array<std::string_view, 3> names{"straight line", "power law", "parabola"};
  return names[static_cast<std::size_t>(form)];
}

double FittedLaw::at(double x) const {
  switch (form) {
    case LawForm::power:
      return coefficients[0] * std::pow(x / reference, coefficients[1]);
    case LawForm::parabola:
      return coefficients[0] + x * (coefficients[1] + x * coefficients[2]);
    case LawForm::line:
      break;
  }
  return coefficients[0] + x * coefficients[1];
}

std::vector<FittedLaw> fitted_laws(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& ci95) {
  const Data d = data_of(x, y, ci95);
  constexpr std::size_t fewest = 4;
  if (std::set<double>(d.x.begin(), d.x.end()).size() < fewest) return {};
  const auto [least, most] = std::ranges::minmax_element(d.y);
  if (*most - *least <= 1e-9 * std::max(std::abs(*most), std::abs(*least))) return {};
  std::vector<FittedLaw> laws{polynomial(d, LawForm::line)};
  if (*least > 0 && *std::ranges::min_element(d.x) > 0) laws.push_back(power(d));
  laws.push_back(polynomial(d, LawForm::parabola));
  // Squares of numbers near 1e300 overflow.
  std::erase_if(laws, [](const FittedLaw& l) {
    return l.coefficients.empty() || !std::isfinite(l.r_squared);
  });
  return laws;
}

LawSelection select_law(const std::vector<FittedLaw>& laws) {
  constexpr double apart = 2;  // AICc difference below which laws are equivalent (cam.27)
  LawSelection choice;
  const auto ranked =
      std::ranges::count_if(laws, [](const FittedLaw& l) { return !std::isnan(l.aicc); });
  choice.by_aicc = ranked >= 2;
  const auto score = [&](const FittedLaw& l) {
    if (!choice.by_aicc) return -l.adjusted;
    return std::isnan(l.aicc) ? INFINITY : l.aicc;
  };
  for (std::size_t i = 0; i < laws.size(); ++i)
    if (score(laws[i]) < score(laws[choice.best])) choice.best = i;
  for (std::size_t i = 0; i < laws.size() && choice.by_aicc; ++i)
    if (i != choice.best && score(laws[i]) < score(laws[choice.best]) + apart)
      choice.equivalent.push_back(i);
  return choice;
}

bool through_origin(const FittedLaw& law) {
  return law.form == LawForm::line && std::abs(law.coefficients[0]) <= law.ci95[0];
}

}  // namespace mahlwerk::report
