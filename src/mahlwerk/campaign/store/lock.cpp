// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {
namespace {

/// The lock. Throws InputError if its file cannot be opened.
std::unique_ptr<results::FileLock> taken(const std::filesystem::path& file,
                                         results::FileLock::Mode mode) try {
  return std::make_unique<results::FileLock>(file, mode);
} catch (const std::system_error& e) {
  throw InputError(Fault{
      file.generic_string(), "the campaign's folder cannot be written to: " + e.code().message(),
      "check that you may write there, or give another folder with --out", "store"});
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& file, Mode mode)
    : lock_(taken(file, mode)) {
  using State = results::FileLock::State;
  if (lock_->state() == State::unsupported)
    throw InputError(
        Fault{file.generic_string(),
              "the file cannot be locked: " + std::generic_category().message(lock_->error()),
              "use a file system that supports locks", "store"});
  if (lock_->state() == State::held_elsewhere)
    throw InputError(Fault{
        file.parent_path().generic_string(), "another process is at work on this campaign",
        "wait until it ends; `mahlwerk sweep status` shows its progress", "campaign-at-work"});
}

bool CampaignLock::held(const std::filesystem::path& file) {
  return results::FileLock::held(file);
}

}  // namespace mahlwerk::campaign
