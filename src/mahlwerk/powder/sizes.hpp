// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/feed.hpp"

// Sizes of grains in classes, and what a distribution over them says. Shares are of the mass.
namespace mahlwerk::powder {

/// Classes of size from coarse to fine, each the same factor below the last (siz.1).
class SizeGrid {
 public:
  SizeGrid() = default;
  /// `middle` [m] is the middle of a class; others are added until they reach from `smallest` to
  /// `largest` [m]. A grain that is halved goes `per_octave`/3 classes down: a multiple of 3.
  SizeGrid(double middle, double largest, double smallest, int per_octave);

  int classes() const { return classes_; }
  int per_octave() const { return per_octave_; }
  double upper(int i) const;   ///< [m] edge of class i
  double middle(int i) const;  ///< [m] geometric
  double lower(int i) const { return upper(i + 1); }
  int class_of(double size) const;                     ///< the outermost for what lies beyond
  std::vector<double> shares(const Feed& feed) const;  ///< of each class

 private:
  double top_ = 1;  // [m] upper edge of the first
  int classes_ = 0, per_octave_ = 6;
};

/// [m] Size that this share of the mass, 0 to 1, is finer than: evenly in the logarithm of the size
/// within a class (siz.2).
double quantile(const SizeGrid& grid, const std::vector<double>& shares, double share);
/// [1] Share finer than `size` [m], likewise.
double undersize(const SizeGrid& grid, const std::vector<double>& shares, double size);
/// [m2/kg] Surface of spheres of these sizes over their mass (siz.3).
double specific_surface(const SizeGrid& grid, const std::vector<double>& shares, double density);
/// [m] Mean size by mass.
double mean_size(const SizeGrid& grid, const std::vector<double>& shares);

}  // namespace mahlwerk::powder
