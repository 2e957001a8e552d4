// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include "mahlwerk/base/start_threads.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/settled_state.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/settling.hpp"

namespace mahlwerk::campaign {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double record_bytes = 100;    // of a collision in collisions.h5, compressed: 87 to 98
constexpr double result_bytes = 1.5e6;  // tables, report and summary of a result

/// Computing over simulated time of a replicate of the soft engine with a bed.
double usual_cost(const cases::Case& decided) {
  return soft_work(decided) * ball_step_cost /
         (decided.run.settle_at_rest + cases::simulated_time(decided));
}

/// Sets a flag some time after its start, unless it is destroyed before: a slice of a run may take
/// longer than expected, where a flight that was skipped ends in a contact of small steps.
class Deadline {
 public:
  Deadline() = default;
  void start(std::chrono::milliseconds patience) {
    start_threads(timer_, 1, [this, patience](int) {
      std::unique_lock lock(mutex_);
      if (!ended_.wait_for(lock, patience, [this] { return done_; })) over_ = true;
    });
  }
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    ended_.notify_all();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  const std::atomic<bool>& over() const { return over_; }

 private:
  std::atomic<bool> over_ = false;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::vector<std::jthread> timer_;  // joins before the others are destroyed
};

/// A case that runs until it is stopped.
cases::Case endless(cases::Case made) {
  cases::settle_at_speed(made.run, 0);
  made.run.time = 1e3;
  made.run.until.reset();
  return made;
}

/// [bytes] of what a run writes while it proceeds: its frames and records. The space of its tables
/// is reserved when their folder is made.
double streamed(const cases::Case& mill_case, double collisions) {
  const cases::Observe& observe = mill_case.observe;
  const double time = cases::expected_time(mill_case);
  const double frames = observe.frames ? time / *observe.frames * cases::frame_bytes(mill_case) : 0;
  const double records = observe.collisions ? time * collisions * record_bytes : 0;
  return static_cast<double>(mill_case.run.replicates) * (frames + records);
}

}  // namespace

Forecast forecast(const cases::Case& decided, std::chrono::milliseconds patience) {
  constexpr double most_work = 3e7;  // about a second
  const std::int64_t cores = std::max(1U, std::thread::hardware_concurrency()),
                     replicates = decided.run.replicates;
  Forecast made{.share = (replicates + cores - 1) / cores};
  const auto settled = settled_state(decided, most_work);
  const cases::Case pilot = endless(settled ? settled->mill_case : decided);
  const auto most = static_cast<std::int64_t>(replicates_together(decided));
  const std::int64_t batches = (made.share + most - 1) / most,
                     together = (made.share + batches - 1) / batches;
  const int threads = static_cast<int>(std::max<std::int64_t>(1, cores / replicates));
  Deadline deadline;
  std::vector<std::unique_ptr<ReplicateRun>> runs;
  std::vector<ReplicateRun*> all;
  for (int r = 0; r < together; ++r) {
    runs.push_back(
        std::make_unique<ReplicateRun>(pilot, r, nullptr, nullptr, threads, &deadline.over()));
    all.push_back(runs.back().get());
  }
  const Clock::time_point began = Clock::now();
  deadline.start(2 * patience);
  while (std::ranges::none_of(all, &ReplicateRun::done) && Clock::now() - began < patience &&
         !deadline.over())
    ReplicateRun::run_slice_together(all);
  const double spent = std::chrono::duration<double>(Clock::now() - began).count();
  double simulated = 0, collisions = 0;
  for (const auto* run : all) {
    simulated += run->energy_balance().time;
    collisions += static_cast<double>(run->energy_balance().collisions);
  }
  if (!(simulated > 0)) return made;
  double of_second = spent / simulated;  // [1] computing over simulated time
  if (!settled && cases::in_time_steps(decided.run.engine))
    of_second = std::max(of_second, usual_cost(decided) / threads);
  made.settling =
      settled && cases::settles(decided) ? settled->settling : cases::least_settling(decided);
  made.each = of_second * (made.settling + cases::expected_time(decided));
  made.collisions = collisions / simulated;
  return made;
}

double disk_needed(const cases::Case& mill_case, double collisions) {
  return result_bytes + streamed(mill_case, collisions);
}

std::optional<double> disk_available(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code wrong;
  fs::path place = fs::absolute(folder, wrong);
  while (!fs::exists(place, wrong) && place.has_relative_path()) place = place.parent_path();
  const fs::space_info space = fs::space(place, wrong);
  return wrong ? std::nullopt : std::optional(static_cast<double>(space.available));
}

std::vector<Fault> disk_faults(const std::vector<cases::Case>& points, double collisions,
                               std::optional<double> available) {
  double needed = 0;
  const cases::Case* records = nullptr;
  for (const cases::Case& point : points) {
    needed += streamed(point, collisions);
    if (point.observe.collisions) records = &point;
  }
  const bool recorded = records != nullptr;
  const bool full = available && needed > *available;
  if (!full && !(recorded && needed > largest_records)) return {};
  const cases::Case& shown = recorded ? *records : points.front();
  const double fits = std::min(available.value_or(needed), recorded ? largest_records : needed);
  const std::string key = recorded ? "observe.collisions" : "observe.frames";
  std::string what =
      fmt::format("the {} need about {}", recorded ? "records of collisions" : "frames",
                  bytes_in_words(needed));
  if (recorded)
    what += fmt::format(" (about {:.2g} collisions a second in each replicate)", collisions);
  what += full ? fmt::format(", but {} are free on the disk", bytes_in_words(*available))
               : fmt::format(", more than {}", bytes_in_words(largest_records));
  return {{cases::location_of(shown, key), std::move(what),
           fmt::format("shorten run.time to {} or less, take fewer run.replicates, or {}",
                       show_rounded(0.9 * shown.run.time * fits / needed, "s", 2),
                       recorded ? "write collisions = false: all tables and spectra are written "
                                  "without the records, too"
                                : "choose a folder on another disk with --out"),
           "not-enough-disk"}};
}

void check_disk(const std::vector<cases::Case>& points, const std::filesystem::path& folder) {
  if (points.empty()) return;
  double collisions = 0;
  if (points.front().observe.collisions) {
    constexpr std::chrono::milliseconds patience{100};
    const cases::Case& first = points.front();
    collisions = forecast(decided_case(first, choose_engine(first)), patience).collisions;
  }
  std::vector<Fault> wrong = disk_faults(points, collisions, disk_available(folder));
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

}  // namespace mahlwerk::campaign
