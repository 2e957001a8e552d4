// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/quantities/checks.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/milling.hpp"
#include "mahlwerk/results/quantities/motion.hpp"
#include "mahlwerk/results/quantities/power.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/series.hpp"
#include "mahlwerk/results/quantities/wear.hpp"

namespace mahlwerk::results {
namespace {

using observe::Sums;
using scene::Account;

double energy_balance(const cases::Case&, const Replicate& r) {
  const Account& a = r.account;
  const double scale = std::abs(a.wall_work) + std::abs(a.lost()) + std::abs(a.started_with);
  const double residual = std::abs(a.residual());
  return residual == 0 ? 0 : residual / scale;
}

/// A mean over collisions, once over all of them and once over those above the threshold.
struct CollisionMean {
  std::string name, unit, about;
  double Sums::*sum;
  double factor = 1;
};

std::vector<CollisionMean> collision_means() {
  return {
      {"energy_normal_mean", "J", "mean impact energy of the normal motion, m u_n^2/2",
       &Sums::energy_normal},
      {"energy_contact_point_mean", "J",
       "mean impact energy of the motion of the touching points, m (u_n^2 + u_t^2)/2, spin "
       "included",
       &Sums::energy_contact_point},
      {"energy_centre_mean", "J", "mean impact energy of the motion of the centres, spin left out",
       &Sums::energy_centre},
      {"energy_lost_mean", "J", "mean energy dissipated in one collision", &Sums::lost},
      {"impact_speed_normal_mean", "m/s", "mean normal speed u_n at first touch", &Sums::approach},
      {"impact_speed_tangential_mean", "m/s",
       "mean tangential speed |u_t| of the touching points at first touch, spin included",
       &Sums::slip},
      {"impact_angle_mean", "deg", "mean angle of impact, atan2(|u_t|, u_n): 0 head-on, 90 grazing",
       &Sums::angle, 180 / std::numbers::pi},
  };
}

double of_mean(const CollisionMean& mean, const Sums& sums) {
  return share(mean.factor * sums.*mean.sum, static_cast<double>(sums.count));
}

const std::vector<Measure>& rates() {
  static const std::vector<Measure> list{
      {"collision_rate", "1/s", "collisions per second, all of them",
       [](const cases::Case&, const Replicate& r) {
         return share(static_cast<double>(r.tally.all.count), r.time());
       }},
      {"collision_rate_above_threshold", "1/s",
       "collisions per second with a normal speed u_n of at least the threshold",
       [](const cases::Case&, const Replicate& r) {
         return share(static_cast<double>(r.tally.above.count), r.time());
       }},
      {"collision_rate_in_flight", "1/s",
       "collisions above the threshold per second that the balls are not in lasting contact",
       [](const cases::Case& c, const Replicate& r) {
         const double contact = r.account.contact_time - r.at_settled.contact_time;
         return share(static_cast<double>(r.tally.above.count),
                      r.time() - contact / count_of_balls(c));
       }},
  };
  return list;
}

double between_balls(const Sums& sums, const Replicate& r) {
  return share(static_cast<double>(sums.between_balls), r.time());
}
double with_jar(const Sums& sums, const Replicate& r) {
  return share(static_cast<double>(sums.count - sums.between_balls), r.time());
}

/// Rates by partner, where there are several balls.
const std::vector<Measure>& partners() {
  static const std::vector<Measure> list{
      {"collision_rate_between_balls", "1/s",
       "collisions of balls with balls per second, each once",
       [](const cases::Case&, const Replicate& r) { return between_balls(r.tally.all, r); }},
      {"collision_rate_between_balls_above_threshold", "1/s",
       "those with a normal speed u_n of at least the threshold",
       [](const cases::Case&, const Replicate& r) { return between_balls(r.tally.above, r); }},
      {"collision_rate_with_jar", "1/s", "collisions of balls with the jar per second",
       [](const cases::Case&, const Replicate& r) { return with_jar(r.tally.all, r); }},
      {"collision_rate_with_jar_above_threshold", "1/s",
       "those with a normal speed u_n of at least the threshold",
       [](const cases::Case&, const Replicate& r) { return with_jar(r.tally.above, r); }},
  };
  return list;
}

double ratio(const cases::Case& c) {
  return *c.powder->grain_size / *c.powder->size;  // (chg.9)
}

/// Of powder as grains: the same in every replicate.
const std::vector<Measure>& grains(const cases::Case& what) {
  static const std::vector<Measure> list{
      {"grain_count", "1", "spheres that stand for the powder",
       [](const cases::Case& c, const Replicate&) {
         return static_cast<double>(c.balls.back().count);
       },
       true},
      {"coarse_graining_ratio", "1", "size of a grain over the powder's size",
       [](const cases::Case& c, const Replicate&) { return ratio(c); }, true},
      {"particles_per_grain", "1", "particles of the powder that each grain stands for",
       [](const cases::Case& c, const Replicate&) { return ratio(c) * ratio(c) * ratio(c); }, true},
  };
  static const std::vector<Measure> without_size(list.begin(), list.begin() + 1), none;
  if (!what.powder || !what.powder->grain_size) return none;
  return what.powder->size ? list : without_size;
}

const std::vector<Measure>& checks() {
  static const std::vector<Measure> list{
      {"energy_residual", "1",
       "largest relative residual of one collision's energy balance, of all replicates",
       [](const cases::Case&, const Replicate& r) { return r.account.worst_collision; }, true},
      {"energy_balance", "1",
       "residual of a whole run's energy balance over wall work + losses + energy at the start, of "
       "the "
       "worst replicate",
       energy_balance, true},
      {"deepest_overlap", "1",
       "deepest overlap of two bodies as they collided over the ball's radius, of all replicates",
       [](const cases::Case&, const Replicate& r) { return r.account.deepest_overlap; }, true},
      {"simulated_time", "s", "counted time of one replicate",
       [](const cases::Case&, const Replicate& r) { return r.time(); }},
  };
  return list;
}

/// Gathers one replicate's numbers in the order of summary.json.
class Gathering {
 public:
  Gathering(const Outcome& outcome, const Replicate& replicate)
      : case_(outcome.what), replicate_(replicate) {}

  void add(const Measure& m) {
    found_.push_back({m.name, m.of(case_, replicate_), nothing, m.unit, m.about});
  }
  void add(const std::vector<Measure>& list) {
    for (const Measure& m : list) add(m);
  }
  void add(const CollisionMean& m) {
    found_.push_back({m.name, of_mean(m, replicate_.tally.all), nothing, m.unit, m.about});
    found_.push_back({m.name + "_above_threshold", of_mean(m, replicate_.tally.above), nothing,
                      m.unit, m.about + "; collisions above the threshold"});
  }
  std::vector<Quantity> found() { return std::move(found_); }

 private:
  const cases::Case& case_;
  const Replicate& replicate_;
  std::vector<Quantity> found_;
};

/// The TC rule's share is told where the case asks for the rule, so that names depend on the case
/// alone; the soft engine has no such rule.
bool has_tc(const Outcome& o) {
  return o.what.contact.lasting == cases::Lasting::tc &&
         o.what.run.engine != cases::EngineName::soft;
}

/// The worst of all replicates, averaged or not; one that is not even a number is the worst there
/// is.
double worst(const Outcome& outcome, const Measure& m) {
  double most = 0;
  for (const Replicate& r : outcome.replicates) {
    const double v = m.of(outcome.what, r);
    if (!(v <= most)) most = v;
    if (std::isnan(most)) break;
  }
  return most;
}

}  // namespace

void combine(Quantity& q, const std::vector<double>& values) {
  std::vector<double> there;
  for (const double v : values) {
    if (std::isfinite(v)) there.push_back(v);
  }
  q.value = q.ci95 = nothing;
  if (there.empty()) return;
  const observe::Estimate e = observe::estimate(there);
  q.value = e.mean;
  q.ci95 = e.ci95;
}

std::vector<const Replicate*> averaged(const Outcome& outcome) {
  std::vector<const Replicate*> whole, any;
  for (const Replicate& r : outcome.replicates) {
    if (!(r.time() > 0)) continue;
    any.push_back(&r);
    if (r.complete) whole.push_back(&r);
  }
  return whole.size() >= 2 ? whole : any;
}

std::vector<const Replicate*> ground_replicates(const Outcome& outcome) {
  std::vector<const Replicate*> chosen = averaged(outcome);
  std::erase_if(chosen, [](const Replicate* r) { return !r->ground; });
  return chosen;
}

bool complete(const Outcome& outcome) {
  return !outcome.replicates.empty() &&
         std::all_of(outcome.replicates.begin(), outcome.replicates.end(),
                     [](const Replicate& r) { return r.complete && r.time() > 0; });
}

std::vector<Quantity> summarise(const Outcome& outcome, const Replicate& replicate) {
  Gathering gathering(outcome, replicate);
  gathering.add(rates());
  if (count_of_balls(outcome.what) > 1) gathering.add(partners());
  for (const CollisionMean& m : collision_means()) gathering.add(m);
  gathering.add(power_measures());
  if (outcome.what.run.engine == cases::EngineName::soft) gathering.add(loss_measures());
  if (has_tc(outcome)) gathering.add(contact_time_measures());
  gathering.add(mill_measures(outcome.what));
  gathering.add(ledger_measures());
  gathering.add(dose_measures(outcome.what));
  gathering.add(regime_measures(outcome.what));
  gathering.add(motion_measures(outcome.what));
  gathering.add(tangential_measures());
  gathering.add(wear_measures(outcome.what));
  gathering.add(heat_measures(outcome.what));
  gathering.add(capture_measures(outcome.what));
  gathering.add(grinding_measures(outcome.what));
  gathering.add(kinetics_measures(outcome.what));
  gathering.add(grains(outcome.what));
  gathering.add(checks());
  return gathering.found();
}

std::vector<Quantity> summarise_checks(const Outcome& outcome) {
  std::vector<Quantity> list;
  for (const Measure& m : checks()) {
    Quantity q{m.name, worst(outcome, m), nothing, m.unit, m.about};
    if (!m.worst) {
      std::vector<double> values;
      for (const Replicate* r : averaged(outcome)) values.push_back(m.of(outcome.what, *r));
      combine(q, values);
    }
    list.push_back(std::move(q));
  }
  return list;
}

std::vector<Quantity> summarise(const Outcome& outcome) {
  const std::vector<const Replicate*> chosen = averaged(outcome);
  std::vector<std::vector<Quantity>> each;
  for (const Replicate* r : chosen) each.push_back(summarise(outcome, *r));
  std::vector<Quantity> list =
      each.empty() ? summarise(outcome, Replicate(outcome.what.observe.threshold)) : each.front();
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::vector<double> values;
    for (const auto& one : each) values.push_back(one[i].value);
    combine(list[i], values);
    list[i].ci95_time = ci95_over_time(chosen, list[i].name);
  }
  for (const auto* some : {&grains(outcome.what), &checks()})
    for (const Measure& m : *some) {
      if (!m.worst) continue;
      const auto same = [&](const Quantity& q) { return q.name == m.name; };
      Quantity& q = *std::find_if(list.begin(), list.end(), same);
      q.value = worst(outcome, m);
      q.ci95 = nothing;
    }
  list.push_back({"settling_time", settling_time(chosen), nothing, "s",
                  "of the counted time, what the dissipated power shows to belong to the start"});
  list.push_back({"replicates", static_cast<double>(chosen.size()), nothing, "1",
                  "independent replicates that the means are taken over"});
  return list;
}

}  // namespace mahlwerk::results
