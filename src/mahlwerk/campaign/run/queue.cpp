// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/queue.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/start_threads.hpp"
#include "mahlwerk/campaign/run/active_point.hpp"
#include "mahlwerk/campaign/run/conclude.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/lammps_runs.hpp"
#include "mahlwerk/campaign/run/progress_reporter.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"

namespace mahlwerk::campaign {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Replicates of a point to be run by one thread.
struct Task {
  std::shared_ptr<ActivePoint> point;
  std::size_t first = 0, count = 0;
};

/// A replicate that runs.
struct ActiveReplicate {
  std::size_t index;
  CheckpointSlot slot;
  std::size_t job;
  std::unique_ptr<ReplicateRun> run;
};

class CampaignRunner {
 public:
  CampaignRunner(const RunQueue& queue, const RunOptions& options)
      : queue_(queue), options_(options), progress_(options, queue.total) {}

  void work(int threads) {
    const auto worker = [this] {
      try {
        while (auto task = next_task()) finish(*task);
      } catch (...) {
        fail_all(std::current_exception());
      }
    };
    {
      std::vector<std::jthread> team;
      start_threads(team, threads - 1, [&](int) { worker(); });
      worker();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  bool stopped() const {
    return failed_.load() || (options_.stop != nullptr && options_.stop->load());
  }

  void fail_all(std::exception_ptr why) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(why);
    failed_ = true;
    changed_.notify_all();
  }

  /// The next replicates of an active point, else of a new point; empty once all have begun.
  std::optional<Task> next_task() {
    std::unique_lock lock(mutex_);
    for (;;) {
      if (failed_) return std::nullopt;
      for (const auto& point : open_)
        if (point->next < point->outcome.replicates.size()) return task_of(point);
      if (next_ < queue_.size && !stopped())
        open_next(lock);
      else if (opening_ > 0)
        changed_.wait(lock);  // the new point may have several replicates
      else
        return std::nullopt;
    }
  }

  Task task_of(const std::shared_ptr<ActivePoint>& point) const {
    Task task{point, point->next,
              std::min(batch_size(*point), point->outcome.replicates.size() - point->next)};
    point->next += task.count;
    return task;
  }

  /// Number of replicates that one thread runs together, in batches of equal size. Towards the end
  /// of the queue, all threads share the replicates of a point.
  std::size_t batch_size(const ActivePoint& point) const {
    const std::size_t count = point.outcome.replicates.size(),
                      most = replicates_together(point.decided),
                      workers = queue_.size - next_ < static_cast<std::size_t>(threads())
                                    ? static_cast<std::size_t>(threads())
                                    : 1;
    const std::size_t share = (count + workers - 1) / workers;  // of a worker
    const std::size_t batches = (share + most - 1) / most;
    return (share + batches - 1) / batches;
  }

  /// Unlocks the mutex while the case is read, so that other threads continue.
  void open_next(std::unique_lock<std::mutex>& lock) {
    const std::size_t index = next_++;
    ++opening_;
    lock.unlock();
    std::shared_ptr<ActivePoint> point;
    std::exception_ptr error;
    try {
      point = open(index);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    --opening_;
    changed_.notify_all();
    if (error) std::rethrow_exception(error);
    if (point) open_.push_back(std::move(point));
  }

  /// Null if the point failed; the failure has been reported.
  std::shared_ptr<ActivePoint> open(std::size_t index) try {
    cases::Case mill_case = queue_.open(index);
    std::vector<Fault> wrong = run_faults(mill_case);
    if (wrong.empty())
      wrong = memory_faults({mill_case}, threads(), options_.memory, options_.sums_up);
    if (!wrong.empty()) throw InputError(std::move(wrong));
    auto point = std::make_shared<ActivePoint>(index, mill_case, options_.stop);
    if (options_.sums_up && results::can_be_summed_up(point->decided))
      point->sums = std::make_unique<results::SummingUp>(point->outcome);
    return point;
  } catch (...) {
    failed(index, std::current_exception());
    return nullptr;
  }

  int threads() const { return std::max(1, options_.threads); }

  /// Runs replicates; after the last one of a point, passes on the outcome.
  void finish(const Task& task) {
    ActivePoint& point = *task.point;
    std::exception_ptr error;
    try {
      simulate(task);
    } catch (...) {
      error = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      if (error && !point.failure) drop(point, error);
      if ((point.left -= task.count) > 0) return;
      open_.remove(task.point);
    }
    if (point.failure) return failed(point.index, point.failure);
    point.outcome.interrupted = stopped();
    point.outcome.wall_seconds = seconds_since(point.began);
    conclude(point.outcome, point.choice, options_.stop);
    queue_.done(point.index, std::move(point.outcome));
  }

  /// Begins no further replicate of the point; active ones end soon.
  static void drop(ActivePoint& point, const std::exception_ptr& why) {
    point.failure = why;
    point.dropped = true;
    point.left -= point.outcome.replicates.size() - point.next;
    point.next = point.outcome.replicates.size();
  }

  void failed(std::size_t index, const std::exception_ptr& why) try {
    std::rethrow_exception(why);
  } catch (const std::exception& e) {
    if (!queue_.failed || !is_point_failure(e)) throw;
    queue_.failed(index, e);
  }

  /// Runs replicates side by side and puts their results into the outcome of their point.
  void simulate(const Task& task) {
    ActivePoint& point = *task.point;
    std::vector<ActiveReplicate> active;
    for (std::size_t r = task.first; r < task.first + task.count; ++r) try {
        active.push_back(begin(point, r));
      } catch (const Interrupted&) {  // stopped before the replicate began
        point.outcome.replicates[r].complete = false;
        if (point.sums) point.sums->ended(r);
      }
    double cpu = thread_cpu_seconds();
    while (!active.empty()) {
      Checkpoint* const states = active.front().slot.checkpoint;  // of all
      const bool end_writes =
          stopped() || active.front().slot.on_end == CheckpointSlot::OnEnd::write;
      const auto ended = std::erase_if(active, [&](const ActiveReplicate& one) {
        const bool ends = one.run->done() || stopped() || point.dropped;
        if (ends) end(point, one);
        return ends;
      });
      if (!active.empty()) run_slice(point, active, cpu);
      if (states == nullptr) continue;
      if (ended > 0 && stopped())
        states->flush();
      else if (ended > 0 && end_writes)
        states->write_soon();
      else
        states->write_if_due();
    }
    if (stopped()) flush_states(point);
  }

  /// Of replicates that ended before the stop, without a write since then.
  void flush_states(const ActivePoint& point) const {
    if (!queue_.checkpoint_slot) return;
    if (Checkpoint* const states = queue_.checkpoint_slot(point.index).checkpoint) states->flush();
  }

  ActiveReplicate begin(const ActivePoint& point, std::size_t replicate) {
    const int r = static_cast<int>(replicate);
    ActiveReplicate one{.index = replicate, .slot = {}, .job = replicate, .run = nullptr};
    if (queue_.checkpoint_slot) one.slot = queue_.checkpoint_slot(point.index);
    one.job += one.slot.first_job;
    if (point.decided.run.engine == cases::EngineName::lammps)
      one.slot.checkpoint = nullptr;  // it has restart files of its own
    Checkpoint* const states = one.slot.checkpoint;
    // A kept state is restored even after a stop, so that the outcome includes it.
    const bool begun = states != nullptr && states->has_state(one.job);
    one.run = std::make_unique<ReplicateRun>(
        point.setup_of(replicate), r, options_.records ? options_.records(point.index, r) : nullptr,
        options_.frames ? options_.frames(point.index, r) : nullptr, queue_.threads_per_replicate,
        begun ? nullptr : options_.stop, launch(point, r));
    one.run->stop_on(options_.stop);
    if (options_.replays_of_all) one.run->record_replay();
    if (states != nullptr) states->restore(one.job, *one.run);
    progress_.add(weight(point) * one.run->energy_balance().time, 0,
                  0);  // simulated by an earlier process
    return one;
  }

  lammps::Launch launch(const ActivePoint& point, int replicate) const {
    lammps::Launch made = options_.lammps;
    if (made.ranks == 0) made.ranks = usual_ranks(point.decided, queue_.threads_per_replicate);
    if (!made.folder.empty())
      made.folder = lammps_folder(made.folder, point.index, queue_.size, replicate);
    return made;
  }

  double weight(const ActivePoint& point) const {
    return queue_.weight ? queue_.weight(point.index) : 1;
  }

  /// `cpu`: [s] CPU time of the thread up to which it has been attributed.
  void run_slice(const ActivePoint& point, const std::vector<ActiveReplicate>& active,
                 double& cpu) {
    std::vector<ReplicateRun*> runs;
    std::vector<scene::EnergyBalance> before;
    for (const ActiveReplicate& one : active) {
      runs.push_back(one.run.get());
      before.push_back(one.run->energy_balance());
    }
    ReplicateRun::run_slice_together(runs);
    std::vector<std::size_t> moved;  // the others were ahead
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k]->energy_balance().time != before[k].time || runs[k]->done()) moved.push_back(k);
    const double now_cpu = thread_cpu_seconds();
    const double share = (now_cpu - std::exchange(cpu, now_cpu)) /
                         static_cast<double>(std::max<std::size_t>(1, moved.size()));
    for (const std::size_t k : moved) {
      const ActiveReplicate& one = active[k];
      const scene::EnergyBalance& now = one.run->energy_balance();
      one.run->cpu_seconds() += share;
      progress_.add(weight(point) * (now.time - before[k].time),
                    static_cast<double>(now.collisions - before[k].collisions),
                    now.worst_collision);
      if (one.slot.checkpoint != nullptr && one.slot.checkpoint->due(one.job))
        one.slot.checkpoint->save(one.job, *one.run);
    }
  }

  /// Keeps the state of a replicate, if that is asked, and its result.
  void end(ActivePoint& point, const ActiveReplicate& one) const {
    constexpr double min_cpu_time = 0.05;  // [s] CPU time worth a write
    using OnEnd = CheckpointSlot::OnEnd;
    if (one.slot.checkpoint != nullptr && !point.dropped) {
      const bool worth_it =
          one.slot.on_end == OnEnd::write_when_due && one.run->cpu_seconds() > min_cpu_time;
      if (stopped() || one.slot.on_end == OnEnd::write || worth_it)
        one.slot.checkpoint->save(one.job, *one.run);
    }
    results::Replicate ended = one.run->result();
    ended.pack();
    point.take(one.index, std::move(ended));
  }

  const RunQueue& queue_;
  const RunOptions& options_;
  ProgressReporter progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<std::shared_ptr<ActivePoint>> open_;  // points with unfinished replicates
  std::size_t next_ = 0;                          // next point to open
  int opening_ = 0;                               // points being opened
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
};

}  // namespace

bool is_point_failure(const std::exception& why) {
  constexpr std::array<std::string_view, 5> of_all{"cannot-write", "result-exists", "store",
                                                   "bad-catalogue-file", "no-catalogue"};
  if (dynamic_cast<const std::system_error*>(&why) != nullptr ||
      dynamic_cast<const std::bad_alloc*>(&why) != nullptr)
    return false;
  const auto* input = dynamic_cast<const InputError*>(&why);
  return input == nullptr || std::ranges::none_of(input->faults(), [&](const Fault& fault) {
           return std::ranges::find(of_all, fault.code) != of_all.end();
         });
}

void run_queue(const RunQueue& queue, const RunOptions& options) {
  CampaignRunner(queue, options).work(std::max(1, options.threads));
}

}  // namespace mahlwerk::campaign
