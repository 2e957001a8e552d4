// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mahlwerk {

/// One thing wrong with what the user gave: where, what, and how to mend it.
struct Fault {
  std::string where;   ///< "case.toml:14" or "--set jar.diameter"; may be empty
  std::string what;    ///< the cause, in a sentence without a full stop
  std::string remedy;  ///< what to do; may be empty
  std::string code;    ///< anchor in docs/errors.md, for instance "e-unknown-key"; may be empty
};

/// Bad input: all faults found, together. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  explicit InputError(Fault fault);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A run that cannot go on for a reason of physics (Zeno guard, lost ball). Exit code 3.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Work was ended because the user asked for it.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// The faults as the lines a user reads.
std::string describe(const std::vector<Fault>& faults);

}  // namespace mahlwerk
