// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/spectra.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"

namespace mahlwerk::results {
namespace {

using observe::JointHistogram;
using observe::LogHistogram;
using observe::Spectra;

/// An energy of collisions: its name in columns and its description.
struct Energy {
  std::string name, about;
  HistogramMember part;
};

const std::vector<Energy>& energies() {
  static const std::vector<Energy> list{
      {"normal", "m u_n^2/2, the normal motion", &Spectra::energy_normal},
      {"contact_point", "m (u_n^2 + u_t^2)/2, slip and spin included",
       &Spectra::energy_contact_point},
      {"centre", "the energy of the motion of the centres", &Spectra::energy_centre},
      {"lost", "the energy dissipated", &Spectra::energy_lost},
      {"lost_normal", "the energy dissipated along the normal", &Spectra::lost_normal},
      {"lost_tangential", "the energy dissipated across the normal", &Spectra::lost_tangential},
  };
  return list;
}

std::vector<HistogramMember> histograms() {
  std::vector<HistogramMember> list;
  for (const Energy& e : energies()) list.push_back(e.part);
  return list;
}

/// All histograms that means are taken of.
const std::vector<HistogramMember>& all_histograms() {
  static const std::vector<HistogramMember> list = [] {
    std::vector<HistogramMember> made = histograms();
    for (const HistogramMember one : {&Spectra::approach, &Spectra::duration, &Spectra::flash})
      made.push_back(one);
    return made;
  }();
  return list;
}

std::size_t cell(int normal, int tangential) {
  return static_cast<std::size_t>(normal) * JointHistogram::bins +
         static_cast<std::size_t>(tangential);
}

/// Rates and powers of the first four energies, then of the two added later, so that older columns
/// keep their places.
template <class Rate, class Power>
void in_order(const Rate& rate, const Power& power) {
  const std::span<const Energy> all(energies());
  for (const std::span<const Energy> some : {all.first(4), all.subspan(4)}) {
    for (const Energy& e : some) rate(e);
    for (const Energy& e : some) power(e);
  }
}

std::vector<Column> energy_columns() {
  std::vector<Column> columns{{"energy_low", "J", "lower edge of the bin, which belongs to it"},
                              {"energy_high", "J", "upper edge of the bin"}};
  in_order(
      [&](const Energy& e) {
        columns.push_back({"rate_" + e.name, "1/s", "collisions per second by " + e.about});
      },
      [&](const Energy& e) {
        columns.push_back({"power_" + e.name, "W", "the sum per second of " + e.about});
      });
  return columns;
}

/// The first bin holds everything below its upper edge, 0 included.
double lower_edge(int bin) {
  return bin == 0 ? 0 : LogHistogram::lower(bin);
}

std::vector<double> energy_row(const MeanSpectra& spectra, int bin) {
  std::vector<double> row{lower_edge(bin), LogHistogram::lower(bin + 1)};
  in_order([&](const Energy& e) { row.push_back(spectra.rate(e.part, bin)); },
           [&](const Energy& e) { row.push_back(spectra.power(e.part, bin)); });
  return row;
}

/// One histogram as a table with a row per bin.
Table single(const Outcome& outcome, HistogramMember part, std::vector<Column> columns) {
  Table table{std::move(columns), {}};
  const MeanSpectra spectra = mean_spectra(outcome);
  const auto [first, last] = spectra.filled_bins({part});
  for (int bin = first; bin < last; ++bin)
    table.rows.push_back({lower_edge(bin), LogHistogram::lower(bin + 1), spectra.rate(part, bin)});
  return table;
}

}  // namespace

MeanSpectra::MeanSpectra()
    : bins_(all_histograms().size()),
      joint_(std::size_t{JointHistogram::bins} * JointHistogram::bins) {
  for (Bins& one : bins_)
    one.rate = one.power = std::vector<double>(std::size_t{LogHistogram::bins});
}

MeanSpectra::MeanSpectra(const std::vector<const Replicate*>& replicates) : MeanSpectra() {
  for (const Replicate* r : replicates) add(r->tally.total_spectra(), r->time());
}

MeanSpectra::MeanSpectra(const std::vector<const Replicate*>& replicates, int pair)
    : MeanSpectra() {
  for (const Replicate* r : replicates) add(r->tally.by_pair[pair].spectra, r->time());
}

/// Rates, not counts, are summed up, in the order of replicates: their times may differ.
void MeanSpectra::add(const Spectra& spectra, double time) {
  ++replicates_;
  for (std::size_t k = 0; k < bins_.size(); ++k) {
    const LogHistogram& counted = spectra.*all_histograms()[k];
    const auto [first, last] = counted.occupied_range();
    for (int bin = first; bin < last; ++bin) {
      const auto i = static_cast<std::size_t>(bin);
      bins_[k].rate[i] += static_cast<double>(counted.count(bin)) / time;
      bins_[k].power[i] += counted.sum(bin) / time;
    }
    if (first == last) continue;
    bins_[k].first = std::min(bins_[k].first, first);
    bins_[k].last = std::max(bins_[k].last, last);
  }
  for (int n = 0; n < JointHistogram::bins; ++n)
    for (int t = 0; t < JointHistogram::bins; ++t)
      joint_[cell(n, t)] += static_cast<double>(spectra.normal_tangential.count(n, t)) / time;
  for (std::size_t i = 0; i < observe::angle_bins; ++i) {
    angle_all_[i] += static_cast<double>(spectra.angle_all[i]) / time;
    angle_above_[i] += static_cast<double>(spectra.angle_above[i]) / time;
  }
}

double MeanSpectra::mean(double sum) const {
  return empty() ? 0 : sum / replicates_;
}

const MeanSpectra::Bins& MeanSpectra::bins_of(HistogramMember part) const {
  const auto& all = all_histograms();
  return bins_[static_cast<std::size_t>(std::ranges::find(all, part) - all.begin())];
}

double MeanSpectra::rate(HistogramMember part, int bin) const {
  return mean(bins_of(part).rate[static_cast<std::size_t>(bin)]);
}
double MeanSpectra::power(HistogramMember part, int bin) const {
  return mean(bins_of(part).power[static_cast<std::size_t>(bin)]);
}
double MeanSpectra::rate(observe::Angles Spectra::*part, std::size_t degree) const {
  return mean((part == &Spectra::angle_all ? angle_all_ : angle_above_)[degree]);
}
double MeanSpectra::rate(int normal, int tangential) const {
  return mean(joint_[cell(normal, tangential)]);
}

std::array<int, 2> MeanSpectra::filled_bins(const std::vector<HistogramMember>& wanted) const {
  int first = LogHistogram::bins, last = 0;
  for (const HistogramMember part : wanted) {
    first = std::min(first, bins_of(part).first);
    last = std::max(last, bins_of(part).last);
  }
  return first < last ? std::array{first, last} : std::array{0, 0};
}

MeanSpectra mean_spectra(const Outcome& outcome) {
  MeanSpectra made = outcome.summed_up ? outcome.summed_up->spectra : MeanSpectra();
  for (const Replicate* r : averaged_replicates(outcome))
    if (!r->read_before) made.add(r->tally.total_spectra(), r->time());
  return made;
}

MeanSpectra mean_spectra(const Outcome& outcome, int pair) {
  MeanSpectra made = outcome.summed_up ? outcome.summed_up->by_pair[static_cast<std::size_t>(pair)]
                                       : MeanSpectra();
  for (const Replicate* r : averaged_replicates(outcome))
    if (!r->read_before) made.add(r->tally.by_pair[pair].spectra, r->time());
  return made;
}

double largest_speed(const Replicate& replicate) {
  if (replicate.read_before) return replicate.read_before->largest_speed;
  const LogHistogram speeds = replicate.tally.total_spectra().approach;
  const int last = speeds.occupied_range()[1] - 1;
  return last < 0 ? 0 : speeds.sum(last) / static_cast<double>(speeds.count(last));
}

Table spectrum(const Outcome& outcome) {
  Table table{energy_columns(), {}};
  const MeanSpectra spectra = mean_spectra(outcome);
  const auto [first, last] = spectra.filled_bins(histograms());
  for (int bin = first; bin < last; ++bin) table.rows.push_back(energy_row(spectra, bin));
  return table;
}

Table speeds(const Outcome& outcome) {
  return single(outcome, &Spectra::approach,
                {{"speed_low", "m/s", "lower edge of the bin, which belongs to it"},
                 {"speed_high", "m/s", "upper edge of the bin"},
                 {"rate", "1/s", "collisions per second by their normal speed u_n"}});
}

Table durations(const Outcome& outcome) {
  return single(outcome, &Spectra::duration,
                {{"duration_low", "s", "lower edge of the bin, which belongs to it"},
                 {"duration_high", "s", "upper edge of the bin"},
                 {"rate", "1/s", "contacts that ended per second by their duration"}});
}

Table flashes(const Outcome& outcome) {
  return single(outcome, &Spectra::flash,
                {{"rise_low", "K", "lower edge of the bin, which belongs to it"},
                 {"rise_high", "K", "upper edge of the bin"},
                 {"rate", "1/s", "collisions per second by their flash temperature rise"}});
}

Table angles(const Outcome& outcome) {
  Table table{{{"angle_low", "deg", "lower edge of the bin; 0 is head-on, 90 grazing"},
               {"angle_high", "deg", "upper edge of the bin"},
               {"rate", "1/s", "collisions per second by impact angle"},
               {"rate_above_threshold", "1/s",
                "collisions per second with a normal speed u_n of at least the threshold"}},
              {}};
  const MeanSpectra spectra = mean_spectra(outcome);
  if (spectra.empty()) return table;
  for (std::size_t bin = 0; bin < observe::angle_bins; ++bin) {
    const auto low = static_cast<double>(bin);
    table.rows.push_back({low, low + 1, spectra.rate(&Spectra::angle_all, bin),
                          spectra.rate(&Spectra::angle_above, bin)});
  }
  return table;
}

Table normal_tangential(const Outcome& outcome) {
  Table table{{{"energy_normal_low", "J", "lower edge of the bin of m u_n^2/2"},
               {"energy_normal_high", "J", "upper edge of that bin"},
               {"energy_tangential_low", "J", "lower edge of the bin of m u_t^2/2"},
               {"energy_tangential_high", "J", "upper edge of that bin"},
               {"rate", "1/s", "collisions per second with both energies in these bins"}},
              {}};
  const MeanSpectra spectra = mean_spectra(outcome);
  for (int n = 0; n < JointHistogram::bins; ++n)
    for (int t = 0; t < JointHistogram::bins; ++t)
      if (const double rate = spectra.rate(n, t); rate > 0)
        table.rows.push_back({JointHistogram::lower(n), JointHistogram::lower(n + 1),
                              JointHistogram::lower(t), JointHistogram::lower(t + 1), rate});
  return table;
}

Table spectra_by_pair(const Outcome& outcome) {
  Table table{pair_columns(), {}};
  for (Column& column : energy_columns()) table.columns.push_back(std::move(column));
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const observe::StatisticsByPair& first = chosen.front()->tally.by_pair;
  for (int pair = 0; pair < first.pairs(); ++pair) {
    const MeanSpectra spectra = mean_spectra(outcome, pair);
    const auto [from, to] = spectra.filled_bins(histograms());
    for (int bin = from; bin < to; ++bin) {
      const std::vector<double> numbers = energy_row(spectra, bin);
      if (std::all_of(numbers.begin() + 2, numbers.end(), [](double v) { return v == 0; }))
        continue;
      std::vector<double> row = pair_cells(table, pair_names(outcome.mill_case, first, pair));
      row.insert(row.end(), numbers.begin(), numbers.end());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace mahlwerk::results
