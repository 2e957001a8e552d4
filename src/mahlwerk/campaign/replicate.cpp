// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/replicate.hpp"

#include <algorithm>
#include <chrono>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/event/engine.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int stretches = 200;  // a run's time series has this many rows, however long it is

/// What is counted, and, if asked for, kept.
class Ears final : public scene::Observer {
 public:
  Ears(observe::Tally& tally, scene::Observer* also) : tally_(&tally), also_(also) {}
  void collisions(std::span<const scene::Collision> finished) override {
    if (!counting) return;
    tally_->collisions(finished);
    if (also_ != nullptr) also_->collisions(finished);
  }
  bool counting = false;

 private:
  observe::Tally* tally_;
  scene::Observer* also_;
};

event::Rules rules(const cases::Contact& c) {
  const auto lasting = c.lasting == cases::Lasting::roll ? event::Lasting::roll
                       : c.lasting == cases::Lasting::tc ? event::Lasting::tc
                                                         : event::Lasting::none;
  return {
      .bounce = c.rule,
      .lasting_friction = c.rule.tangential_restitution == 1 ? 0 : c.lasting_friction,  // (evt.15)
      .rolling_friction = c.rolling_friction,
      .lasting = lasting,
      .lasting_speed = c.lasting_speed,
      .contact_time = c.contact_time};
}

/// The change of everything between two looks, as one row of the time series.
results::Window window(double end, const scene::Account& a, const scene::Account& b,
                       const observe::Sums& all, const observe::Sums& above,
                       const observe::Tally& after) {
  return {.time = end,
          .length = b.time - a.time,
          .collisions = static_cast<double>(after.all.count - all.count),
          .above = static_cast<double>(after.above.count - above.count),
          .energy_normal = after.all.energy_normal - all.energy_normal,
          .energy_contact_point = after.all.energy_contact_point - all.energy_contact_point,
          .lost = b.lost() - a.lost(),
          .wall_work = b.wall_work - a.wall_work,
          .contact_time = b.contact_time - a.contact_time,
          .kinetic = b.kinetic};
}

}  // namespace

std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index) {
  return event::one_ball(cases::chamber(what), cases::starting_balls(what, index).front(),
                         rules(what.contact));
}

results::Replicate replicate(const cases::Case& what, int index, const Told& told,
                             std::unique_ptr<scene::Observer> keeper) {
  results::Replicate result(what.observe.threshold);
  Ears ears(result.tally, keeper.get());
  const auto running = engine(what, index);
  result.account = result.at_settled = running->account();
  // Goes on to `time` in portions of about a twentieth of a second of work, so that somebody can
  // end it; false once somebody or physics has. How it is cut changes no bit.
  double portion = 1e-3;  // [s] simulated
  const auto advance = [&](double time) {
    while (result.complete && result.account.time < time) {
      using Clock = std::chrono::steady_clock;
      const Clock::time_point began = Clock::now();
      const scene::Account before = result.account;
      try {
        running->advance(std::min(time, before.time + portion), ears);
      } catch (const RunError& e) {
        result.stopped = e.what();
      }
      const double worked = std::chrono::duration<double>(Clock::now() - began).count();
      portion = std::max(1e-9, portion * (worked < 0.025 ? 2 : worked > 0.1 ? 0.25 : 1));
      const scene::Account& now = result.account = running->account();
      const bool wanted =
          told(now.time - before.time, static_cast<double>(now.collisions - before.collisions),
               now.worst_collision);
      result.complete = wanted && result.stopped.empty();
    }
    return result.complete;
  };
  const auto settle = what.run.settle;
  const bool settled = settle <= 0 || advance(settle);
  scene::Account last = result.at_settled = result.account;
  if (!settled) return result;
  ears.counting = true;
  for (int i = 1; i <= stretches; ++i) {
    const observe::Sums all = result.tally.all, above = result.tally.above;
    const double end = what.run.time * i / stretches;
    const bool on = advance(settle + end);
    result.windows.push_back(window(end, last, result.account, all, above, result.tally));
    last = result.account;
    if (!on) break;
  }
  return result;
}

}  // namespace mahlwerk::campaign
