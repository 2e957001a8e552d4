// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"

namespace mahlwerk::soft {
namespace {

constexpr std::int64_t energy_check_interval = 64;  // steps between two checks of the energy
constexpr std::int64_t never_halt = std::numeric_limits<std::int64_t>::max();

template <std::size_t size, class T>
void put_bytes(unsigned char (&to)[size], const T* from, std::size_t bytes) {
  std::memset(to, 0, size);
  std::memcpy(to, from, bytes);
}

}  // namespace

DeviceSolver::DeviceSolver(const scene::Chamber& chamber, const std::vector<scene::Ball>& balls,
                           const Settings& settings, const contact::PairTable& pairs, double start)
    : chamber_(chamber),
      pair_table_(pairs),
      jar_(moving_wall(chamber)),
      settings_(settings),
      pairs_(balls, pairs, *settings.model.law),
      device_(settings.device()),
      law_(std::visit([]<class L>(const L&) { return law_kernels<L>(); }, *settings_.model.law)),
      shape_(shape_kernels(*chamber.shape)),
      start_(start),
      has_history_(
          std::visit([]<class L>(const L&) { return L::has_history; }, *settings_.model.law) ||
          contact::rule_of(settings.model.rolling).has_history ||
          settings.model.rescaled_unloading),
      has_friction_history_(settings.model.partial_slip ||
                            settings.model.twisting != contact::Twisting::none),
      balls_(std::make_unique<BallMemory>(*device_)),
      sorted_(std::make_unique<BallMemory>(*device_)),
      list_(std::make_unique<ListMemory>(*device_)),
      old_list_(std::make_unique<ListMemory>(*device_)),
      reference_(*device_),
      wall_points_(*device_),
      forces_(*device_),
      sums_(*device_),
      incoming_first_(*device_),
      incoming_(*device_),
      cell_(*device_),
      order_(*device_),
      cell_first_(*device_),
      cursor_(*device_),
      scan_partials_(*device_),
      balls_in_contact_(*device_),
      size_class_(*device_),
      partial_(*device_),
      separation_energy_(*device_),
      species_mass_(*device_),
      species_inertia_(*device_),
      ended_(*device_),
      control_(*device_),
      inputs_(*device_),
      parameters_(*device_),
      half_kicks_(*device_) {
  std::visit([&](const auto& law) { put_bytes(arrays_.law, &law, sizeof law); },
             *settings_.model.law);
  set_shape(*chamber.shape);
  arrays_.constants = step_constants(settings_, jar_->periods());
  arrays_.faces = jar_->faces();
  arrays_.first_rotor_face = jar_->first_rotor_face();
  set_species(pairs);
  set_balls(balls);
  const scene::EnergyBalance now = energy_balance();
  energy_balance_.initial_energy = now.kinetic + now.potential + now.elastic;
  watch_.begin(now);
  this->balls();  // the last that is known, should the device fail
}

/// The shape, and copies of its arrays if it has some.
void DeviceSolver::set_shape(const geometry::AnyShape& shape) {
  const auto bytes = shape_for_kernels(shape, [&](const void* from, std::size_t count) {
    unsigned char* to = shape_arrays_.emplace_back(*device_).reserve(count);
    device_->write(to, from, count);
    return to;
  });
  put_bytes(arrays_.shape, bytes.data(), bytes.size());
}

/// Parameters of all species and pairs of them.
void DeviceSolver::set_species(const contact::PairTable& pairs) {
  arrays_.species = static_cast<std::int32_t>(pairs_.all_species().size());
  arrays_.species_row = arrays_.species + pairs.faces();
  const std::vector<PairParameters> parameters =
      all_pair_parameters(pairs_, pairs.faces(), settings_);
  std::vector<double> released, mass, inertia;
  std::vector<VectorPair> half_kicks;
  for (const PairParameters& p : parameters)
    released.push_back(separation_energy(p, 0, *settings_.model.law));
  for (const SpeciesPair& p : pairs_.all())
    arrays_.pull_off_distance = std::max(arrays_.pull_off_distance, p.pull_off_distance);
  for (const Species& s : pairs_.all_species()) {
    const double kick = 0.5 * settings_.time_step / s.mass,
                 spin_kick = 0.5 * settings_.time_step / s.inertia;
    half_kicks.push_back({kick, kick, kick, 0, spin_kick, spin_kick, spin_kick, 0});
    mass.push_back(s.mass), inertia.push_back(s.inertia);
  }
  const SizeClasses classes(pairs_.all_species(), DeviceArrays::most_classes);
  arrays_.classes = static_cast<int>(classes.radius.size());
  std::ranges::copy(classes.radius, arrays_.class_radius);
  smallest_radius_ = classes.smallest;
  arrays_.skin = 0.3 * smallest_radius_;
  arrays_.parameters = parameters_.write(parameters);
  arrays_.separation_energy = separation_energy_.write(released);
  arrays_.half_kicks = half_kicks_.write(half_kicks);
  arrays_.mass = species_mass_.write(mass);
  arrays_.inertia = species_inertia_.write(inertia);
  arrays_.size_class = size_class_.write(classes.of);
}

/// Balls of step 0, whose lists say what the start presses together; then their rows one step
/// ahead, without contact forces (dem.26).
void DeviceSolver::set_balls(const std::vector<scene::Ball>& balls) {
  const std::size_t count = balls.size();
  arrays_.balls = static_cast<std::int32_t>(count);
  arrays_.partials = std::clamp(arrays_.balls, 64, DeviceArrays::most_partials);
  HostBalls start;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3& x = balls[k].position;
    mass_ += pairs_.species_of(k).mass;
    start.rows.push_back({x.x, x.y, x.z, balls[k].radius, 0, 0, 0, 0});
    start.species.push_back(pairs_.species_index(k));
    start.id.push_back(static_cast<std::int32_t>(k));
  }
  arrays_.now = balls_->reserve(count), arrays_.sorted = sorted_->reserve(count);
  arrays_.reference = reference_.reserve(count);
  arrays_.cell = cell_.reserve(count), arrays_.order = order_.reserve(count);
  arrays_.cursor = cursor_.reserve(count);
  arrays_.incoming_first = incoming_first_.reserve(count + 1);
  arrays_.balls_in_contact = balls_in_contact_.zeroed(DeviceArrays::contact_counters);
  arrays_.scan_partials = scan_partials_.reserve(static_cast<std::size_t>(arrays_.partials));
  arrays_.partial = partial_.reserve(static_cast<std::size_t>(arrays_.partials) *
                                     sizeof(ContactSums) / sizeof(double));
  arrays_.control = control_.reserve(1);
  balls_->rows.write(start.rows), balls_->species.write(start.species), balls_->id.write(start.id);
  balls_->spins.zeroed(count), balls_->half_step.zeroed(count);  // an error of the lists tells them
  load_inputs(0, 1);
  rebuild_lists(0);
  check_start();
  const HostBalls sorted = read_balls();
  start = sorted;
  std::vector<DriveSample> drive(2);
  jar_->sample_drive(start_, settings_.time_step, 0, drive);
  const double dt = settings_.time_step;
  for (std::size_t row = 0; row < count; ++row) {
    const scene::Ball& ball = balls[static_cast<std::size_t>(sorted.id[row])];
    const Vec3 v = ball.velocity + 0.5 * dt * drive[0].body_acceleration,
               predicted = v + 0.5 * dt * drive[1].body_acceleration, x = ball.position + dt * v;
    const Vec3& w = ball.spin;
    start.half_step[row] = {v.x, v.y, v.z, 0, w.x, w.y, w.z, 0};
    start.rows[row] = {x.x, x.y, x.z, ball.radius, predicted.x, predicted.y, predicted.z, 0};
    start.spins[row] = {w.x, w.y, w.z, 0};
  }
  balls_->rows.write(start.rows), balls_->spins.write(start.spins);
  balls_->half_step.write(start.half_step);
  lists_due_ = true;
}

/// The drive of the steps `first` to `last`.
void DeviceSolver::load_inputs(std::int64_t first, std::int64_t last) {
  const auto count = static_cast<std::size_t>(last - first) + 1;
  std::vector<DriveSample> drive(count);
  jar_->sample_drive(start_, settings_.time_step, first, drive);
  std::vector<StepInput> inputs(count);
  for (std::size_t k = 0; k < count; ++k)
    inputs[k] = {drive[k], jar_->axes(mill_time(first + static_cast<std::int64_t>(k)))};
  arrays_.inputs = inputs_.write(inputs);
  arrays_.first_input = first;
}

void DeviceSolver::advance(double time, scene::Observer& observer) {
  if (!failure_.empty()) throw DeviceError(failure_);
  try {
    advance_steps(time, observer);
  } catch (const DeviceError& e) {
    failure_ = e.what();
    throw;
  }
}

void DeviceSolver::advance_steps(double time, scene::Observer& observer) {
  const auto until = static_cast<std::int64_t>(std::ceil(time / settings_.time_step - 1e-6));
  target_time_ = time;
  while (step_ < until) {
    if (rest_.at_rest) return pass_rest(until);
    const std::int64_t end =
        std::min(until, (step_ / energy_check_interval + 1) * energy_check_interval);
    load_inputs(step_ + 1, end + 1);
    while (step_ < end) {
      if (stopped()) return;
      const Control control = run_steps(end);
      hand_over(static_cast<std::size_t>(control.ended), observer);
      if (control.bad_ball != Control::no_ball) stop_at_last_known(control.bad_ball);
    }
    if (step_ % energy_check_interval != 0) continue;
    collect_sums();
    check_energy();
    check_rest();
    if (!failure_.empty()) throw DeviceError(failure_);
  }
}

/// The last step whose contacts the lists are sure to hold, by the motion of the wall.
std::int64_t DeviceSolver::last_step_of_lists() const {
  const double speed = jar_->max_wall_speed();
  if (!(speed > 0)) return never_halt;
  const double steps = 0.5 * arrays_.skin / (speed * settings_.time_step);
  return reference_step_ + static_cast<std::int64_t>(std::min(steps, 1e15));
}

/// Computes steps up to `end`, or to one after which the lists must be built or records handed
/// over.
Control DeviceSolver::run_steps(std::int64_t end) {
  if (lists_due_ || step_ + 1 > last_step_of_lists()) rebuild_lists(step_ + 1);
  const std::int64_t last = std::min(end, std::max(step_ + 1, last_step_of_lists()));
  control_.write({Control{.step = step_ + 1, .halt_at = never_halt}});
  for (std::int64_t step = step_ + 1; step <= last; ++step) {
    run(shape_.find_wall_point, arrays_.list.walls);
    run(law_.compute_contact, arrays_.list.size());
    run(common_kernels().move_ball, arrays_.balls);
    run(common_kernels().end_step, 1);
  }
  const Control control = control_.read(1).front();
  tests_ += (control.step - 1 - step_) * arrays_.list.size();
  step_ = control.step - 1;
  lists_due_ = control.moved != 0;
  return control;
}

/// Hands over the records of the contacts that have ended, in the order of steps and pairs.
void DeviceSolver::hand_over(std::size_t count, scene::Observer& observer) {
  std::vector<EndedContact> ended = ended_.read(count);
  std::ranges::sort(ended, {}, [](const EndedContact& e) { return std::pair(e.step, e.index); });
  std::vector<scene::Collision> all;
  all.reserve(count);
  for (const EndedContact& e : ended) {
    all.push_back(collision(e));
    ++energy_balance_.collisions;
    const double duration = all.back().duration;
    const ContactOnset onset{.step = e.onset_step, .approach = e.approach};
    if (is_sustained(duration, onset, pairs_[e.species_pair], *settings_.model.law))
      ++energy_balance_.lasting_contacts;
  }
  if (!all.empty()) observer.collisions(all);
}

scene::Collision DeviceSolver::collision(const EndedContact& e) const {
  const double t = mill_time(e.step);
  const int face = e.other < 0 ? ~e.other : -1;
  const Vec3 separation = e.other < 0 || !arrays_.constants.periodic
                              ? e.separation
                              : nearest_image(e.separation, jar_->periods());
  const Vec3 normal = (1 / norm(separation)) * separation,
             where = jar_->within_period(e.position) + e.radius * normal;
  return {.time = time_of(e.onset_step),
          .duration = time_of(e.step - e.onset_step),
          .ball = e.ball,
          .other = e.other,
          .where = jar_->to_face_axes(where, t, face),
          .normal = jar_->to_face_axes(normal, t, face),
          .mass = pairs_[e.species_pair].effective.mass,
          .approach = e.approach,
          .slip = e.slip,
          .glide = e.glide,
          .impulse = e.impulse,
          .lost_normal = e.lost_normal,
          .lost_tangential = e.lost_tangential};
}

void DeviceSolver::stop(std::size_t ball, const char* why) const {
  refuse_start_outside(step_, ball, why);
  const HostBalls all = read_balls();
  const auto row = static_cast<std::size_t>(
      std::ranges::find(all.id, static_cast<std::int32_t>(ball)) - all.id.begin());
  const scene::Ball at = present(all, row, body_kick_change());
  throw unstable_run_error(time_of(step_), ball, why, at.position, at.velocity,
                           settings_.time_step);
}

/// Stops a run in which a ball is nowhere. What is known of the balls is from before.
void DeviceSolver::stop_at_last_known(std::int32_t ball) {
  const auto number = static_cast<std::size_t>(ball);
  const scene::Ball& last = last_balls_[number];
  failure_ = not_finite_message;
  throw unstable_run_error(time_of(step_), number, not_finite_message, last.position, last.velocity,
                           settings_.time_step);
}

}  // namespace mahlwerk::soft
