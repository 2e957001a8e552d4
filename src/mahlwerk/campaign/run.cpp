// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/engine_choice.hpp"
#include "mahlwerk/campaign/parallel.hpp"
#include "mahlwerk/campaign/plan.hpp"
#include "mahlwerk/campaign/replicate.hpp"
#include "mahlwerk/campaign/soft_settings.hpp"
#include "mahlwerk/results/making.hpp"

namespace mahlwerk::campaign {
namespace {

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Job {
  std::size_t point;
  int replicate;
};

/// Progress of all replicates together, told at most ten times a second.
class Teller {
 public:
  Teller(const Options& options, double wanted) : options_(&options) { sum_.wanted = wanted; }

  void add(double simulated, double collisions, double residual) {
    if (!options_->progress) return;
    const std::lock_guard lock(mutex_);
    sum_.simulated += simulated;
    sum_.collisions += collisions;
    sum_.residual = std::max(sum_.residual, residual);
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < std::chrono::milliseconds(100)) return;
    told_ = now;
    options_->progress(sum_);
  }

 private:
  const Options* options_;
  Progress sum_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

}  // namespace

std::vector<results::Outcome> run(const std::vector<cases::Case>& points, const Options& options) {
  std::vector<Fault> wrong;
  std::vector<Job> jobs;
  std::vector<results::Outcome> outcomes;
  double wanted = 0;
  for (const cases::Case& what : points) {
    for (Fault& fault : run_faults(what)) wrong.push_back(std::move(fault));
    const auto count = static_cast<std::size_t>(what.run.replicates);
    for (std::size_t i = 0; i < count; ++i) jobs.push_back({outcomes.size(), static_cast<int>(i)});
    wanted += (what.run.time + what.run.settle) * static_cast<double>(count);
    outcomes.push_back(
        {.what = what, .replicates = {count, results::empty_replicate(what)}, .notes = {}});
  }
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = options.threads > 0 ? options.threads : cores;
  if (wrong.empty()) wrong = memory_faults(points, threads, options.memory);
  if (!wrong.empty()) throw InputError(std::move(wrong));

  const auto started = std::chrono::steady_clock::now();
  Teller teller(options, wanted);
  const auto stopped = [&] { return options.stop != nullptr && options.stop->load(); };
  // Threads that no replicate is left for help those there are.
  const int each = std::max(1, threads / std::max(1, static_cast<int>(jobs.size())));
  std::vector<Choice> choices(points.size());
  std::vector<cases::Case> decided = points;  // with the engine that runs them
  in_parallel(threads, points.size(), [&](std::size_t i) {
    choices[i] = choose(points[i], options.stop);
    decided[i].run.engine = choices[i].engine;
  });
  in_parallel(threads, jobs.size(), [&](std::size_t i) {
    const Job& job = jobs[i];
    Replica replica(decided[job.point], job.replicate,
                    options.records ? options.records(job.point, job.replicate) : nullptr,
                    options.frames ? options.frames(job.point, job.replicate) : nullptr, each);
    if (options.checkpoint != nullptr) options.checkpoint->restore(i, replica);
    const double cpu = thread_cpu_seconds() - replica.cpu_seconds();
    while (!replica.done() && !stopped()) {
      const scene::Account before = replica.account();
      replica.go_on();
      const scene::Account& now = replica.account();
      replica.cpu_seconds() = thread_cpu_seconds() - cpu;
      teller.add(now.time - before.time, static_cast<double>(now.collisions - before.collisions),
                 now.worst_collision);
      if (options.checkpoint != nullptr && options.checkpoint->due(i))
        options.checkpoint->keep(i, replica);
    }
    if (options.checkpoint != nullptr) options.checkpoint->keep(i, replica);
    outcomes[job.point].replicates[static_cast<std::size_t>(job.replicate)] = replica.result();
  });
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    results::Outcome& outcome = outcomes[i];
    outcome.engine = choices[i].engine;
    outcome.interrupted = stopped();
    outcome.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    for (const results::Replicate& r : outcome.replicates) outcome.cpu_seconds += r.cpu_seconds;
    outcome.notes = notes_on(outcome, choices[i]);
  }
  return outcomes;
}

results::Outcome run(const cases::Case& what, const Options& options) {
  return run(std::vector{what}, options).front();
}

std::vector<cases::Case> points(const cases::Case& what, const cases::Catalogue& catalogue,
                                const std::vector<cases::Override>& overrides) {
  if (what.sweep.empty()) return {what};
  std::vector<std::vector<cases::Override>> all;
  const Plan plan(what.sweep, what.seed);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    all.push_back(overrides);
    const std::vector<std::string> values = plan.values(i);
    for (std::size_t k = 0; k < values.size(); ++k)
      all.back().push_back({plan.keys()[k], values[k]});
  }
  std::vector<cases::Case> made;
  std::vector<Fault> wrong;
  for (const auto& one : all) try {
      made.push_back(cases::read(what.file, catalogue, one));
      made.back().sweep = {};
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

}  // namespace mahlwerk::campaign
