// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/body_core.hpp"

namespace mahlwerk::soft {

/// Bodies of one shape, size and density: clumps of spheres, or rounded convex bodies. Such a body
/// has one row, the sphere that holds it.
struct BodySpecies {
  scene::Ball ball;               ///< the ball as the scene knows it, without its state
  double mass = 0;                ///< [kg]
  Vec3 inertia, inverse_inertia;  ///< [kg m2] principal, and inverse
  std::vector<Vec3> offsets;      ///< [m] centres of the spheres, along the principal axes
  std::vector<double> radii;      ///< [m] of the spheres
  double reach = 0;               ///< [m] of the sphere about the centre of mass that holds them
  scene::BodyCore features;       ///< over the radius of the ball
  geometry::ConvexCore core;      ///< [m] of a rounded convex body, else empty
  double rounding = 0;            ///< [m]

  bool is_rounded() const { return !core.is_empty(); }
  /// [kg] The least effective mass of a contact of a sphere of the body (bod.12); of a rounded
  /// body, of a contact at its core.
  double least_contact_mass(std::size_t sphere) const;
  /// [m] Radius of the edges of a rounded body, of the side of a cylinder: (bod.22) takes no R*
  /// above twice that of the larger one of two bodies.
  double edge_radius() const { return rounding + (core.is_cylinder() ? core.radius : 0); }
  /// The largest number of spheres that touch a plane across a principal axis.
  int spheres_on_a_plane() const;
};

/// The species of the balls that are no spheres.
class BodySpeciesTable {
 public:
  /// `shapes`: by Ball::kind; none: all balls are spheres.
  BodySpeciesTable(const std::vector<scene::Ball>& balls,
                   const std::vector<scene::BodyShape>& shapes);

  bool empty() const { return species_.empty(); }
  const std::vector<BodySpecies>& all() const { return species_; }
  const BodySpecies& operator[](std::int32_t s) const {
    return species_[static_cast<std::size_t>(s)];
  }
  /// Species of a ball; < 0: a sphere.
  std::int32_t of_ball(std::size_t ball) const { return empty() ? -1 : of_ball_[ball]; }
  bool has_rounded() const { return has_rounded_; }
  /// Number of spheres of a ball.
  std::size_t sphere_count(std::size_t ball) const {
    return of_ball(ball) < 0 ? 1 : (*this)[of_ball(ball)].offsets.size();
  }
  /// Number of spheres of all balls.
  std::size_t sphere_count(const std::vector<scene::Ball>& balls) const {
    std::size_t count = balls.size();
    for (std::size_t b = 0; b < balls.size() && !empty(); ++b) count += sphere_count(b) - 1;
    return count;
  }
  /// The spheres of all balls in turn, each as a ball with the mass of its body, for SpeciesPairs.
  std::vector<scene::Ball> spheres(const std::vector<scene::Ball>& balls) const;
  /// The same, each with the mass of its lightest contact: what limits the time step (bod.13).
  std::vector<scene::Ball> lightest_contacts(const std::vector<scene::Ball>& balls) const;
  /// The same, each with the mass of its heaviest contact, one in line with the centre of mass, and
  /// the radius of its sphere or rounding: what limits the overlap.
  std::vector<scene::Ball> heaviest_contacts(const std::vector<scene::Ball>& balls) const;

 private:
  /// `part(species, sphere)`: radius and mass of each sphere.
  template <class Part>
  std::vector<scene::Ball> parts(const std::vector<scene::Ball>& balls, const Part& part) const;

  std::vector<BodySpecies> species_;
  std::vector<std::int32_t> of_ball_;
  bool has_rounded_ = false;
};

}  // namespace mahlwerk::soft
