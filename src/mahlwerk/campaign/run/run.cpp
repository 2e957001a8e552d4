// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/run.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/further_starts.hpp"
#include "mahlwerk/campaign/run/later_motion.hpp"
#include "mahlwerk/campaign/run/other_engine.hpp"
#include "mahlwerk/campaign/run/queue.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::campaign {
namespace {

/// Faults of all points, and their work.
struct Load {
  std::vector<Fault> wrong;
  std::vector<std::size_t> first_job;  // of each point: replicates of those before it
  std::size_t jobs = 0;
  double total = 0;  // [s] simulated, of all
};

Load load_of(const std::vector<cases::Case>& points) {
  Load load;
  for (const cases::Case& mill_case : points) {
    for (Fault& fault : run_faults(mill_case)) load.wrong.push_back(std::move(fault));
    load.first_job.push_back(load.jobs);
    load.jobs += static_cast<std::size_t>(mill_case.run.replicates);
    load.total += cases::simulated_time(mill_case) * static_cast<double>(mill_case.run.replicates);
  }
  return load;
}

/// Adds what only a single run computes: many points would take twice as long.
void conclude_single(results::Outcome& outcome, const RunOptions& options) {
  append(outcome.notices, further_start_notices(outcome, options.stop));
  append(outcome.notices, later_motion_notices(outcome, options));
  append(outcome.notices, other_engine_notices(outcome, options));
  std::ranges::stable_sort(outcome.notices, std::ranges::greater(), &Notice::severity);
}

/// Outcome of a point that was never begun.
results::Outcome unstarted_outcome(const cases::Case& mill_case) {
  const auto count = static_cast<std::size_t>(mill_case.run.replicates);
  results::Outcome outcome{.mill_case = mill_case,
                           .replicates = {count, results::unrun_replicate(mill_case)}};
  outcome.interrupted = true;
  outcome.summary = results::summarise(outcome);
  outcome.notices = results::warnings(outcome);
  return outcome;
}

}  // namespace

std::vector<results::Outcome> run(const std::vector<cases::Case>& points,
                                  const RunOptions& options) {
  Load load = load_of(points);
  RunOptions own = options;
  own.threads = thread_count(options.threads) / std::max(1, options.lammps.ranks);
  own.threads = std::max(1, own.threads);
  if (load.wrong.empty()) load.wrong = memory_faults(points, own.threads, own.memory, own.sums_up);
  if (!load.wrong.empty()) throw InputError(std::move(load.wrong));
  own.memory = std::nullopt;  // checked above for all points together
  std::vector<std::optional<results::Outcome>> ended(points.size());
  const auto started = std::chrono::steady_clock::now();
  RunQueue queue;
  queue.size = points.size();
  queue.open = [&](std::size_t i) { return points[i]; };
  queue.done = [&](std::size_t i, results::Outcome&& outcome) { ended[i] = std::move(outcome); };
  if (options.checkpoint != nullptr)
    queue.checkpoint_slot = [&](std::size_t i) {
      return CheckpointSlot{options.checkpoint, load.first_job[i]};
    };
  // Spare threads share the work of replicates.
  queue.threads_per_replicate = std::max(1, own.threads / std::max(1, static_cast<int>(load.jobs)));
  queue.total = load.total;
  run_queue(queue, own);
  if (points.size() == 1 && ended[0]) conclude_single(*ended[0], options);
  const double took =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  std::vector<results::Outcome> outcomes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    outcomes.push_back(ended[i] ? std::move(*ended[i]) : unstarted_outcome(points[i]));
    outcomes.back().wall_seconds = took;
  }
  return outcomes;
}

int thread_count(int asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

results::Outcome run(const cases::Case& mill_case, const RunOptions& options) {
  return run(std::vector{mill_case}, options).front();
}

std::vector<cases::Case> points(const cases::Case& mill_case, const cases::Catalogue& catalogue,
                                const std::vector<cases::Override>& overrides, std::size_t most) {
  if (mill_case.sweep.empty()) return {mill_case};
  const Plan plan(mill_case.sweep, mill_case.seed);
  const cases::CaseFile file(mill_case.file);
  std::vector<cases::Case> made;
  std::vector<Fault> wrong;
  for (std::size_t i = 0; i < std::min(plan.size(), most); ++i) try {
      std::vector<cases::Override> set = overrides;
      std::ranges::move(plan.overrides(i), std::back_inserter(set));
      made.push_back(file.read(catalogue, set));
      made.back().sweep = {};
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

}  // namespace mahlwerk::campaign
