// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace mahlwerk::contact {

/// How a body gives way under load.
struct Elastic {
  double youngs_modulus = 0;  ///< [Pa] > 0; infinite: rigid
  double poisson_ratio = 0;   ///< [1] in (-1, 0.5]
  bool operator==(const Elastic&) const = default;
};

/// What a contact law needs to know of two bodies that may touch, but for their radii and masses.
struct Pair {
  double modulus = 0;           ///< [Pa] E* (dem.2)
  double shear_modulus = 0;     ///< [Pa] G* (dem.3)
  double restitution = 1;       ///< [1] e in [0, 1]
  double friction = INFINITY;   ///< [1] mu >= 0; infinite: sticks at any load
  double rolling_friction = 0;  ///< [1] mu_r >= 0; [s/m] for the viscous rule
  double surface_energy = 0;    ///< [J/m2] gamma of one surface, of JKR
  double cohesion = 0;          ///< [J/m3] energy density, of SJKR
  bool operator==(const Pair&) const = default;
};

/// E* and G* of two bodies, both 1 / (sum of compliances) (dem.2, dem.3).
inline double effective_modulus(const Elastic& a, const Elastic& b) {
  const auto compliance = [](const Elastic& x) {
    return (1 - x.poisson_ratio * x.poisson_ratio) / x.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}
inline double effective_shear_modulus(const Elastic& a, const Elastic& b) {
  const auto compliance = [](const Elastic& x) {
    return 2 * (2 - x.poisson_ratio) * (1 + x.poisson_ratio) / x.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}

/// The pair properties of every two kinds of balls, and of each kind and face of the jar.
class PairTable {
 public:
  PairTable(int kinds, int faces, const Pair& all)
      : kinds_(static_cast<std::size_t>(kinds)),
        row_(kinds_ + static_cast<std::size_t>(faces)),
        pairs_(kinds_ * row_, all) {}

  const Pair& balls(int a, int b) const { return pairs_[index(a, b)]; }
  const Pair& wall(int kind, int face) const { return pairs_[index(kind, face) + kinds_]; }
  void set_balls(int a, int b, const Pair& pair) {
    pairs_[index(a, b)] = pairs_[index(b, a)] = pair;
  }
  void set_wall(int kind, int face, const Pair& pair) { pairs_[index(kind, face) + kinds_] = pair; }

  int kinds() const { return static_cast<int>(kinds_); }
  int faces() const { return static_cast<int>(row_ - kinds_); }
  bool operator==(const PairTable&) const = default;

 private:
  /// A row of pairs for each kind: against every kind, then against every face.
  std::size_t index(int kind, int other) const {
    return static_cast<std::size_t>(kind) * row_ + static_cast<std::size_t>(other);
  }

  std::size_t kinds_, row_;
  std::vector<Pair> pairs_;
};

}  // namespace mahlwerk::contact
