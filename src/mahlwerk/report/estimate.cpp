// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/key_numbers.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;
using results::Outcome;
using results::Quantity;

/// The key quantities with a number, but one dose: after the milling time, else in an hour.
std::vector<std::string> names_of(const Outcome& outcome) {
  const std::vector<Quantity>& list = outcome.summary.quantities;
  std::vector<std::string> names = results::key_quantities(list);
  std::erase_if(names, [&](const std::string& name) {
    return name == "specific_energy_dose_rate" || std::isnan(results::named(list, name).value);
  });
  if (std::ranges::find(names, "specific_energy_dose") != names.end())
    std::erase(names, "specific_energy_dose_per_hour");
  return names;
}

/// How far a cause moves a quantity from its value.
double reach(const BandCause& cause, double value) {
  return std::fmax(std::abs(cause.at_ends[0] - value), std::abs(cause.at_ends[1] - value));
}

/// The power of the quantity that is proportional to the dissipated power or its inverse: the doses
/// and the time to one. 0: neither. Their bands follow from that of the power.
int order_in_power(std::string_view name) {
  if (name == "specific_energy_dose" || name == "specific_energy_dose_per_hour") return 1;
  return name == "time_to_dose" ? -1 : 0;
}

/// The band of a quantity that goes with the power.
Band band_by_power(const Quantity& q, const Band& power) {
  const auto at = [&](double watt) {
    const double ratio = watt / power.quantity.value;
    return order_in_power(q.name) > 0 ? q.value * ratio : q.value / ratio;
  };
  Band band{q, at(power.low), at(power.high), power.causes};
  if (band.low > band.high) std::swap(band.low, band.high);
  for (BandCause& cause : band.causes) cause.at_ends = {at(cause.at_ends[0]), at(cause.at_ends[1])};
  return band;
}

std::vector<BandCause> causes_of(const Outcome& outcome, const Quantity& q) {
  std::vector<BandCause> causes;
  if (!outcome.summary.sensitivity) return causes;
  const results::Sensitivity& all = *outcome.summary.sensitivity;
  const auto at = std::ranges::find(all.quantities, q.name);
  if (at == all.quantities.end()) return causes;
  const auto i = static_cast<std::size_t>(at - all.quantities.begin());
  for (const results::AssumedInfluence& one : all.keys) {
    BandCause cause{one.key, one.ends, {one.at_ends[0][i], one.at_ends[1][i]}};
    if (all.beyond_chance(i, cause.at_ends[0], q.value) ||
        all.beyond_chance(i, cause.at_ends[1], q.value))
      causes.push_back(std::move(cause));
  }
  std::ranges::stable_sort(causes, std::ranges::greater(),
                           [&](const BandCause& c) { return reach(c, q.value); });
  return causes;
}

/// "restitution" of contact.restitution.
std::string plain(std::string_view key) {
  std::string word(key.substr(key.rfind('.') + 1));
  std::ranges::replace(word, '_', ' ');
  return word;
}

std::string reason(const Band& band) {
  constexpr std::size_t most = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, band.causes.size()); ++i) {
    const BandCause& one = band.causes[i];
    text +=
        fmt::format("{}{} {} to {}", i > 0 ? ", " : "", plain(one.key), one.ends[0], one.ends[1]);
  }
  return text.empty() ? "chance: the replicates differ" : text;
}

/// What would narrow the band of the first quantity most.
std::string advice(const std::vector<Band>& all) {
  if (all.empty()) return "";
  if (all.front().causes.empty())
    return "To narrow the bands, count longer and more replicates: --set run.time=\"20 s\" "
           "--set run.replicates=10.\n";
  const BandCause& first = all.front().causes.front();
  return fmt::format(
      "To narrow the bands, measure what makes them widest, and give it: --set {}=...\n"
      "(between {} and {} the {} is {}).\n",
      first.key, first.ends[0], first.ends[1], label(all.front().quantity),
      key_range(first.at_ends[0], first.at_ends[1], all.front().quantity.unit));
}

}  // namespace

std::vector<Band> bands(const Outcome& outcome) {
  std::vector<Band> all;
  for (const std::string& name : names_of(outcome)) {
    const Quantity& q = results::named(outcome.summary.quantities, name);
    if (order_in_power(name) != 0 && !all.empty() && all.front().quantity.value > 0) {
      all.push_back(band_by_power(q, all.front()));
      continue;
    }
    const results::Range range = results::range_of(name);
    const double half = std::isfinite(q.half_width()) ? q.half_width() : 0;
    Band band{q, std::fmax(range.least, q.value - half), std::fmin(range.most, q.value + half),
              causes_of(outcome, q)};
    if (const auto& found = outcome.summary.sensitivity)
      if (const auto over = found->range(name, q.value)) {
        band.low = std::fmin(band.low, over->first);
        band.high = std::fmax(band.high, over->second);
      }
    all.push_back(std::move(band));
  }
  return all;
}

std::string estimate_words(const Outcome& outcome) {
  const std::vector<Band> all = bands(outcome);
  std::vector<std::array<std::string, 4>> lines{{"", "best guess", "band", "wide because of"}};
  for (const Band& band : all)
    lines.push_back({key_title(band.quantity, outcome.mill_case), key_value(band.quantity),
                     key_range(band.low, band.high, band.quantity.unit), reason(band)});
  std::string text = fmt::format("{}\n\n{}\n", outcome.mill_case.title, aligned(lines));
  text +=
      "Bands: each assumed value alone at both ends of its plausible range, beyond what chance\n"
      "makes, and the 95 % interval over replicates. Doses go with the power.\n";
  if (const auto& found = outcome.summary.sensitivity; found && !found->left_out.empty())
    text +=
        fmt::format("Not varied, as the ends of the range do not fit the rest of the case: {}.\n",
                    fmt::join(found->left_out, ", "));
  text += advice(all);
  if (const std::string& regime = outcome.summary.regime; !regime.empty())
    text += fmt::format("\nThe charge is {}: {}.\n", regime, outcome.summary.regime_reason);
  for (const Notice& one : outcome.notices)
    if (one.warns()) text += fmt::format("\nWarning: {}\n", one.text);
  return text;
}

Json estimate_json(const Outcome& outcome, std::string_view case_text, std::string_view version) {
  Json quantities = Json::object();
  for (const Band& band : bands(outcome)) {
    Json causes = Json::array();
    for (const BandCause& one : band.causes)
      causes.push_back(Json::object({{"key", one.key},
                                     {"range", Json::array({one.ends[0], one.ends[1]})},
                                     {"at_ends", Json::array({one.at_ends[0], one.at_ends[1]})}}));
    quantities[band.quantity.name] = Json::object({{"value", band.quantity.value},
                                                   {"low", band.low},
                                                   {"high", band.high},
                                                   {"unit", band.quantity.unit},
                                                   {"causes", std::move(causes)}});
  }
  results::NoticeCounts notices;
  results::count(notices, outcome.notices);
  return with(study_head("estimate", version, outcome.mill_case.title, ""),
              {{"engine", cases::name_of(outcome.engine)},
               {"quantities", std::move(quantities)},
               {"notices", results::notices_json(notices)},
               {"toml", case_text}});
}

}  // namespace mahlwerk::report
