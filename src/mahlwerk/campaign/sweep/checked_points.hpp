// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::campaign {

/// The points of a case, read without running them, and their faults: each fault once, with the
/// first point that has it. A case without [sweep] is a campaign of one point.
class CheckedPoints {
 public:
  static constexpr std::size_t most = 1000;  ///< points that are read at most

  CheckedPoints(const cases::Case& mill_case, const std::filesystem::path& file,
                const cases::Catalogue& known, const std::vector<cases::Override>& set);

  const std::vector<cases::Case>& good() const { return good_; }  ///< points that can be run
  const std::vector<Fault>& faults() const { return faults_; }
  std::size_t size() const { return size_; }  ///< points of the whole campaign
  std::size_t bad() const { return bad_; }    ///< points with faults, of those read

 private:
  void add_faults(std::vector<Fault> more, const std::string& point);

  std::size_t size_ = 1, bad_ = 0;
  std::vector<cases::Case> good_;
  std::vector<Fault> faults_;
  std::set<std::pair<std::string, std::string>> known_;  // where and what
};

}  // namespace mahlwerk::campaign
