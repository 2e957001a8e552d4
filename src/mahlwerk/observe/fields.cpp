// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/fields.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::observe {
namespace {

double share(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

}  // namespace

void PlaneField::add(double x, double y, double u, double v, double speed2, double mass,
                     double weight) {
  const double width = 2 * half_size_ / cells;
  const double a = std::clamp((x + half_size_) / width - 0.5, 0.0, cells - 1.0);
  const double b = std::clamp((y + half_size_) / width - 0.5, 0.0, cells - 1.0);
  const int i = std::min(static_cast<int>(a), cells - 2),
            j = std::min(static_cast<int>(b), cells - 2);
  const double right = a - i, up = b - j;
  for (const int di : {0, 1})
    for (const int dj : {0, 1}) {
      const double m = mass * weight * (di == 0 ? 1 - right : right) * (dj == 0 ? 1 - up : up);
      Sum& sum = sums_[static_cast<std::size_t>(j + dj) * cells + static_cast<std::size_t>(i + di)];
      sum.mass += m;
      sum.x += m * u;
      sum.y += m * v;
      sum.kinetic += 0.5 * m * speed2;
    }
}

double PlaneField::density(int i, int j) const {
  return share(at(i, j).mass, time_ * cell_area());
}
double PlaneField::velocity_x(int i, int j) const {
  return share(at(i, j).x, at(i, j).mass);
}
double PlaneField::velocity_y(int i, int j) const {
  return share(at(i, j).y, at(i, j).mass);
}
double PlaneField::kinetic_energy(int i, int j) const {
  return share(at(i, j).kinetic, time_ * cell_area());
}

void PlaneField::merge(const PlaneField& other) {
  time_ += other.time_;
  sums_.merge(other.sums_, [](Sum& mine, const Sum& more) {
    mine.mass += more.mass;
    mine.x += more.x;
    mine.y += more.y;
    mine.kinetic += more.kinetic;
  });
}

}  // namespace mahlwerk::observe
