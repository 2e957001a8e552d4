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
constexpr std::string_view magic = "mahlwerk checkpoint 6\n";

InputError refusal(const std::filesystem::path& file, std::string what, std::string remedy) {
  return InputError(
      Fault{file.generic_string(), std::move(what), std::move(remedy), "bad-checkpoint"});
}

InputError damaged(const std::filesystem::path& file) {
  return refusal(file, "the checkpoint is damaged", "start the run anew, without --resume");
}

Fault no_checkpoint(const std::filesystem::path& file, const std::string& why) {
  return {file.generic_string(), "the checkpoint " + why,
          "make room or mend the permissions; the run goes on without it, and its results are "
          "written",
          "bad-checkpoint"};
}

/// Takes the fingerprint of all else off the end of a file; whether it is right. A state with a bit
/// turned would run on, wrongly.
bool whole(std::string& bytes) {
  std::uint64_t kept = 0;
  if (bytes.size() < sizeof kept) return false;
  std::memcpy(&kept, bytes.data() + bytes.size() - sizeof kept, sizeof kept);
  bytes.resize(bytes.size() - sizeof kept);
  return kept == fingerprint(bytes);
}

void carry(Archive& archive, std::string& title, std::string& what,
           std::vector<std::string>& states) {
  archive(title)(what);
  auto count = static_cast<std::uint64_t>(states.size());
  archive(count);
  if (archive.reading()) states.resize(std::min<std::uint64_t>(count, archive.bytes().size()));
  for (std::string& state : states) archive(state);
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every,
                       Trouble trouble)
    : file_(std::move(file)),
      what_(std::move(what)),
      every_(every),
      states_(jobs),
      kept_(jobs, std::chrono::steady_clock::now()),
      told_(std::move(trouble)) {
  std::error_code none;
  std::filesystem::remove(aside(), none);
}

void Checkpoint::load() {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream)
    throw refusal(file_, "there is no checkpoint to go on from",
                  "start the run with --checkpoint; leave out --resume to start anew");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}}, title, what;
  const auto begins = [&](std::string_view with) {
    return bytes.find(with) == sizeof(std::uint64_t);  // after its length
  };
  const bool ours = begins(magic);
  if (!begins(any_magic) || (ours && !whole(bytes))) throw damaged(file_);
  if (ours) try {
      Archive archive(std::move(bytes));
      carry(archive, title, what, states_);
      archive.finish();
    } catch (const RunError&) {
      throw damaged(file_);
    }
  if (!ours || what != what_ || states_.size() != kept_.size())
    throw refusal(file_, "the checkpoint is of another run: case, settings or version differ",
                  "resume with the case and settings it was started with, or start anew");
  loaded_ = true;
}

bool Checkpoint::holds(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return !states_[job].empty();
}

void Checkpoint::restore(std::size_t job, Replica& replica) {
  const std::lock_guard lock(mutex_);
  if (states_[job].empty()) return;
  try {
    Archive archive(states_[job]);
    replica.carry(archive);
    archive.finish();
  } catch (const RunError&) {
    throw damaged(file_);
  }
}

bool Checkpoint::due(std::size_t job) const {
  const std::lock_guard lock(mutex_);
  return std::chrono::steady_clock::now() - kept_[job] > every_;
}

void Checkpoint::keep(std::size_t job, Replica& replica, bool now) {
  Archive archive;
  replica.carry(archive);
  const std::lock_guard lock(mutex_);
  states_[job] = archive.bytes();
  kept_[job] = std::chrono::steady_clock::now();
  waits_ = true;
  if (now || kept_[job] - filed_ > every_) write();
}

void Checkpoint::flush() {
  const std::lock_guard lock(mutex_);
  if (waits_) write();
}

/// All that is kept, into the file.
void Checkpoint::write() {
  Archive archive;
  std::string title(magic);
  carry(archive, title, what_, states_);
  std::uint64_t seal = fingerprint(archive.bytes());
  archive(seal);
  filed_ = std::chrono::steady_clock::now();
  waits_ = false;
  const bool fresh = !failed_;
  failed_.reset();
  try {
    results::write_text(aside(), archive.bytes());
    std::filesystem::rename(aside(), file_);
  } catch (const InputError& e) {
    failed_ = no_checkpoint(file_, e.faults().front().what);
  } catch (const std::filesystem::filesystem_error& e) {
    failed_ = no_checkpoint(file_, "cannot be written: " + e.code().message());
  }
  if (!failed_) return;
  std::error_code none;
  std::filesystem::remove(aside(), none);
  if (fresh && told_) told_(*failed_);
}

std::optional<Fault> Checkpoint::trouble() const {
  const std::lock_guard lock(mutex_);
  return failed_;
}

void Checkpoint::remove() {
  std::error_code gone;
  std::filesystem::remove(file_, gone);
}

}  // namespace mahlwerk::campaign
