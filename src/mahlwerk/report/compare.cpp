// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"

namespace mahlwerk::report {
namespace {

using observe::LogHistogram;
using results::Outcome;
using results::Quantity;
using results::Replicate;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Quantities that describe the quality of a run, or mean different things in each engine.
constexpr std::array<std::string_view, 7> left_out{
    "tc_collision_share", "lasting_contacts_rate", "energy_residual", "energy_balance",
    "deepest_overlap",    "simulated_time",        "replicates"};

std::vector<ComparedQuantity> quantities(const Outcome& event, const Outcome& soft) {
  std::vector<ComparedQuantity> list;
  const std::vector<Quantity>& others = soft.summary.quantities;
  for (const Quantity& q : event.summary.quantities) {
    if (std::find(left_out.begin(), left_out.end(), q.name) != left_out.end()) continue;
    const auto twin = std::find_if(others.begin(), others.end(),
                                   [&](const Quantity& o) { return o.name == q.name; });
    if (twin == others.end()) continue;
    list.push_back({q.name, q.unit, q.about, {{q.value, q.ci95}, {twin->value, twin->ci95}}});
  }
  list.push_back({"computing_time",
                  "s",
                  "CPU time of all replicates",
                  {{event.cpu_seconds, nothing}, {soft.cpu_seconds, nothing}}});
  return list;
}

using Chosen = std::vector<const Replicate*>;
using results::HistogramMember;

/// The total spectra of each replicate.
struct Counted {
  explicit Counted(const Chosen& chosen) {
    for (const Replicate* r : chosen) {
      spectra.push_back(r->tally.total_spectra());
      times.push_back(r->time());
    }
  }
  /// Collisions per second in the bins `first` to `last` - 1.
  observe::Estimate rate(HistogramMember part, int first, int last) const {
    std::vector<double> each;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
      std::int64_t count = 0;
      for (int bin = first; bin < last; ++bin) count += (spectra[i].*part).count(bin);
      each.push_back(static_cast<double>(count) / times[i]);
    }
    return observe::estimate(each);
  }
  std::vector<observe::Spectra> spectra;
  std::vector<double> times;
};

/// Histograms of both engines over the common range of occupied bins.
class Spectra {
 public:
  Spectra(const Outcome& event, const Outcome& soft, HistogramMember part)
      : event_(results::averaged_replicates(event)),
        soft_(results::averaged_replicates(soft)),
        part_(part) {
    for (const Counted* counted : {&event_, &soft_})
      for (const observe::Spectra& one : counted->spectra) {
        const auto [low, high] = (one.*part).occupied_range();
        if (low == high) continue;
        first_ = std::min(first_, low);
        last_ = std::max(last_, high);
      }
  }

  /// Rates in groups of `wide` bins, over the top `octaves`. With `all` the first group includes
  /// all lower bins.
  std::vector<ComparedBin> bins(int wide, int octaves, bool all) const {
    std::vector<ComparedBin> list;
    if (first_ >= last_) return list;
    const int end = (last_ + wide - 1) / wide * wide;
    const int begin = std::max(first_ / wide * wide, end - octaves * LogHistogram::per_octave);
    for (int bin = begin; bin < end; bin += wide) {
      const bool rest = all && bin == begin && first_ < begin;
      const int from = rest ? 0 : bin, to = std::min(bin + wide, LogHistogram::bins);
      list.push_back({rest ? 0 : LogHistogram::lower(bin),
                      LogHistogram::lower(bin + wide),
                      {event_.rate(part_, from, to), soft_.rate(part_, from, to)}});
    }
    return list;
  }

 private:
  Counted event_, soft_;
  HistogramMember part_;
  int first_ = LogHistogram::bins, last_ = 0;
};

/// Only the event engine uses the tangential restitution: a warning if the case sets it.
std::string caution(const cases::Contact& contact) {
  std::vector<contact::BounceRule> rules{contact.rule};
  for (const cases::PairRule& pair : contact.pairs) rules.push_back(pair.rule);
  const auto said = std::find_if(rules.begin(), rules.end(), [](const contact::BounceRule& rule) {
    return rule.tangential_restitution != 0;
  });
  if (said == rules.end()) return "";
  return fmt::format(
      "The case sets tangential_restitution = {}. The event engine uses it; the soft engine uses "
      "friction only{}. Spins, tangential speeds, losses and powers differ for that reason.",
      said->tangential_restitution,
      std::isfinite(said->friction) ? "" : ", here without a limit: surfaces stick");
}

EngineDiagnostics side(const Outcome& outcome) {
  return {outcome.cpu_seconds, outcome.notices};
}

double share_in_contact(const Comparison& c, observe::Estimate EnginePair::*engine) {
  for (const ComparedQuantity& q : c.quantities)
    if (q.name == "contact_time_share") return (q.estimates.*engine).mean;
  return nothing;
}

std::vector<std::string> cells(const EnginePair& b) {
  const bool told = std::isfinite(b.event.ci95) && std::isfinite(b.soft.ci95);
  std::vector<std::string> list;
  for (const double x :
       {b.event.mean, b.event.ci95, b.soft.mean, b.soft.ci95, b.ratio(), b.ratio_ci95()})
    list.push_back(results::csv_cell(x));
  list.push_back(told ? (b.differs() ? "1" : "0") : "");
  return list;
}

}  // namespace

double EnginePair::ratio_ci95() const {
  return std::abs(ratio()) * std::hypot(event.ci95 / event.mean, soft.ci95 / soft.mean);
}

bool EnginePair::differs() const {
  const double rounding = 1e-12 * (std::abs(event.mean) + std::abs(soft.mean));
  return std::abs(event.mean - soft.mean) > event.ci95 + soft.ci95 + rounding;
}

Comparison compare(const Outcome& event, const Outcome& soft) {
  constexpr int octaves = 10;  // of speed: a factor of about 1000
  constexpr int octave = LogHistogram::per_octave;
  const Spectra speeds(event, soft, &observe::Spectra::approach),
      energies(event, soft, &observe::Spectra::energy_normal);
  return {.title = event.mill_case.title,
          .case_file = event.mill_case.file,
          .threshold = event.mill_case.observe.threshold,
          .event = side(event),
          .soft = side(soft),
          .caution = caution(event.mill_case.contact),
          .quantities = quantities(event, soft),
          .speeds = speeds.bins(octave, octaves, true),
          .energies = energies.bins(2 * octave, 2 * octaves, true),
          .speed_curve = speeds.bins(1, octaves, false),
          .energy_curve = energies.bins(1, 2 * octaves, false)};
}

std::string how_to_read(const Comparison& c) {
  const double event = 100 * share_in_contact(c, &EnginePair::event);
  const double soft = 100 * share_in_contact(c, &EnginePair::soft);
  std::string text =
      "How to read it: if balls fly freely most of the time, the engines should agree in the rates "
      "and energies above the threshold and in the power. If balls stay in contact or lie in a "
      "bed, they should not: where the soft engine counts one long contact, the event engine makes "
      "many small bounces, or one rolling ball. Counts of all collisions and of slow ones, and "
      "their means, then differ.";
  if (std::isfinite(event) && std::isfinite(soft))
    text += fmt::format(" Here balls were in contact {} % (event) and {} % (soft) of the time.",
                        two_digits(event), two_digits(soft));
  return text + " ≠ marks numbers whose 95 % intervals do not overlap, which is rare by chance.";
}

std::string compare_csv(const Comparison& c) {
  std::string text =
      results::csv_line({"quantity", "unit", "event", "event_ci95", "soft", "soft_ci95", "ratio",
                         "ratio_ci95", "apart", "bin_low", "bin_high", "bin_unit"});
  const auto line = [&](std::string_view name, std::string_view unit, const EnginePair& both,
                        const std::vector<std::string>& bin) {
    std::vector<std::string> all{results::csv_cell(name), results::csv_cell(unit)};
    for (const auto& part : {cells(both), bin}) all.insert(all.end(), part.begin(), part.end());
    text += results::csv_line(all);
  };
  for (const ComparedQuantity& q : c.quantities) line(q.name, q.unit, q.estimates, {"", "", ""});
  const auto spectrum = [&](const char* name, const char* unit, const auto& bins) {
    for (const ComparedBin& b : bins)
      line(name, "1/s", b.rate, {results::csv_cell(b.low), results::csv_cell(b.high), unit});
  };
  spectrum("collision_rate_by_impact_speed_normal", "m/s", c.speeds);
  spectrum("collision_rate_by_energy_normal", "J", c.energies);
  return text;
}

}  // namespace mahlwerk::report
