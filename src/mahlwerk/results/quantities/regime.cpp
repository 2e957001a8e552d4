// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/regime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"
#include "mahlwerk/results/quantities/motion_states.hpp"
#include "mahlwerk/results/quantities/regime_rule.hpp"

namespace mahlwerk::results {
bool has_regime(const cases::Case& mill_case) {
  const kinematics::Tumbling* drum = cases::drum_motion(mill_case);
  return (drum != nullptr && drum->speed != 0 && mill_case.gravity > 0) ||
         kinematics::as<kinematics::Planetary>(*mill_case.mill.motion) != nullptr;
}

namespace {

using cases::Case;
using kinematics::Planetary;
using kinematics::Tumbling;
using observe::Charge;

constexpr double degrees = 180 / std::numbers::pi;

/// The motion of a mill with a regime that is not a drum.
const Planetary& planetary(const Case& c) {
  const auto* mill = kinematics::as<Planetary>(*c.mill.motion);
  if (mill == nullptr) throw std::logic_error("a regime is that of a drum or of a planetary mill");
  return *mill;
}

/// Zero of angles, from the plane's right axis, and the sense in which they increase (obs.8). Drum:
/// from its lowest point, in its sense of rotation. Planetary mill: from the outward direction, in
/// the jar's sense of rotation on its disc.
struct Reference {
  double zero = 0;  // [rad]
  double sense = 1;
};
Reference reference(const Case& c) {
  if (const Tumbling* drum = cases::drum_motion(c))
    return {-0.5 * std::numbers::pi, drum->speed < 0 ? -1.0 : 1.0};
  return {0, planetary(c).ratio * planetary(c).speed < 0 ? -1.0 : 1.0};
}

/// Toe and shoulder [deg]: the 5 % and 95 % quantiles of the charge's mass by angle. Counting
/// begins opposite the centre of mass. The toe is within half a turn of the reference.
struct Ends {
  double toe = undefined, shoulder = undefined;
};
Ends ends(const Charge& charge, const Reference& from) {
  constexpr int n = Charge::angles;
  const double step = 2 * std::numbers::pi / n;
  double x = 0, y = 0, all = 0;
  for (std::size_t i = 0; i < charge.mass_by_angle.size(); ++i) {
    const double at = step * (static_cast<double>(i) + 0.5);
    x += charge.mass_by_angle[i] * math::cos(at);
    y += charge.mass_by_angle[i] * math::sin(at);
    all += charge.mass_by_angle[i];
  }
  if (!(all > 0)) return {};
  const int first = static_cast<int>(std::floor((math::atan2(y, x) + std::numbers::pi) / step));
  const int on = from.sense < 0 ? -1 : 1;  // whole slots, in the sense of rotation
  const double start = from.sense * (step * (on < 0 ? first + 1 : first) - from.zero);
  const auto angle_of = [&](double part) {
    double below = 0;
    for (int k = 0; k < n; ++k) {
      const double mass = charge.mass_by_angle[static_cast<std::size_t>((first + on * k + n) % n)];
      if (mass > 0 && below + mass >= part * all)
        return start + step * (k + (part * all - below) / mass);
      below += mass;
    }
    return start + 2 * std::numbers::pi;
  };
  const double toe = angle_of(0.05), wrapped = std::remainder(toe, 2 * std::numbers::pi);
  return {degrees * wrapped, degrees * (wrapped + angle_of(0.95) - toe)};
}

/// Rounding of the contact time may exceed the time by its last digits.
double flight_share(const Case& c, const Replicate& r) {
  const double flying = 1 - per_time(r, &scene::EnergyBalance::contact_time) / count_of_balls(c);
  return flying < 0 ? 0 : flying;
}

/// A ball in flight touches nothing and is outside the bed, so the share is at most either.
double airborne_share(const Case& c, const Replicate& r) {
  const double outside = share(r.charge.mass_outside, r.charge.mass_sought),
               flying = flight_share(c, r);
  return std::isnan(outside) || std::isnan(flying) ? undefined : std::min(outside, flying);
}

/// Mass in the emptiest of 36 sectors over that of a uniformly spread charge.
double emptiest_sector(const Case&, const Replicate& r) {
  constexpr std::size_t sectors = 36, each = Charge::angles / sectors;
  const std::vector<double>& mass = r.charge.mass_by_angle;
  const double all = std::accumulate(mass.begin(), mass.end(), 0.0);
  double least = all;
  for (std::size_t s = 0; s < sectors && !mass.empty(); ++s)
    least = std::min(
        least, std::accumulate(mass.begin() + static_cast<std::ptrdiff_t>(s * each),
                               mass.begin() + static_cast<std::ptrdiff_t>((s + 1) * each), 0.0));
  return share(least * static_cast<double>(sectors), all);
}

double toe(const Case& c, const Replicate& r) {
  return ends(r.charge, reference(c)).toe;
}
double shoulder(const Case& c, const Replicate& r) {
  return ends(r.charge, reference(c)).shoulder;
}

/// [rad/s] Mean angular velocity of the jar.
double jar_spin(const Case& c, const Replicate& r) {
  const Tumbling* drum = cases::drum_motion(c);
  return mill_rate(c, r) * (drum != nullptr ? drum->speed : planetary(c).jar_spin());
}

double wall_slip(const Case& c, const Replicate& r) {
  const double wall = std::abs(jar_spin(c, r)) * r.tally.wall_map.grid().radius;
  return share(share(r.charge.wall_slip, r.charge.mass_at_wall), wall);
}

bool is_drum(const Case& c) {
  return cases::drum_motion(c) != nullptr;
}

/// [m] Distance of the centre of the largest ball on the wall from the jar's axis.
double arm(const Case& c, const Replicate& r) {
  double largest = 0;
  for (const cases::BallSet& set : c.balls)
    for (const cases::SizeClass& size : set.sizes())
      if (!set.grains) largest = std::max(largest, 0.5 * size.diameter);
  return r.tally.wall_map.grid().radius - largest;
}

/// Acceleration that presses the largest ball on the wall over that which pulls it off: gravity in
/// a drum, the disc's rotation in a planetary mill.
double pinning(const Case& c, const Replicate& r) {
  if (const auto* mill = kinematics::as<Planetary>(*c.mill.motion)) {
    const double spin = mill->jar_spin();
    return spin * spin * arm(c, r) / (mill->speed * mill->speed * mill->orbit_radius);
  }
  const double spin = jar_spin(c, r);
  return share(spin * spin * arm(c, r), c.gravity);
}

/// [m/s] Mean speed of the wall's surface seen from the carrier, which holds the jar's centre.
double wall_speed(const Case& c, const Replicate& r) {
  const auto* mill = kinematics::as<Planetary>(*c.mill.motion);
  const double spin = mill != nullptr ? mill->ratio * mill->speed * mill_rate(c, r)
                                      : jar_spin(c, r);  // seen from the carrier
  return std::abs(spin) * r.tally.wall_map.grid().radius;
}

/// Acceleration of the largest ball on the wall seen from the carrier, over the field.
double froude_on_carrier(const Case& c, const Replicate& r) {
  if (is_drum(c)) return pinning(c, r);
  const double ratio = planetary(c).ratio;
  return ratio * ratio * arm(c, r) / planetary(c).orbit_radius;
}

/// Speed of the charge seen from the jar of a planetary mill, over the disc's at the jar.
double speed_over_disc(const Case& c, const Replicate& r) {
  return share(speed_in_jar(r), mill_speed(c, r) * planetary(c).orbit_radius);
}

/// Speeds over wall_speed(): of the charge seen from the jar and from its carrier, and of the slip
/// at the wall. Undefined without samples of the balls.
double jar_lag(const Case& c, const Replicate& r) {
  return share(speed_in_jar(r), wall_speed(c, r));
}
double carrier_motion(const Case& c, const Replicate& r) {
  return share(speed_in_carrier(r), wall_speed(c, r));
}
double slip_at_wall(const Case& c, const Replicate& r) {
  return share(share(r.charge.wall_slip, r.charge.mass_at_wall), wall_speed(c, r));
}

double wall_share(const Case&, const Replicate& r) {
  return share(r.charge.mass_at_wall, r.charge.mass_total);
}

/// Mean square over squared mean of the charge's squared speed seen from the jar (obs.19).
double intermittency(const Case&, const Replicate& r) {
  const double speed = speed_in_jar(r), squared = speed * speed;
  return share(share(r.charge.jar_speed_fourth, r.charge.in_jar.time()), squared * squared);
}

using Sign = double (*)(const Case&, const Replicate&);

/// The word by the numbers that `value_of` gives. "resting": the jar is at rest on its carrier, and
/// the charge in the jar.
template <class ValueOf>
std::string named(const Case& c, const ValueOf& value_of) {
  constexpr double little = 0.01;
  if (!is_drum(c) && planetary(c).ratio == 0 && value_of(speed_over_disc) < little)
    return "resting";
  return std::string(regime_word({.froude = value_of(froude_on_carrier),
                                  .flight_share = value_of(flight_share),
                                  .airborne_share = value_of(airborne_share),
                                  .emptiest_sector = value_of(emptiest_sector),
                                  .jar_lag = value_of(jar_lag),
                                  .carrier_motion = value_of(carrier_motion),
                                  .wall_slip = value_of(slip_at_wall),
                                  .wall_share = value_of(wall_share),
                                  .intermittency = value_of(intermittency)},
                                 is_drum(c)));
}

/// Mean over the averaged replicates.
double mean_of(const Outcome& outcome, Sign of) {
  double sum = 0;
  const auto chosen = averaged_replicates(outcome);
  const cases::CaseBySense by_sense(outcome.mill_case);
  for (const Replicate* r : chosen) sum += of(by_sense.of(number_of(outcome, *r) - 1), *r);
  return chosen.empty() ? undefined : sum / static_cast<double>(chosen.size());
}

std::string about_toe(const Case& c) {
  return is_drum(c)
             ? "angle below which 5 % of the charge lies, from the lowest point in the sense "
               "of rotation"
             : "angle below which 5 % of the charge lies, in the disc's frame, from the "
               "outward direction in the jar's sense of rotation";
}

}  // namespace

Measures regime_measures() {
  return where(
      has_regime, "drums and planetary mills",
      {
          {"flight_share",
           "1",
           "share of the balls' time without any contact, between the bounces in a bed too",
           flight_share,
           {.range = share_of_whole,
            .label = "share of time in flight",
            .symbol = "$φ$",
            .heading = "Motion of the charge"}},
          {"airborne_share",
           "1",
           "share of the charge's mass in flight outside the bed",
           airborne_share,
           {.range = share_of_whole, .equation = "obs.18"}},
          {"toe_angle",
           "deg",
           "angle below which 5 % of the charge lies, in the sense of rotation",
           toe,
           {.range = any_value,
            .applies = has_one_sense,
            .only = in_one_sense,
            .about = about_toe}},
          {"shoulder_angle",
           "deg",
           "angle below which 95 % of the charge lies, measured as the toe angle",
           shoulder,
           {.range = any_value, .applies = has_one_sense, .only = in_one_sense}},
          {"emptiest_sector",
           "1",
           "mass in the emptiest 10 degrees about the axis over that of a uniformly spread charge",
           emptiest_sector,
           {.range = share_of_whole}},  // at most the mean mass of all sectors
          {"wall_slip_ratio", "1",
           "mean slip speed of balls at the wall over the wall's speed of rotation", wall_slip},
          {"jar_lag", "1",
           "root mean square speed of the charge seen from the jar over the wall's speed seen from "
           "the carrier: 0 if the charge turns with the jar",
           jar_lag},
          {"intermittency",
           "1",
           "mean square over squared mean of the charge's squared speed seen from the jar: 1 if it "
           "moves steadily, 2 if it moves half of the time",
           intermittency,
           {.equation = "obs.19"}},
          {"froude_number",
           "1",
           "centripetal acceleration of the largest ball at the wall over gravity: 1 pins it",
           pinning,
           {.applies = is_drum, .only = "drums"}},
          {"pinning_ratio",
           "1",
           "centripetal acceleration of the largest ball at the wall by the jar's rotation over "
           "that by the disc's: above 1 the ball is pinned",
           pinning,
           {.applies = [](const Case& c) { return !is_drum(c); }, .only = "planetary mills"}},
      });
}

std::string regime(const Outcome& outcome) {
  const Case& c = outcome.mill_case;
  if (averaged_replicates(outcome).empty()) return "";
  if (has_motion_states(c)) return motion_word(averaged_replicates(outcome));
  if (!has_regime(c)) return "";
  return named(c, [&](Sign of) { return mean_of(outcome, of); });
}

std::string regime(const Case& mill_case, const Replicate& r) {
  if (!(r.time() > 0)) return "";
  if (has_motion_states(mill_case)) return motion_word({&r});
  if (!has_regime(mill_case)) return "";
  return named(mill_case, [&](Sign of) { return of(mill_case, r); });
}

std::string regime_reason(const Outcome& outcome) {
  const auto mean = [&](Sign of) { return mean_of(outcome, of); };
  const std::string lies =
      has_one_sense(outcome.mill_case)
          ? fmt::format("lies from {:.0f}° to {:.0f}° and ", mean(toe), mean(shoulder))
          : "";
  return fmt::format(
      "{:.0f} % of the mass fly outside the bed (balls touch nothing for {:.0f} % of their time), "
      "the emptiest 10° about the axis hold {:.0f} % of a uniform charge's share, the charge {}"
      "moves at {:.2g} of the wall's speed seen from the jar, {:.2g} seen from its carrier, balls "
      "slip at {:.2g} of it on the wall, intermittency {:.2g}, {} {:.2g}",
      100 * mean(airborne_share), 100 * mean(flight_share), 100 * mean(emptiest_sector), lies,
      mean(jar_lag), mean(carrier_motion), mean(slip_at_wall), mean(intermittency),
      is_drum(outcome.mill_case) ? "Froude number" : "pinning ratio", mean(pinning));
}

}  // namespace mahlwerk::results
