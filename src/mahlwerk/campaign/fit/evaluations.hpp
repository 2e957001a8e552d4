// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {

/// Predictions of a fit so far, in a file from which an interrupted fit resumes. The search for the
/// best parameters is the same for the same predictions, so a resumed fit has the result of an
/// uninterrupted one. The file is written under another name, then renamed.
class FitEvaluations {
 public:
  /// The replicates whose prediction is evaluated: all together, or one of them.
  using Replicates = std::optional<std::size_t>;
  /// A set of parameter values, and its sum of squares.
  struct Best {
    std::vector<double> values;
    double sum = 0;
  };

  /// Reads the predictions in `file`, if they are of the fit that `what` identifies: cases,
  /// measurements, version. The file is written every `every` [s]. If it cannot be written,
  /// `on_write_error` is called, and the fit goes on.
  FitEvaluations(std::filesystem::path file, std::string what, double every,
                 std::function<void(const Fault&)> on_write_error);

  std::size_t count() const { return known_.size(); }  ///< of predictions
  /// A known prediction; null if there is none.
  const std::vector<double>* find(Replicates of, const std::vector<double>& values) const;
  void keep(Replicates of, const std::vector<double>& values, const std::vector<double>& predicted);
  void flush();  ///< writes predictions that are not yet in the file

  /// Notes the sum of squares of a set of values by all replicates.
  void note(const std::vector<double>& values, double sum);
  const std::optional<Best>& best() const { return best_; }

 private:
  void load();
  void write();

  std::filesystem::path file_;
  std::string what_;
  std::chrono::duration<double> every_;
  std::function<void(const Fault&)> on_write_error_;
  std::map<std::pair<Replicates, std::vector<double>>, std::vector<double>> known_;
  std::optional<Best> best_;
  std::chrono::steady_clock::time_point written_at_ = std::chrono::steady_clock::now();
  bool unwritten_ = false;
};

}  // namespace mahlwerk::campaign
