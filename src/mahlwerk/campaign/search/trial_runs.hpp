// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/campaign/search/trial_store.hpp"
#include "mahlwerk/cases/read.hpp"

// Settings of a case that a search asks for, run (docs/theory/optimum.md).
namespace mahlwerk::campaign {

/// A case whose keys are changed within ranges.
class TrialRuns {
 public:
  /// Over the ranges of [optimise] or [match], which the case must have; `set` is applied to it
  /// before. Throws InputError where the case cannot be read, or an end of a range cannot be one,
  /// whatever the other keys are.
  TrialRuns(const std::filesystem::path& file, const cases::Catalogue& catalogue,
            std::vector<cases::Override> set, cases::ValueSource source);

  const cases::Case& base() const { return base_; }
  const std::vector<cases::SweptKey>& ranges() const { return ranges_; }

  /// What the keys are set to, as the case says it, to six digits: "412.5 rpm".
  std::vector<std::string> values(const DesignPoint& point) const;
  /// The point of those values: of whole numbers and rounded ones not quite what was asked for.
  DesignPoint snap(const DesignPoint& point) const;
  /// The case there. Replicates from `first` on begin from another seed than those before. Throws
  /// InputError where the setting cannot be read.
  cases::Case at(const DesignPoint& point, int first, int count) const;

  /// The same case by another engine.
  TrialRuns with_engine(cases::EngineName engine) const;

  /// What a search is told of a replicate.
  using Measure =
      std::function<std::vector<double>(const results::Outcome&, const results::Replicate&)>;
  /// A setting that cannot be built, or that physics stops, has failed. What `store` has been told
  /// by the same `version` is not run again. Throws Interrupted where options.stop was set.
  std::vector<TrialResult> run(const std::vector<TrialRequest>& asked, const Measure& measure,
                               const RunOptions& options, TrialStore& store,
                               std::string_view version) const;

 private:
  std::string place_of(const cases::SweptKey& range) const;
  void check(const cases::SweptKey& range, std::vector<Fault>& wrong) const;
  void check_end(const cases::SweptKey& range, std::size_t end, std::vector<Fault>& wrong) const;

  cases::CaseFile file_;
  const cases::Catalogue& catalogue_;
  std::vector<cases::Override> set_;
  cases::ValueSource source_;
  cases::Case base_;
  std::vector<cases::SweptKey> ranges_;
};

}  // namespace mahlwerk::campaign
