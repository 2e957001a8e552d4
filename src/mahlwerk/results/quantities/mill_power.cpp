// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Power of a tumbling mill beside the formulas of comminution, and scaled to its length.
#include "mahlwerk/cases/mill_power.hpp"

#include <numbers>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/flow.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using cases::MillNumbers;

bool is_mill(const Case& c) {
  return cases::mill_numbers(c).has_value();
}
MillNumbers numbers(const Case& c, const Replicate& r) {
  MillNumbers mill = cases::mill_numbers(c).value_or(MillNumbers());
  mill.speed *= mill_rate(c, r);
  return mill;
}
double drawn(const Replicate& r) {
  return per_time(r, &scene::EnergyBalance::wall_work);
}

/// [deg] An angle of Morrell's, from 3 o'clock, as one from the lowest point.
double from_lowest(double angle) {
  return angle * 180 / std::numbers::pi + 90;
}

double bond(const Case& c, const MillNumbers& mill) {
  return cases::bond_power(mill, cases::balls_mass(cases::sets_at_start(c)));
}
double hogg_fuerstenau(const Case&, const MillNumbers& mill) {
  return cases::hogg_fuerstenau_power(mill, cases::usual_lift_angle);
}
double morrell(const Case&, const MillNumbers& mill) {
  return cases::morrell_losses * cases::morrell_charge(mill).power;
}
double morrell_toe(const Case&, const MillNumbers& mill) {
  return from_lowest(cases::morrell_charge(mill).toe) - 360;
}
double morrell_shoulder(const Case&, const MillNumbers& mill) {
  return from_lowest(cases::morrell_charge(mill).shoulder);
}

template <const cases::FormulaRange& range>
bool in_range(const Case& c) {
  return cases::may_hold(range, c);
}
constexpr std::string_view only_in_range = "in the range of the formula";

using Formula = double (*)(const Case&, const MillNumbers&);

/// By a formula, at the mean speed of the run; NaN outside its range.
template <Formula formula, const cases::FormulaRange& range>
double in_run(const Case& c, const Replicate& r) {
  const MillNumbers mill = numbers(c, r);
  return range.has(mill) ? formula(c, mill) : undefined;
}

/// A power by a formula, and the simulated one over it.
template <Formula formula, const cases::FormulaRange& range>
Measures beside(const char* name, const char* about, const char* ratio, const char* about_ratio,
                const char* equation) {
  return {{name,
           "W",
           about,
           in_run<formula, range>,
           {.equation = equation, .applies = in_range<range>, .only = only_in_range}},
          {ratio,
           "1",
           about_ratio,
           [](const Case& c, const Replicate& r) {
             return share(drawn(r), in_run<formula, range>(c, r));
           },
           {.equation = equation, .applies = in_range<range>, .only = only_in_range}}};
}

}  // namespace

Measures mill_power_measures() {
  Measures all{{"power_per_charge",
                "kW/t",
                "drawn power per mass of balls",
                [](const Case& c, const Replicate& r) {
                  return share(drawn(r), cases::balls_mass(c.balls));
                },
                {.heading = "Power of the mill"}},
               {"power_per_length", "kW/m", "drawn power per length of the drum",
                [](const Case& c, const Replicate& r) {
                  return share(drawn(r) / 1000, numbers(c, r).length);
                }},
               {"power_of_whole_mill",
                "W",
                "drawn power times the length of the whole mill over that of the slice",
                [](const Case& c, const Replicate& r) {
                  return drawn(r) * c.jar.mill_length.value_or(undefined) / numbers(c, r).length;
                },
                {.applies = [](const Case& c) { return c.jar.mill_length.has_value(); },
                 .only = "with `mill_length` in `[jar]`"}}};
  const auto add = [&](Measures more) {
    for (Measure& m : more) all.push_back(std::move(m));
  };
  add(beside<bond, cases::bond_range>("bond_power", "power at the shell by Bond's formula",
                                      "power_over_bond", "drawn power over that by Bond's formula",
                                      "mil.1"));
  add(beside<hogg_fuerstenau, cases::hogg_fuerstenau_range>(
      "hogg_fuerstenau_power", "net power by Hogg and Fuerstenau, lift angle 35 degrees",
      "power_over_hogg_fuerstenau", "drawn power over that by Hogg and Fuerstenau", "mil.2"));
  add(beside<morrell, cases::morrell_range>(
      "morrell_power", "power of the charge by Morrell's C model, times 1.26 for losses",
      "power_over_morrell", "drawn power over that by Morrell's C model", "mil.7"));
  all.push_back({"morrell_toe_angle",
                 "deg",
                 "toe of the charge by Morrell's C model, from the lowest point",
                 in_run<morrell_toe, cases::morrell_range>,
                 {.range = any_value,
                  .equation = "mil.3",
                  .applies = in_range<cases::morrell_range>,
                  .only = only_in_range}});
  all.push_back({"morrell_shoulder_angle",
                 "deg",
                 "shoulder of the charge by Morrell's C model, from the lowest point",
                 in_run<morrell_shoulder, cases::morrell_range>,
                 {.range = any_value,
                  .equation = "mil.4",
                  .applies = in_range<cases::morrell_range>,
                  .only = only_in_range}});
  return where(is_mill, "drums with balls that turn about a lying axis", all);
}

}  // namespace mahlwerk::results
