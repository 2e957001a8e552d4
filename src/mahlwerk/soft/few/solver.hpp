// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/energy_watch.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "mahlwerk/soft/few/liquid_loop.hpp"
#include "mahlwerk/soft/few/step_block.hpp"
#include "mahlwerk/soft/rest_watch.hpp"
#include "mahlwerk/soft/species_pairs.hpp"

namespace mahlwerk::soft {

class ReplicateBatch;

/// The soft engine for few balls: every neighbour pair has a lane (docs/theory/soft.md).
class FewBodySolver final : public scene::Engine, private StepCallbacks {
 public:
  FewBodySolver(std::unique_ptr<const MovingWall> jar, const std::vector<scene::Ball>& balls,
                const Settings& settings, const contact::PairTable& pairs, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::EnergyBalance energy_balance() const override;
  void begin_counting() override;
  std::vector<scene::Ball> balls() const override;
  std::vector<Vec3> forces() const override;
  std::vector<scene::WallLoad> wall_loads() const override { return loads_; }
  void serialize(Archive& archive) override;

 private:
  friend ReplicateBatch;

  // The main loop (solver.cpp).
  std::int64_t last_step(double time) const;
  void advance_block(std::int64_t until);
  std::int64_t block_end(std::int64_t until) const;
  void sample_drive(std::int64_t end);
  void set_idle_from();
  StepBlock step_block(std::vector<ParticleData*>& charges, std::vector<PairPacket>& packets,
                       std::vector<GatherMap>& gather_maps, StepCallbacks& callbacks) const;
  void end_block();
  void hand_over(scene::Observer& observer);
  bool pause() override { return false; }
  double mill_time(std::int64_t step) const;  // [s] of the mill
  double time_of(std::int64_t step) const;    // [s] since the start of the run
  template <class F>
  void each_overlap(const F& f) const;
  void refuse_overlaps() const;
  [[noreturn]] void stop(std::size_t ball, const char* why) const;

  // Liquid (liquid.cpp).
  void add_liquid_forces(std::size_t, const DriveSample& drive) override { add_liquid(drive); }
  void start_in_liquid();
  void build_liquid_neighbours();
  void add_liquid(const DriveSample& drive);
  bool liquid_at_wall() const;

  // Energy (energy.cpp).
  StoredEnergy elastic_energy(const PairPacket& packet, std::size_t lane) const;
  StoredEnergy elastic_energy() const;  // of open contacts
  double energy_at_start() const;       // [J] of the overlaps of the starting positions
  void check_energy();
  void check_rest();

  // Neighbour list (neighbours.cpp).
  struct NearPair {
    std::int32_t i, j, face;  // face < 0: two balls
    friend auto operator<=>(const NearPair&, const NearPair&) = default;
  };
  void rebuild_neighbour_list();
  bool rebuild_neighbour_list(std::size_t) override;
  void find_pairs();
  void find_wall_pairs(std::size_t ball);
  void test_pair(std::size_t i, std::size_t j);
  Vec3 nearest(const Vec3& separation) const {
    return periodic_ ? nearest_image(separation, jar_->periods()) : separation;
  }
  void find_ball_pairs();
  void update_slacks();

  // Lane of each pair (lanes.cpp).
  static NearPair pair_of(const PairPacket& p, std::size_t lane);
  bool lanes_due() const;
  void update_lanes();
  void sort_touching_first();
  void fill_lanes(const std::vector<NearPair>& wanted);
  void assign_lane(PairPacket& p, std::size_t lane, const NearPair& c);
  void allocate_wall_points();
  void keep_near_facets(std::span<const WallNeighbour> before);
  void build_gather_maps();
  const double* body_address(std::int64_t body) const;  // of position.x
  static void find_sources(const PairPacket& p, GatherMap& map);

  // Contacts that begin and end (contacts.cpp).
  void begin(const PacketLanes& begun) override;
  void record_onset(const PacketLanes& begun, const OnsetSpeeds& speeds) override;
  void end(const PacketLanes& ended) override;
  void forces_done() override;
  void add_wall_load(const DriveSample& drive, const MovingWall::WallForce& force) override;
  void begin_lane(PairPacket& p, std::size_t lane);
  void record_onset(PairPacket& p, std::size_t lane, const OnsetSpeeds& speeds);
  void end_lane(PairPacket& p, std::size_t lane);
  // Adds the work of a lane to the energy balance; clears its work and springs.
  void flush_work(PairPacket& p, std::size_t lane);
  void change_contact_count(std::int64_t body, int more);  // of a ball, by +1 or -1

  // Free flight (free_flight_skip.cpp).
  bool start_skip();
  std::int64_t collision_free_steps() const;
  struct FreeFlight {
    Vec3 shift, gain;  // [m], [m/s] of all balls, added to straight flight
    double time = 0;
  };
  FreeFlight free_flight(std::int64_t steps) const;
  void end_skip();

  std::unique_ptr<const MovingWall> jar_;
  std::vector<scene::Ball> initial_balls_;  // radius, density, kind; initial positions
  Settings settings_;
  SpeciesPairs pairs_;
  std::optional<LiquidForces> liquid_;
  LiquidNeighbours liquid_neighbours_;  // derived from the listed pairs and their lanes
  BlockStepper step_block_;
  double start_, skin_;
  double mass_ = 0;  // [kg] of all balls
  // [m] Largest gap of all pairs at which a contact persists or a liquid acts.
  double pull_off_distance_ = 0;
  bool skips_, periodic_;     // skip free flight; periodic box
  std::vector<double> gaps_;  // [m] from each ball to each face, when the list was built

  ParticleData particles_;
  std::vector<NearPair> found_pairs_, listed_pairs_;  // of the last search; those that have a lane
  std::int64_t next_skip_ = 0;                        // earliest step of the next skip
  std::int64_t skip_end_ = -1;  // end of the current skip; < 0: none; at rest it has no end
  std::int64_t now_ = 0;        // current step; in a skip ahead of particles_.step
  std::int64_t skipped_steps_ = 0;
  double target_time_ = 0;  // [s] target of the last advance()

  scene::EnergyBalance energy_balance_;    // sums over contacts that have ended
  std::vector<scene::WallLoad> loads_;     // of the jar and its parts; none without parts
  std::vector<std::int32_t> contacts_of_;  // number of contacts of each ball
  std::int64_t balls_in_contact_ = 0;      // balls with contacts
  std::int64_t contact_count_step_ = 0;
  EnergyWatch watch_;
  RestWatch rest_;
  std::vector<scene::Collision> finished_;
  std::vector<PacketLanes> ended_;  // in this step
  std::vector<DriveSample> drive_;
};

}  // namespace mahlwerk::soft
