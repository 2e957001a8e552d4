// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/trial_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/queue.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"

namespace mahlwerk::campaign {
namespace {

/// Position of a value in a range, 0 to 1.
double position_in_range(const cases::SweptKey& range, const std::string& text) {
  const double from = parse_quantity(range.values[0]).value;
  const double to = parse_quantity(range.values[1]).value;
  const double value = parse_quantity(text).value;
  const double position = range.logarithmic ? math::log(value / from) / math::log(to / from)
                                            : (value - from) / (to - from);
  return std::clamp(position, 0.0, 1.0);
}

/// The first fault of an exception, else its text.
std::string short_reason(const std::exception& why) {
  if (const auto* input = dynamic_cast<const InputError*>(&why);
      input != nullptr && !input->faults().empty())
    return input->faults().front().what;
  return why.what();
}

/// A fault of a range's end in terms of the range: `speed = 300: the unit is missing` becomes `from
/// = 300: the unit is missing`.
std::string with_range(const std::string& what, const cases::SweptKey& range, std::size_t end) {
  const std::string name = range.key.substr(range.key.rfind('.') + 1) + " = ";
  if (!what.starts_with(name)) return what;
  return fmt::format("\"{}\" {} = {}", range.key, end == 0 ? "from" : "to",
                     what.substr(name.size()));
}

TrialResult trial_result(const results::Outcome& outcome, const TrialRuns::Measure& measure) {
  TrialResult result;
  result.notices = outcome.notices;
  for (const results::Replicate& r : outcome.replicates) {
    if (!r.stop_reason.empty()) result.failure = r.stop_reason;
    result.replicates.push_back(measure(outcome, r));
  }
  return result;
}

/// A trial that is not in the store.
struct PendingRun {
  TrialResult* result;
  cases::Case mill_case;
  RunHash hash;

  /// The case by the soft engine, if that is to replace a result: one of several balls by the event
  /// engine that is invalid. No value where this takes too long. So the best setting of a search is
  /// the best by an engine that is valid there.
  std::optional<cases::Case> by_soft_engine() const {
    const bool invalid = std::ranges::find(result->notices, Severity::invalid, &Notice::severity) !=
                         result->notices.end();
    if (mill_case.run.engine != cases::EngineName::event || !invalid ||
        cases::balls_count(mill_case.balls) == 1)
      return std::nullopt;
    cases::Case soft = mill_case;
    soft.run.engine = cases::EngineName::soft;
    const bool runs = run_faults(soft).empty() &&
                      soft_work(soft) * static_cast<double>(soft.run.replicates) <= max_check_work;
    return runs ? std::optional(std::move(soft)) : std::nullopt;
  }
};

/// Runs the trials, and puts their results in place and into the store.
void run_pending(const std::vector<PendingRun>& pending, const TrialRuns::Measure& measure,
                 const RunOptions& options, TrialStore& store) {
  RunQueue queue;
  queue.size = pending.size();
  queue.open = [&](std::size_t i) { return pending[i].mill_case; };
  queue.done = [&](std::size_t i, results::Outcome&& outcome) {
    if (outcome.interrupted) return;
    *pending[i].result = trial_result(outcome, measure);
    if (!pending[i].by_soft_engine()) store.keep(pending[i].hash, *pending[i].result);
  };
  queue.failed = [&](std::size_t i, const std::exception& why) {
    pending[i].result->failure = short_reason(why);
  };
  RunOptions with = options;
  with.threads = thread_count(options.threads);
  run_queue(queue, with);
  if (options.stop != nullptr && *options.stop) throw Interrupted();
}

}  // namespace

TrialRuns::TrialRuns(const std::filesystem::path& file, const cases::Catalogue& catalogue,
                     std::vector<cases::Override> set, cases::ValueSource source)
    : file_(file), catalogue_(catalogue), set_(std::move(set)), source_(source) {
  if (source == cases::ValueSource::fit)
    take_ranges_of_fit(file);
  else
    base_ = file_.read(catalogue, set_);
  if (source == cases::ValueSource::match) ranges_ = base_.match->over;
  if (source == cases::ValueSource::optimise) ranges_ = base_.optimise->over;
  std::vector<Fault> wrong;
  for (const cases::SweptKey& range : ranges_) check(range, wrong);
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

/// Keys of [fit] may have no value in the case: for the base case each has the upper end of its
/// range.
void TrialRuns::take_ranges_of_fit(const std::filesystem::path& file) {
  std::vector<cases::Override> anywhere = set_;
  for (const auto& [key, ends] : cases::fit_ranges(file)) {
    if (cases::gives_value(set_, key)) continue;
    anywhere.push_back({key, ends[1], source_});
    if (cases::is_key_of_run(key))
      ranges_.push_back({.key = key, .values = {ends[0], ends[1]}, .range = true});
  }
  base_ = file_.read(catalogue_, anywhere);
  for (cases::SweptKey& range : ranges_) {
    const double least = parse_quantity(range.values[0]).value,
                 most = parse_quantity(range.values[1]).value;
    range.logarithmic = least > 0 && most > 10 * least;  // (fit.2)
  }
}

std::string TrialRuns::place_of(const cases::SweptKey& range) const {
  if (source_ == cases::ValueSource::fit) return cases::location_of(base_, "fit." + range.key);
  const char* section = source_ == cases::ValueSource::match ? "match" : "optimise";
  return cases::location_of(base_, fmt::format("{}.over.{}", section, range.key));
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

/// Adds the faults of a range's end that hold for any setting: key, unit or number. Other faults
/// may depend on other keys.
void TrialRuns::check_end(const cases::SweptKey& range, std::size_t end,
                          std::vector<Fault>& wrong) const {
  constexpr std::array sure{"unknown-key", "bad-quantity", "wrong-type", "unknown-word",
                            "out-of-range"};
  const std::string label = fmt::format("{} = {}", range.key, range.values[end]);
  std::vector<cases::Override> set = set_;
  set.push_back({range.key, range.values[end], source_});
  try {
    file_.read(catalogue_, set);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) {
      if (!fault.where.ends_with(label) || std::ranges::find(sure, fault.code) == sure.end())
        continue;
      Fault swept_fault{place_of(range), with_range(fault.what, range, end), fault.remedy,
                        fault.code};
      const auto same = [&](const Fault& f) {
        return f.where == swept_fault.where && f.what == swept_fault.what;
      };
      if (std::ranges::none_of(wrong, same)) wrong.push_back(std::move(swept_fault));
    }
  }
}

std::vector<std::string> TrialRuns::values(const DesignPoint& point) const {
  std::vector<std::string> made;
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    made.push_back(value_in_range(ranges_[i], point[i]));
  return made;
}

DesignPoint TrialRuns::snap(const DesignPoint& point) const {
  DesignPoint made;
  const std::vector<std::string> texts = values(point);
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    made.push_back(position_in_range(ranges_[i], texts[i]));
  return made;
}

cases::Case TrialRuns::at(const DesignPoint& point, int first, int count) const {
  std::vector<cases::Override> set = set_;
  const std::vector<std::string> texts = values(point);
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    set.push_back({ranges_[i].key, texts[i], source_});
  cases::Case made = file_.read(catalogue_, set);
  made.run.replicates = count;
  made.seed = base_.seed + static_cast<std::uint64_t>(first);
  if (made.uncertainty) made.uncertainty->first = first;
  made.optimise.reset();
  made.match.reset();
  made.fit.clear();
  return made;
}

TrialRuns TrialRuns::with_engine(cases::EngineName engine) const {
  TrialRuns other = *this;
  constexpr const char* key = "run.engine";
  std::erase_if(other.set_, [&](const cases::Override& set) { return set.key == key; });
  other.set_.push_back({key, std::string(name_of(engine))});
  return other;
}

std::vector<TrialResult> TrialRuns::run(const std::vector<TrialRequest>& requests,
                                        const Measure& measure, const RunOptions& options,
                                        TrialStore& store, std::string_view version) const {
  return run_each({*this}, requests, measure, options, store, version).front();
}

std::vector<std::vector<TrialResult>> TrialRuns::run_each(const std::vector<TrialRuns>& cases,
                                                          const std::vector<TrialRequest>& requests,
                                                          const Measure& measure,
                                                          const RunOptions& options,
                                                          TrialStore& store,
                                                          std::string_view version) {
  std::vector<std::vector<TrialResult>> all(cases.size(),
                                            std::vector<TrialResult>(requests.size()));
  std::vector<PendingRun> pending;  // not in the store
  for (std::size_t k = 0; k < cases.size(); ++k)
    for (std::size_t i = 0; i < requests.size(); ++i) try {
        const TrialRequest& asked = requests[i];
        cases::Case mill_case = cases[k].at(asked.point, asked.first, asked.count);
        const RunHash hash = run_hash(mill_case, version);
        if (auto known = store.find(hash))
          all[k][i] = std::move(*known);
        else
          pending.push_back({&all[k][i], std::move(mill_case), hash});
      } catch (const InputError& why) {
        if (!is_point_failure(why)) throw;
        all[k][i].failure = short_reason(why);
      }
  run_pending(pending, measure, options, store);
  std::vector<PendingRun> again;
  for (const PendingRun& one : pending)
    if (auto soft = one.by_soft_engine()) again.push_back({one.result, std::move(*soft), one.hash});
  run_pending(again, measure, options, store);
  return all;
}

}  // namespace mahlwerk::campaign
