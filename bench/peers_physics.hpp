// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

// Means of the motion of balls in the planetary mill of bench/peers.hpp, from samples of their
// motion by any program.
namespace mahlwerk::bench {

/// State of the balls at one time, in the jar frame: axes of the laboratory, origin at the vial's
/// centre, velocities relative to it.
struct Sample {
  struct Ball {
    Vec3 position;  ///< [m]
    Vec3 velocity;  ///< [m/s]
    Vec3 force;     ///< [N] of contacts; gravity along the axis may be in it or not
    Vec3 spin;      ///< [rad/s]
    Vec3 torque;    ///< [N m]
  };
  double time = 0;  ///< [s]
  std::vector<Ball> balls;
};

/// Means over a time window.
struct Physics {
  struct Impacts {
    double rate = 0;      ///< [1/s] touches faster than `slowest_impact`, of all balls together
    double speed = 0;     ///< [m/s] their mean normal speed
    double all_rate = 0;  ///< [1/s] touches at any speed
  };
  double power = 0;             ///< [W] of the vial's walls on the balls; its mean is the loss
  double kinetic = 0;           ///< [J] of translation, laboratory frame
  double rotational = 0;        ///< [J]
  double kinetic_on_plate = 0;  ///< [J] of translation, in the frame that turns with the disc
  Impacts ball_ball, ball_side;
};

/// [m/s] Slower touches depend on how a program treats sustained contacts and a vial's facets.
inline constexpr double slowest_impact = 0.1;

/// Evaluates samples in the order of time without storing them.
class Analysis {
 public:
  /// Samples from `from` to `to` [s] count.
  Analysis(double from, double to) : from_(from), to_(to) {}

  void add_sample(const Sample& sample);
  /// NaN unless at least two samples lay in the window.
  Physics physics() const;
  double last_sample_time() const { return last_sample_time_; }  ///< [s] time of the last sample

 private:
  /// Gaps of the pairs that may touch. The speed of a touch is the rate at which the gap has shrunk
  /// since the sample before.
  struct Gaps {
    std::vector<double> now, before;  ///< [m]
    double touches = 0, impacts = 0, speeds = 0;

    void compare(double passed);
    Physics::Impacts over(double duration) const;
  };

  void add_means(const Sample& sample);
  void add_touches(const Sample& sample);

  double from_, to_, first_ = NAN, last_ = NAN, last_sample_time_ = NAN;
  double samples_ = 0;
  Physics sum_;
  Gaps ball_ball_, ball_side_;
};

/// Reads the output of "dump custom id x y z vx vy vz fx fy fz omegax omegay omegaz tqx tqy tqz" of
/// LAMMPS and LIGGGHTS, in the laboratory frame, and passes each sample to `analysis`. Other lines
/// are ignored.
class DumpReader {
 public:
  /// `step` [s] is the time step of the program.
  DumpReader(int balls, double step, Analysis& analysis);

  void line(std::string_view text);

 private:
  void ball(std::string_view text);
  void finish();

  double step_;
  Analysis& analysis_;
  enum class Awaiting { header, step, balls } awaiting_ = Awaiting::header;
  int missing_ = 0;
  Sample sample_;
};

}  // namespace mahlwerk::bench
