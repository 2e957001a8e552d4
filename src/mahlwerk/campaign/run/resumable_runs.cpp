// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/resumable_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/campaign/run/queue.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;

/// Text of all inputs that determine a point's outcome.
std::string run_identity(const cases::Case& point, std::string_view version) {
  return fmt::format("version {}\n{}{}", version, cases::write(point),
                     cases::input_files_fingerprint(point));
}

/// The states of a point's replicates, read from `file` if it exists; null if the point records
/// collisions or frames. Replicates that take less than settings.interval are run again after a
/// process was killed.
std::unique_ptr<Checkpoint> checkpoint_of(const cases::Case& point, const std::string& what,
                                          const fs::path& file,
                                          const ResumableRuns::CheckpointSettings& settings) {
  if (point.observe.collisions || point.observe.frames) return nullptr;
  const auto fresh = [&] {
    return std::make_unique<Checkpoint>(file, what, static_cast<std::size_t>(point.run.replicates),
                                        settings.interval, settings.on_write_error);
  };
  auto states = fresh();
  if (fs::exists(file)) try {
      states->load();
    } catch (const InputError&) {
      return fresh();  // damaged: the run starts from the beginning
    }
  return states;
}

}  // namespace

ResumableRuns::ResumableRuns(const fs::path& results) : folder_(results.string() + ".checkpoints") {
  results::make_folder(folder_);
  const fs::path lock = folder_ / "lock";
  if (CampaignLock::held(lock))
    throw InputError(Fault{results.string(), "another process is at work on it",
                           "wait until it ends, or give another folder with --out",
                           "campaign-at-work"});
  lock_.emplace(lock);
}

std::vector<results::Outcome> ResumableRuns::compute(const std::vector<cases::Case>& points,
                                                     const Streams& streams, RunOptions options,
                                                     const CheckpointSettings& settings) {
  options.threads = thread_count(options.threads);
  streams.attach(options);
  std::vector<std::unique_ptr<Checkpoint>> states;
  std::vector<results::Outcome> outcomes(points.size());
  RunQueue queue;
  std::size_t begun = 0, jobs = 0;
  for (const cases::Case& point : points) {
    const std::string what = run_identity(point, settings.version);
    files_.push_back(folder_ / (hash_text(fingerprint(what)) + ".checkpoint"));
    states.push_back(checkpoint_of(point, what, files_.back(), settings));
    begun += states.back() != nullptr && states.back()->loaded() ? 1 : 0;
    queue.total += cases::simulated_time(point) * static_cast<double>(point.run.replicates);
    jobs += static_cast<std::size_t>(point.run.replicates);
  }
  const bool alone = points.size() == 1;
  if (begun > 0 && settings.on_resume) settings.on_resume(begun);
  queue.size = points.size();
  queue.threads_per_replicate =
      std::max(1, options.threads / std::max(1, static_cast<int>(jobs)));  // uses spare threads
  queue.open = [&](std::size_t i) { return points[i]; };
  queue.done = [&](std::size_t i, results::Outcome&& ended) {
    if (states[i]) states[i]->flush();
    states[i].reset();  // its file stays until all is done
    outcomes[i] = std::move(ended);
  };
  queue.checkpoint_slot = [&](std::size_t i) {
    using OnEnd = CheckpointSlot::OnEnd;
    return CheckpointSlot{.checkpoint = states[i].get(),
                          .on_end = alone ? OnEnd::write : OnEnd::write_when_due};
  };
  run_queue(queue, options);
  return outcomes;
}

void ResumableRuns::remove() {
  std::error_code none;
  for (const fs::path& file : files_) fs::remove(file, none);
  bool others = false;
  for (const auto& entry : fs::directory_iterator(folder_, none))
    others = others || entry.path().filename() != "lock";
  if (!others) fs::remove_all(folder_, none);
}

}  // namespace mahlwerk::campaign
