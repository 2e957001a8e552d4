// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {
namespace {

/// The lock, or the reason why there is none.
std::unique_ptr<results::FileLock> taken(const std::filesystem::path& file,
                                         results::FileLock::Holds holds) try {
  return std::make_unique<results::FileLock>(file, holds);
} catch (const std::system_error& e) {
  throw InputError(Fault{
      file.generic_string(), "the campaign's folder cannot be written to: " + e.code().message(),
      "check that you may write there, or give another folder with --out", "store"});
}

}  // namespace

CampaignLock::CampaignLock(const std::filesystem::path& file, Holds holds)
    : lock_(taken(file, holds)) {
  using State = results::FileLock::State;
  if (lock_->state() == State::no_locks)
    throw InputError(
        Fault{file.generic_string(),
              "the file cannot be locked: " + std::generic_category().message(lock_->error()),
              "use a file system that knows locks", "store"});
  if (lock_->state() == State::another_has_it)
    throw InputError(Fault{
        file.parent_path().generic_string(), "another process is at work on this campaign",
        "wait until it ends; `mahlwerk sweep status` tells how far it is", "campaign-at-work"});
}

bool CampaignLock::held(const std::filesystem::path& file) {
  return results::FileLock::held(file);
}

}  // namespace mahlwerk::campaign
