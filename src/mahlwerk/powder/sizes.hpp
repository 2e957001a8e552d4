// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/feed.hpp"

// Size classes of grains, and statistics of size distributions. Shares are mass shares.
namespace mahlwerk::powder {

/// Geometric size classes, from coarse to fine (siz.1).
class SizeGrid {
 public:
  SizeGrid() = default;
  /// `middle` [m] is the geometric middle of one class; the classes cover `smallest` to `largest`
  /// [m]. `per_octave`: classes per octave, a multiple of 3, so that halving a grain's volume moves
  /// it down by `per_octave`/3 classes.
  SizeGrid(double middle, double largest, double smallest, int per_octave);

  int classes() const { return classes_; }
  int per_octave() const { return per_octave_; }
  double upper(int i) const;   ///< [m] upper edge of class i
  double middle(int i) const;  ///< [m] geometric middle of class i
  double lower(int i) const { return upper(i + 1); }
  int class_of(double size) const;                     ///< clamped to the outermost classes
  std::vector<double> shares(const Feed& feed) const;  ///< mass share of each class

 private:
  double top_ = 1;  // [m] upper edge of the first class
  int classes_ = 0, per_octave_ = 6;
};

/// [m] Size that this mass share, 0 to 1, is finer than. The distribution within a class is uniform
/// in the logarithm of the size (siz.2).
double quantile(const SizeGrid& grid, const std::vector<double>& shares, double share);
/// [1] Mass share finer than `size` [m], likewise.
double undersize(const SizeGrid& grid, const std::vector<double>& shares, double size);
/// [m2/kg] Specific surface of spheres of these sizes (siz.3). `density` [kg/m3].
double specific_surface(const SizeGrid& grid, const std::vector<double>& shares, double density);
/// [m] Mean size, weighted by mass.
double mean_size(const SizeGrid& grid, const std::vector<double>& shares);

}  // namespace mahlwerk::powder
