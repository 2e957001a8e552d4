// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/still.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;

double impacts_per_ball(const Case& c, const Replicate& r, const observe::CollisionSums& sums) {
  // A collision of two balls is one impact on each ball.
  return share(static_cast<double>(sums.count + sums.between_balls), r.time() * count_of_balls(c));
}

double drawn(const Replicate& r) {
  return per_time(r, &scene::EnergyBalance::wall_work);
}

/// [N m] (obs.7), (obs.16)
double shaft_torque(const Case& c, const Replicate& r) {
  return drawn(r) / mill_speed(c, r);
}

/// The jar's stirrer, if it has one that turns in a vessel at rest; else null.
const geometry::Attritor* stirrer(const Case& c) {
  if (kinematics::as<kinematics::Still>(*c.mill.motion) == nullptr) return nullptr;
  const auto* vessel = std::get_if<geometry::Attritor>(&*c.jar.shape);
  return vessel != nullptr && vessel->rotor_speed != 0 ? vessel : nullptr;
}

/// [1] Power number of the stirrer (obs.17).
double power_number(const Case& c, const Replicate& r) {
  const geometry::Attritor& vessel = *stirrer(c);
  const double n = mill_speed(c, r) / (2 * std::numbers::pi);
  return drawn(r) / (cases::bulk_density(c.balls) * n * n * n * math::pow(vessel.arm_span, 5));
}

/// [1] Number of powder particles; NaN if their size is not known.
double particles(const Case& c) {
  if (!c.powder->size || !c.powder->density) return undefined;
  const double x = *c.powder->size;
  return c.powder->mass / (*c.powder->density * std::numbers::pi / 6 * x * x * x);
}

double stress_energy(const Replicate& r) {
  return share(r.tally.above.energy_contact_point, static_cast<double>(r.tally.above.count));
}

constexpr double one_hour = 3600;  // [s]

/// [J/kg] The dose whose milling time is computed.
double dose_asked(const Case& c) {
  return c.milling.value_or(cases::MillingTime()).dose;
}

double dose_rate(const Case& c, const Replicate& r) {
  return dissipated_power(r) / (1000 * c.powder->mass);
}

bool is_tumbling(const Case& c) {
  return cases::drum_motion(c) != nullptr;
}
bool is_stirred(const Case& c) {
  return stirrer(c) != nullptr;
}

/// The charge of balls: of a campaign that varies sizes, these are columns.
Measures charge_measures() {
  return {{"ball_count",
           "1",
           "number of balls of all sets",
           [](const Case& c, const Replicate&) { return count_of_balls(c); },
           {.label = "number of balls"}},
          {"balls_mass",
           "g",
           "mass of all balls",
           [](const Case& c, const Replicate&) { return 1000 * cases::balls_mass(c.balls); },
           {.label = "mass of the balls"}}};
}

/// Speed and filling of a drum, as comminution states them.
Measures drum_measures() {
  return where(
      is_tumbling, "tumbling mills",
      {{"drum_speed",
        "rpm",
        "mean speed of the drum",
        [](const Case& c, const Replicate& r) { return mill_speed(c, r) * 30 / std::numbers::pi; },
        {.label = "speed of the drum", .symbol = "$n$"}},
       {"bulk_filling",
        "1",
        "J: bulk volume of the balls, with 40 % voids, over the volume of the jar",
        [](const Case& c, const Replicate&) {
          return cases::bulk_filling(cases::sets_at_start(c), c.jar);  // (obs.14)
        },
        {.label = "bulk filling of balls", .symbol = "$J$", .equation = "obs.14"}},
       {"void_filling",
        "1",
        "U: bulk volume of the powder over the voids between the balls at rest",
        [](const Case& c, const Replicate&) {
          return *cases::void_filling(c);  // (obs.15)
        },
        {.label = "powder filling of the voids",
         .symbol = "$U$",
         .equation = "obs.15",
         .applies = [](const Case& c) { return cases::void_filling(c).has_value(); },
         .only = "with `[powder]` of known density"}}});
}

Measures stirrer_measures() {
  return where(is_stirred, "`kind = \"attritor\"` in a mill at rest",
               {{"rotor_torque",
                 "N m",
                 "drawn power over the mean speed of the rotor; without friction of the drive",
                 shaft_torque,
                 {.label = "torque of the rotor", .symbol = "$M$", .equation = "obs.16"}},
                {"power_number",
                 "1",
                 "Np: drawn power over rho N^3 d^5, with the bulk density rho of the balls, the "
                 "turns N of the rotor per second and its diameter d",
                 power_number,
                 {.symbol = "$N_{p}$", .equation = "obs.17"}}});
}

bool has_milling_time(const Case& c) {
  return cases::milling_time(c).has_value();
}

std::string about_dose(const Case& c) {
  return has_milling_time(c)
             ? "dose rate times the milling time"
             : "dose rate times the milling time, which the case does not give: [milling] time";
}
std::string about_time_to_dose(const Case& c) {
  return fmt::format("milling time, without pauses, to a dose of {} ([milling] dose)",
                     show_rounded(dose_asked(c), "J/kg"));
}

}  // namespace

Measures mill_measures() {
  Measures list{
      {"impacts_per_ball", "1/s",
       "impacts of each ball per second, with other balls and with the jar",
       [](const Case& c, const Replicate& r) { return impacts_per_ball(c, r, r.tally.all); }},
      {"impacts_per_ball_above_threshold", "1/s",
       "impacts of each ball per second with a normal speed u_n of at least the threshold",
       [](const Case& c, const Replicate& r) { return impacts_per_ball(c, r, r.tally.above); }},
      {"power_imbalance",
       "1",
       "drawn over dissipated power, minus one: where it is not small, the charge still gains or "
       "loses energy",
       [](const Case&, const Replicate& r) { return share(drawn(r), dissipated_power(r)) - 1; },
       {.range = any_value}},
      {"shaft_torque",
       "N m",
       "drawn power over the mean speed of the shaft, per jar; without friction of the drive",
       shaft_torque,
       {.symbol = "$M$",
        .equation = "obs.7",
        .applies = [](const Case& c) { return cases::shaft_speed(c) && !is_stirred(c); },
        .only = "tumbling and planetary mills"}},
  };
  for (Measures (*more)() : {charge_measures, drum_measures, stirrer_measures})
    std::ranges::move(more(), std::back_inserter(list));
  list.push_back({"drawn_power_of_mill",
                  "W",
                  "drawn power of all jars that the mill carries",
                  [](const Case& c, const Replicate& r) {
                    return drawn(r) * static_cast<double>(c.mill.jars_carried);
                  },
                  {.label = "drawn power of all jars",
                   .applies = [](const Case& c) { return c.mill.jars_carried > 1; },
                   .only = "with more than one jar"}});
  return list;
}

Measures dose_measures() {
  const auto weighed_powder = [](const Case& c) { return c.powder && c.powder->mass > 0; };
  const auto of_known_size = [](const Case& c) { return c.powder->size && c.powder->density; };
  return where(
      weighed_powder, "with `[powder]`",
      {
          {"specific_energy_dose_rate",
           "W/g",
           "dissipated power per mass of powder: an upper bound of what the powder gets",
           dose_rate,
           {.heading = "Energy per mass of powder", .key = 4}},
          {"specific_energy_dose",
           "J/g",
           "dose rate times the milling time",
           [](const Case& c, const Replicate& r) {
             return dose_rate(c, r) * cases::milling_time(c).value_or(undefined);
           },
           {.key = 6, .about = about_dose}},
          {"milling_time",
           "s",
           "operating time of the mill without pauses, as the case gives it",
           [](const Case& c, const Replicate&) { return *cases::milling_time(c); },
           {.applies = has_milling_time, .only = "if the case gives it"}},
          {"specific_energy_dose_per_hour",
           "J/g",
           "dose of an hour of milling without pauses",
           [](const Case& c, const Replicate& r) { return one_hour * dose_rate(c, r); },
           {.key = 5}},
          {"time_to_dose",
           "s",
           "milling time, without pauses, to a dose ([milling] dose)",
           [](const Case& c, const Replicate& r) {
             return share(dose_asked(c) / 1000, dose_rate(c, r));
           },
           {.key = 7, .about = about_time_to_dose}},
          {"specific_impact_power", "W/g",
           "impact energy of the contact points of all collisions, per second and mass of powder",
           [](const Case& c, const Replicate& r) {
             return share(r.tally.all.energy_contact_point, r.time() * 1000 * c.powder->mass);
           }},
          {"stress_energy",
           "J",
           "mean impact energy m (u_n^2 + u_t^2)/2 of a stress event, a collision above the "
           "threshold",
           [](const Case&, const Replicate& r) { return stress_energy(r); },
           {.symbol = "$E$", .above_threshold = true}},
          {"stress_number_rate",
           "1/s",
           "stress events per second and particle of the powder, one particle an event",
           [](const Case& c, const Replicate& r) {
             return share(static_cast<double>(r.tally.above.count), r.time() * particles(c));
           },
           {.above_threshold = true,
            .applies = of_known_size,
            .only = "of known size and density"}},
      });
}

Measures energy_balance_measures() {  // (obs.3)
  return where(knows_losses, not_in_lammps,
               {
                   {"dissipated_power_of_collisions", "W",
                    "power dissipated in finished collisions: the sum of the spectrum",
                    [](const Case&, const Replicate& r) {
                      return share(above_rounding(r, r.tally.all.lost), r.time());
                    }},
                   {"dissipated_power_of_lasting_contacts",
                    "W",
                    "power dissipated in sustained contacts, for which there are no collision "
                    "records, and in "
                    "contacts that had not ended",
                    [](const Case&, const Replicate& r) {
                      return per_time(r, &scene::EnergyBalance::lost_lasting) +
                             per_time(r, &scene::EnergyBalance::lost_open);
                    },
                    {.range = any_value, .label = "dissipated power of sustained contacts"}},
               });
}

}  // namespace mahlwerk::results
