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

// Runs of the settings that a search requests (docs/theory/optimum.md).
namespace mahlwerk::campaign {

/// A case whose keys vary within ranges.
class TrialRuns {
 public:
  /// Takes the ranges of [optimise], [match] or [fit], which the case must have; `set` is applied
  /// to the case first. Keys of [fit] that `set` gives, or that a powder model reads, are left out.
  /// Throws InputError if the case cannot be read, or an end of a range is invalid whatever the
  /// other keys are.
  TrialRuns(const std::filesystem::path& file, const cases::Catalogue& catalogue,
            std::vector<cases::Override> set, cases::ValueSource source);

  const cases::Case& base() const { return base_; }
  const std::vector<cases::SweptKey>& ranges() const { return ranges_; }

  /// Values of the keys at a point, as a case has them, to six digits: "412.5 rpm".
  std::vector<std::string> values(const DesignPoint& point) const;
  /// The point of those values; it differs from `point` where values are whole numbers or rounded.
  DesignPoint snap(const DesignPoint& point) const;
  /// The case at a point, with `count` replicates. Its seed depends on `first`, so that further
  /// replicates differ from earlier ones. Throws InputError if the setting is invalid.
  cases::Case at(const DesignPoint& point, int first, int count) const;

  /// The same case with another engine.
  TrialRuns with_engine(cases::EngineName engine) const;

  /// The outcomes of a replicate that a search uses.
  using Measure =
      std::function<std::vector<double>(const results::Outcome&, const results::Replicate&)>;
  /// Runs all requests. A setting fails if it cannot be built, or if physics stops it. Results that
  /// `store` has of the same `version` are not computed again. Throws Interrupted if options.stop
  /// is set.
  std::vector<TrialResult> run(const std::vector<TrialRequest>& asked, const Measure& measure,
                               const RunOptions& options, TrialStore& store,
                               std::string_view version) const;
  /// The same for several cases: the results by case, then by request.
  static std::vector<std::vector<TrialResult>> run_each(const std::vector<TrialRuns>& cases,
                                                        const std::vector<TrialRequest>& asked,
                                                        const Measure& measure,
                                                        const RunOptions& options,
                                                        TrialStore& store,
                                                        std::string_view version);

 private:
  void take_ranges_of_fit(const std::filesystem::path& file);
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
