// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/flow/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/sections/vector_key.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"

namespace mahlwerk::parts::flow {
namespace {

using cases::Case;
using cases::Flow;
using Feed = Flow::Feed;

void describe_inlet(cases::KeyVisitor& v, Flow& flow) {
  cases::describe(v,
                  {.component = {"inlet", "m", any_number,
                                 "middle of the box in which balls enter, in the jar's own axes"},
                   .standard = {},
                   .source = "",
                   .required = true},
                  flow.inlet);
  cases::describe(v,
                  {.component = {"inlet_size", "m", not_negative,
                                 "edges of the box along the jar's own axes; 0: a sheet or a line"},
                   .standard = {},
                   .source = "",
                   .required = true},
                  flow.inlet_size);
}

class FlowCheck {
 public:
  FlowCheck(const Case& c, std::vector<Fault>& found)
      : c_(c), flow_(*c.flow), found_(found), obstacles_(c) {}

  void all() {
    if (c_.liquid)
      fault("flow.outlet", "balls that leave and enter a jar with a liquid are not computed",
            "remove [liquid] or [flow]");
    if (c_.observe.final_state)
      fault("observe.final_state",
            "final_state = true: with [flow] some balls are outside the jar at the end, and no run "
            "can start from there",
            "leave final_state out");
    interval();
    periodic();
    outlet();
    if (flow_.feed != Feed::none) inlet();
  }

 private:
  void fault(const char* key, std::string what, std::string remedy) {
    found_.push_back({cases::location_of(c_, key), std::move(what), std::move(remedy), "bad-flow"});
  }
  void interval() {
    const double counted = cases::counted_time(c_);
    constexpr double most_rows = 1000;
    if (!flow_.interval) return;
    if (*flow_.interval > counted)
      fault("flow.interval",
            fmt::format("an interval of {} is longer than the counted time ({})",
                        show_rounded(*flow_.interval, "s"), show_rounded(counted, "s")),
            "give a shorter interval, or leave it out");
    else if (*flow_.interval < counted / most_rows * (1 - 1e-9))
      fault("flow.interval",
            fmt::format("a row every {} makes more than {} rows",
                        show_rounded(*flow_.interval, "s"), most_rows),
            fmt::format("write interval = \"{}\" or more, or leave it out",
                        show_rounded(1.05 * counted / most_rows, "s")));
  }
  bool has_left(const Vec3& p) const { return dot(p - flow_.outlet, flow_.outlet_normal) > 0; }

  /// A plane that cuts across a direction in which the jar repeats has no outside.
  void periodic() {
    const Vec3 periods = geometry::periods(*c_.jar.shape), n = flow_.outlet_normal;
    const auto across = [](double period, double along) {
      return std::isfinite(period) && std::abs(along) > 1e-12;
    };
    if (across(periods.x, n.x) || across(periods.y, n.y) || across(periods.z, n.z))
      fault("flow.outlet_normal",
            "the outlet lies across a direction in which the jar is periodic: what leaves there "
            "enters at the other end",
            "turn the outlet_normal, or take a jar with ends");
  }

  /// Some of the jar must lie on the inner side of the outlet.
  void outlet() {
    const double reach = geometry::reach(*c_.jar.shape);
    if (!std::isfinite(reach)) return;
    constexpr int points = 16;
    for (int i = 0; i <= points; ++i)
      for (int j = 0; j <= points; ++j)
        for (int k = 0; k <= points; ++k) {
          const Vec3 p =
              reach * Vec3{2.0 * i / points - 1, 2.0 * j / points - 1, 2.0 * k / points - 1};
          if (!has_left(p) && geometry::nearest_wall(*c_.jar.shape, p, reach) > 0) return;
        }
    fault("flow.outlet", "the whole jar lies beyond the outlet: all balls would leave at once",
          "give the plane from the middle of the jar, and an outlet_normal that points outwards");
  }

  /// The largest ball must find a place in the inlet.
  void inlet() {
    double largest = 0;
    for (const cases::BallSet& set : c_.balls)
      for (const cases::SizeClass& size : set.sizes()) largest = std::max(largest, size.diameter);
    constexpr int points = 8;
    double widest = -geometry::never;
    bool beyond = false;
    for (int i = 0; i <= points; ++i)
      for (int j = 0; j <= points; ++j)
        for (int k = 0; k <= points; ++k) {
          const Vec3 share{1.0 * i / points - 0.5, 1.0 * j / points - 0.5, 1.0 * k / points - 0.5};
          const Vec3 p =
              flow_.inlet + Vec3{share.x * flow_.inlet_size.x, share.y * flow_.inlet_size.y,
                                 share.z * flow_.inlet_size.z};
          beyond = beyond || has_left(p);
          widest = std::max(widest, std::min(geometry::nearest_wall(*c_.jar.shape, p, largest),
                                             obstacles_.clearance(p, 0.5 * largest)));
        }
    if (!(widest > 0.5 * largest))
      fault("flow.inlet",
            fmt::format("no ball of {} fits into the inlet: it lies outside the jar, in a part, or "
                        "too near to a wall",
                        show_rounded(largest, "m")),
            "give the middle of the inlet from the middle of the jar, in its own axes, and leave "
            "room for the radius of a ball");
    else if (beyond)
      fault("flow.inlet", "a part of the inlet lies beyond the outlet: balls would leave at once",
            "move the inlet, or turn the outlet_normal, which points outwards");
  }

  const Case& c_;
  const Flow& flow_;
  std::vector<Fault>& found_;
  cases::Obstacles obstacles_;
};

}  // namespace

void describe(cases::KeyVisitor& v, Flow& flow, const Case&) {
  cases::describe(v,
                  {.component = {"outlet", "m", any_number,
                                 "a point of the plane beyond which balls have left, in the jar's "
                                 "own axes at the start"},
                   .standard = {},
                   .source = "",
                   .required = true},
                  flow.outlet);
  cases::describe(v,
                  {.component = {"outlet_normal", "", any_number,
                                 "direction square to the plane, out of the jar"},
                   .standard = {0, 0, -1},
                   .source = "balls fall out of a standing jar",
                   .direction = true},
                  flow.outlet_normal);
  if (!v.word({"feed",
               {"none", "recirculate", "rate"},
               "none",
               "the jar empties",
               "which balls enter",
               {"none: a batch is discharged", "each ball that has left, as soon as there is room",
                "the balls that have left, at a given rate"}},
              flow.feed))
    return v.ignore_unknown_keys();
  if (flow.feed != Feed::none || v.visits_all())
    describe_inlet(v, flow);
  else
    v.refuse({"inlet", "inlet_size"}, "with feed = \"none\"",
             "remove it, or write feed = \"recirculate\" or \"rate\"");
  if (flow.feed == Feed::rate || v.visits_all())
    v.number(cases::NumberSpec("feed_rate", "1/s", positive, "balls that enter per second")
                 .with({.start = "100 1/s"}),
             flow.feed_rate);
  else
    v.refuse({"feed_rate"}, "without feed = \"rate\"", "remove it, or write feed = \"rate\"");
  v.optional_number(
      cases::NumberSpec("interval", "s", positive, "time between two rows of flow.csv")
          .with_default_text("a hundredth of the counted time"),
      flow.interval);
}

void check(const Case& c, std::vector<Fault>& found) {
  FlowCheck(c, found).all();
}

}  // namespace mahlwerk::parts::flow
