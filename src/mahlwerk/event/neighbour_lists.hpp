// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/huge_page_allocator.hpp"
#include "mahlwerk/base/index.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::event {

/// Verlet neighbour lists for a dense charge. Each ball moves inside a sphere around the place
/// where its list was made last. Two balls are in each other's lists if their spheres let them
/// touch. A ball that leaves its sphere gets a new one, and only its own pairs change.
class NeighbourLists {
 public:
  /// `skin` [m] is the radius of the spheres, `radii` [m] those of the balls by species, `periods`
  /// [m] those of the box.
  NeighbourLists(std::span<const double> radii, double skin, const Vec3& periods,
                 std::size_t balls);

  std::span<const std::int32_t> of(std::int32_t ball) const {
    return {&entries_[row(ball)], as_index(spheres_[as_index(ball)].count)};
  }
  const Vec3& centre(std::int32_t ball) const { return spheres_[as_index(ball)].centre; }

  /// Time [s] after which a ball that is at `position` [m] and moves in a straight line leaves its
  /// sphere.
  double safe_time(std::int32_t ball, const Vec3& position, const Vec3& velocity) const;
  bool has_left(std::int32_t ball, const Vec3& position) const;

  /// Puts a ball into its first sphere. Its list stays empty until renew().
  void place(std::int32_t ball, std::uint32_t species, const Vec3& position);
  /// Moves the sphere of a ball to `position` [m] and renews its list from `candidates`, which
  /// contain all balls whose spheres let them touch it there.
  void renew(std::int32_t ball, const Vec3& position, std::span<const std::int32_t> candidates);
  /// Renumbers the balls: ball i becomes `number[i]`.
  void renumber(std::span<const std::int32_t> number);

  void prefetch(std::int32_t ball) const;
  void serialize(Archive& archive);
  bool is_consistent(std::size_t balls) const;  ///< of lists read from an archive

 private:
  struct alignas(32) Sphere {
    Vec3 centre;  ///< [m]
    std::int32_t count = 0;
    std::uint32_t species = 0;
  };
  std::size_t row(std::int32_t ball) const { return as_index(ball) * capacity_; }
  void remove_from_others(std::int32_t ball);
  void add(std::int32_t ball, std::int32_t other);
  void grow();

  std::vector<double> radii_;
  double skin_;
  Vec3 periods_;
  std::size_t capacity_ = 16;             // entries of a list
  HugePageVector<Sphere> spheres_;        // by ball
  HugePageVector<std::int32_t> entries_;  // `capacity_` for each ball
  std::vector<std::int32_t> found_;       // scratch of renew()
};

}  // namespace mahlwerk::event
