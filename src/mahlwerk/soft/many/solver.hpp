// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/base/huge_page_allocator.hpp"
#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/contacts.hpp"
#include "mahlwerk/soft/energy_watch.hpp"
#include "mahlwerk/soft/many/body_step.hpp"
#include "mahlwerk/soft/many/breakage_state.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"
#include "mahlwerk/soft/many/thread_team.hpp"
#include "mahlwerk/soft/neighbours/candidates.hpp"
#include "mahlwerk/soft/neighbours/grid.hpp"
#include "mahlwerk/soft/rest_watch.hpp"
#include "mahlwerk/soft/settings.hpp"
#include "mahlwerk/soft/solver_state.hpp"
#include "mahlwerk/soft/species_pairs.hpp"

namespace mahlwerk::soft {

/// The soft engine for many balls (docs/theory/soft.md). Neighbouring balls form a chunk, which
/// stores their contacts. The step of a chunk reads the present rows of all balls and writes the
/// next rows of its own balls (double buffering). So results have the same bits for any order of
/// the chunks and any number of threads.
class ManyBodySolver final : public scene::Engine, private ManyContactCallbacks {
 public:
  ManyBodySolver(std::unique_ptr<const MovingWall> jar, const std::vector<scene::Ball>& balls,
                 const Settings& settings, const contact::PairTable& pairs, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::EnergyBalance energy_balance() const override;
  void begin_counting() override;
  std::vector<scene::Ball> balls() const override;
  std::vector<Vec3> forces() const override;
  std::vector<scene::WallLoad> wall_loads() const override;
  void serialize(Archive& archive) override;
  SolverState state() const;

 private:
  // The main loop (solver.cpp).
  void initialize_rows(const std::vector<scene::Ball>& balls);
  void step(const DriveSample& drive, const DriveSample& next_drive);
  double mill_time(std::int64_t step) const { return start_ + time_of(step); }
  double time_of(std::int64_t step) const;
  std::vector<DriveSample> drive_samples(std::int64_t first, std::int64_t last) const;
  std::int64_t block_end(std::int64_t until) const;
  void advance_drive();
  bool update_bounds();
  void rebuild_neighbour_lists();
  std::size_t record_count() const;
  void collect_records();
  [[noreturn]] void stop(std::size_t row, const char* why) const;

  // Energy (energy.cpp).
  struct BallEnergy {
    double kinetic = 0, potential = 0;  // [J]
    double total() const { return kinetic + potential; }
  };
  BallEnergy energy_of(std::size_t row, const Vec3& body_kick_change,
                       const kinematics::FrameMotion& frame) const;
  struct OpenContacts {
    StoredEnergy stored;
    double work_done = 0;  // [J] since their onset: dissipated, and stored across the normal
  };
  StoredEnergy stored_in(const ContactPackets& list, std::size_t packet, std::size_t lane) const;
  OpenContacts open_contacts(const Chunk& chunk) const;
  void check_energy();
  void check_rest();
  void pass_rest(std::int64_t until);
  void flush_sums();
  void add_sums(scene::EnergyBalance& a, const Chunk& chunk) const;

  // Balls that leave and enter (flow.cpp).
  void move_flow(scene::Observer& observer);
  scene::Passage passage(std::size_t row, bool entered) const;
  void take_out_balls(std::vector<scene::Passage>& passages);
  void end_contacts_of_leaving(double& book, double sign);
  double end_contact_of_leaving(Chunk& chunk, ContactPackets& list, std::size_t n, std::size_t l);
  void put_in_balls(std::vector<scene::Passage>& passages);
  void mix_fresh_feed();
  std::optional<Vec3> room_at_inlet(std::int32_t ball);
  scene::Passage put_in(std::int32_t ball, const Vec3& position);
  void add_row(std::int32_t ball, std::int32_t species, const Vec3& position, const Vec3& velocity,
               const Vec3& spin);
  void rebuild_after_flow();
  void drop_rows(std::size_t kept);
  bool leaves(std::size_t row) const { return !leaves_.empty() && leaves_[row]; }

  // Grains that break (breakage.cpp).
  /// What the stressing of the grains of a chunk changes.
  struct Stressing {
    std::vector<scene::SizeChange> changes;
    std::vector<double> fines;  // [kg] stressed, by energy; empty: none
    std::int64_t broken = 0;
  };
  void start_breakage(const std::vector<scene::Ball>& balls);
  std::int32_t species_of_grain(double radius) const;
  void break_grains(scene::Observer& observer);
  void sum_loads(Chunk& chunk);
  void follow_stressing(std::vector<scene::SizeChange>& changes);
  double cushioned_share() const;
  void stress(std::size_t row, double share, Stressing& out);
  static void stress_fines(double energy, double mass, double share, Stressing& out);
  void become_finer(scene::GrainState& grain, double mass, Stressing& out) const;
  void replace_broken(std::vector<scene::SizeChange>& changes);
  std::vector<int> count_fragments(const std::vector<double>& shares, double mass,
                                   std::size_t from);
  bool replace(std::size_t row, std::vector<scene::SizeChange>& changes);
  struct GrainMotion {
    Vec3 velocity, spin;
  };
  GrainMotion motion_after_kick(std::size_t row) const;
  double energy_after_kick(std::size_t row) const;
  double put_in_fragments(std::size_t row, const std::vector<int>& counts,
                          std::vector<scene::SizeChange>& changes);
  void add_fines(const std::vector<double>& shares, double mass,
                 std::vector<scene::SizeChange>& changes);
  void grind_fines(std::vector<scene::SizeChange>& changes);
  void begin_relaxed(ContactPackets& list, std::size_t n, std::size_t l, bool wall);
  void end_new_fragments();
  // Bodies that are clumps of spheres (clumps.cpp).
  struct PresentBody {
    Vec3 velocity, momentum, spin;  // [m/s], [kg m2/s], [rad/s]
  };
  void assign_body_classes();
  void place_spheres(const std::vector<scene::Ball>& balls);
  void initialize_bodies(const std::vector<scene::Ball>& balls,
                         const std::vector<DriveSample>& drive);
  void sort_bodies(std::size_t size_class, std::vector<std::int32_t>& from) const;
  void reorder_bodies(const std::vector<std::int32_t>& from);
  Vec3 grid_position(std::size_t row) const;
  void step_bodies(const ChunkStep& step, const Chunk& chunk, const BallForces& forces,
                   ChunkDisplacement& displacement) override;
  void apply_contact_mass(PairParameters& parameters, std::size_t lane, const NeighbourPair& pair,
                          std::int32_t species_pair) const;
  double contact_mass(const ContactPackets& list, std::size_t packet, std::size_t lane) const;
  // Rounded convex bodies (rounded.cpp).
  struct TouchingSpheres {
    Vec3 arm_i = {}, arm_j = {};        // [m] centres of the spheres, from those of the bodies
    double radius_i = 0, radius_j = 0;  // [m] 0 of a wall
    Vec3 normal = {};                   // unit, from the sphere of i
    double distance = 0;                // [m] of the centres; from a wall
    double curvature_i = 0, curvature_j = 0;  // [1/m] mean of the surfaces; 0 of a wall
    geometry::NearestHulls hulls = {};        // of a pair with a rounded body
    bool meeting = false;                     // the cores meet
    double overlap() const { return radius_i + radius_j - distance; }
    double least_gap() const { return (1 - 1e-5) * distance - radius_i - radius_j; }  // (bod.21)
  };
  const BodySpecies* rounded_species(std::int32_t row) const;
  geometry::PlacedCore placed_core(std::int32_t row, const Vec3& centre) const;
  /// Of two rows, or of a row and the face ~j.
  /// `hulls`: of a pair with a rounded body.
  TouchingSpheres touching_spheres(std::int32_t i, std::int32_t j,
                                   geometry::NearestHulls hulls = {}) const;
  TouchingSpheres of_rounded_pair(std::int32_t i, std::int32_t j,
                                  geometry::NearestHulls hulls) const;
  bool has_rounded(const NeighbourPair& pair) const;
  TouchingSpheres sphere_at_wall(std::int32_t i, int face) const;
  Vec3 wall_arm(std::int32_t i, int face) const;
  void test_near_pairs(Chunk& chunk);
  double largest_move(const Chunk& chunk) const;
  void follow_moves();
  void place_contact_spheres(Chunk& chunk, ContactPackets& list, std::size_t n) override;
  PresentBody present(std::size_t body, const Vec3& body_kick_change) const;
  scene::BodyFeature feature_hit(std::int32_t row, const Vec3& arm) const;
  Vec3 velocity_of_row(std::size_t row, const Vec3& body_kick_change) const;  // ball or sphere
  Vec3 spin_of_row(std::size_t row) const;
  BallEnergy energy_of_sphere(std::size_t row, const Vec3& body_kick_change,
                              const kinematics::FrameMotion& frame) const;
  void add_bodies(std::vector<scene::Ball>& all, const Vec3& body_kick_change) const;
  void add_body_forces(std::vector<Vec3>& all, const Vec3& pull) const;
  void serialize_bodies(Archive& archive);
  bool is_member(std::size_t row) const { return bodies_.has_members() && bodies_.is_member(row); }

  // State (state.cpp).
  Vec3 body_kick_change() const;  // [m/s] half a step times the change of the body acceleration
  Vec3 velocity(std::size_t row, const Vec3& body_kick_change) const;  // of a ball
  Vec3 spin(std::size_t row) const;

  // The state for another solver (transfer.cpp).
  SolverState::Contact contact_of(const ContactPackets& list, std::size_t packet, std::size_t lane,
                                  bool wall) const;
  void take_contact(Chunk& chunk, const SolverState::Contact& contact,
                    const std::vector<std::int32_t>& row);
  void take(const SolverState& state);

  // Order of the balls, chunks (order.cpp).
  void sort_into_chunks();
  std::vector<std::int32_t> sort_balls();
  void reorder(const std::vector<std::int32_t>& from);
  std::vector<Chunk> make_chunks();
  void share_work();
  std::int32_t chunk_of(std::int32_t ball) const;
  std::size_t class_of(std::size_t row) const {
    return static_cast<std::size_t>(class_of_[static_cast<std::size_t>(species_[row])]);
  }

  // Contacts move with their balls to new rows (lanes.cpp).
  struct ContactAddress {
    std::int32_t i = 0, j = 0;  // new rows of the balls; at a wall, j is the face
    std::int32_t list = 0;      // old place: index of chunk and list (list_of)
    std::int32_t lane = 0;      // lane l of packet g: 8 g + l
  };
  struct ContactsByBall {
    std::vector<ContactAddress> contacts;
    std::vector<std::int32_t> first;  // index of the first contact of each ball
  };
  ContactsByBall collect_contacts(const std::vector<std::int32_t>& to);
  void distribute_contacts(const ContactsByBall& all, std::vector<Chunk>& old);
  void place_contact(Chunk& chunk, const ContactAddress& kept, const ContactPackets& from);
  void copy_contact(ContactPackets& list, const ContactAddress& kept, const ContactPackets& from,
                    std::int32_t i, std::int32_t j, std::int32_t species_pair, double sign);

  // Neighbour lists (neighbours.cpp).
  void rebuild();
  void tune_skin();
  void set_reference_positions();
  std::int64_t test_count() const;
  bool rebin_is_due() const;
  void rebin_pairs();
  double wall_gap(const NeighbourPair& pair) const;
  std::int32_t gather_candidates(const Chunk& chunk, std::int32_t from,
                                 Candidates& candidates) const;
  void find_ball_pairs(Chunk& chunk);
  struct BallError {
    std::size_t row = 0;
    const char* why = nullptr;
  };
  BallError find_wall_pairs(Chunk& chunk);
  Vec3 nearest(const Vec3& separation) const {
    return periodic_ ? nearest_image(separation, jar_->periods()) : separation;
  }
  template <class F>
  void each_overlap(const F& f) const;
  void refuse_overlaps() const;
  double energy_at_start() const;  // [J] of the overlaps of the starting positions

  // Contacts that begin and end (contacts.cpp).
  void test_walls(Chunk& chunk) override;
  geometry::NearFacets* tested_facets(Chunk& chunk, const NeighbourPair& pair) const;
  void activate(Chunk& chunk, const NeighbourPair& pair) override;
  void add_packet(ContactPackets& list, std::int32_t species_pair, std::int32_t ball);
  std::int32_t free_lane(ContactPackets& list, std::int32_t species_pair, std::int32_t ball);
  void begin(Chunk& chunk, ContactPackets& list, std::size_t n) override;
  void record_onset(ContactPackets& list, std::size_t n, std::uint32_t begun,
                    const OnsetSpeeds& speeds) override;
  void end(Chunk& chunk, ContactPackets& list, std::size_t n, std::uint32_t ended) override;
  void record(Chunk& chunk, const ContactPackets& list, std::size_t n, std::size_t lane);
  void change_contact_count(Chunk& chunk, std::int32_t ball, int more);

  void add_wall_load(const ChunkStep& step, Chunk& chunk,
                     const MovingWall::WallForce& force) override;

  // Liquid (liquid.cpp).
  void add_liquid_forces(const ChunkStep& step, Chunk& chunk, BallForces& forces) override;

  std::unique_ptr<const MovingWall> jar_;
  Settings settings_;
  BodySpeciesTable body_species_;  // before pairs_, which has a species for each of their spheres
  SpeciesPairs pairs_;
  std::optional<LiquidForces> liquid_;
  ChunkStepper step_chunk_;
  std::size_t ball_count_;  // inside the jar and outside
  // pull_off_distance_: largest gap [m] of all pairs at which a contact persists or a liquid acts.
  double start_, pull_off_distance_ = 0, mass_ = 0;
  bool periodic_, large_, has_history_, has_friction_history_;
  std::vector<PairParameters> parameters_;  // of each species pair
  std::vector<Lanes> half_kick_factors_;    // of each species
  std::vector<std::int32_t> class_of_;      // size class of each species
  std::vector<double> class_radius_;        // [m] of the largest ball of each class
  std::size_t first_body_class_ = 0;        // classes from it on are of bodies
  std::vector<double> class_row_radius_;    // [m] likewise; of bodies, of their largest sphere
  mutable ThreadTeam team_;

  std::int64_t step_ = 0;
  WallAxes wall_axes_;  // at this step

  // The balls, in the order of their rows.
  HugePageVector<BallRecord> rows_, next_rows_;        // at this step; at the next
  HugePageVector<FloatPosition> reference_positions_;  // when the pairs were last binned
  HugePageVector<SpinRecord> spins_, next_spins_;
  HugePageVector<VectorPair> half_step_;
  std::vector<std::int32_t> id_, species_, contacts_of_;
  RigidBodies bodies_;  // empty where all balls are spheres
  std::vector<BodyFactors> body_factors_ = body_factors(body_species_, settings_.time_step);
  BodyStepper step_bodies_ = body_stepper();
  /// [m] Bound of the decrease of any gap of rounded bodies since the start.
  double path_ = 0;

  std::vector<Chunk> chunks_;
  std::vector<ChunkDisplacement> displacements_;
  std::vector<Vec3> predicted_means_;      // [m] of each chunk, for the next step
  std::vector<std::int32_t> class_first_;  // first row of each size class, and the end
  std::vector<BallForces> ball_forces_;    // of each thread
  std::vector<std::int32_t> share_;        // first chunk of each thread, and the end
  std::vector<Grid> grids_;                // of each size class, while the lists are built

  double skin_ = 0;                // [m]
  double largest_coordinate_ = 0;  // [m] largest absolute coordinate in reference_positions_
  double used_skin_ = 0;           // [m] part of the skin used up at the last binning
  std::int64_t reference_step_ = 0, tests_at_rebin_ = 0, pairs_rebinned_ = 0;
  struct Tuning {
    std::int64_t step = 0;
    double last_cost = 0, tests = 0, growth = 1.15;
  } tuning_;

  scene::EnergyBalance energy_balance_;
  std::vector<scene::WallLoad> loads_;  // of the jar and its parts; none without parts
  EnergyWatch watch_;
  RestWatch rest_;
  std::int64_t rested_steps_ = 0;  // passed at once, at rest
  double target_time_ = 0;
  std::vector<FinishedCollision> finished_;

  BreakageState breakage_;
  std::vector<double> load_;  // [J] of each row, while the stressing is followed
  double stored_share_ = 0;   // (bed.1)

  struct OutsideBall {
    Vec3 position;  // [m] at which it left
    std::int32_t ball = 0, zero = 0;
  };
  std::vector<OutsideBall> outside_;  // fresh balls, then those that left, in their order
  std::int64_t fresh_ = 0;            // balls that have never been inside
  std::vector<bool> leaves_;          // by row, while balls are taken out; else empty
  bool keeps_next_rows_ = false;      // rows of the next step move with those of this one
  std::int64_t tries_ = 0;            // places in the inlet that were tried
  double next_feed_ = 0;              // [s] earliest time of the next ball
};

}  // namespace mahlwerk::soft
