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
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/sections/key_reader.hpp"
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

/// The names of `fresh_feed`; none after a fault.
std::vector<std::string> read_names(cases::SectionReader& in) {
  const cases::Node* at = in.find("fresh_feed");
  std::vector<std::string> names;
  if (at == nullptr) return names;
  const bool sound = at->kind == cases::Node::Kind::list && !at->items.empty() &&
                     std::ranges::all_of(at->items, [](const cases::Node& one) {
                       return one.kind == cases::Node::Kind::text;
                     });
  if (!sound) {
    in.fault(*at, "`fresh_feed` must be a list of names of ball sets",
             "write fresh_feed = [\"balls.1\"], [\"powder\"], or the name of a material",
             "wrong-type");
    return names;
  }
  for (const cases::Node& one : at->items) names.push_back(one.text);
  in.record_origin("fresh_feed", cases::list_text(names), at);
  return names;
}

void describe_fresh_feed(cases::KeyVisitor& v, Flow& flow) {
  if (cases::SectionReader* in = v.reader()) {
    flow.fresh_feed = read_names(*in);
    return;
  }
  if (flow.fresh_feed.empty() && !v.visits_all()) return;
  v.custom({.key = "fresh_feed",
            .about = "ball sets that are outside at the start and wait to be fed: \"balls.2\", "
                     "\"powder\", or a material",
            .default_text = "no ball set"},
           [&] { return cases::list_text(flow.fresh_feed); });
}

/// The rate, by number or by mass, and whether what has left comes again.
void describe_rate(cases::KeyVisitor& v, Flow& flow) {
  const cases::NumberSpec by_mass = cases::NumberSpec("feed_mass_rate", "kg/s", positive,
                                                      "mass of the balls that enter per second")
                                        .with({.start = "10 g/s"})
                                        .in_place_of("feed_rate");
  cases::SectionReader* in = v.reader();
  const bool mass = in != nullptr ? in->one_of({"feed_rate", by_mass.key}) == by_mass.key
                                  : flow.feed_mass_rate.has_value();
  if (mass || v.visits_all()) v.optional_number(by_mass, flow.feed_mass_rate);
  if (!mass || v.visits_all())
    v.number(cases::NumberSpec("feed_rate", "1/s", positive, "balls that enter per second")
                 .with({.start = "100 1/s"}),
             flow.feed_rate);
  const cases::Flag again{"recirculate", false, "what has left stays outside",
                          "with fresh_feed: whether what has left waits to be fed again"};
  if (!flow.fresh_feed.empty() || v.visits_all()) return v.flag(again, flow.recirculate);
  v.refuse_but_default(again, "without fresh_feed: only what has left is fed",
                       "remove it, or give fresh_feed");
}

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
    fresh_feed();
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

  void fresh_feed() {
    if (flow_.fresh_feed.empty() || c_.balls.empty()) return;
    for (const std::string& name : flow_.fresh_feed)
      if (cases::pair_selector(name, c_).kinds.empty())
        fault(
            "flow.fresh_feed", fmt::format("no ball set is called \"{}\"", name),
            "name ball sets as \"balls.1\", \"balls.2\", the grains as \"powder\", or a material");
    const std::vector<bool> fresh = cases::fresh_sets(c_);
    for (std::size_t i = 0; i < fresh.size(); ++i)
      if (fresh[i] && !c_.balls[i].positions.empty())
        fault("flow.fresh_feed",
              fmt::format("{} is fed, and has positions in the jar", cases::set_name(c_, i)),
              "give its count in place of positions, or take it out of fresh_feed");
    if (c_.run.start_from.states)
      fault("flow.fresh_feed", "run.start_from gives all balls a place, those that are fed too",
            "remove start_from or fresh_feed");
  }

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
               {"none: a batch is discharged",
                "the fresh feed, and each ball that has left, as soon as there is room",
                "at a given rate: the fresh feed, or the balls that have left"}},
              flow.feed))
    return v.ignore_unknown_keys();
  if (flow.feed != Feed::none || v.visits_all())
    describe_inlet(v, flow), describe_fresh_feed(v, flow);
  else
    v.refuse({"inlet", "inlet_size", "fresh_feed"}, "with feed = \"none\"",
             "remove it, or write feed = \"recirculate\" or \"rate\"");
  if (flow.feed == Feed::rate || v.visits_all())
    describe_rate(v, flow);
  else
    v.refuse({"feed_rate", "feed_mass_rate", "recirculate"}, "without feed = \"rate\"",
             "remove it, or write feed = \"rate\"");
  v.optional_number(
      cases::NumberSpec("interval", "s", positive, "time between two rows of flow.csv")
          .with_default_text("a hundredth of the counted time"),
      flow.interval);
}

void check(const Case& c, std::vector<Fault>& found) {
  FlowCheck(c, found).all();
}

}  // namespace mahlwerk::parts::flow
