// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/campaigns/paper_runs.hpp"

#include <fmt/format.h>

#include <functional>
#include <mutex>
#include <set>

#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/report.hpp"

namespace mahlwerk::commands {
namespace {

std::string below(const std::string& campaign, std::size_t point) {
  return fmt::format("{}/point-{:03}/", campaign, point + 1);
}

campaign::Campaign numbers_of(const cases::Case& mill_case,
                              const std::vector<results::Outcome>& outcomes) {
  const campaign::Plan plan(mill_case.sweep, mill_case.seed);
  const std::vector<std::string> own = campaign::base_values(plan, mill_case);
  campaign::Campaign made{.title = mill_case.title};
  for (const results::Outcome& outcome : outcomes) {
    const std::size_t i = made.points.size();
    campaign::add(made,
                  {.number = i + 1,
                   .values = campaign::point_values(plan, i, own),
                   .regime = outcome.summary.regime,
                   .warnings = results::warning_codes(outcome.notices),
                   .folder = fmt::format("point-{:03}/", i + 1)},
                  outcome.summary.quantities);
  }
  for (const results::Outcome& outcome : outcomes) results::count(made.notices, outcome.notices);
  results::sort(made.notices);
  made.keys = campaign::campaign_keys(plan.keys(), made.points);
  return made;
}

/// The points of all campaigns; points that campaigns share are stored once.
class UniquePoints {
 public:
  /// Adds a point unless an equal one is there. Returns its index in `points`.
  std::size_t add(const cases::Case& point) {
    cases::Case bare = point;
    bare.title.clear();
    const bool alone =
        point.observe.collisions || point.observe.frames;  // such a point writes its own files
    const std::string what = alone ? "" : cases::write(bare) + cases::input_files_fingerprint(bare);
    if (!alone) {
      const auto [known, fresh] = places_.try_emplace(what, points.size());
      if (!fresh) return known->second;
    }
    points.push_back(point);
    return points.size() - 1;
  }
  std::vector<cases::Case> points;

 private:
  std::map<std::string, std::size_t> places_;
};

/// Where a point stands in the paper.
struct PointPlace {
  std::string campaign;
  std::size_t point = 0;
};

/// Writes the results of points as they end and frees their statistics and films, unless a table or
/// a picture of the paper needs them. Once a file cannot be written, no further one is; the runs go
/// on.
class PointWriter {
 public:
  PointWriter(const PaperJob& job, std::vector<std::vector<PointPlace>> places)
      : job_(job), places_(std::move(places)) {
    for (const report::PaperTable& table : job.paper.tables)
      if (table.kind == report::PaperTable::Kind::captured) in_tables_.insert(table.campaign);
    for (const report::PaperFigure& figure : job.paper.figures)
      if (figure.drawn != report::PaperFigure::Drawn::quantity)
        in_pictures_.insert(figure.campaign);
  }
  void operator()(std::size_t k, results::Outcome& ended) {
    if (ended.interrupted) return;  // nothing of the paper will be written
    const std::lock_guard<std::mutex> one_at_a_time(mutex_);
    bool in_table = false, in_picture = false;
    for (const PointPlace& place : places_[k]) {
      ended.mill_case = job_.points.at(place.campaign)[place.point];
      if (unwritten.empty())
        unwritten = write_result([&] {
          report::write(*job_.folder, ended, version(), below(place.campaign, place.point), false);
        });
      in_table = in_table || in_tables_.contains(place.campaign);
      in_picture = in_picture || in_pictures_.contains(place.campaign);
    }
    if (!in_table) results::release_statistics(ended);
    if (in_picture) return;
    for (results::Replicate& r : ended.replicates) r.replay = {};
  }

  std::vector<Fault> unwritten;  ///< why the first file that failed was not written

 private:
  const PaperJob& job_;
  std::vector<std::vector<PointPlace>> places_;
  std::set<std::string> in_tables_, in_pictures_;  // campaigns
  std::mutex mutex_;
};

}  // namespace

PaperRuns run_paper(const Running& running, std::optional<double> checkpoint, const PaperJob& job,
                    campaign::ResumableRuns& kept) {
  UniquePoints unique;
  campaign::Streams streams(version());
  std::map<std::string, std::vector<std::size_t>> at;
  std::vector<std::vector<PointPlace>> places;
  for (const auto& [name, points] : job.points)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t k = unique.add(points[i]);
      at[name].push_back(k);
      if (k == places.size()) {
        places.emplace_back();
        streams.add(points[i], *job.folder, below(name, i));
      }
      places[k].push_back({name, i});
    }
  std::vector<std::size_t> uses;  // of each outcome, by campaigns
  for (const auto& one : places) uses.push_back(one.size());
  PointWriter write(job, std::move(places));
  std::vector<results::Outcome> outcomes =
      compute(running, unique.points, streams, kept, checkpoint, true, std::ref(write));
  PaperRuns made{.campaigns = {}, .unwritten = std::move(write.unwritten)};
  streams.close();
  std::vector<bool> counted(outcomes.size(), false);
  for (const auto& [name, points] : job.points) {
    report::RunCampaign& one = made.campaigns[name];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t k = at[name][i];
      if (!counted[k]) one.seconds += outcomes[k].cpu_seconds;
      counted[k] = true;
      const bool last = --uses[k] == 0;
      one.outcomes.push_back(last ? std::move(outcomes[k]) : outcomes[k]);
      one.outcomes.back().mill_case = points[i];
    }
    one.numbers = numbers_of(job.whole.at(name), one.outcomes);
  }
  return made;
}

}  // namespace mahlwerk::commands
