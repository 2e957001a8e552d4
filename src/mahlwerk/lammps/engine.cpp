// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/lammps/hits.hpp"
#include "mahlwerk/lammps/output_files.hpp"
#include "mahlwerk/lammps/run.hpp"

namespace mahlwerk::lammps {
namespace fs = std::filesystem;
namespace {

/// A line of balance.N.txt.
struct Balance {
  double kinetic = 0;     // [J] in the jar frame, of translation
  double turning = 0;     // [J] of rotation
  Vec3 centre, velocity;  // [m], [m/s] of the charge's centre of mass in the jar frame
  double wall_power = 0, body_power = 0;  // [W] means over the row
  explicit Balance(const double* v)
      : kinetic(v[1]),
        turning(v[2]),
        centre{v[3], v[4], v[5]},
        velocity{v[6], v[7], v[8]},
        wall_power(v[9]),
        body_power(v[10]) {}
};

Vec3 vector_at(const double* v) {
  return {v[0], v[1], v[2]};
}

class Engine final : public scene::Engine {
 public:
  Engine(const cases::Case& mill_case, scene::Chamber chamber, std::vector<scene::Ball> balls,
         const Steps& steps, const Launch& launch)
      : chamber_(std::move(chamber)),
        steps_(steps),
        run_(launch),
        hits_(mill_case, chamber_, balls, steps.time_step),
        balls_(std::move(balls)),
        balance_(run_.folder(), "balance", OutputFile::Kind::table, balance_columns),
        contacts_(run_.folder(), "contacts", OutputFile::Kind::dump, contact_columns),
        frames_(run_.folder(), "balls", OutputFile::Kind::dump, ball_columns),
        walls_(run_.folder(), "wall", OutputFile::Kind::dump, ball_columns) {
    for (const scene::Ball& ball : balls_) {
      mass_ += ball.mass();
      centre_ = centre_ + ball.mass() * ball.position;
      velocity_ = velocity_ + ball.mass() * ball.velocity;
    }
    centre_ = centre_ / mass_;
    velocity_ = velocity_ / mass_;
    begin_balance();
    if (!run_.resumes())
      write_folder(run_.folder(), mill_case, chamber_, balls_, steps, run_.ranks());
    run_.start(mill_case, steps.total);
  }

  void advance(double time, scene::Observer& observer) override {
    while (reached_.time < time && !stopped()) {
      const bool ended = run_.ended();
      sessions_ = sessions(run_.folder());
      if (read_row(observer)) continue;
      if (ended) run_.end_early(reached_.time);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    // A run that has reached its end may write its last files.
    while (!stopped() && reached_.time >= steps_.time && !run_.ended())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (stopped()) run_.stop();
  }
  scene::EnergyBalance energy_balance() const override { return reached_; }
  std::vector<scene::Ball> balls() const override { return balls_; }
  std::optional<double> balls_time() const override { return balls_time_; }
  double cpu_seconds_elsewhere() const override { return run_.cpu_seconds(); }
  int restarts() const override {
    return std::max(0, static_cast<int>(sessions(run_.folder()).size()) - 1);
  }
  void serialize(Archive&) override {
    throw RunError("a run by LAMMPS keeps its state in restart files of its own");
  }

 private:
  static constexpr std::size_t contact_columns = 8, ball_columns = 10;

  /// What LAMMPS writes at intervals must have no holes.
  void check_step(const char* name, std::int64_t found, std::int64_t expected) const {
    if (found == expected) return;
    throw RunError(fmt::format(
        "the files {}.*.txt in {} have no step {}, but {}: they are damaged, or two LAMMPS wrote "
        "them. Begin again with --force",
        name, run_.folder().string(), expected, found));
  }

  /// Takes over what LAMMPS wrote up to the next line of the balance. False if that is not
  /// complete.
  bool read_row(scene::Observer& observer) {
    if (next_step_ == 0) {
      const Rows* row = balance_.next(sessions_);
      if (row == nullptr) return false;
      if (row->step > 0) check_step("balance", row->step, reached_.time_steps + steps_.row);
      next_step_ = row->step;
      next_row_ = row->values;
    }
    while (frame_step_ + steps_.frame <= next_step_)
      if (!read_frame()) return false;
    while (!steps_.frames_show_wall() && wall_step_ + steps_.wall < next_step_)
      if (!read_walls()) return false;
    while (contact_step_ < next_step_)
      if (!read_contacts()) return false;
    std::ranges::sort(found_, {}, [](const scene::Collision& c) { return c.time + c.duration; });
    observer.collisions(found_);
    for (const scene::Collision& c : found_) {
      reached_.lost_normal += c.lost_normal;
      reached_.lost_tangential += c.lost_tangential;
    }
    reached_.collisions += std::ssize(found_);
    found_.clear();
    take_balance(next_step_, Balance(next_row_.data()));
    next_step_ = 0;
    return true;
  }

  bool read_frame() {
    const Rows* rows = frames_.next(sessions_);
    if (rows == nullptr) return false;
    if (rows->step > 0) check_step("balls", rows->step, frame_step_ + steps_.frame);
    frame_step_ = rows->step;
    balls_time_ = static_cast<double>(rows->step) * steps_.time_step;
    for (std::size_t i = 0; i < rows->count(); ++i) set_ball(rows->row(i), balls_);
    if (rows->step == 0) return true;
    const double share = static_cast<double>(hits_.look(balls_, rows->step));
    reached_.contact_time += share * steps_.frame_time();
    if (const auto lost = hits_.outside())
      throw RunError(fmt::format(
          "ball {} is outside the jar at {:.6g} s. Use stiffer contacts, a shorter run.time_step, "
          "or a start in which all balls are inside",
          *lost + 1, balls_time_));
    for (std::size_t i = 0; i < balls_.size() && steps_.frames_show_wall(); ++i)
      hits_.at_jar(static_cast<std::int32_t>(i), balls_[i], rows->step, found_);
    return true;
  }

  std::size_t ball_of(double id) const {
    if (!(id >= 1 && id <= static_cast<double>(balls_.size())))
      throw RunError(
          fmt::format("LAMMPS wrote of a ball {:.6g}, which the case does not have", id));
    return static_cast<std::size_t>(id) - 1;
  }

  void set_ball(const double* row, std::vector<scene::Ball>& balls) const {
    scene::Ball& ball = balls[ball_of(row[0])];
    ball.position = vector_at(row + 1);
    ball.velocity = vector_at(row + 4);
    ball.spin = vector_at(row + 7);
  }

  bool read_walls() {
    const Rows* rows = walls_.next(sessions_);
    if (rows == nullptr) return false;
    if (rows->step > 0) check_step("wall", rows->step, wall_step_ + steps_.wall);
    wall_step_ = rows->step;
    read_wall(*rows);
    return true;
  }

  void read_wall(const Rows& rows) {
    for (std::size_t i = 0; i < rows.count(); ++i) {
      const double* row = rows.row(i);
      scene::Ball ball = balls_[ball_of(row[0])];
      ball.position = vector_at(row + 1);
      ball.velocity = vector_at(row + 4);
      ball.spin = vector_at(row + 7);
      hits_.at_jar(static_cast<std::int32_t>(ball_of(row[0])), ball, rows.step, found_);
    }
  }

  /// The steps at which a contact began and ended. LAMMPS counts time from the start of a session,
  /// and a contact from before it keeps the time of its own session.
  std::pair<std::int64_t, std::int64_t> steps_of_contact(const double* row,
                                                         std::int64_t ended_by) const {
    auto session =
        std::ranges::find_if(sessions_, [&](const Session& s) { return ended_by <= s.last; });
    const std::int64_t start = session->first,
                       ended = start + std::llround(row[3] / steps_.time_step),
                       began = std::llround(row[2] / steps_.time_step);
    while (session != sessions_.begin() && began + session->first > ended) --session;
    return {began + session->first, ended};
  }

  bool read_contacts() {
    const Rows* rows = contacts_.next(sessions_);
    if (rows == nullptr) return false;
    if (rows->step > 0) check_step("contacts", rows->step, next_step_);
    contact_step_ = rows->step;
    for (std::size_t i = 0; i < rows->count(); ++i) {
      const double* row = rows->row(i);
      const auto [began, ended] = steps_of_contact(row, rows->step);
      found_.push_back(hits_.between_balls({.one = static_cast<std::int32_t>(ball_of(row[0])),
                                            .other = static_cast<std::int32_t>(ball_of(row[1])),
                                            .began = began,
                                            .ended = ended,
                                            .distance = row[4],
                                            .middle = vector_at(row + 5)}));
    }
    return true;
  }

  /// Kinetic and potential energy in the axes of the laboratory, from those in the jar frame.
  void set_energies(scene::EnergyBalance& a, double kinetic, double time) const {
    const kinematics::FrameMotion frame = kinematics::frame_motion(*chamber_.motion, time);
    a.kinetic = kinetic + mass_ * (dot(frame.velocity, velocity_) + 0.5 * squared(frame.velocity));
    a.potential = -mass_ * dot(chamber_.gravity, centre_ + frame.centre);
  }

  void begin_balance() {
    double kinetic = 0;
    for (const scene::Ball& b : balls_)
      kinetic += 0.5 * (b.mass() * squared(b.velocity) + b.inertia() * squared(b.spin));
    set_energies(reached_, kinetic, 0);
    reached_.initial_energy = reached_.kinetic + reached_.potential;
    in_jar_frame_ = kinetic - mass_ * dot(chamber_.gravity, centre_);
  }

  /// Losses follow from the balance in the jar frame, where the body force and the turning wall do
  /// work; the jar's work in laboratory axes is that plus what the frames differ by (lmp.7).
  void take_balance(std::int64_t step, const Balance& b) {
    const double time = static_cast<double>(step) * steps_.time_step, took = time - reached_.time;
    centre_ = b.centre;
    velocity_ = b.velocity;
    const double kinetic = b.kinetic + b.turning;
    const double in_jar_frame = kinetic - mass_ * dot(chamber_.gravity, centre_);
    const double lost = took * (b.wall_power + b.body_power) - (in_jar_frame - in_jar_frame_);
    in_jar_frame_ = in_jar_frame;
    const double before = reached_.kinetic + reached_.potential;
    set_energies(reached_, kinetic, time);
    reached_.wall_work += reached_.kinetic + reached_.potential - before + lost;
    lost_ += lost;
    reached_.lost_lasting = lost_ - reached_.lost_normal - reached_.lost_tangential;
    reached_.time = time;
    reached_.time_steps = step;
    reached_.deepest_overlap = hits_.deepest_overlap();
    reached_.lasting_contacts = hits_.lasting();
  }

  scene::Chamber chamber_;
  Steps steps_;
  Run run_;
  Hits hits_;
  std::vector<scene::Ball> balls_;  // of the last frame
  double balls_time_ = 0;
  OutputFile balance_, contacts_, frames_, walls_;
  std::vector<Session> sessions_;

  std::int64_t next_step_ = 0;  // of a line of the balance whose row is not complete
  std::vector<double> next_row_;
  std::int64_t frame_step_ = 0, contact_step_ = 0, wall_step_ = 0;
  std::vector<scene::Collision> found_;

  double mass_ = 0;          // of all balls
  Vec3 centre_, velocity_;   // of the charge, in the jar frame
  double in_jar_frame_ = 0;  // kinetic and potential energy
  double lost_ = 0;          // of all kinds
  scene::EnergyBalance reached_;
};

}  // namespace

std::unique_ptr<scene::Engine> make_engine(const cases::Case& mill_case,
                                           const scene::Chamber& chamber,
                                           const std::vector<scene::Ball>& balls,
                                           const Steps& steps, const Launch& launch) {
  return std::make_unique<Engine>(mill_case, chamber, balls, steps, launch);
}

}  // namespace mahlwerk::lammps
