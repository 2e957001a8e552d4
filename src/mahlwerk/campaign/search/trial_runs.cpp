// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/campaign/run/queue.hpp"
#include "mahlwerk/campaign/sweep/plan.hpp"

namespace mahlwerk::campaign {
namespace {

/// Where in a range a text lies.
double place_in_range(const cases::SweptKey& range, const std::string& text) {
  const double from = parse_quantity(range.values[0]).value;
  const double to = parse_quantity(range.values[1]).value;
  const double value = parse_quantity(text).value;
  const double place = range.logarithmic ? std::log(value / from) / std::log(to / from)
                                         : (value - from) / (to - from);
  return std::clamp(place, 0.0, 1.0);
}

/// The first line of what is wrong.
std::string short_reason(const std::exception& why) {
  if (const auto* input = dynamic_cast<const InputError*>(&why);
      input != nullptr && !input->faults().empty())
    return input->faults().front().what;
  return why.what();
}

/// What is wrong with an end of a range, in its own words: `speed = 300: the unit is missing` is
/// `from = 300`.
std::string as_said(const std::string& what, const cases::SweptKey& range, std::size_t end) {
  const std::string name = range.key.substr(range.key.rfind('.') + 1) + " = ";
  if (!what.starts_with(name)) return what;
  return fmt::format("\"{}\" {} = {}", range.key, end == 0 ? "from" : "to",
                     what.substr(name.size()));
}

Told told_by(const results::Outcome& outcome, const TrialRuns::Measure& measure) {
  Told told;
  told.notices = outcome.notices;
  for (const results::Replicate& r : outcome.replicates) {
    if (!r.stopped.empty()) told.failure = r.stopped;
    told.replicates.push_back(measure(outcome, r));
  }
  return told;
}

}  // namespace

TrialRuns::TrialRuns(const std::filesystem::path& file, const cases::Catalogue& catalogue,
                     std::vector<cases::Override> set, cases::Giver by)
    : file_(file),
      catalogue_(catalogue),
      set_(std::move(set)),
      by_(by),
      base_(file_.read(catalogue, set_)),
      over_(by == cases::Giver::match ? base_.match->over : base_.optimise->over) {
  std::vector<Fault> wrong;
  for (const cases::SweptKey& range : over_) check(range, wrong);
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

std::string TrialRuns::place_of(const cases::SweptKey& range) const {
  const char* section = by_ == cases::Giver::match ? "match" : "optimise";
  return cases::place_of(base_, fmt::format("{}.over.{}", section, range.key));
}

void TrialRuns::check(const cases::SweptKey& range, std::vector<Fault>& wrong) const {
  try {
    value_in_range(range, 0.5);
  } catch (const InputError& error) {
    for (Fault fault : error.faults()) {
      fault.where = fmt::format("{}: {}", place_of(range), fault.where);
      wrong.push_back(std::move(fault));
    }
    return;
  }
  for (const std::size_t end : {0, 1}) check_end(range, end, wrong);
}

/// A key, a unit or a number that no setting could have; what does not fit may fit elsewhere.
void TrialRuns::check_end(const cases::SweptKey& range, std::size_t end,
                          std::vector<Fault>& wrong) const {
  constexpr std::array sure{"unknown-key", "bad-quantity", "wrong-type", "unknown-word",
                            "out-of-range"};
  const std::string label = fmt::format("{} = {}", range.key, range.values[end]);
  std::vector<cases::Override> set = set_;
  set.push_back({range.key, range.values[end], by_});
  try {
    file_.read(catalogue_, set);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) {
      if (!fault.where.ends_with(label) || std::ranges::find(sure, fault.code) == sure.end())
        continue;
      Fault said{place_of(range), as_said(fault.what, range, end), fault.remedy, fault.code};
      const auto same = [&](const Fault& f) {
        return f.where == said.where && f.what == said.what;
      };
      if (std::ranges::none_of(wrong, same)) wrong.push_back(std::move(said));
    }
  }
}

std::vector<std::string> TrialRuns::values(const Place& place) const {
  std::vector<std::string> made;
  for (std::size_t i = 0; i < over_.size(); ++i) made.push_back(value_in_range(over_[i], place[i]));
  return made;
}

Place TrialRuns::snap(const Place& place) const {
  Place made;
  const std::vector<std::string> texts = values(place);
  for (std::size_t i = 0; i < over_.size(); ++i) made.push_back(place_in_range(over_[i], texts[i]));
  return made;
}

cases::Case TrialRuns::at(const Place& place, int first, int count) const {
  std::vector<cases::Override> set = set_;
  const std::vector<std::string> texts = values(place);
  for (std::size_t i = 0; i < over_.size(); ++i) set.push_back({over_[i].key, texts[i], by_});
  cases::Case made = file_.read(catalogue_, set);
  made.run.replicates = count;
  made.seed = base_.seed + static_cast<std::uint64_t>(first);
  made.optimise.reset();
  made.match.reset();
  return made;
}

TrialRuns TrialRuns::by_engine(cases::EngineName engine) const {
  TrialRuns other = *this;
  constexpr const char* key = "run.engine";
  std::erase_if(other.set_, [&](const cases::Override& set) { return set.key == key; });
  other.set_.push_back({key, std::string(name_of(engine))});
  return other;
}

std::vector<Told> TrialRuns::run(const std::vector<Asked>& asked, const Measure& measure,
                                 const Options& options, TrialStore& store,
                                 std::string_view version) const {
  struct Trial {
    std::size_t number;  // in `asked`
    cases::Case what;
    RunHash hash;
  };
  std::vector<Told> told(asked.size());
  std::vector<Trial> trials;  // that are to be run
  for (std::size_t i = 0; i < asked.size(); ++i) try {
      cases::Case what = at(asked[i].place, asked[i].first, asked[i].count);
      const RunHash hash = run_hash(what, version);
      if (auto known = store.find(hash))
        told[i] = std::move(*known);
      else
        trials.push_back({i, std::move(what), hash});
    } catch (const InputError& why) {
      told[i].failure = short_reason(why);
    }
  Queue queue;
  queue.size = trials.size();
  queue.open = [&](std::size_t i) { return trials[i].what; };
  queue.done = [&](std::size_t i, results::Outcome&& outcome) {
    if (outcome.interrupted) return;
    Told& mine = told[trials[i].number] = told_by(outcome, measure);
    store.keep(trials[i].hash, mine);
  };
  queue.failed = [&](std::size_t i, const std::exception& why) {
    told[trials[i].number].failure = short_reason(why);
  };
  Options with = options;
  with.threads = threads_of(options.threads);
  work_off(queue, with);
  if (options.stop != nullptr && *options.stop) throw Interrupted();
  return told;
}

}  // namespace mahlwerk::campaign
