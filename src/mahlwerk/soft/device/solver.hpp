// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/device/ball_kernels.hpp"
#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/device/kernels.hpp"
#include "mahlwerk/soft/device/list_kernels.hpp"
#include "mahlwerk/soft/energy_watch.hpp"
#include "mahlwerk/soft/rest_watch.hpp"
#include "mahlwerk/soft/settings.hpp"
#include "mahlwerk/soft/solver_state.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// The soft engine on a device (docs/theory/soft.md): the run's arrays stay in its memory, and each
/// step is a few kernels. The host gives the motion of the jar and takes records and sums. Results
/// have the same bits on every device.
class DeviceSolver final : public scene::Engine {
 public:
  DeviceSolver(const scene::Chamber& chamber, const std::vector<scene::Ball>& balls,
               const Settings& settings, const contact::PairTable& pairs, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::EnergyBalance energy_balance() const override;
  void begin_counting() override;
  std::vector<scene::Ball> balls() const override;
  std::vector<Vec3> forces() const override;
  void serialize(Archive& archive) override;
  SolverState state() const;

 private:
  // The main loop (solver.cpp).
  void advance_steps(double time, scene::Observer& observer);
  void set_shape(const geometry::AnyShape& shape);
  void set_species(const contact::PairTable& pairs);
  void set_balls(const std::vector<scene::Ball>& balls);
  void load_inputs(std::int64_t first, std::int64_t last);
  Control run_steps(std::int64_t end);
  std::int64_t last_step_of_lists() const;
  void hand_over(std::size_t count, scene::Observer& observer);
  scene::Collision collision(const EndedContact& of) const;
  void run(const Kernel& kernel, std::int64_t count) const { device_->run(kernel, arrays_, count); }
  double mill_time(std::int64_t step) const { return start_ + time_of(step); }
  double time_of(std::int64_t step) const {
    return static_cast<double>(step) * settings_.time_step;
  }
  [[noreturn]] void stop(std::size_t ball, const char* why) const;
  [[noreturn]] void stop_at_last_known(std::int32_t ball);

  // Lists of pairs (lists.cpp).
  void rebuild_lists(std::int64_t step);
  void tune_skin(std::int64_t lasted);
  void sort_into_cells();
  Corners corners() const;
  void set_grids(const Corners& corners);
  void scan(std::int32_t* numbers, std::int32_t count);
  std::int32_t last_of(const std::int32_t* numbers, std::int32_t count) const;
  void find_pairs();
  void reserve_pairs(std::int32_t count);
  void find_incoming();
  void check_start();

  // Energy (energy.cpp).
  scene::EnergyBalance balance_on_device() const;
  void collect_sums();
  void add_sums(scene::EnergyBalance& a, const ContactSums& sums) const;
  ContactSums work(const Kernel& kernel) const;
  std::int64_t count_contacts() const;
  void check_energy();
  void check_rest();
  void pass_rest(std::int64_t until);
  template <class Totals>
  std::vector<Totals> partial_sums(const Kernel& kernel, const DeviceArrays& arrays) const;

  // The state for another solver (transfer.cpp).
  void take(const SolverState& state);
  SolverState last_known() const;
  void read_state(Archive& archive);
  void take_contacts(const SolverState& state, const std::vector<std::int32_t>& row);
  SolverState state_of_many(Archive& archive) const;

  // State (state.cpp).
  std::vector<scene::Ball> balls_on_device() const;
  void serialize_lists(Archive& archive);
  struct HostBalls {
    std::vector<BallRecord> rows;
    std::vector<SpinRecord> spins;
    std::vector<VectorPair> half_step;
    std::vector<std::int32_t> species, id;
  };
  HostBalls read_balls() const;
  scene::Ball present(const HostBalls& all, std::size_t row, const Vec3& kick_change) const;
  Vec3 body_kick_change() const;

  // Memory of a list of pairs.
  struct ListMemory {
    explicit ListMemory(Device& d)
        : pair_first(d),
          wall_first(d),
          i(d),
          j(d),
          touch(d),
          state(d),
          optional(d),
          friction(d),
          normals(d) {}
    DeviceArray<std::int32_t> pair_first, wall_first, i, j;
    DeviceArray<Touch> touch;
    DeviceArray<ContactState> state;
    DeviceArray<OptionalState> optional;
    DeviceArray<FrictionState> friction;
    DeviceArray<Vec3> normals;
  };
  struct BallMemory {
    explicit BallMemory(Device& d) : rows(d), spins(d), half_step(d), species(d), id(d) {}
    BallArrays reserve(std::size_t count) {
      return {rows.reserve(count), spins.reserve(count), half_step.reserve(count),
              species.reserve(count), id.reserve(count)};
    }
    DeviceArray<BallRecord> rows;
    DeviceArray<SpinRecord> spins;
    DeviceArray<VectorPair> half_step;
    DeviceArray<std::int32_t> species, id;
  };

  scene::Chamber chamber_;
  contact::PairTable pair_table_;
  std::unique_ptr<const MovingWall> jar_;
  Settings settings_;
  SpeciesPairs pairs_;
  std::shared_ptr<Device> device_;
  LawKernels law_;
  ShapeKernels shape_;
  double start_, mass_ = 0, smallest_radius_ = 0;
  bool has_history_, has_friction_history_;

  DeviceArrays arrays_;
  std::unique_ptr<BallMemory> balls_, sorted_;
  std::unique_ptr<ListMemory> list_, old_list_;
  DeviceArray<Vec3> reference_, wall_points_;
  DeviceArray<PairForce> forces_;
  DeviceArray<ContactSums> sums_;
  DeviceArray<std::int32_t> incoming_first_, incoming_, cell_, order_, cell_first_, cursor_,
      scan_partials_, balls_in_contact_, size_class_;
  DeviceArray<double> partial_, separation_energy_, species_mass_, species_inertia_;
  DeviceArray<EndedContact> ended_;
  DeviceArray<Control> control_;
  DeviceArray<StepInput> inputs_;
  DeviceArray<PairParameters> parameters_;
  DeviceArray<VectorPair> half_kicks_;
  std::list<DeviceArray<unsigned char>> shape_arrays_;

  std::int64_t step_ = 0, reference_step_ = 0, rested_steps_ = 0, tests_ = 0, contact_steps_ = 0;
  double target_time_ = 0, start_energy_ = 0;
  bool lists_due_ = true;  // they must be built before the next step
  scene::EnergyBalance energy_balance_;
  EnergyWatch watch_;
  RestWatch rest_;
  // Once a device has failed, its arrays are not read any more: balls and energies are then the
  // last that were asked for.
  mutable std::string failure_;  // why it failed; empty: it has not
  mutable scene::EnergyBalance last_balance_;
  mutable std::vector<scene::Ball> last_balls_;
};

}  // namespace mahlwerk::soft
