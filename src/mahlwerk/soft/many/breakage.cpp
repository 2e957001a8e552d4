// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Grains that break (docs/theory/bed-breakage.md): the energy that contacts put into each grain,
// and the fragments that take the place of a grain that broke.
namespace mahlwerk::soft {
namespace {

using scene::GrainState;

constexpr std::uint64_t fragment_stream = 0x667261676d656e74;  // apart from other draws of the seed
constexpr int tried_places = 24;  // for a fragment in the sphere of its grain

/// [1] Elastic energy over elastic force times overlap, a constant of a law without adhesion and
/// history (bed.1): 2/5 for Hertz, 1/2 for a linear spring.
double stored_share(const SpeciesPair& pair, const contact::AnyLaw& law) {
  return std::visit(
      [&](const auto& l) {
        double history[contact::law_history_size] = {};
        const double overlap = 1e-3 * pair.effective.radius;
        const double force = l.evaluate(pair.coefficients.data(), history, overlap, 0.0).force;
        return l.elastic_energy(pair.coefficients, history, overlap) / (force * overlap);
      },
      law);
}

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

/// Sets the states of the grains; those that are outside wait to become fragments.
void ManyBodySolver::start_breakage(const std::vector<scene::Ball>& balls) {
  const scene::GrainBreakage& rule = *settings_.breakage;
  BreakageState& b = breakage_;
  b.active = settings_.breakage_from_start ? 1 : 0;
  b.grains.resize(balls.size());
  const auto is_grain = [&](const scene::Ball& ball) {
    return ball.kind == rule.kind() && !ball.outside;
  };
  const std::int64_t count = std::ranges::count_if(balls, is_grain);
  std::int64_t number = 0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (!is_grain(balls[k])) continue;
    b.grains[k] = rule.at_start(number++, count, 2 * balls[k].radius);
    b.powder += balls[k].mass();
  }
  b.fines.assign(static_cast<std::size_t>(rule.classes()), 0);
  b.stressed.assign(scene::GrainBreakage::energy_bins, 0);
  b.is_new.assign(balls.size(), 0);
  Random random(rule.seed() ^ fragment_stream, 0);
  for (const double diameter : rule.diameters()) {
    b.species.push_back(species_of_grain(0.5 * diameter));
    b.due.push_back(random.uniform() * pairs_.species(b.species.back()).mass);
  }
  for (std::size_t n = 0; n < pairs_.all().size(); ++n) {
    const auto row = static_cast<std::int32_t>(n / pairs_.row_length());
    const SpeciesPair& own = pairs_[pairs_.ball_pair_index(row, row)];
    b.energy_share.push_back(pairs_.all()[n].effective.pair.modulus /
                             (2 * own.effective.pair.modulus));
  }
  stored_share_ = stored_share(pairs_[0], *settings_.model.law);
}

std::int32_t ManyBodySolver::species_of_grain(double radius) const {
  const auto all = pairs_.all_species();
  const auto found = std::ranges::min_element(all, {}, [&](const Species& s) {
    return s.kind == settings_.breakage->kind() ? std::abs(s.radius - radius) : geometry::never;
  });
  return static_cast<std::int32_t>(found - all.begin());
}

/// Follows the stressing of the grains, and replaces those that broke, at steps that do not depend
/// on how advance() divides a run.
void ManyBodySolver::break_grains(scene::Observer& observer) {
  if (step_ % stressing_interval != 0 || breakage_.active == 0) return;
  std::vector<scene::SizeChange> changes;
  follow_stressing(changes);
  if (step_ - breakage_.replaced_at >= replacement_interval) replace_broken(changes);
  if (step_ % replacement_interval == 0) grind_fines(changes);
  if (!changes.empty()) observer.size_changes(changes);
}

/// [J] Energy that the contacts of a chunk put into each of its balls (bed.2), into `load_`.
void ManyBodySolver::sum_loads(Chunk& chunk) {
  std::fill(load_.begin() + chunk.first, load_.begin() + chunk.last, 0.0);
  for (ContactPackets* list : {&chunk.own, &chunk.halo, &chunk.wall})
    for (std::size_t n = 0; n < list->packets.size(); ++n) {
      const ContactPacket& g = list->packets[n];
      StressHistory& stress = list->stresses[n];
      for (std::size_t l = 0; l < lanes; ++l) {
        if (!g.touches(l)) continue;
        const double energy = stress.energy[l];
        const double share = breakage_.energy_share[static_cast<std::size_t>(g.species_pair[l])];
        load_[static_cast<std::size_t>(g.i[l])] += share * energy;
        if (list == &chunk.own) load_[static_cast<std::size_t>(g.j[l])] += (1 - share) * energy;
      }
      stress.energy = {};
    }
}

void ManyBodySolver::follow_stressing(std::vector<scene::SizeChange>& changes) {
  load_.resize(rows_.size());
  std::vector<Stressing> of_chunk(chunks_.size());
  const double share = cushioned_share();
  team_.run_items(share_, [&](int, std::int32_t c, std::int32_t) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
    sum_loads(chunk);
    for (std::int32_t row = chunk.first; row < chunk.last; ++row) {
      const auto k = static_cast<std::size_t>(row);
      if (pairs_.species(species_[k]).kind == settings_.breakage->kind())
        stress(k, share, of_chunk[static_cast<std::size_t>(c)]);
    }
  });
  for (const Stressing& one : of_chunk) {
    changes.insert(changes.end(), one.changes.begin(), one.changes.end());
    for (std::size_t n = 0; n < one.fines.size(); ++n) breakage_.stressed[n] += one.fines[n];
    energy_balance_.broken_grains += one.broken;
  }
}

/// [1] Share of the energy of a stressing that a grain receives, the rest going to the fines around
/// it, by their masses (bed.7).
double ManyBodySolver::cushioned_share() const {
  const double fines = std::accumulate(breakage_.fines.begin(), breakage_.fines.end(), 0.0);
  return 1 - fines / breakage_.powder;
}

/// Follows the stressing of a grain: it breaks at the largest energy so far, and is weakened once
/// half of that is gone (bed.3).
void ManyBodySolver::stress(std::size_t row, double share, Stressing& out) {
  GrainState& grain = breakage_.grains[static_cast<std::size_t>(id_[row])];
  if (grain.phase == GrainState::Phase::replaced) return;
  const double mass = pairs_.species(species_[row]).mass, now = share * load_[row];
  const auto stress_fines = [&](double energy) {
    if (!(share < 1) || !(energy > 0)) return;
    out.fines.resize(scene::GrainBreakage::energy_bins);
    out.fines[static_cast<std::size_t>(scene::GrainBreakage::bin_of(energy))] +=
        mass * (1 - share) / share;
  };
  if (now > grain.peak) {
    grain.peak = now;
    if (grain.phase == GrainState::Phase::broke || !settings_.breakage->breaks(grain, now / mass))
      return;
    stress_fines(now / mass);
    grain.broken = now / mass;
    grain.phase = GrainState::Phase::replaced;
    if (breakage_.species.empty()) become_finer(grain, mass, out);
  } else if (now < 0.5 * grain.peak) {
    stress_fines(grain.peak / mass);
    if (grain.phase == GrainState::Phase::whole)
      settings_.breakage->weaken(grain, grain.peak / mass);
    grain.phase = GrainState::Phase::whole;
    grain.peak = now;
  }
}

/// The sphere of a grain that broke stays, and stands for particles of one size of the fragments,
/// drawn by mass (bed.4).
void ManyBodySolver::become_finer(GrainState& grain, double mass, Stressing& out) const {
  const scene::GrainBreakage& rule = *settings_.breakage;
  const double size = rule.fragment_size(grain);
  const GrainState was = grain;
  grain = rule.particle(std::min(size, grain.size), grain.draw + 2);
  grain.peak = was.peak, grain.broken = was.broken, grain.phase = GrainState::Phase::broke;
  ++out.broken;
  out.changes.push_back({time_of(step_), -mass, rule.class_of(was.size), 1});
  out.changes.push_back({time_of(step_), mass, rule.class_of(grain.size), 0});
}

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
ManyBodySolver::BodyMotion ManyBodySolver::motion_after_kick(std::size_t row) const {
  const VectorPair& half = half_step_[row];
  const Vec3 body_kick =
      0.5 * settings_.time_step * drive_samples(step_, step_ + 1).front().body_acceleration;
  return {Vec3{half.x, half.y, half.z} - body_kick, {half.a, half.b, half.c}};
}
double ManyBodySolver::energy_after_kick(std::size_t row) const {
  const Species& of = pairs_.species(species_[row]);
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  const BodyMotion motion = motion_after_kick(row);
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
  const BodyMotion grain_motion = motion_after_kick(row);
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
