// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/microphone/microphone.hpp"

#include <fmt/format.h>

#include <string>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/parts/microphone/hit_counter.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::microphone {
namespace {

using cases::Case;
using observe::LogHistogram;
using results::Outcome;
using results::Replicate;
using results::Table;

void describe(cases::KeyVisitor& v, Microphone& microphone, const Case&) {
  v.number({"threshold", "J", not_negative, "least normal energy of a hit that is heard",
            Microphone().threshold, "every hit is heard"},
           microphone.threshold);
  v.number({"definition_time", "s", not_negative,
            "hits with shorter intervals are heard as one, with the energy of the largest",
            Microphone().definition_time, "the ring of a jar; uncalibrated, 0.1-10 ms"},
           microphone.definition_time);
  v.word({"hears",
          {"jar", "all"},
          "jar",
          "the jar carries the sound to the sensor",
          "which hits are heard",
          {"hits on the jar", "also hits between balls"}},
         microphone.hears);
}

const Microphone& microphone_of(const Case& c) {
  return *c.parts.find<Microphone>();
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  const Microphone& microphone = microphone_of(c);
  return std::make_unique<HitCounter>(microphone.threshold, microphone.definition_time,
                                      microphone.hears == Microphone::Hears::all);
}

const HitCounter& hits(const Replicate& r) {
  return *r.recorders.find<HitCounter>();
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<Microphone>() != nullptr; };
  return results::where(
      present, "with `[microphone]`",
      {{"heard_hit_rate",
        "1/s",
        "hits per second that the microphone hears",
        [](const Case&, const Replicate& r) {
          const LogHistogram heard = hits(r).heard();
          return results::share(static_cast<double>(heard.total()), r.time());
        },
        {.label = "rate of heard hits", .equation = "sns.3", .heading = "Microphone", .key = 13}},
       {"heard_hit_energy_mean",
        "J",
        "mean normal energy of the hits that it hears",
        [](const Case&, const Replicate& r) {
          const LogHistogram heard = hits(r).heard();
          return results::share(heard.sum(), static_cast<double>(heard.total()));
        },
        {.label = "mean energy of heard hits"}}});
}

/// A row for each bin of energy.
Table heard_hits(const Outcome& outcome) {
  Table table{{{"energy_low", "J", "lower edge of the bin of normal energy"},
               {"energy_high", "J", "its upper edge"},
               {"rate", "1/s", "hits per second that are heard"},
               {"rate_above", "1/s", "those with at least the energy of the lower edge"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  LogHistogram all;
  double time = 0;
  for (const Replicate* r : chosen) {
    all.merge(hits(*r).heard());
    time += r->time();
  }
  const auto [first, end] = all.occupied_range();
  double above = static_cast<double>(all.total());
  for (int bin = first; bin < end; ++bin) {
    const auto count = static_cast<double>(all.count(bin));
    table.rows.push_back(
        {LogHistogram::lower(bin), LogHistogram::lower(bin + 1), count / time, above / time});
    above -= count;
  }
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"microphone", "hits that the microphone hears, by energy", heard_hits(outcome)}};
}

/// Impacts follow each other faster than the microphone can tell them apart (sns.3).
Notices merged_hits(const Outcome& outcome) {
  const auto chosen = results::averaged_replicates(outcome);
  const Microphone& microphone = microphone_of(outcome.mill_case);
  if (chosen.empty()) return {};
  const double rate = results::mean_over(
      chosen, [](const Replicate& r) { return static_cast<double>(hits(r).impacts()) / r.time(); });
  if (!(rate * microphone.definition_time > 1)) return {};
  return {warning(
      "merged-hits",
      fmt::format("{:.0f} impacts per second are loud enough for the microphone, more than one in "
                  "its definition time of {}: it hears most of them as one, and its rate of hits "
                  "says little. A higher microphone.threshold tells the strong ones apart.",
                  rate, show_rounded(microphone.definition_time, "s")))};
}

report::Plot plot_of(const Outcome& outcome) {
  const Table table = heard_hits(outcome);
  const std::vector<double> energy = report::column(table, "energy_low"),
                            rate = report::column(table, "rate_above");
  const report::Multiple unit = report::multiple(report::largest(energy), "J");
  report::Plot plot{
      .title = "Hits that the microphone hears",
      .x = report::Axis{.label = fmt::format("normal energy of a hit ({})", unit.unit),
                        .logarithmic = true},
      .y = report::Axis{.label = "hits per second with at least this energy", .logarithmic = true},
      .series =
          {{"", report::column(table, "energy_low", unit.factor), rate, {}, report::Mark::line}},
      .shape = 0.42};
  constexpr double decades = 1e7;  // the weakest bounces of a settling ball are not drawn
  if (!energy.empty() && energy.front() < energy.back() / decades)
    plot.x.least = energy.back() / unit.factor / decades;
  return plot;
}

std::string panel(const Outcome& outcome) {
  return report::figure(
      plot_of(outcome),
      "Hits per second that are heard with at least this normal energy: what an acoustic sensor "
      "counts above a threshold. microphone.csv has the numbers.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "microphone",
      .sections = {cases::section_of<Microphone, describe>(
          {"microphone", "", "hits that an acoustic sensor hears, by energy; may be empty"})},
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .notices = merged_hits,
      .heading = "Sensors",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::microphone
