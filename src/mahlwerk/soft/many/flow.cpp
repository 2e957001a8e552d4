// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Balls that leave the jar and enter it (docs/theory/flow.md). A ball outside has no row: it
// touches nothing and costs nothing.
namespace mahlwerk::soft {
namespace {

constexpr int tries_of_a_ball = 20;  // places in the inlet that are tried at a time
constexpr std::uint64_t inlet_stream = 0x696e6c6574,  // apart from other draws of the seed
    order_stream = 0x6f72646572;

}  // namespace

/// Takes out the balls beyond the outlet, and puts in those that the feed asks for. Called at steps
/// that do not depend on how advance() divides a run.
void ManyBodySolver::move_flow(scene::Observer& observer) {
  std::vector<scene::Passage> passages;
  take_out_balls(passages);
  put_in_balls(passages);
  if (passages.empty()) return;
  rebuild_after_flow();
  observer.passages(passages);
}

scene::Passage ManyBodySolver::passage(std::size_t row, bool entered) const {
  const Species& of = pairs_.species(species_[row]);
  return {time_of(step_), of.mass, id_[row], of.kind, entered ? 1 : 0};
}

void ManyBodySolver::take_out_balls(std::vector<scene::Passage>& passages) {
  leaves_.assign(rows_.size(), false);
  std::vector<std::size_t> leaving;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (settings_.flow->has_left(jar_->within_period(rows_[k].position()))) leaving.push_back(k);
  std::ranges::sort(leaving, {}, [&](std::size_t k) { return id_[k]; });
  if (leaving.empty()) return;
  const Vec3 change = body_kick_change();
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  for (const std::size_t k : leaving) {
    leaves_[k] = true;
    energy_balance_.flow -= energy_of(k, change, frame).total();
    outside_.push_back({jar_->within_period(rows_[k].position()), id_[k], 0});
    passages.push_back(passage(k, false));
  }
  end_contacts_of_leaving(energy_balance_.flow, -1);
}

/// Ends the contacts of balls that leave; what is stored in them goes to `book`, times `sign`.
void ManyBodySolver::end_contacts_of_leaving(double& book, double sign) {
  for (Chunk& chunk : chunks_)
    for (ContactPackets* list : {&chunk.own, &chunk.halo, &chunk.wall})
      for (std::size_t n = 0; n < list->packets.size(); ++n)
        for (std::size_t l = 0; l < lanes; ++l)
          book += sign * end_contact_of_leaving(chunk, *list, n, l);
}

/// Ends a contact if a ball of it leaves. Returns what its compression stores; what its tangential
/// springs store counts as dissipated, as at the end of every contact.
double ManyBodySolver::end_contact_of_leaving(Chunk& chunk, ContactPackets& list, std::size_t n,
                                              std::size_t l) {
  ContactPacket& g = list.packets[n];
  if (!g.touches(l)) return 0;
  const bool wall = &list == &chunk.wall, halo = &list == &chunk.halo;
  const bool one = leaves_[static_cast<std::size_t>(g.i[l])],
             other = !wall && leaves_[static_cast<std::size_t>(g.j[l])];
  if (!one && !other) return 0;
  const double stored = (halo ? 0.5 : 1) * stored_in(list, n, l).normal;
  change_contact_count(chunk, g.i[l], -1);
  if (&list == &chunk.own) change_contact_count(chunk, g.j[l], -1);
  if (!halo || g.i[l] < g.j[l]) record(chunk, list, n, l);
  g.touching &= ~bit(l);  // the lists are built anew; the lane need not be free
  return stored;
}

/// Draws the order in which the balls that are outside at the start are fed, so that the feed has
/// the composition of its sets and sizes from the first ball on.
void ManyBodySolver::mix_fresh_feed() {
  fresh_ = std::ssize(outside_);
  if (!settings_.flow) return;
  Random random(settings_.flow->seed ^ order_stream, 0);
  for (std::size_t left = outside_.size(); left > 1; --left) {
    const auto drawn = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(outside_[left - 1], outside_[std::min(drawn, left - 1)]);
  }
}

/// Puts balls in, the first that waits first, until the feed is met or one finds no room.
void ManyBodySolver::put_in_balls(std::vector<scene::Passage>& passages) {
  const scene::Flow& flow = *settings_.flow;
  const double now = time_of(step_);
  const auto wanted = [&] {
    return flow.feed == scene::Flow::Feed::recirculate ||
           (flow.feed == scene::Flow::Feed::rate && next_feed_ <= now);
  };
  const auto waiting = flow.returns ? outside_.size() : static_cast<std::size_t>(fresh_);
  std::size_t entered = 0;
  for (; entered < waiting && wanted(); ++entered) {
    const std::optional<Vec3> place = room_at_inlet(outside_[entered].ball);
    if (!place) break;
    passages.push_back(put_in(outside_[entered].ball, *place));
    if (flow.feed == scene::Flow::Feed::rate)
      next_feed_ += flow.feed_interval(passages.back().mass);
  }
  fresh_ = std::max<std::int64_t>(0, fresh_ - static_cast<std::int64_t>(entered));
  outside_.erase(outside_.begin(), outside_.begin() + static_cast<std::ptrdiff_t>(entered));
  next_feed_ = std::max(next_feed_, now);  // what could not be fed is not made up for
}

/// A random place in the inlet at which a ball touches nothing; none if the tries find no room.
std::optional<Vec3> ManyBodySolver::room_at_inlet(std::int32_t ball) {
  const scene::Flow& flow = *settings_.flow;
  const double radius = pairs_.species_of(static_cast<std::size_t>(ball)).radius;
  std::vector<double> walls(static_cast<std::size_t>(jar_->faces()));
  const auto free = [&](const Vec3& x) {
    jar_->distances(x, wall_axes_, radius, walls);
    for (int face = 0; face < jar_->faces(); ++face)
      if (jar_->can_touch(face, radius) && !(walls[static_cast<std::size_t>(face)] > radius))
        return false;
    return std::ranges::none_of(rows_, [&](const BallRecord& other) {
      const double apart = radius + other.radius;
      return squared(nearest(other.position() - x)) < apart * apart;
    });
  };
  for (int k = 0; k < tries_of_a_ball; ++k) {
    Random random(flow.seed ^ inlet_stream, static_cast<std::uint32_t>(tries_++));
    const double a = random.uniform() - 0.5, b = random.uniform() - 0.5, c = random.uniform() - 0.5;
    const Vec3 within{a * flow.inlet_size.x, b * flow.inlet_size.y, c * flow.inlet_size.z};
    const Vec3 x = flow.inlet + flow.axes * within;
    if (free(x)) return x;
  }
  return std::nullopt;
}

/// Puts in a ball that is at rest in the laboratory.
scene::Passage ManyBodySolver::put_in(std::int32_t ball, const Vec3& x) {
  const kinematics::FrameMotion frame = jar_->frame_motion(mill_time(step_));
  add_row(ball, pairs_.species_index(static_cast<std::size_t>(ball)), x, -frame.velocity, {});
  energy_balance_.flow += energy_of(rows_.size() - 1, body_kick_change(), frame).total();
  return passage(rows_.size() - 1, true);
}

/// Adds a row for a ball with velocity and spin at this step, one step ahead as all rows (dem.26).
void ManyBodySolver::add_row(std::int32_t ball, std::int32_t species, const Vec3& x, const Vec3& v,
                             const Vec3& w) {
  const double dt = settings_.time_step;
  const std::vector<DriveSample> drive = drive_samples(step_, step_ + 1);
  const Vec3 half = v + 0.5 * dt * drive[0].body_acceleration,
             predicted = half + 0.5 * dt * drive[1].body_acceleration, next = x + dt * half;
  const double radius = pairs_.species(species).radius;
  rows_.push_back({x.x, x.y, x.z, radius, v.x, v.y, v.z, 0});
  next_rows_.push_back({next.x, next.y, next.z, radius, predicted.x, predicted.y, predicted.z, 0});
  reference_positions_.emplace_back();
  spins_.push_back({w.x, w.y, w.z, 0}), next_spins_.push_back({w.x, w.y, w.z, 0});
  half_step_.push_back({half.x, half.y, half.z, 0, w.x, w.y, w.z, 0});
  id_.push_back(ball), species_.push_back(species), contacts_of_.push_back(0);
  leaves_.push_back(false);
}

/// Builds the lists of the balls that are inside now. The rows of the next step stand already.
void ManyBodySolver::rebuild_after_flow() {
  keeps_next_rows_ = true;
  rebuild();
  keeps_next_rows_ = false;
  leaves_.clear();
  for (std::size_t c = 0; c < chunks_.size(); ++c)
    for (auto k = static_cast<std::size_t>(chunks_[c].first);
         k < static_cast<std::size_t>(chunks_[c].last); ++k)
      displacements_[c].spread =
          std::max(displacements_[c].spread, norm(next_rows_[k].position() - rows_[k].position()));
}

/// Removes the rows of balls that have left, which are the last.
void ManyBodySolver::drop_rows(std::size_t kept) {
  rows_.resize(kept), next_rows_.resize(kept), reference_positions_.resize(kept);
  spins_.resize(kept), next_spins_.resize(kept), half_step_.resize(kept);
  id_.resize(kept), species_.resize(kept), contacts_of_.resize(kept);
}

}  // namespace mahlwerk::soft
