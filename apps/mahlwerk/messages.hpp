// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"

// What the program says on stderr: in words, or with --json as one JSON object a line. Nothing of
// it throws: a terminal that has gone must not end a run.
namespace mahlwerk::app {

/// From here on messages are JSON.
void set_json_messages();
bool json_messages();

/// Something the user must know while the run goes on.
void print_warning(const Fault& warning);

/// Trouble that many may meet: told when it comes first, and once more at the end. Threads may call
/// at the same time.
class WriteErrorReporter {
 public:
  void operator()(const Fault& trouble);
  void repeat() const;

 private:
  mutable std::mutex mutex_;
  std::optional<Fault> first_;
};

/// How the program ends, and why: `words` as text, the faults as JSON. Gives back the exit code.
int report_end(int code, std::string_view words, const std::vector<Fault>& faults);
/// The same with the faults in words.
int report_end(int code, const std::vector<Fault>& faults);

/// Writes to stderr, whether or not anybody reads it.
void to_stderr(std::string_view text);

/// As one word of a shell, whatever stands in it; quoted where it must be.
std::string shell_word(std::string_view text);

}  // namespace mahlwerk::app
