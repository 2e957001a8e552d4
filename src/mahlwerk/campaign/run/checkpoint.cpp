// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/checkpoint.hpp"

#include <algorithm>
#include <utility>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {
namespace {

Fault no_checkpoint(const std::filesystem::path& file, const std::string& why) {
  return {file.generic_string(), "the checkpoint " + why,
          "free disk space or correct the permissions; the run continues without a checkpoint, "
          "and its results are written",
          "bad-checkpoint"};
}

/// A write after the last one took so many times its duration costs a few percent of the run.
constexpr double rest = 20;

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every,
                       WriteErrorCallback on_write_error, std::optional<Unasked> unasked)
    : states_(std::move(file), std::move(what), jobs),
      interval_(every),
      unasked_(unasked),
      saved_at_(jobs, Clock::now()),
      on_write_error_(std::move(on_write_error)) {}

void Checkpoint::load() {
  states_.load();
  loaded_ = true;
}

bool Checkpoint::has_state(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return states_.has(job);
}

void Checkpoint::restore(std::size_t job, ReplicateRun& replica) {
  const std::lock_guard lock(mutex_);
  if (!states_.has(job)) return;
  try {
    Archive archive(states_.state(job));
    replica.serialize(archive);
    archive.finish();
  } catch (const RunError& e) {
    const std::string why = e.what();
    if (why == Archive::broken().what()) throw StateFile::damaged(file());
    throw InputError(Fault{file().generic_string(), "the state cannot be set: " + why,
                           "resume on the device that the run began on, or start it again, without "
                           "--resume",
                           "bad-checkpoint"});
  }
}

bool Checkpoint::due(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return Clock::now() - saved_at_[job] > interval_;
}

void Checkpoint::save(std::size_t job, ReplicateRun& replica) {
  Archive archive;
  replica.serialize(archive);
  const std::lock_guard lock(mutex_);
  saved_at_[job] = Clock::now();
  if (given_up_) return;
  states_.set(job, archive.bytes());
  unwritten_ = true;
  if (!unasked_ || states_.bytes() <= unasked_->most) return;
  given_up_ = true;  // an earlier file stays valid
  unwritten_ = false;
  states_.clear();
}

/// Whether the states that are only in memory take too much of it. An eighth of the file at least,
/// because each write copies the file; not while writes fail.
bool Checkpoint::crowded() const {
  return !write_error_ && states_.in_memory() > std::max(most_in_memory, states_.in_file() / 8);
}

bool Checkpoint::begun() const {
  return !unasked_ || loaded_ || crowded() ||
         Clock::now() - made_at_ >= std::chrono::duration<double>(unasked_->after);
}

void Checkpoint::write_if_due() {
  const std::lock_guard lock(mutex_);
  if (unwritten_ && begun() && (crowded() || Clock::now() - written_at_ > interval_)) write();
}

void Checkpoint::write_soon() {
  const std::lock_guard lock(mutex_);
  if (unwritten_ && begun() && (crowded() || Clock::now() - written_at_ >= rest * write_took_))
    write();
}

void Checkpoint::flush() {
  const std::lock_guard lock(mutex_);
  if (unwritten_ && begun()) write();
}

bool Checkpoint::written() const {
  const std::lock_guard lock(mutex_);
  return (written_ || loaded_) && !write_error_;
}

void Checkpoint::write() {
  const Clock::time_point began = Clock::now();
  unwritten_ = false;
  const bool fresh = !write_error_;
  write_error_.reset();
  try {
    states_.write();
    written_ = true;
  } catch (const InputError& e) {
    write_error_ = no_checkpoint(file(), e.faults().front().what);
  } catch (const std::filesystem::filesystem_error& e) {
    write_error_ = no_checkpoint(file(), "cannot be written: " + e.code().message());
  }
  written_at_ = Clock::now();
  write_took_ = written_at_ - began;
  if (!write_error_) return;
  std::error_code none;
  std::filesystem::remove(states_.temporary_file(), none);
  if (fresh && on_write_error_) on_write_error_(*write_error_);
}

std::optional<Fault> Checkpoint::write_error() const {
  const std::lock_guard lock(mutex_);
  return write_error_;
}

void Checkpoint::remove() {
  std::error_code gone;
  std::filesystem::remove(file(), gone);
}

}  // namespace mahlwerk::campaign
