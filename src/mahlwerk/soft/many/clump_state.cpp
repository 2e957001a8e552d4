// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/kernel/rigid_body.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Bodies that are clumps of spheres: their motion at the present step, energies, forces,
// checkpoints.
namespace mahlwerk::soft {

/// The motion of a body at the present step, from that half a step later (bod.8).
ManyBodySolver::PresentBody ManyBodySolver::present(std::size_t b,
                                                    const Vec3& body_kick_change) const {
  const BodyMotion& m = bodies_.motion[b];
  const BodySpecies& of = body_species_[bodies_.rows[b].species];
  const Vec3 momentum = 2.0 * second_vector(m.half_step) - second_vector(m.predicted);
  return {2.0 * first_vector(m.half_step) - first_vector(m.predicted) + body_kick_change, momentum,
          scaled_along_axes(rotation_of(bodies_.now[b].orientation), of.inverse_inertia, momentum)};
}

Vec3 ManyBodySolver::spin_of_row(std::size_t row) const {
  return is_member(row) ? present(bodies_.body(row), {}).spin : spin(row);
}

Vec3 ManyBodySolver::velocity_of_row(std::size_t row, const Vec3& body_kick_change) const {
  if (!is_member(row)) return velocity(row, body_kick_change);
  const std::size_t b = bodies_.body(row);
  const PresentBody at = present(b, body_kick_change);
  return at.velocity + cross(at.spin, rows_[row].position() - bodies_.now[b].centre);
}

/// All the energy of a body counts at its first row.
ManyBodySolver::BallEnergy ManyBodySolver::energy_of_sphere(
    std::size_t row, const Vec3& body_kick_change, const kinematics::FrameMotion& frame) const {
  if (bodies_.sphere_of[row] > 0) return {};
  const std::size_t b = bodies_.body(row);
  const BodySpecies& of = body_species_[bodies_.rows[b].species];
  const PresentBody at = present(b, body_kick_change);
  return {0.5 * (of.mass * squared(at.velocity + frame.velocity) + dot(at.momentum, at.spin)),
          -(of.mass * dot(jar_->gravity(), bodies_.now[b].centre + frame.centre))};
}

/// Where the body of a row is hit, with the vector `arm` from the centre of the row to the contact
/// (bod.16).
scene::BodyFeature ManyBodySolver::feature_hit(std::int32_t number, const Vec3& arm) const {
  const auto row = static_cast<std::size_t>(number);
  if (!is_member(row)) return scene::BodyFeature::none;
  const std::size_t b = bodies_.body(row);
  const BodyRecord& at = bodies_.now[b];
  const BodySpecies& of = body_species_[bodies_.rows[b].species];
  const Vec3 point = rows_[row].position() + arm - at.centre;
  return of.features.feature_at(rotation_of(at.orientation).apply_inverse(point) / of.ball.radius);
}

void ManyBodySolver::add_bodies(std::vector<scene::Ball>& all, const Vec3& body_kick_change) const {
  for (std::size_t b = 0; b < bodies_.rows.size(); ++b) {
    const PresentBody at = present(b, body_kick_change);
    scene::Ball ball = body_species_[bodies_.rows[b].species].ball;
    ball.position = jar_->within_period(bodies_.now[b].centre);
    ball.velocity = at.velocity, ball.spin = at.spin;
    ball.orientation = bodies_.now[b].orientation;
    all[static_cast<std::size_t>(bodies_.rows[b].ball)] = ball;
  }
}

void ManyBodySolver::add_body_forces(std::vector<Vec3>& all, const Vec3& pull) const {
  const double half_dt = 0.5 * settings_.time_step;
  for (std::size_t b = 0; b < bodies_.rows.size(); ++b) {
    const BodyMotion& m = bodies_.motion[b];
    all[static_cast<std::size_t>(bodies_.rows[b].ball)] =
        body_species_[bodies_.rows[b].species].mass / half_dt *
        (first_vector(m.predicted) - first_vector(m.half_step) - pull);
  }
}

void ManyBodySolver::serialize_bodies(Archive& archive) {
  const std::size_t bodies = bodies_.rows.size();
  archive(path_)(bodies_.now)(bodies_.next)(bodies_.motion)(bodies_.rows)(bodies_.body_of)(
      bodies_.sphere_of);
  if (bodies_.rows.size() != bodies || bodies_.now.size() != bodies ||
      bodies_.next.size() != bodies || bodies_.motion.size() != bodies ||
      bodies_.body_of.size() != rows_.size() || bodies_.sphere_of.size() != rows_.size())
    throw Archive::broken();
}

}  // namespace mahlwerk::soft
