// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/checkpoint.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::string_view any_magic = "mahlwerk checkpoint ";
constexpr std::string_view magic = "mahlwerk checkpoint 12\n";

InputError refusal(const std::filesystem::path& file, std::string what, std::string remedy) {
  return InputError(
      Fault{file.generic_string(), std::move(what), std::move(remedy), "bad-checkpoint"});
}

InputError damaged(const std::filesystem::path& file) {
  return refusal(file, "the checkpoint is damaged", "start the run again, without --resume");
}

Fault no_checkpoint(const std::filesystem::path& file, const std::string& why) {
  return {file.generic_string(), "the checkpoint " + why,
          "free disk space or correct the permissions; the run continues without a checkpoint, "
          "and its results are written",
          "bad-checkpoint"};
}

/// Removes the fingerprint from the end of a file's content; true if it matches. Without this check
/// a run would continue with wrong results from a corrupted state.
bool take_fingerprint(std::string& bytes) {
  std::uint64_t kept = 0;
  if (bytes.size() < sizeof kept) return false;
  std::memcpy(&kept, bytes.data() + bytes.size() - sizeof kept, sizeof kept);
  bytes.resize(bytes.size() - sizeof kept);
  return kept == fingerprint(bytes);
}

void serialize(Archive& archive, std::string& title, std::string& what,
               std::vector<std::string>& states) {
  archive(title)(what);
  auto count = static_cast<std::uint64_t>(states.size());
  archive(count);
  if (archive.reading()) states.resize(std::min<std::uint64_t>(count, archive.bytes().size()));
  for (std::string& state : states) archive(state);
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every,
                       WriteErrorCallback on_write_error, std::optional<Unasked> unasked)
    : file_(std::move(file)),
      run_id_(std::move(what)),
      interval_(every),
      unasked_(unasked),
      states_(jobs),
      saved_at_(jobs, std::chrono::steady_clock::now()),
      on_write_error_(std::move(on_write_error)) {
  std::error_code none;
  std::filesystem::remove(temporary_file(), none);
}

void Checkpoint::load() {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream)
    throw refusal(
        file_, "there is no checkpoint to resume from",
        "leave out --resume to start from the beginning; a run of more than a minute keeps a "
        "checkpoint when it is interrupted, a shorter one with --checkpoint");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}}, title, what;
  const auto begins = [&](std::string_view with) {
    return bytes.find(with) == sizeof(std::uint64_t);  // after the length of the string
  };
  const bool ours = begins(magic);
  if (!begins(any_magic) || (ours && !take_fingerprint(bytes))) throw damaged(file_);
  if (ours) try {
      Archive archive(std::move(bytes));
      serialize(archive, title, what, states_);
      archive.finish();
    } catch (const RunError&) {
      throw damaged(file_);
    }
  if (!ours || what != run_id_ || states_.size() != saved_at_.size())
    throw refusal(file_, "the checkpoint belongs to another run: case, settings or version differ",
                  "resume with the original case and settings, or leave out --resume");
  loaded_ = true;
}

bool Checkpoint::has_state(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return !states_[job].empty();
}

void Checkpoint::restore(std::size_t job, ReplicateRun& replica) {
  const std::lock_guard lock(mutex_);
  if (states_[job].empty()) return;
  try {
    Archive archive(states_[job]);
    replica.serialize(archive);
    archive.finish();
  } catch (const RunError&) {
    throw damaged(file_);
  }
}

bool Checkpoint::due(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return std::chrono::steady_clock::now() - saved_at_[job] > interval_;
}

void Checkpoint::save(std::size_t job, ReplicateRun& replica) {
  Archive archive;
  replica.serialize(archive);
  const std::lock_guard lock(mutex_);
  saved_at_[job] = std::chrono::steady_clock::now();
  if (given_up_) return;
  bytes_ += archive.bytes().size() - states_[job].size();
  states_[job] = archive.bytes();
  unwritten_ = true;
  if (!unasked_ || bytes_ <= unasked_->most) return;
  given_up_ = true;  // an earlier file stays valid
  unwritten_ = false;
  states_.assign(states_.size(), {});
}

bool Checkpoint::begun() const {
  return !unasked_ || loaded_ ||
         std::chrono::steady_clock::now() - made_at_ >=
             std::chrono::duration<double>(unasked_->after);
}

void Checkpoint::write_if_due() {
  const std::lock_guard lock(mutex_);
  if (unwritten_ && begun() && std::chrono::steady_clock::now() - written_at_ > interval_) write();
}

void Checkpoint::flush() {
  const std::lock_guard lock(mutex_);
  if (unwritten_ && begun()) write();
}

bool Checkpoint::written() const {
  const std::lock_guard lock(mutex_);
  return (written_ || loaded_) && !write_error_;
}

/// Writes all kept states to a temporary file, then renames it.
void Checkpoint::write() {
  Archive archive;
  std::string title(magic);
  serialize(archive, title, run_id_, states_);
  std::uint64_t seal = fingerprint(archive.bytes());
  archive(seal);
  written_at_ = std::chrono::steady_clock::now();
  unwritten_ = false;
  const bool fresh = !write_error_;
  write_error_.reset();
  try {
    results::write_text(temporary_file(), archive.bytes());
    std::filesystem::rename(temporary_file(), file_);
    written_ = true;
  } catch (const InputError& e) {
    write_error_ = no_checkpoint(file_, e.faults().front().what);
  } catch (const std::filesystem::filesystem_error& e) {
    write_error_ = no_checkpoint(file_, "cannot be written: " + e.code().message());
  }
  if (!write_error_) return;
  std::error_code none;
  std::filesystem::remove(temporary_file(), none);
  if (fresh && on_write_error_) on_write_error_(*write_error_);
}

std::optional<Fault> Checkpoint::write_error() const {
  const std::lock_guard lock(mutex_);
  return write_error_;
}

void Checkpoint::remove() {
  std::error_code gone;
  std::filesystem::remove(file_, gone);
}

}  // namespace mahlwerk::campaign
