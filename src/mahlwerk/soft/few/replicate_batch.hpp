// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <span>
#include <vector>

#include "mahlwerk/soft/few/solver.hpp"

namespace mahlwerk::soft {

/// Replicates of one case that step side by side in one thread. Their pairs share packets, those
/// that touch in the first ones, so that nearly all lanes of a computed register are in use.
///
/// Each replicate has the same bits as alone: lanes do not influence each other, and forces, work
/// and records of a replicate are summed and listed in the order of its own lanes.
class ReplicateBatch final : private StepCallbacks {
 public:
  /// Whether all are at the same time, in a jar without parts.
  static bool fits(std::span<FewBodySolver* const> solvers);
  /// The solvers are those of one case, all at the same time.
  explicit ReplicateBatch(std::span<FewBodySolver* const> solvers);

  /// Advances all to `time` [s], as FewBodySolver::advance() does. Returns for each solver the
  /// exception that stopped it, or null.
  std::vector<std::exception_ptr> advance(double time, std::span<scene::Observer* const> observers);

 private:
  /// A lane of a packet.
  struct Place {
    std::size_t packet = 0, lane = 0;
  };
  using Pair = FewBodySolver::NearPair;
  struct Replicate {
    FewBodySolver* solver;
    std::exception_ptr failure = nullptr;
    std::vector<Pair> pairs = {};    // sorted, those in the shared packets
    std::vector<Place> places = {};  // of `pairs`, in the shared packets

    bool sleeps() const { return solver->skip_end_ >= 0; }  // in a free-flight skip
  };
  /// The pair that has a lane of a shared packet.
  struct Owner {
    Replicate* replicate = nullptr;
    Place own;  // in the packets of the replicate
  };

  // Blocks of steps.
  void advance_block(std::int64_t until);
  void step_active(std::int64_t end);
  void pass_skips(std::int64_t until);
  template <class F>
  void attempt(Replicate& r, const F& f);
  std::int64_t next_skip_end() const;
  bool rebuild_neighbour_list(std::size_t charge) override;
  void add_liquid_forces(std::size_t charge, const DriveSample& drive) override;
  bool pause() override;
  void deactivate(std::size_t charge);

  // Lanes of the shared packets.
  template <class F>
  static void each_own(const Replicate& r, const F& f);
  void load_all();
  void add_packets(std::size_t count);
  void load(Replicate& r);
  void reload(Replicate& r);
  void connect(Replicate& r, const Place& own, const Place& place);
  void store(Replicate& r);
  void store_lane(const Place& place);
  void store_touching(const Replicate& r);
  void store_missing(const Replicate& r);
  Place free_place(bool first);
  void clear(const Place& place);

  // Contacts that begin and end.
  void begin(const PacketLanes& begun) override;
  void record_onset(const PacketLanes& begun, const OnsetSpeeds& speeds) override;
  void end(const PacketLanes& ended) override;
  void forces_done() override;

  std::vector<Replicate> replicates_;
  std::vector<Replicate*> active_;      // those that step
  std::vector<ParticleData*> charges_;  // of active_
  std::int64_t step_;                   // of all

  std::vector<PairPacket> packets_;
  std::vector<GatherMap> gather_maps_;
  std::vector<std::array<Owner, lanes>> owners_;
  std::vector<std::uint32_t> free_lanes_;  // bits
  std::vector<Place> ended_;               // in this step
  StepBlock* block_ = nullptr;             // the present one
  BodyBlock no_body_;                      // of free lanes
  ForceRow no_row_;
};

}  // namespace mahlwerk::soft
