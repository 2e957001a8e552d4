// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// What a command prints. Results go to stdout. Messages go to stderr: as text, or with --json as
// one JSON object per line; none of their functions throws, because a closed terminal must not end
// a run.
namespace mahlwerk::commands {

class Listener;

/// Exit codes (docs/cli.md).
enum Exit : int {
  success = 0,
  internal_error = 1,
  bad_input = 2,
  stopped_by_physics = 3,
  output_lost = 4,
  interrupted = 130
};

/// Prints a page or a part of one to stdout, as the terminal shows it (terminal.hpp), with control
/// characters escaped: it may contain text of a case or user.
void to_stdout(std::string_view text);
/// The same for texts that are copied or read by programs: they stay as they are.
void verbatim_to_stdout(std::string_view text);
/// Prints the title of a page, one line.
void title_to_stdout(std::string_view text);

/// Files and folders that a command wrote, and what they are: "report".
using Places = std::vector<std::pair<std::string, std::filesystem::path>>;
/// Prints them to stdout, one a line: "report:   results/x/report.html".
void places_to_stdout(const Places& places);
/// Prints the result of a command as JSON.
void json_to_stdout(const results::Json& json);

/// Switches all later messages to JSON.
void set_json_messages();
bool json_messages();

/// Prints a warning during a run.
void print_warning(const Fault& warning);

/// Reports a write error once when it first occurs and once at the end. Thread-safe.
class WriteErrorReporter {
 public:
  WriteErrorReporter();
  void operator()(const Fault& trouble);
  void repeat() const;

 private:
  Listener* listener_;
  mutable std::mutex mutex_;
  std::optional<Fault> first_;
};

/// Reports how the program ends and why: `words` as text, or the faults as JSON. Returns `code`.
int report_end(int code, std::string_view words, const std::vector<Fault>& faults);
/// The same; the text is made from the faults.
int report_end(int code, const std::vector<Fault>& faults);

/// A fault as JSON: code, where, what, remedy.
results::Json fault_json(const Fault& fault);

/// Writes to stderr; ignores errors.
void to_stderr(std::string_view text);

/// `text` as a single shell word, quoted if necessary.
std::string shell_word(std::string_view text);

}  // namespace mahlwerk::commands
