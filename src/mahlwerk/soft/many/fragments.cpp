// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Fragments that take the place of a grain that broke, and fines (docs/theory/bed-breakage.md).
namespace mahlwerk::soft {
namespace {

using scene::GrainState;

constexpr int tried_places = 24;  // for a fragment in the sphere of its grain

/// Distance of a point from the surfaces of the spheres placed so far, less a radius; < 0: overlap.
double clearance(const Vec3& x, double radius, std::span<const Vec3> centres,
                 std::span<const double> radii) {
  double least = geometry::never;
  for (std::size_t k = 0; k < centres.size(); ++k)
    least = std::min(least, norm(x - centres[k]) - radii[k] - radius);
  return least;
}

/// Places spheres in a sphere about the origin, the largest first, each where it overlaps the
/// others least of some random places (bed.6). `radii` [m] fall.
std::vector<Vec3> packed(std::span<const double> radii, double radius, Random& random) {
  std::vector<Vec3> centres;
  for (const double r : radii) {
    Vec3 best;
    double most = -geometry::never;
    for (int k = 0; k < tried_places; ++k) {
      const Vec3 x = (radius - r) * math::cbrt(random.uniform()) * random.direction();
      const double clear = clearance(x, r, centres, radii);
      if (clear > most) most = clear, best = x;
      if (clear >= 0) break;
    }
    centres.push_back(best);
  }
  return centres;
}

}  // namespace

/// Replaces the grains that broke by their fragments, in the order of their numbers.
void ManyBodySolver::replace_broken(std::vector<scene::SizeChange>& changes) {
  std::vector<std::size_t> broken;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (breakage_.grains[static_cast<std::size_t>(id_[k])].phase == GrainState::Phase::replaced)
      broken.push_back(k);
  if (broken.empty()) return;
  std::ranges::sort(broken, {}, [&](std::size_t k) { return id_[k]; });
  breakage_.replaced_at = step_;
  leaves_.assign(rows_.size(), false);
  bool any = false;
  for (const std::size_t k : broken) any = replace(k, changes) || any;
  if (!any) return leaves_.clear();
  end_contacts_of_leaving(energy_balance_.lost_breakage, 1);
  rebuild_after_flow();
}

/// Number of spheres of each of the first size classes among the fragments of a grain, its own
/// class `from`. What is due of each class is carried over to the next grain, so that the shares
/// are exact over many grains, and the mass for each (bed.5).
std::vector<int> ManyBodySolver::count_fragments(const std::vector<double>& shares, double mass,
                                                 std::size_t from) {
  std::vector<int> counts(breakage_.species.size());
  double left = mass;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    breakage_.due[k] += shares[k] * mass;
    const double each = pairs_.species(breakage_.species[k]).mass;
    if (k <= from) continue;
    constexpr double rounding = 1e-9;
    const double most = std::floor(left / each + rounding);
    counts[k] = static_cast<int>(std::clamp(std::floor(breakage_.due[k] / each), 0.0, most));
    left -= counts[k] * each;
    breakage_.due[k] -= counts[k] * each;
  }
  return counts;
}

/// Replaces a grain that broke. Returns whether its sphere leaves: where no ball is left to become
/// a fragment, it stays and stands for finer particles.
bool ManyBodySolver::replace(std::size_t row, std::vector<scene::SizeChange>& changes) {
  const scene::GrainBreakage& rule = *settings_.breakage;
  const auto ball = static_cast<std::size_t>(id_[row]);
  const GrainState grain = breakage_.grains[ball];
  const double mass = pairs_.species(species_[row]).mass;
  const std::vector<double> shares = rule.fragment_shares(grain);
  const auto from = static_cast<std::size_t>(rule.class_of(2 * rows_[row].radius));
  const std::vector<int> counts = count_fragments(shares, mass, from);
  const int spheres = std::accumulate(counts.begin(), counts.end(), 0);
  if (static_cast<std::size_t>(spheres) > outside_.size()) {
    for (std::size_t k = 0; k < counts.size(); ++k)
      breakage_.due[k] += counts[k] * pairs_.species(breakage_.species[k]).mass - shares[k] * mass;
    Stressing out;
    become_finer(breakage_.grains[ball], mass, out);
    changes.insert(changes.end(), out.changes.begin(), out.changes.end());
    energy_balance_.broken_grains += out.broken;
    return false;
  }
  ++energy_balance_.broken_grains;
  energy_balance_.lost_breakage += energy_after_kick(row);
  changes.push_back({time_of(step_), -mass, rule.class_of(grain.size), 1});
  const double left = mass - put_in_fragments(row, counts, changes);
  add_fines(shares, left, changes);
  leaves_[row] = true;
  breakage_.grains[ball] = {};
  outside_.push_back({jar_->within_period(rows_[row].position()), id_[row], 0});
  return true;
}

/// Velocity and spin at this step, after the whole kick of its contact forces, of which the bodies
/// that touch the grain have felt the reaction.
ManyBodySolver::GrainMotion ManyBodySolver::motion_after_kick(std::size_t row) const {
  const VectorPair& half = half_step_[row];
  const Vec3 body_kick =
      0.5 * settings_.time_step * drive_samples(step_, step_ + 1).front().body_acceleration;
  return {Vec3{half.x, half.y, half.z} - body_kick, {half.a, half.b, half.c}};
}
double ManyBodySolver::energy_after_kick(std::size_t row) const {
  const Species& of = pairs_.species(species_[row]);
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  const GrainMotion motion = motion_after_kick(row);
  return 0.5 * (of.mass * squared(motion.velocity + frame.velocity) +
                of.inertia * squared(motion.spin)) -
         of.mass * dot(jar_->gravity(), rows_[row].position() + frame.centre);
}

/// Puts spheres in the place of a grain. They move with it, and turn no faster (bed.6). Returns
/// their mass.
double ManyBodySolver::put_in_fragments(std::size_t row, const std::vector<int>& counts,
                                        std::vector<scene::SizeChange>& changes) {
  const scene::GrainBreakage& rule = *settings_.breakage;
  std::vector<double> radii;
  std::vector<std::int32_t> species;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    radii.insert(radii.end(), static_cast<std::size_t>(counts[k]),
                 pairs_.species(breakage_.species[k]).radius);
    species.insert(species.end(), static_cast<std::size_t>(counts[k]), breakage_.species[k]);
  }
  const GrainState& grain = breakage_.grains[static_cast<std::size_t>(id_[row])];
  Random random(rule.seed() ^ fragment_stream, static_cast<std::uint32_t>(++breakage_.replaced));
  const double radius = rows_[row].radius;
  const std::vector<Vec3> places = packed(radii, radius, random);
  double mass = 0, inertia = 0;
  Vec3 centre;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Species& s = pairs_.species(species[k]);
    mass += s.mass, centre += s.mass * places[k];
  }
  if (mass > 0) centre = (1 / mass) * centre;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Species& s = pairs_.species(species[k]);
    inertia += s.mass * squared(places[k] - centre) + s.inertia;
  }
  const double share = inertia > 0 ? std::min(1.0, 0.4 * mass * radius * radius / inertia) : 0;
  const GrainMotion grain_motion = motion_after_kick(row);
  const Vec3 v = grain_motion.velocity, w = share * grain_motion.spin, change = body_kick_change(),
             middle = rows_[row].position();
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::int32_t ball = outside_.back().ball;
    outside_.pop_back();
    breakage_.grains[static_cast<std::size_t>(ball)] =
        rule.particle(2 * radii[k], grain.draw + 2 + k);
    add_row(ball, species[k], middle + places[k], v + cross(w, places[k] - centre), w);
    energy_balance_.lost_breakage -= energy_of(rows_.size() - 1, change, frame).total();
    breakage_.is_new[static_cast<std::size_t>(ball)] = 1;
    breakage_.new_balls.push_back(ball);
    changes.push_back(
        {time_of(step_), pairs_.species(species[k]).mass, rule.class_of(2 * radii[k]), 0});
  }
  return mass;
}

/// Adds what is left of a grain beside its spheres to the particles that are not simulated.
void ManyBodySolver::add_fines(const std::vector<double>& shares, double mass,
                               std::vector<scene::SizeChange>& changes) {
  const std::size_t first = breakage_.species.size();
  double all = 0;
  for (std::size_t k = first; k < shares.size(); ++k) all += shares[k];
  for (std::size_t k = first; k < shares.size(); ++k) {
    const double part = all > 0 ? mass * shares[k] / all : (k == first ? mass : 0);
    if (part == 0) continue;
    breakage_.fines[k] += part;
    changes.push_back({time_of(step_), part, static_cast<std::int32_t>(k), 0});
  }
}

/// The population balance of the particles that are not simulated (bed.8).
void ManyBodySolver::grind_fines(std::vector<scene::SizeChange>& changes) {
  const std::vector<double> before = breakage_.fines;
  settings_.breakage->grind(breakage_.fines, breakage_.stressed);
  std::ranges::fill(breakage_.stressed, 0.0);
  for (std::size_t k = 0; k < before.size(); ++k)
    if (const double gained = breakage_.fines[k] - before[k]; gained != 0)
      changes.push_back({time_of(step_), gained, static_cast<std::int32_t>(k), 0});
}

/// A contact of a fragment that is new begins where the fragment was put: its overlap presses only
/// as far as it grows (bed.6).
void ManyBodySolver::begin_relaxed(ContactPackets& list, std::size_t n, std::size_t l, bool wall) {
  const ContactPacket& g = list.packets[n];
  const auto i = static_cast<std::size_t>(g.i[l]), j = static_cast<std::size_t>(g.j[l]);
  const auto is_new = [&](std::size_t row) {
    return breakage_.is_new[static_cast<std::size_t>(id_[row])] != 0;
  };
  if (!is_new(i) && (wall || !is_new(j))) return;
  const BallRecord& ball = rows_[i];
  const double distance =
      wall ? jar_->gap(g.j[l], ball.position(), wall_axes_, ball.radius).distance
           : norm(nearest(rows_[j].position() - ball.position())) - rows_[j].radius;
  list.stresses[n].rest[l] = std::max(0.0, ball.radius - distance);
  list.onsets[n][l] = {step_, 0, 0, 0};
}

/// Fragments are new for one step.
void ManyBodySolver::end_new_fragments() {
  for (const std::int32_t ball : breakage_.new_balls)
    breakage_.is_new[static_cast<std::size_t>(ball)] = 0;
  breakage_.new_balls.clear();
}

}  // namespace mahlwerk::soft
