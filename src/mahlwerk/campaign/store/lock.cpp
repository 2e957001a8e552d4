// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {

CampaignLock::CampaignLock(const std::filesystem::path& file, Holds holds) {
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw InputError(Fault{
        file.generic_string(),
        "the campaign's folder cannot be written to: " + std::generic_category().message(errno),
        "check that you may write there, or give another folder with --out", "store"});
  if (::flock(descriptor_, (holds == Holds::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0) return;
  const int why = errno;
  ::close(descriptor_);
  if (why != EWOULDBLOCK)
    throw InputError(Fault{file.generic_string(),
                           "the file cannot be locked: " + std::generic_category().message(why),
                           "use a file system that knows locks", "store"});
  throw InputError(
      Fault{file.parent_path().generic_string(), "another process is at work on this campaign",
            "wait until it ends; `mahlwerk sweep status` tells how far it is", "campaign-at-work"});
}

CampaignLock::~CampaignLock() {
  ::close(descriptor_);  // the file stays: taking it away would let two in
}

bool CampaignLock::held(const std::filesystem::path& file) {
  int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);  // as locks over a network want it
  if (descriptor < 0) descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

}  // namespace mahlwerk::campaign
