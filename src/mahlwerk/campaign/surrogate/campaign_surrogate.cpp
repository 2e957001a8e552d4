// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {

std::optional<double> SurrogateKey::position(const std::string& text) const {
  constexpr double rounding = 1e-9;
  const Quantity low = parse_quantity(least), high = parse_quantity(most),
                 given = parse_quantity(text);
  if (given.dimension != low.dimension)
    throw UnitError(fmt::format("\"{}\" is not a quantity like \"{}\"", text, least));
  const auto scaled = [&](const Quantity& q) { return logarithmic ? math::log(q.value) : q.value; };
  if (logarithmic && !(given.value > 0)) return std::nullopt;
  const double place = (scaled(given) - scaled(low)) / (scaled(high) - scaled(low));
  if (!(place >= -rounding && place <= 1 + rounding)) return std::nullopt;
  return std::clamp(place, 0.0, 1.0);
}

observe::IntervalEstimate predict(const SurrogateQuantity& quantity, const DesignPoint& point) {
  constexpr double z95 = 1.959963984540054;
  const OutcomeEmulator& emulator = quantity.emulator;
  const Posterior p = emulator.model.at(point);
  const double half = z95 * quantity.hold_out.widening * p.deviation;
  return {emulator.value_of(p.mean), emulator.value_of(p.mean - half),
          emulator.value_of(p.mean + half)};
}

namespace {

/// "balls.diameter" for "balls.1.diameter", which is the same key.
std::string plain_key(const std::string& key) {
  constexpr std::string_view first = "balls.1.";
  return key.starts_with(first) ? "balls." + key.substr(first.size()) : key;
}

}  // namespace

DesignPoint CampaignSurrogate::point(const std::vector<cases::Override>& setting) const {
  std::vector<Fault> faults;
  std::vector<std::string> known;
  for (const SurrogateKey& key : keys) known.push_back(key.key);
  DesignPoint made(keys.size(), -1);
  for (const cases::Override& one : setting) {
    const std::string where = fmt::format("--set {}={}", one.key, one.value);
    const auto fault = [&](std::string what, std::string remedy, const char* code) {
      faults.push_back({where, std::move(what), std::move(remedy), code});
    };
    const auto same = [&](const std::string& key) { return plain_key(key) == plain_key(one.key); };
    if (std::ranges::any_of(following, same)) {
      fault(fmt::format("{} follows from the other keys", one.key), "remove it", "unknown-key");
      continue;
    }
    const auto key = std::ranges::find_if(keys, [&](const SurrogateKey& k) { return same(k.key); });
    if (key == keys.end()) {
      const std::string near = nearest_word(one.key, known);
      fault(fmt::format("the surrogate has no key {}", one.key),
            near.empty()
                ? fmt::format("it takes {}; all else is as in the campaign", fmt::join(known, ", "))
                : fmt::format("did you mean {}?", near),
            "unknown-key");
      continue;
    }
    if (made[static_cast<std::size_t>(key - keys.begin())] >= 0) {
      fault(fmt::format("{} is given twice", one.key), "give it once", "too-much");
      continue;
    }
    try {
      const std::optional<double> place = key->position(one.value);
      made[static_cast<std::size_t>(key - keys.begin())] = place.value_or(0);
      if (!place)
        faults.push_back({where,
                          fmt::format("{} is outside {} to {}, the range of the campaign: a "
                                      "surrogate does not extrapolate",
                                      one.value, key->least, key->most),
                          "give a value in the range, or run the case", "out-of-range"});
    } catch (const UnitError& error) {
      faults.push_back({where, error.what(),
                        fmt::format("write for instance {}=\"{}\"", one.key, key->least),
                        "bad-quantity"});
      made[static_cast<std::size_t>(key - keys.begin())] = 0;
    }
  }
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (made[k] < 0)
      faults.push_back({"", fmt::format("{} is not given", keys[k].key),
                        fmt::format("add --set {}=VALUE, from {} to {}", keys[k].key, keys[k].least,
                                    keys[k].most),
                        "missing-value"});
  if (!faults.empty()) throw InputError(std::move(faults));
  return made;
}

namespace {

InputError no_surrogate(const std::string& folder, std::string what, std::string remedy) {
  return InputError(Fault{folder, std::move(what), std::move(remedy), "no-surrogate"});
}

std::optional<Quantity> quantity_in(const std::string& text) {
  try {
    return parse_quantity(text);
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

/// The range of a key over the points; empty if it has one value only.
std::optional<SurrogateKey> ranged_key(const std::string& key, std::size_t at,
                                       const std::vector<Point>& points,
                                       const std::string& folder) {
  constexpr double much = 10;  // largest over smallest value
  SurrogateKey made{.key = key};
  double low = INFINITY, high = -INFINITY;
  std::optional<Dimension> dimension;
  for (const Point& point : points) {
    const std::optional<Quantity> value = quantity_in(point.values[at]);
    if (!value || (dimension && value->dimension != *dimension))
      throw no_surrogate(
          folder,
          fmt::format("{} takes the value \"{}\", and a surrogate takes numbers only", key,
                      point.values[at]),
          "sweep over numbers, with a campaign for each word");
    dimension = value->dimension;
    if (value->value < low) low = value->value, made.least = point.values[at];
    if (value->value > high) high = value->value, made.most = point.values[at];
  }
  if (!(high > low)) return std::nullopt;
  made.logarithmic = low > 0 && high >= much * low;
  return made;
}

/// A setting's mean, and its scatter from the half-width of its interval over `replicates`, or over
/// time if there is one replicate, which counts as many. `of_draws`: intervals contain the draws of
/// [uncertainty] (cal.9).
SettingSample sample_of_setting(DesignPoint point, double mean, double ci95, double replicates,
                                bool logarithmic, bool of_draws) {
  constexpr double z95 = 1.959963984540054, many = 50;
  SettingSample made{.point = std::move(point), .count = std::max(1.0, replicates), .mean = mean};
  if (std::isfinite(ci95)) {
    double variance_of_mean = 0;
    if (made.count > 1) {
      const double t = observe::student95(static_cast<int>(made.count) - 1);
      const double widened = of_draws ? std::sqrt(made.count + 1) : 1;  // (cal.9)
      variance_of_mean = ci95 / t / widened * (ci95 / t / widened);
    } else {
      made.count = many;
      variance_of_mean = ci95 / z95 * (ci95 / z95);
    }
    if (logarithmic) variance_of_mean /= mean * mean;
    made.squares = variance_of_mean * made.count * (made.count - 1);
  }
  if (logarithmic) made.mean = math::log(mean);
  return made;
}

SurrogateQuantity emulated(const results::Quantity& quantity, std::size_t column,
                           std::size_t replicates, const std::vector<Point>& points,
                           const std::vector<DesignPoint>& places, bool of_draws,
                           const std::string& folder) {
  double least = INFINITY, most = -INFINITY;
  std::size_t count = 0;
  for (const Point& p : points) {
    if (!std::isfinite(p.value[column])) continue;
    ++count;
    least = std::min(least, p.value[column]);
    most = std::max(most, p.value[column]);
  }
  if (count < places.front().size() + 2)
    throw no_surrogate(folder,
                       fmt::format("{} has a value at {} settings only", quantity.name, count),
                       "choose other quantities with --quantity");
  const bool logarithmic = varies_by_factors(least, most);
  std::vector<SettingSample> samples;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].value[column]))
      samples.push_back(sample_of_setting(places[i], points[i].value[column],
                                          points[i].ci95[column], points[i].value[replicates],
                                          logarithmic, of_draws));
  OutcomeEmulator emulator{outcome_model(samples), logarithmic};
  const HoldOut others = hold_out(emulator);
  return {quantity.name, quantity.unit, quantity.about, std::move(emulator), others};
}

std::vector<Point> ended_points(const Store& store, const std::vector<std::string>& names,
                                std::size_t& failed) {
  std::vector<Point> points;
  store.read(names, [&](const Point& point) {
    if (point.state == RunState::failed) ++failed;
    if (point.state == RunState::done) points.push_back(point);
  });
  return points;
}

std::string digest_of(const std::vector<std::string>& keys, const std::vector<std::string>& names,
                      const std::vector<Point>& points) {
  std::string all = fmt::format("{}\n{}\n", fmt::join(keys, ","), fmt::join(names, ","));
  for (const Point& p : points) {
    all += fmt::format("{}", fmt::join(p.values, ","));
    for (std::size_t i = 0; i < p.value.size(); ++i)
      all += fmt::format(",{},{}", shortest(p.value[i]), shortest(p.ci95[i]));
    all += '\n';
  }
  return hash_text(fingerprint(all));
}

/// The known quantities of these names.
std::vector<results::Quantity> chosen_quantities(const Store& store, const std::string& folder,
                                                 const std::vector<std::string>& names) {
  const std::vector<results::Quantity> known = store.quantities();
  std::vector<std::string> spelling;
  for (const results::Quantity& q : known) spelling.push_back(q.name);
  std::vector<results::Quantity> chosen;
  for (const std::string& name : names) {
    const auto there = std::ranges::find(known, name, &results::Quantity::name);
    if (there != known.end()) {
      chosen.push_back(*there);
      continue;
    }
    const std::string near = nearest_word(name, spelling);
    throw InputError(Fault{folder, fmt::format("the campaign has no quantity {}", name),
                           near.empty() ? "the columns of campaign.csv are its quantities"
                                        : fmt::format("did you mean {}?", near),
                           "no-such-quantity"});
  }
  return chosen;
}

void take_keys(CampaignSurrogate& made, const Store& store, const std::string& folder,
               const std::vector<Point>& points, std::vector<DesignPoint>& places) {
  const std::vector<std::string> keys = store.keys();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (store.follows(keys[k])) {
      made.following.push_back(keys[k]);
      continue;
    }
    const std::optional<SurrogateKey> ranged = ranged_key(keys[k], k, points, folder);
    if (!ranged) continue;
    for (std::size_t i = 0; i < points.size(); ++i)
      places[i].push_back(*ranged->position(points[i].values[k]));
    made.keys.push_back(*ranged);
  }
  if (made.keys.empty())
    throw no_surrogate(folder, "no key varies over the settings that have ended",
                       "finish the campaign: mahlwerk sweep with its case resumes it");
}

}  // namespace

CampaignSurrogate surrogate_of(const Store& store, const std::string& folder,
                               const std::vector<std::string>& quantities,
                               std::string_view version) {
  constexpr std::size_t fewest = 4, most = CampaignSurrogate::most_settings;
  const std::vector<results::Quantity> chosen = chosen_quantities(store, folder, quantities);
  CampaignSurrogate made{.title = store.title(), .version = std::string(version)};
  std::vector<std::string> names = quantities;
  names.push_back("replicates");
  const std::vector<Point> points = ended_points(store, names, made.failed);
  if (points.size() < fewest)
    throw no_surrogate(
        folder,
        fmt::format("{} settings of the campaign have ended, fewer than {}", points.size(), fewest),
        "finish the campaign, or sweep more settings");
  if (points.size() > most)
    throw no_surrogate(
        folder,
        fmt::format("the campaign has {} settings, more than {}: a surrogate of them "
                    "would take minutes",
                    points.size(), most),
        "sweep with design = \"sobol\" and fewer samples");
  made.settings = points.size();
  made.digest = digest_of(store.keys(), names, points);
  for (const Point& p : points)
    if (!p.engine.empty() && std::ranges::find(made.engines, p.engine) == made.engines.end())
      made.engines.push_back(p.engine);
  std::vector<DesignPoint> places(points.size());
  take_keys(made, store, folder, points, places);
  made.notices = store.notices();
  const bool of_draws = std::ranges::any_of(made.notices, [](const results::NoticeCount& n) {
    return n.first.code == "uncertain-parameters";
  });
  std::erase_if(made.notices, [](const results::NoticeCount& n) {  // of single runs
    return !n.first.warns();
  });
  std::string exact;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    made.quantities.push_back(
        emulated(chosen[i], i, chosen.size(), points, places, of_draws, folder));
    if (std::ranges::none_of(points, [&](const Point& p) { return p.ci95[i] > 0; }))
      exact += (exact.empty() ? "" : ", ") + chosen[i].name;
  }
  if (!exact.empty())
    made.notices.push_back(
        {warning("no-scatter",
                 fmt::format("The scatter of {} is not known, and counts as zero: the intervals of "
                             "the surrogate are too narrow. Sweep with several replicates.",
                             exact)),
         points.size()});
  if (made.engines.size() > 1)
    made.notices.push_back(
        {warning("several-engines",
                 fmt::format("The settings were run by the engines {}, whose results "
                             "differ: the surrogate has a step between them.",
                             fmt::join(made.engines, " and "))),
         points.size()});
  results::sort(made.notices);
  return made;
}

}  // namespace mahlwerk::campaign
