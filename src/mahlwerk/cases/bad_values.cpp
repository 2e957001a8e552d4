// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Values that are out of range, each for itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/grinding_fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

/// Checks of single values, for a case that no reader has seen.
class ValueCheck {
 public:
  explicit ValueCheck(const Case& c) : c_(c) {}

  void number(const std::string& key, double value, const Range& range, std::string_view unit) {
    if (std::isfinite(value) && range.holds(value)) return;
    fault(key, fmt::format("{} = {} is out of range", key, show(value, unit)));
  }
  template <class Model, class Fields>
  void fields(const std::string& section, const Model& model, const Fields& all) {
    for (const auto& f : all) number(section + std::string(f.key), model.*f.value, f.range, f.unit);
  }
  void word(const std::string& key, const std::string& word,
            const std::vector<std::string>& known) {
    if (std::ranges::find(known, word) == known.end())
      fault(key, fmt::format("there is no {} = \"{}\"", key, word));
  }
  void whole(const std::string& key, std::int64_t n, std::int64_t most) {
    if (n < 1 || n > most) fault(key, fmt::format("{} = {} must be from 1 to {}", key, n, most));
  }
  void fault(const std::string& key, std::string what) {
    found.push_back({place_of(c_, key), std::move(what),
                     "see docs/cases.md for the values of a case", "out-of-range"});
  }

  std::vector<Fault> found;

 private:
  const Case& c_;
};

void check_rule(ValueCheck& check, const std::string& section, const contact::BounceRule& rule) {
  check.number(section + "restitution", rule.restitution.value(), restitution_range, "");
  check.number(section + "tangential_restitution", rule.tangential_restitution, tangential_range,
               "");
  if (!(rule.friction >= 0))  // infinite: no Coulomb limit
    check.fault(section + "friction", section + "friction must be at least 0");
}

template <class Owner>
void check_touch(ValueCheck& check, const std::string& section, const Owner& owner,
                 const contact::ContactModel& model) {
  for (const auto& f : touch_fields<Owner>())
    check.number(section + std::string(f.key), owner.*f.value, f.range,
                 unit_of(f.key, f.unit, model));
}

template <class L>
void check_law(ValueCheck& check, const L& law) {
  for (const auto& f : L::fields())
    if (contact::is_given(law, f))
      check.number("contact." + std::string(f.key), law.*f.value, f.range, f.unit);
}

void check_contact(ValueCheck& check, const Contact& contact) {
  const contact::ContactModel& model = contact.model;
  std::visit([&](const auto& law) { check_law(check, law); }, model.law);
  check.fields("contact.", model, std::array{rolling_damping});
  check_rule(check, "contact.", contact.rule);
  check_touch(check, "contact.", contact, model);
  for (std::size_t i = 0; i < contact.pairs.size(); ++i) {
    const std::string section = fmt::format("contact.pairs.{}.", i + 1);
    check_rule(check, section, contact.pairs[i].rule);
    check_touch(check, section, contact.pairs[i], model);
  }
  check.fields("contact.", contact, contact_fields());
}

void check_sizes(ValueCheck& check, const std::string& set, const BallSet& balls) {
  std::int64_t count = 0;
  for (const SizeClass& size : balls.classes) {
    check.number(set + "diameter", size.diameter, positive, "m");
    check.whole(set + "count", size.count, most_balls);
    count += size.count;
  }
  if (!balls.classes.empty() && count != balls.count)
    check.fault(set + "count", fmt::format("{}count = {}, but its classes have {} balls", set,
                                           balls.count, count));
}

void check_balls(ValueCheck& check, const std::vector<BallSet>& balls) {
  if (balls.empty()) check.fault("balls", "there are no balls");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::string set = fmt::format("balls.{}.", i + 1);
    check.fields(set, balls[i], ball_fields());
    check_sizes(check, set, balls[i]);
    check.fields(set, balls[i].elastic, elastic_fields());
    check.fields(set, balls[i].substance, substance_fields());
    check.whole(set + "count", balls[i].count, most_balls);
    const std::vector<Vec3>& places = balls[i].positions;
    if (!places.empty() && std::cmp_not_equal(places.size(), balls[i].count))
      check.fault(set + "positions", fmt::format("{}positions has {} places for {} balls", set,
                                                 places.size(), balls[i].count));
    if (!std::ranges::all_of(places, [](const Vec3& p) { return std::isfinite(norm(p)); }))
      check.fault(set + "positions", set + "positions must be finite");
  }
}

void check_mill(ValueCheck& check, const Mill& mill) {
  std::visit([&](const auto& m) { check.fields("mill.", m, m.fields()); }, mill.motion);
  check.whole("mill.jars_carried", mill.jars_carried, most_jars);
}

void check_run(ValueCheck& check, const Run& run) {
  check.fields("run.", run, run_fields());
  if (run.until) {
    check.number("run.time", run.until->within, until_range, "");
    check.word("run.until", run.until->quantity, until_words());
  }
  if (run.time_step) check.number("run.time_step", *run.time_step, positive, "s");
  check.number("run.time_step_fraction", run.time_step_fraction, step_share.range, "");
  check.whole("run.replicates", run.replicates, most_replicates);
}

void check_heat(ValueCheck& check, const Heat& heat) {
  check.fields("heat.", heat, heat_fields());
  check.fields("heat.", heat, std::array{cycle_milling, pause_time});
  check.whole("heat.cycles", heat.cycles, most_cycles);
}

void check_powder(ValueCheck& check, const Powder& powder) {
  using Law = powder::Feed::Law;
  check.number("powder.mass", powder.mass, positive, "kg");
  if (powder.size) check.number("powder.size", *powder.size, positive, "m");
  if (powder.density) check.number("powder.density", *powder.density, positive, "kg/m3");
  if (powder.grain_size) check.number("powder.grain_size", *powder.grain_size, positive, "m");
  const powder::Feed& feed = powder.feed;
  if (feed.law == Law::lognormal || feed.law == Law::rosin_rammler) {
    check.number("powder.size", feed.size, positive, "m");
    check.number("powder.spread", feed.spread, feed_spreads(feed.law), "");
  }
  const auto rises = [](const auto& a, const auto& b) { return a[0] < b[0] && a[1] <= b[1]; };
  const auto& rows = feed.passing;
  if (feed.law != Law::sieves) return;
  bool sound = rows.size() > 1 && rows.front()[0] > 0 && rows.front()[1] == 0 &&
               std::isfinite(rows.back()[0]) && rows.back()[1] == 1;
  for (std::size_t i = 1; i < rows.size(); ++i) sound = sound && rises(rows[i - 1], rows[i]);
  if (!sound) check.fault("powder.passing", "powder.passing must rise from 0 to 1");
}

template <class... Models>
void check_model(ValueCheck& check, const std::string& section,
                 const std::variant<Models...>& any) {
  std::visit([&](const auto& m) { check.fields(section, m, m.fields()); }, any);
}

void check_grinding(ValueCheck& check, const Grinding& g) {
  check_model(check, "breakage.", g.breakage);
  check_model(check, "fragments.", g.fragments);
  check.fields("grinding.", g, grinding_shares());
  check.fields("grinding.", g, std::array{grinding_time, smallest_size, welding_energy});
  if (g.sticking_size) check.number("grinding.sticking_size", *g.sticking_size, positive, "m");
  check.whole("grinding.classes_per_octave", g.classes_per_octave, most_per_octave);
  if (g.classes_per_octave % size_step != 0)
    check.fault("grinding.classes_per_octave",
                fmt::format("grinding.classes_per_octave = {} is no multiple of {}",
                            g.classes_per_octave, size_step));
  check.whole("grinding.sample", g.sample, most_sample);
}

void check_kinetics(ValueCheck& check, const Kinetics& k) {
  check.fields("kinetics.", k.conversion, kinetics_fields());
  check.fields("kinetics.", k, std::array{kinetics_time});
  check.number("kinetics.initial", k.initial, any_number, "");
  check.number("kinetics.final", k.final, any_number, "");
}

}  // namespace

std::vector<Fault> bad_values(const Case& c) {
  ValueCheck check(c);
  check.fields("", c, case_fields());
  check_mill(check, c.mill);
  if (axis_word(c.mill.jar_axis).empty())
    check.fault("mill.jar_axis",
                "mill.jar_axis must be vertical (0, 0, 1) or horizontal (1, 0, 0)");
  std::visit([&](const auto& s) { check.fields("jar.", s, s.fields()); }, c.jar.shape);
  check.fields("jar.", c.jar.elastic, elastic_fields());
  check.fields("jar.", c.jar.substance, substance_fields());
  check.fields("jar.", c.jar, std::array{wall_density, wall_thickness});
  check_balls(check, c.balls);
  if (c.powder) check_powder(check, *c.powder);
  check_contact(check, c.contact);
  check_run(check, c.run);
  check.fields("observe.", c.observe, observe_fields());
  if (c.wear) check.fields("wear.", *c.wear, std::array{wear_coefficient});
  if (c.heat) check_heat(check, *c.heat);
  if (c.capture) {
    check_model(check, "capture.", c.capture->model);
    check.fields("capture.", *c.capture, std::array{energy_share});
  }
  if (c.grinding) check_grinding(check, *c.grinding);
  if (c.kinetics) check_kinetics(check, *c.kinetics);
  if (c.observe.frames) check.number("observe.frames", *c.observe.frames, positive, "s");
  return std::move(check.found);
}

}  // namespace mahlwerk::cases
