// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/kernel/rigid_body.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Bodies that are clumps of spheres (docs/theory/bodies.md).
namespace mahlwerk::soft {
namespace {

/// Writes the rows of a body's spheres with the predicted motion (bod.7); `w` is the spin.
void write_rows(const BodySpecies& of, const Vec3& centre, const Rotation& axes,
                const Vec3& velocity, const Vec3& w, BallRecord* rows, SpinRecord* spins) {
  for (std::size_t k = 0; k < of.offsets.size(); ++k) {
    const Vec3& o = of.offsets[k];
    const Vec3 x = centre + o.x * axes.ex + o.y * axes.ey + o.z * axes.ez;
    const Vec3 v =
        velocity + o.x * cross(w, axes.ex) + o.y * cross(w, axes.ey) + o.z * cross(w, axes.ez);
    rows[k] = {x.x, x.y, x.z, of.radii[k], v.x, v.y, v.z, 0};
    spins[k] = {w.x, w.y, w.z, 0};
  }
}

}  // namespace

/// Bodies have size classes of their own, octaves of their reach, so that a chunk holds whole
/// bodies.
void ManyBodySolver::assign_body_classes() {
  std::map<std::pair<bool, int>, std::int32_t> numbers;  // spheres before bodies
  const auto octave = [&](double size) {
    return static_cast<int>(std::floor(math::log2(size / (2 * skin_))));
  };
  std::vector<const BodySpecies*> body_of(pairs_.all_species().size());
  for (const BodySpecies& body : body_species_.all())
    for (std::size_t s = 0; s < body_of.size(); ++s) {
      const Species& sphere = pairs_.species(static_cast<std::int32_t>(s));
      if (sphere.kind == body.ball.kind && std::abs(sphere.mass - body.mass) < 1e-9 * body.mass)
        body_of[s] = &body;
    }
  const auto key = [&](std::size_t s) {
    return body_of[s] != nullptr
               ? std::pair{true, octave(body_of[s]->reach)}
               : std::pair{false, octave(pairs_.species(static_cast<std::int32_t>(s)).radius)};
  };
  for (std::size_t s = 0; s < body_of.size(); ++s) numbers[key(s)] = 0;
  first_body_class_ = 0;
  for (std::int32_t next = 0; auto& [at, number] : numbers) {
    number = next++;
    if (!at.first) first_body_class_ = static_cast<std::size_t>(next);
  }
  class_radius_.assign(numbers.size(), 0);
  class_row_radius_.assign(numbers.size(), 0);
  for (std::size_t s = 0; s < body_of.size(); ++s) {
    const auto c = static_cast<std::size_t>(class_of_[s] = numbers[key(s)]);
    const double radius = pairs_.species(static_cast<std::int32_t>(s)).radius;
    class_row_radius_[c] = std::max(class_row_radius_[c], radius);
    class_radius_[c] = std::max(class_radius_[c], body_of[s] ? body_of[s]->reach : radius);
  }
}

/// The rows of step 0 of all balls, some of which are bodies.
void ManyBodySolver::place_spheres(const std::vector<scene::Ball>& balls) {
  bodies_.body_of.assign(rows_.size(), -1);
  bodies_.sphere_of.assign(rows_.size(), 0);
  std::size_t row = 0;
  for (std::size_t number = 0; number < balls.size(); ++number) {
    const scene::Ball& ball = balls[number];
    const std::int32_t s = body_species_.of_ball(number);
    const std::size_t count = body_species_.sphere_count(number);
    for (std::size_t k = 0; k < count; ++k) species_[row + k] = pairs_.species_index(row + k);
    if (s < 0) {
      const Vec3& x = ball.position;
      rows_[row] = {x.x, x.y, x.z, ball.radius, 0, 0, 0, 0};
    } else {
      const auto body = static_cast<std::int32_t>(bodies_.rows.size());
      const Quaternion q = normalised(ball.orientation);
      bodies_.rows.push_back(
          {static_cast<std::int32_t>(row), s, static_cast<std::int32_t>(number)});
      bodies_.now.push_back({ball.position, q});
      write_rows(body_species_[s], ball.position, rotation_of(q), {}, {}, &rows_[row],
                 &spins_[row]);
      for (std::size_t k = 0; k < count; ++k) {
        bodies_.body_of[row + k] = body;
        bodies_.sphere_of[row + k] = static_cast<std::int32_t>(k);
      }
    }
    row += count;
  }
  bodies_.motion.resize(bodies_.rows.size());
  bodies_.next.resize(bodies_.rows.size());
}

/// The rows of step 1, without contact forces (bod.8).
void ManyBodySolver::initialize_bodies(const std::vector<scene::Ball>& balls,
                                       const std::vector<DriveSample>& drive) {
  const double dt = settings_.time_step;
  for (std::size_t b = 0; b < bodies_.rows.size(); ++b) {
    const BodyRows& at = bodies_.rows[b];
    const BodySpecies& of = body_species_[at.species];
    const scene::Ball& ball = balls[static_cast<std::size_t>(at.ball)];
    const BodyRecord& now = bodies_.now[b];
    const Vec3 velocity = ball.velocity + 0.5 * dt * drive[0].body_acceleration;
    const Vec3 predicted = velocity + 0.5 * dt * drive[1].body_acceleration;
    const Vec3 momentum = scaled_along_axes(rotation_of(now.orientation), of.inertia, ball.spin);
    bodies_.motion[b] = {vector_pair(velocity, momentum), vector_pair(predicted, momentum)};
    bodies_.next[b] = {now.centre + dt * velocity,
                       after_free_rotation(now.orientation, momentum, of.inverse_inertia, dt)};
    const auto first = static_cast<std::size_t>(at.first);
    const Rotation axes = rotation_of(bodies_.next[b].orientation);
    write_rows(of, bodies_.next[b].centre, axes, predicted,
               scaled_along_axes(axes, of.inverse_inertia, momentum), &next_rows_[first],
               &next_spins_[first]);
  }
}

/// Adds the old rows of the bodies of a class, in the order of their centres along the curve.
void ManyBodySolver::sort_bodies(std::size_t size_class, std::vector<std::int32_t>& from) const {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t b = 0; b < bodies_.rows.size(); ++b)
    if (class_of(static_cast<std::size_t>(bodies_.rows[b].first)) == size_class)
      order.emplace_back(grids_[size_class].key(bodies_.now[b].centre), b);
  std::ranges::stable_sort(order, {}, &std::pair<std::uint64_t, std::size_t>::first);
  for (const auto& [key, b] : order) {
    const BodyRows& at = bodies_.rows[b];
    const auto count = static_cast<std::int32_t>(body_species_[at.species].offsets.size());
    for (std::int32_t k = 0; k < count; ++k) from.push_back(at.first + k);
  }
}

/// Brings the bodies into the order of their new rows; `from` has the old row of each.
void ManyBodySolver::reorder_bodies(const std::vector<std::int32_t>& from) {
  RigidBodies old = std::move(bodies_);
  bodies_ = {};
  const std::size_t rows = from.size();
  bodies_.body_of.resize(rows), bodies_.sphere_of.resize(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const auto was = static_cast<std::size_t>(from[row]);
    bodies_.sphere_of[row] = old.sphere_of[was];
    if (!old.is_member(was)) {
      bodies_.body_of[row] = -1;
      continue;
    }
    const std::size_t b = old.body(was);
    if (old.sphere_of[was] == 0) {
      bodies_.now.push_back(old.now[b]), bodies_.next.push_back(old.next[b]);
      bodies_.motion.push_back(old.motion[b]), bodies_.rows.push_back(old.rows[b]);
      bodies_.rows.back().first = static_cast<std::int32_t>(row);
    }
    bodies_.body_of[row] = static_cast<std::int32_t>(bodies_.rows.size()) - 1;
  }
}

/// A body stands in the cell of its centre, with all its rows.
Vec3 ManyBodySolver::grid_position(std::size_t row) const {
  return is_member(row) ? bodies_.now[bodies_.body(row)].centre : rows_[row].position();
}

void ManyBodySolver::step_bodies(const ChunkStep& s, const Chunk& chunk, const BallForces& forces,
                                 ChunkDisplacement& displacement) {
  step_bodies_({s, body_species_, body_factors_, bodies_,
                bodies_.body(static_cast<std::size_t>(chunk.first)),
                bodies_.body(static_cast<std::size_t>(chunk.last - 1)) + 1, forces.data()},
               displacement);
}

/// Replaces the parameters of a contact by those of its effective mass at the point of first touch
/// (bod.12), and for rounded bodies of the curvatures there (bod.22).
void ManyBodySolver::apply_contact_mass(PairParameters& parameters, std::size_t lane,
                                        const NeighbourPair& contact,
                                        std::int32_t species_pair) const {
  const TouchingSpheres touch = touching_spheres(contact.ball, contact.other);
  const Vec3& n = touch.normal;
  const auto inverse_mass = [&](std::int32_t at, const Vec3& arm, double radius, double side) {
    const auto row = static_cast<std::size_t>(at);
    if (!is_member(row)) {
      const Species& of = pairs_.species(species_[row]);
      return InverseMass{1 / of.mass, 1 / of.mass + radius * radius / of.inertia};
    }
    const BodyRecord& body = bodies_.now[bodies_.body(row)];
    const BodySpecies& of = body_species_[bodies_.rows[bodies_.body(row)].species];
    const Vec3 to = rows_[row].position() + arm + side * radius * n - body.centre;
    return inverse_mass_at(of.mass, of.inverse_inertia, rotation_of(body.orientation), to, n);
  };
  InverseMass sum = inverse_mass(contact.ball, touch.arm_i, touch.radius_i, 1);
  if (contact.other >= 0) {
    const InverseMass of_j = inverse_mass(contact.other, touch.arm_j, touch.radius_j, -1);
    sum.normal += of_j.normal, sum.tangential += of_j.tangential;
  }
  SpeciesPair own = pairs_[species_pair];
  own.effective.mass = 1 / sum.normal;
  own.effective.slip_factor = sum.tangential / sum.normal;
  if (has_rounded(contact)) {
    const auto edge_radius = [&](std::int32_t row, double radius) {
      const BodySpecies* of = row < 0 ? nullptr : rounded_species(row);
      return of != nullptr ? of->edge_radius() : radius;
    };
    const double widest = 2 * std::max(edge_radius(contact.ball, touch.radius_i),
                                       edge_radius(contact.other, touch.radius_j));
    own.effective.radius = 1 / std::max(touch.curvature_i + touch.curvature_j, 1 / widest);
    parameters.radius_i[lane] = touch.radius_i, parameters.radius_j[lane] = touch.radius_j;
    parameters.inverse_radius[lane] = 1 / min_radius(parameters, lane);
  }
  apply_effective_radius(parameters, lane, own.effective, own, settings_.model);
  const double dt = settings_.time_step;
  parameters.phase_squared_per_stiffness[lane] = own.phase_squared_per_stiffness(dt);
  parameters.half_step_squared_over_mass[lane] = 0.5 * dt * dt / own.effective.mass;
  parameters.slip_factor[lane] = own.effective.slip_factor;
}

double ManyBodySolver::contact_mass(const ContactPackets& list, std::size_t n,
                                    std::size_t l) const {
  if (!bodies_.has_members()) return pairs_[list.packets[n].species_pair[l]].effective.mass;
  const double dt = settings_.time_step;
  return 0.5 * dt * dt / list.parameters[n].half_step_squared_over_mass[l];
}

}  // namespace mahlwerk::soft
