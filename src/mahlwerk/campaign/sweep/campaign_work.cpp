// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Execution of a campaign's runs: from the queue into folders and the store.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/queue.hpp"
#include "mahlwerk/campaign/run/streams.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

/// Why physics stopped a run; empty if it did not.
std::string failure_of(const results::Outcome& outcome) {
  for (const results::Replicate& r : outcome.replicates)
    if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

}  // namespace

/// Folders, streams and checkpoints of active runs.
class CampaignFolder::ActiveRuns {
 public:
  ActiveRuns(CampaignFolder& owner, std::vector<std::size_t> todo)
      : owner_(owner), todo_(std::move(todo)) {
    for (const std::size_t point : todo_) total_ += owner_.runs_[point].work;
  }

  WorkSummary work(WorkSummary worked) {
    summary_ = worked;
    const auto begin = std::chrono::steady_clock::now();
    RunOptions options;
    options.threads = thread_count(owner_.settings_.threads);
    options.stop = owner_.settings_.stop;
    options.replays_of_all = owner_.settings_.films;
    options.progress = [&](const Progress& p) { show(p); };
    options.records = [&](std::size_t i, int r) {
      const ActiveRun& mine = active(i);
      return mine.folder ? mine.streams.records(0, r) : nullptr;
    };
    options.frames = [&](std::size_t i, int r) {
      const ActiveRun& mine = active(i);
      return mine.folder ? mine.streams.frames(0, r) : nullptr;
    };
    RunQueue queue;
    queue.size = todo_.size();
    queue.open = [&](std::size_t i) { return open(i); };
    queue.done = [&](std::size_t i, results::Outcome&& outcome) { done(i, outcome); };
    queue.failed = [&](std::size_t i, const std::exception& why) { failed(i, why); };
    queue.checkpoint_slot = [&](std::size_t i) {
      ActiveRun& mine = active(i);
      using OnEnd = CheckpointSlot::OnEnd;
      return CheckpointSlot{.checkpoint = &*mine.checkpoint,
                            .on_end = mine.replicates > 1 ? OnEnd::write_when_due : OnEnd::discard};
    };
    queue.total = total_;
    queue.weight = [&](std::size_t i) {
      const Run& run = owner_.runs_[todo_[i]];
      return run.work / run.seconds;
    };
    run_queue(queue, options);
    summary_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    summary_.interrupted = owner_.stopped();
    return summary_;
  }

 private:
  struct ActiveRun {
    explicit ActiveRun(std::string_view version) : streams(version) {}
    std::string name;  // of its folder, below the campaign's
    std::string began = now();
    std::int64_t replicates = 1;
    std::unique_ptr<results::Folder> folder;  // or null
    Streams streams;
    std::optional<Checkpoint> checkpoint;
  };

  ActiveRun& active(std::size_t i) {
    const std::lock_guard lock(mutex_);
    return *active_.at(i);
  }
  void clear(std::size_t i) {
    const std::lock_guard lock(mutex_);
    active_.erase(i);
  }

  cases::Case open(std::size_t i) {
    const std::size_t point = todo_[i];
    cases::Case mill_case = owner_.file_.read(owner_.settings_.catalogue, owner_.settings(point));
    mill_case.sweep = {};
    auto made = std::make_unique<ActiveRun>(owner_.settings_.version);
    made->replicates = mill_case.run.replicates;
    const std::string hash = hash_text(owner_.runs_[point].hash);
    made->name = fmt::format("{}/{:0{}}-{}", results::campaign_runs, point + 1,
                             std::to_string(owner_.size()).size(), hash.substr(0, 8));
    const fs::path place = owner_.path_ / made->name;
    const bool streams = mill_case.observe.frames || mill_case.observe.collisions;
    results::make_folder(place.parent_path());
    if (owner_.keeps_folders() || streams)
      made->folder = std::make_unique<results::Folder>(place, true);
    if (made->folder) made->streams.add(mill_case, *made->folder, "");
    const fs::path kept = place.string() + ".checkpoint";
    const auto no_state = [&] {
      made->checkpoint.emplace(kept, hash, static_cast<std::size_t>(mill_case.run.replicates),
                               owner_.settings_.checkpoint_every, owner_.settings_.on_write_error);
    };
    no_state();
    if (!streams && fs::exists(kept)) try {
        made->checkpoint->load();
      } catch (const InputError&) {
        no_state();  // of another version, or damaged: the run starts from the beginning
      }
    const std::lock_guard lock(mutex_);
    active_[i] = std::move(made);
    return mill_case;
  }

  void done(std::size_t i, const results::Outcome& outcome) {
    ActiveRun& mine = active(i);
    mine.streams.close();
    if (!outcome.interrupted) {
      if (mine.folder) {
        owner_.settings_.write(*mine.folder, outcome);
        mine.folder->commit();
      }
      RunRecord finished;
      finished.hash = owner_.runs_[todo_[i]].hash;
      finished.resolved = cases::write(outcome.mill_case);
      finished.engine = name_of(outcome.engine);
      finished.regime = outcome.summary.regime;
      finished.folder = mine.folder ? mine.name : "";
      finished.began = mine.began;
      finished.wall_seconds = outcome.wall_seconds;
      finished.cpu_seconds = outcome.cpu_seconds;
      finished.failure = failure_of(outcome);
      finished.quantities = outcome.summary.quantities;
      finished.notices = outcome.notices;
      owner_.store_->keep(finished);
      mine.checkpoint->remove();
      const std::lock_guard lock(mutex_);
      ++(finished.failure.empty() ? summary_.done : summary_.failed);
    }
    clear(i);
  }

  void failed(std::size_t i, const std::exception& why) {
    owner_.store_->fail(owner_.runs_[todo_[i]].hash, why.what());
    clear(i);
    const std::lock_guard lock(mutex_);
    ++summary_.failed;
  }

  void show(const Progress& p) {
    using Seconds = std::chrono::duration<double>;
    const double gone = Seconds(std::chrono::steady_clock::now() - began_).count();
    const double share = p.total > 0 ? std::min(1.0, p.simulated / p.total) : 0;
    const std::lock_guard lock(mutex_);
    if (owner_.settings_.progress)
      owner_.settings_.progress({.share = share,
                                 .seconds = gone,
                                 .done = summary_.done,
                                 .failed = summary_.failed,
                                 .of = todo_.size()});
  }

  CampaignFolder& owner_;
  std::vector<std::size_t> todo_;
  double total_ = 0;  // [s] of work, estimated
  std::mutex mutex_;
  std::map<std::size_t, std::unique_ptr<ActiveRun>> active_;  // by index in todo_
  WorkSummary summary_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

WorkSummary CampaignFolder::work() {
  WorkSummary worked;
  std::vector<std::size_t> todo = waiting_runs(worked);
  return ActiveRuns(*this, std::move(todo)).work(worked);
}

}  // namespace mahlwerk::campaign
