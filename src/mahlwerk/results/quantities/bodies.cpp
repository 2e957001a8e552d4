// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/bodies.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/scene/body_core.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::LogHistogram;
using scene::BodyFeature;

template <BodyFeature feature>
bool case_has(const Case& c) {
  return std::ranges::any_of(c.balls, [](const cases::BallSet& set) {
    return scene::has_feature(set.body.solid_kind(), feature);
  });
}

template <BodyFeature feature>
double share_of_hits(const Case&, const Replicate& r) {
  const observe::BodyHits& hits = r.tally.body_hits;
  return share(static_cast<double>(hits.energies(feature).total()),
               static_cast<double>(hits.count()));
}

template <BodyFeature feature>
double share_of_energy(const Case&, const Replicate& r) {
  const observe::BodyHits& hits = r.tally.body_hits;
  return share(hits.energies(feature).sum(), hits.energy());
}

/// Both shares of a feature; `where`: "on a face", `bodies`: which have it.
template <BodyFeature feature>
void add_shares(Measures& list, const std::string& where, std::string_view bodies,
                std::string_view heading = {}) {
  const std::string name(scene::name_of(feature));
  list.push_back({name + "_hit_share",
                  "1",
                  "share of the hits of bodies that are no spheres that they get " + where +
                      "; a collision of two bodies is a hit of each",
                  share_of_hits<feature>,
                  {.range = share_of_whole,
                   .equation = "bod.16",
                   .heading = heading,
                   .applies = case_has<feature>,
                   .only = bodies}});
  list.push_back({name + "_energy_share",
                  "1",
                  "share of the normal energy m u_n^2/2 of these hits that comes " + where,
                  share_of_energy<feature>,
                  {.range = share_of_whole,
                   .equation = "bod.16",
                   .applies = case_has<feature>,
                   .only = bodies}});
}

bool has_axis(const Case& c) {
  return !cases::sets_with_axis(c).empty();
}
constexpr std::string_view with_axis = "cylpebs, rods or ellipsoids";

double per_second(std::int64_t count, const Replicate& r) {
  return static_cast<double>(count) / r.time();
}

}  // namespace

Measures body_measures() {
  Measures list;
  add_shares<BodyFeature::face>(list, "on a flat face", "cylpebs or cubes", "Bodies");
  add_shares<BodyFeature::edge>(list, "on an edge", "cylpebs or cubes");
  add_shares<BodyFeature::corner>(list, "on a corner", "cubes");
  add_shares<BodyFeature::side>(list, "on the curved side", "cylpebs or rods");
  add_shares<BodyFeature::cap>(list, "on a rounded end", "rods");
  list.push_back(
      {"nematic_order",
       "1",
       "nematic order parameter of the axes of cylpebs, rods and ellipsoids, over bodies "
       "and time, in the carrier's frame: 1 if all are parallel, 0 without order",
       [](const Case&, const Replicate& r) { return r.charge.alignment.nematic_order(); },
       {.range = share_of_whole,
        .symbol = "$S$",
        .equation = "bod.17",
        .applies = has_axis,
        .only = with_axis}});
  list.push_back(
      {"body_axis_angle",
       "deg",
       "mean angle of the axes of cylpebs, rods and ellipsoids to the jar's axis; 57.3 if "
       "all directions are alike",
       [](const Case&, const Replicate& r) {
         return 180 / std::numbers::pi * r.charge.alignment.mean_angle();
       },
       {.range = {.least = 0, .most = 90},
        .label = "angle of bodies to the axis of the jar",
        .equation = "bod.18",
        .applies = has_axis,
        .only = with_axis}});
  return list;
}

Table body_hits(const Outcome& outcome) {
  Table table{{{"energy_low", "J", "lower edge of the bin, which belongs to it"},
               {"energy_high", "J", "upper edge of the bin"}},
              {}};
  const auto replicates = averaged_replicates(outcome);
  int first = LogHistogram::bins, last = 0;
  std::vector<BodyFeature> there;
  for (const BodyFeature feature : scene::body_features) {
    bool any = false;
    for (const Replicate* r : replicates) {
      const auto [low, high] = r->tally.body_hits.energies(feature).occupied_range();
      if (low == high) continue;
      first = std::min(first, low), last = std::max(last, high), any = true;
    }
    if (any) there.push_back(feature);
  }
  for (const BodyFeature feature : there) {
    const std::string name(scene::name_of(feature));
    table.columns.push_back({"rate_" + name, "1/s", "hits of bodies there per second: " + name});
    table.columns.push_back({"power_" + name, "W", "the sum per second of their m u_n^2/2"});
  }
  for (int bin = first; bin < last; ++bin) {
    std::vector<double> row{bin == 0 ? 0 : LogHistogram::lower(bin), LogHistogram::lower(bin + 1)};
    for (const BodyFeature feature : there) {
      row.push_back(mean_over(replicates, [&](const Replicate& r) {
        return per_second(r.tally.body_hits.energies(feature).count(bin), r);
      }));
      row.push_back(mean_over(replicates, [&](const Replicate& r) {
        return r.tally.body_hits.energies(feature).sum(bin) / r.time();
      }));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace mahlwerk::results
