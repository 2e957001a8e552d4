// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/drive.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// State of the balls, forces and checkpoints.
namespace mahlwerk::soft {
namespace {

/// In the format of a vector.
template <class T>
void serialize_list(Archive& archive, BlockList<T>& list) {
  auto count = static_cast<std::uint64_t>(list.size());
  archive(count);
  for (std::size_t n = 0; n < count; ++n)
    archive(archive.reading() ? list.emplace_back() : list[n]);
}

}  // namespace

Vec3 ManyBodySolver::body_kick_change() const {
  const std::vector<DriveSample> b = drive_samples(step_, step_ + 1);
  return 0.5 * settings_.time_step * (b[1].body_acceleration - b[0].body_acceleration);
}

/// Velocity at the present step, from the stored half-step and predicted velocities (dem.26).
Vec3 ManyBodySolver::velocity(std::size_t row, const Vec3& body_kick_change) const {
  const VectorPair& half = half_step_[row];
  const BallRecord& predicted = next_rows_[row];
  return 2.0 * Vec3{half.x, half.y, half.z} - Vec3{predicted.u, predicted.v, predicted.w} +
         body_kick_change;
}
Vec3 ManyBodySolver::spin(std::size_t row) const {
  const VectorPair& half = half_step_[row];
  const SpinRecord& predicted = next_spins_[row];
  return 2.0 * Vec3{half.a, half.b, half.c} - Vec3{predicted.x, predicted.y, predicted.z};
}

std::vector<scene::Ball> ManyBodySolver::balls() const {
  std::vector<scene::Ball> all(ball_count_);
  const Vec3 change = body_kick_change();
  for (std::size_t k = 0; k < id_.size(); ++k) {
    if (is_member(k)) continue;
    const Species& s = pairs_.species(species_[k]);
    const Vec3 position = jar_->within_period(rows_[k].position());
    all[static_cast<std::size_t>(id_[k])] = {
        s.radius, s.density, position, velocity(k, change), spin(k), s.kind, s.inertia_ratio};
  }
  add_bodies(all, change);
  for (const OutsideBall& one : outside_) {
    const auto ball = static_cast<std::size_t>(one.ball);
    const Species& s = pairs_.species_of(ball);
    all[ball] = {s.radius, s.density, one.position, {}, {}, s.kind, s.inertia_ratio, true};
  }
  return all;
}

/// Contact forces, recovered from the rows: the predicted velocity of the next step is the
/// half-step velocity, plus half a kick of the contacts, plus half a step of the next body
/// acceleration (dem.26).
std::vector<Vec3> ManyBodySolver::forces() const {
  std::vector<Vec3> all(ball_count_);
  const double half_dt = 0.5 * settings_.time_step;
  const Vec3 pull = half_dt * drive_samples(step_ + 1, step_ + 1).front().body_acceleration;
  add_body_forces(all, pull);
  for (std::size_t k = 0; k < id_.size(); ++k) {
    if (is_member(k)) continue;
    const VectorPair& half = half_step_[k];
    const BallRecord& predicted = next_rows_[k];
    const Vec3 gained =
        Vec3{predicted.u, predicted.v, predicted.w} - Vec3{half.x, half.y, half.z} - pull;
    all[static_cast<std::size_t>(id_[k])] = pairs_.species(species_[k]).mass / half_dt * gained;
  }
  return all;
}

void ManyBodySolver::serialize(Archive& archive) {
  if (archive.reading() && archive.begins_with(SolverState::mark)) {
    std::int64_t mark = 0;
    SolverState state;
    std::string lists;  // of DeviceSolver
    state.serialize(archive(mark));
    archive(lists);
    return take(state);
  }
  const std::size_t balls = rows_.size() + outside_.size();
  if (settings_.flow) archive(outside_)(fresh_)(tries_)(next_feed_);
  if (settings_.breakage) breakage_.serialize(archive(outside_));
  archive(step_)(reference_step_)(
      skin_)(largest_coordinate_)(used_skin_)(tests_at_rebin_)(pairs_rebinned_)(tuning_);
  archive(rows_)(next_rows_)(reference_positions_)(spins_)(next_spins_)(half_step_);
  if (rows_.size() + outside_.size() != balls) throw Archive::broken();
  archive(id_)(species_)(contacts_of_)(displacements_)(predicted_means_)(class_first_);
  if (bodies_.has_members()) serialize_bodies(archive);
  auto count = static_cast<std::uint64_t>(chunks_.size());
  archive(count);
  if (archive.reading()) {
    if (count > rows_.size() + 1) throw Archive::broken();
    chunks_ = std::vector<Chunk>(count);
  }
  for (Chunk& c : chunks_) {
    archive(c.first)(c.last)(c.max_gap_decrease)(c.max_wall_gap_decrease)(c.balls_in_contact)(
        c.sums)(c.neighbour_chunks);
    if (!loads_.empty()) archive(c.loads);
    for (ContactPackets* list : {&c.own, &c.halo, &c.wall}) {
      serialize_list(archive, list->packets);
      serialize_list(archive, list->onsets);
      serialize_list(archive, list->optional_histories);
      serialize_list(archive, list->friction_histories);
      serialize_list(archive, list->parameters);
      serialize_list(archive, list->wall_normals);
      serialize_list(archive, list->hulls);
      serialize_list(archive, list->stresses);
      archive(list->free);
    }
    for (VerletList* w : {&c.ball_pairs, &c.wall_pairs}) archive(w->pairs)(w->end)(w->separated);
    if (body_species_.has_rounded()) archive(c.near_pairs);
  }
  archive(energy_balance_)(watch_)(rested_steps_)(target_time_);
  rest_.serialize(archive);
  if (!loads_.empty()) archive(loads_);
  if (kinematics::Drive* drive = jar_->drive()) drive->serialize(archive);
  if (!archive.reading()) return;
  wall_axes_ = jar_->axes(mill_time(step_));
  share_work();
}

}  // namespace mahlwerk::soft
