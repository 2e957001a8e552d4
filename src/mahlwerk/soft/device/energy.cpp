// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>

#include "mahlwerk/soft/device/contact_kernels.hpp"
#include "mahlwerk/soft/device/solver.hpp"
#include "mahlwerk/soft/diagnostics.hpp"

// Sums over balls and contacts: partial sums of fixed parts on the device, added in their order.
namespace mahlwerk::soft {

template <class Totals>
std::vector<Totals> DeviceSolver::partial_sums(const Kernel& kernel,
                                               const DeviceArrays& arrays) const {
  static_assert(sizeof(Totals) <= sizeof(ContactSums));
  const auto count = static_cast<std::size_t>(arrays.partials);
  device_->run(kernel, arrays, arrays.partials);
  std::vector<Totals> all(count);
  device_->read(all.data(), arrays.partial, count * sizeof(Totals));
  return all;
}
template std::vector<Corners> DeviceSolver::partial_sums(const Kernel&, const DeviceArrays&) const;

ContactSums DeviceSolver::work(const Kernel& kernel) const {
  ContactSums sum;
  for (const ContactSums& part : partial_sums<ContactSums>(kernel, arrays_)) sum.add(part);
  return sum;
}

/// Sum over the steps since the last collection of the number of balls in contact.
std::int64_t DeviceSolver::count_contacts() const {
  std::int64_t sum = 0;
  for (const std::int32_t n : balls_in_contact_.read(DeviceArrays::contact_counters)) sum += n;
  return sum;
}

/// Moves the sums of the device to the energy balance. Called only at steps that do not depend on
/// how advance() divides a run, because each addition rounds.
void DeviceSolver::collect_sums() {
  add_sums(energy_balance_, work(common_kernels().collect_work));
  contact_steps_ += count_contacts();
  balls_in_contact_.zeroed(DeviceArrays::contact_counters);
}

void DeviceSolver::add_sums(scene::EnergyBalance& a, const ContactSums& sums) const {
  a.lost_normal += sums.normal;
  a.lost_tangential += sums.tangential;
  a.lost_rolling += sums.rolling;
  a.slid += sums.sliding;
  a.wall_work += sums.wall;
  a.deepest_overlap = std::max(a.deepest_overlap, sums.max_overlap);
}

scene::EnergyBalance DeviceSolver::energy_balance() const {
  if (failure_.empty()) try {
      last_balance_ = balance_on_device();
    } catch (const DeviceError& e) {
      failure_ = e.what();
    }
  return last_balance_;
}

scene::EnergyBalance DeviceSolver::balance_on_device() const {
  scene::EnergyBalance a = energy_balance_;
  add_sums(a, work(common_kernels().sum_work));
  a.time = time_of(step_);
  a.time_steps = step_ - rested_steps_;
  a.search_steps = tests_;
  a.contact_time = time_of(contact_steps_ + count_contacts());
  if (a.time < target_time_ && target_time_ - a.time < 1e-5 * settings_.time_step)
    a.time = target_time_;  // rounding
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  DeviceArrays arrays = arrays_;
  arrays.state_sums = {body_kick_change(), frame.velocity, frame.centre, jar_->gravity()};
  a.kinetic = a.potential = a.elastic = 0;
  for (const BallTotals& part : partial_sums<BallTotals>(common_kernels().sum_balls, arrays))
    a.kinetic += part.kinetic, a.potential += part.potential;
  ContactTotals open;
  for (const ContactTotals& part : partial_sums<ContactTotals>(law_.sum_contacts, arrays)) {
    open.stored_normal += part.stored_normal;
    open.stored_tangential += part.stored_tangential;
    open.stored_twisting += part.stored_twisting;
    open.work_done += part.work_done;
  }
  a.elastic = open.stored_normal + open.stored_tangential + open.stored_twisting;
  a.lost_open += open.work_done - open.stored_tangential - open.stored_twisting;
  a.lost_tangential -= open.stored_tangential;  // stored, not dissipated
  a.lost_rolling -= open.stored_twisting;
  // Contacts begin in the first step; those of the starting positions are pressed before it.
  if (step_ == 0) a.elastic = start_energy_;
  return a;
}

/// The sums of a contact keep what it stores.
void DeviceSolver::begin_counting() {
  if (failure_.empty()) try {
      run(law_.begin_counting, arrays_.list.size());
    } catch (const DeviceError& e) {
      failure_ = e.what();
    }
}

void DeviceSolver::check_energy() {
  const scene::EnergyBalance a = energy_balance();
  const double wall = jar_->max_lab_wall_speed(mill_time(step_));
  const Species& first = pairs_.species(0);
  const double least = first.mass * norm(jar_->gravity()) * first.radius;
  if (!watch_.update_and_test(a, 0.5 * mass_ * wall * wall, least)) return;
  const std::vector<scene::Ball> all = balls();
  std::size_t fastest = 0;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (!(squared(all[k].velocity) <= squared(all[fastest].velocity))) fastest = k;
  stop(fastest, energy_jump_message);
}

void DeviceSolver::check_rest() {
  if (!jar_->stands_still()) return;
  const std::vector<scene::Ball> all = balls();
  rest_.update(time_of(step_), settings_, *jar_, all.size(), [&](std::size_t k) {
    return std::tuple(pairs_.species_of(k), all[k].velocity, all[k].spin);
  });
}

/// Nothing changes but the time of contact.
void DeviceSolver::pass_rest(std::int64_t until) {
  const auto size = static_cast<std::size_t>(arrays_.list.size());
  const std::vector<std::int32_t> i = list_->i.read(size), j = list_->j.read(size);
  const std::vector<Touch> touch = list_->touch.read(size);
  std::vector<bool> touches(static_cast<std::size_t>(arrays_.balls));
  for (std::size_t p = 0; p < size; ++p) {
    if (touch[p] != Touch::touching) continue;
    touches[static_cast<std::size_t>(i[p])] = true;
    if (p < static_cast<std::size_t>(arrays_.list.pairs))
      touches[static_cast<std::size_t>(j[p])] = true;
  }
  contact_steps_ += (until - step_) * std::ranges::count(touches, true);
  rested_steps_ += until - step_;
  step_ = until;
}

}  // namespace mahlwerk::soft
