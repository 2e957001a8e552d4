// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/solver.hpp"

// State of the balls, forces and checkpoints.
namespace mahlwerk::soft {

DeviceSolver::HostBalls DeviceSolver::read_balls() const {
  const auto count = static_cast<std::size_t>(arrays_.balls);
  return {balls_->rows.read(count), balls_->spins.read(count), balls_->half_step.read(count),
          balls_->species.read(count), balls_->id.read(count)};
}

Vec3 DeviceSolver::body_kick_change() const {
  std::vector<DriveSample> drive(2);
  jar_->sample_drive(start_, settings_.time_step, step_, drive);
  return 0.5 * settings_.time_step * (drive[1].body_acceleration - drive[0].body_acceleration);
}

/// A ball at the present step (dem.26). Rows are one step ahead.
scene::Ball DeviceSolver::present(const HostBalls& all, std::size_t row,
                                  const Vec3& kick_change) const {
  const VectorPair& half = all.half_step[row];
  const BallRecord& ahead = all.rows[row];
  const SpinRecord& spin = all.spins[row];
  const Species& s = pairs_.species(all.species[row]);
  const Vec3 v{half.x, half.y, half.z};
  return {s.radius,
          s.density,
          jar_->within_period(ahead.position() - settings_.time_step * v),
          2.0 * v - Vec3{ahead.u, ahead.v, ahead.w} + kick_change,
          2.0 * Vec3{half.a, half.b, half.c} - Vec3{spin.x, spin.y, spin.z},
          s.kind,
          s.inertia_ratio};
}

std::vector<scene::Ball> DeviceSolver::balls() const {
  if (failure_.empty()) try {
      last_balls_ = balls_on_device();
    } catch (const DeviceError& e) {
      failure_ = e.what();
    }
  return last_balls_;
}

std::vector<scene::Ball> DeviceSolver::balls_on_device() const {
  const HostBalls all = read_balls();
  const Vec3 change = body_kick_change();
  std::vector<scene::Ball> balls(all.id.size());
  for (std::size_t row = 0; row < balls.size(); ++row)
    balls[static_cast<std::size_t>(all.id[row])] = present(all, row, change);
  return balls;
}

/// Contact forces, as ManyBodySolver recovers them from the velocities.
std::vector<Vec3> DeviceSolver::forces() const {
  if (!failure_.empty()) return std::vector<Vec3>(last_balls_.size());
  const HostBalls all = read_balls();
  std::vector<DriveSample> next(1);
  jar_->sample_drive(start_, settings_.time_step, step_ + 1, next);
  const double half_dt = 0.5 * settings_.time_step;
  const Vec3 pull = half_dt * next.front().body_acceleration;
  std::vector<Vec3> forces(all.id.size());
  for (std::size_t row = 0; row < forces.size(); ++row) {
    const VectorPair& half = all.half_step[row];
    const BallRecord& ahead = all.rows[row];
    const Vec3 gained = Vec3{ahead.u, ahead.v, ahead.w} - Vec3{half.x, half.y, half.z} - pull;
    forces[static_cast<std::size_t>(all.id[row])] =
        pairs_.species(all.species[row]).mass / half_dt * gained;
  }
  return forces;
}

/// The state as any solver of many balls takes it, and the lists, with which this one goes on to
/// the bit. Once the device has failed, the state is what is known of the balls: its run has ended.
void DeviceSolver::serialize(Archive& archive) {
  if (archive.reading()) return read_state(archive);
  std::int64_t mark = SolverState::mark;
  SolverState common;
  Archive own;
  if (failure_.empty()) try {
      common = state();
      serialize_lists(own);
    } catch (const DeviceError& e) {
      failure_ = e.what();
    }
  std::string lists = own.bytes();
  if (!failure_.empty()) common = last_known(), lists.clear();
  common.serialize(archive(mark));
  archive(lists);
}

void DeviceSolver::read_state(Archive& archive) {
  if (!archive.begins_with(SolverState::mark)) return take(state_of_many(archive));
  std::int64_t mark = 0;
  SolverState common;
  std::string lists;
  common.serialize(archive(mark));
  archive(lists);
  if (lists.empty()) return take(common);
  Archive own(lists);
  serialize_lists(own);
  own.finish();
}

/// Everything that the next step reads; what a rebuild makes anew is left out.
void DeviceSolver::serialize_lists(Archive& archive) {
  const bool reading = archive.reading();
  const auto array = [&](auto& memory, auto*& at, std::size_t count) {
    using T = std::remove_cvref_t<decltype(*at)>;
    std::vector<T> all;
    if (!reading) all = memory.read(count);
    archive(all);
    if (!reading) return;
    if (all.size() != count) throw Archive::broken();
    at = memory.write(all);
  };
  archive(step_)(reference_step_)(
      rested_steps_)(tests_)(contact_steps_)(target_time_)(lists_due_)(energy_balance_)(watch_)(arrays_
                                                                                                    .skin);
  rest_.serialize(archive);
  const auto balls = static_cast<std::size_t>(arrays_.balls);
  array(balls_->rows, arrays_.now.rows, balls);
  array(balls_->spins, arrays_.now.spins, balls);
  array(balls_->half_step, arrays_.now.half_step, balls);
  array(balls_->species, arrays_.now.species, balls);
  array(balls_->id, arrays_.now.id, balls);
  array(reference_, arrays_.reference, balls);
  array(balls_in_contact_, arrays_.balls_in_contact, DeviceArrays::contact_counters);
  ContactList& list = arrays_.list;
  std::int32_t pairs = list.pairs, walls = list.walls;
  archive(pairs)(walls);
  if (pairs < 0 || walls < 0) throw Archive::broken();
  if (reading) list.pairs = pairs, list.walls = walls, reserve_pairs(list.size());
  const auto count = static_cast<std::size_t>(list.size());
  array(list_->pair_first, list.pair_first, balls + 1);
  array(list_->wall_first, list.wall_first, balls + 1);
  array(list_->i, list.i, count);
  array(list_->j, list.j, count);
  array(list_->touch, list.touch, count);
  array(list_->state, list.state, count);
  if (has_history_) array(list_->optional, list.optional, count);
  if (has_friction_history_) array(list_->friction, list.friction, count);
  array(list_->normals, list.normals, static_cast<std::size_t>(walls));
  array(wall_points_, arrays_.wall_points, static_cast<std::size_t>(walls));
  array(sums_, arrays_.sums, count);
  if (reading) find_incoming();
}

}  // namespace mahlwerk::soft
