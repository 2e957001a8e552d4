// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mahlwerk {

/// One fault in the user's input: where, what, and the remedy.
struct Fault {
  std::string where;   ///< "case.toml:14" or "--set jar.diameter"; may be empty
  std::string what;    ///< the cause: a sentence without a full stop
  std::string remedy;  ///< what to do; may be empty
  std::string code;    ///< anchor in docs/errors.md, for instance "e-unknown-key"; may be empty
};

/// Invalid input, with all faults that were found. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  explicit InputError(Fault fault);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A run that cannot continue for a physical reason (Zeno guard, lost ball). Exit code 3.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user interrupted the work.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// The text of the faults as shown to the user, without control characters.
std::string describe(const std::vector<Fault>& faults);

}  // namespace mahlwerk
