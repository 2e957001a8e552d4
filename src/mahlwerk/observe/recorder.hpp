// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::observe {

/// What a part of the program records in one replicate: of collisions, or at times of its own. All
/// times are since the start of the run; nothing is recorded before begin().
class Recorder : public scene::Observer {
 public:
  virtual std::unique_ptr<Recorder> copy() const = 0;
  /// Counting begins at `time` [s]; also called when a state is read.
  virtual void begin(double /*time*/) {}
  void collisions(std::span<const scene::Collision> /*finished*/) override {}
  /// [s] The next time to record; infinite where there is none.
  virtual double next() const { return std::numeric_limits<double>::infinity(); }
  /// Called once the run is not before next().
  virtual void take(const scene::EnergyBalance& /*now*/) {}
  /// Whether take_balls() is called instead, with the balls in the jar frame at `time` [s].
  virtual bool wants_balls() const { return false; }
  virtual void take_balls(const scene::EnergyBalance& /*now*/, double /*time*/,
                          const std::vector<scene::Ball>& /*balls*/) {}
  virtual void serialize(Archive& archive) = 0;
};

/// The recorders of a replicate, at most one of each type.
class Recorders {
 public:
  Recorders() = default;
  Recorders(Recorders&&) = default;
  Recorders& operator=(Recorders&&) = default;
  Recorders(const Recorders& other) {
    for (const auto& one : other.all_) all_.push_back(one->copy());
  }
  Recorders& operator=(const Recorders& other) { return *this = Recorders(other); }
  ~Recorders() = default;

  void add(std::unique_ptr<Recorder> one) { all_.push_back(std::move(one)); }
  const std::vector<std::unique_ptr<Recorder>>& all() const { return all_; }
  /// The recorder of that type; null if there is none.
  template <class Of>
  const Of* find() const {
    for (const auto& one : all_)
      if (const auto* found = dynamic_cast<const Of*>(one.get())) return found;
    return nullptr;
  }

 private:
  std::vector<std::unique_ptr<Recorder>> all_;
};

}  // namespace mahlwerk::observe
