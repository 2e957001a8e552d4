// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The functions that web/src/engine.js calls. Arguments are UTF-8 texts; the answer is a text, JSON
// unless said otherwise, that is valid until the next call. Every fault becomes {"faults": [...]}.
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "estimate.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/reference/key_pages.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "session.hpp"
#include "vocabulary.hpp"

namespace mahlwerk::web {
namespace {

std::string answer;
std::optional<Session> session;
std::vector<std::string> states;           // given for `finish`, by replicate
std::map<std::string, std::string> files;  // of the finished result

const char* give(std::string text) {
  answer = std::move(text);
  return answer.c_str();
}

/// The text that `make` returns, or the faults that it throws.
template <class Make>
const char* answer_of(const Make& make) {
  try {
    return give(make());
  } catch (const InputError& e) {
    return give(faults_json(e.faults()).text());
  } catch (const std::exception& e) {
    return give(faults_json({{"", e.what(), "", ""}}).text());
  }
}

/// "key=value" lines.
Overrides overrides(std::string_view lines) {
  Overrides set;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos)
      set.push_back({std::string(line.substr(0, equals)), std::string(line.substr(equals + 1)),
                     cases::ValueSource::command});
  }
  return set;
}

void keep_files(const results::Outcome& outcome) {
  files.clear();
  files["summary.json"] = results::summary_json(outcome, MAHLWERK_VERSION);
  files["report.html"] = report::report_page(outcome, MAHLWERK_VERSION);
  files["case.resolved.toml"] = cases::write(outcome.mill_case);
  for (const results::NamedTable& one : results::tables(outcome))
    files[one.name + ".csv"] = results::csv(one.table);
}

}  // namespace
}  // namespace mahlwerk::web

using namespace mahlwerk;  // NOLINT: the functions below have no namespace
using namespace mahlwerk::web;

extern "C" {

/// Bytes of the last answer, which may contain zeros.
std::size_t mahlwerk_answer_size() {
  return answer.size();
}

const char* mahlwerk_version() {
  return MAHLWERK_VERSION;
}

const char* mahlwerk_vocabulary() {
  return answer_of([] { return vocabulary().text(); });
}

const char* mahlwerk_check(const char* text, const char* set) {
  return answer_of([&] { return description(read_case(text, overrides(set))).text(); });
}

/// The case of a few words, which are JSON (estimate.hpp).
const char* mahlwerk_estimate(const char* words) {
  return answer_of([&] { return estimate(words).text(); });
}

/// The data of a replay with the balls at the start.
const char* mahlwerk_picture(const char* text, const char* set) {
  return answer_of([&] { return first_picture(read_case(text, overrides(set))); });
}

const char* mahlwerk_open(const char* text, const char* set, int replicate) {
  session.reset();
  return answer_of([&] {
    const cases::Case mill_case = read_case(text, overrides(set));
    session.emplace(mill_case, replicate);
    return description(mill_case).text();
  });
}

const char* mahlwerk_advance(double milliseconds) {
  return answer_of([&] { return session.value().advance(milliseconds).text(); });
}

const char* mahlwerk_summary() {
  return answer_of(
      [] { return results::summary_json(session.value().outcome_so_far(), MAHLWERK_VERSION); });
}

/// A table of the open replicate so far as CSV; empty if there is none of this name.
const char* mahlwerk_table(const char* name) {
  return answer_of([&]() -> std::string {
    for (const results::NamedTable& one : session.value().tables_so_far())
      if (one.name == name) return results::csv(one.table);
    return "";
  });
}

const char* mahlwerk_film() {
  return answer_of([] { return session.value().film(); });
}

/// The state of the open replicate: bytes.
const char* mahlwerk_state() {
  return answer_of([] { return session.value().state(); });
}

/// Room for the state of the next replicate, which the caller fills in.
char* mahlwerk_add_state(std::size_t size) {
  states.emplace_back(size, '\0');
  return states.back().data();
}

/// Merges the states that were added; answers with the names of the result's files.
const char* mahlwerk_finish(const char* text, const char* set) {
  return answer_of([&] {
    const std::vector<std::string> given = std::exchange(states, {});
    keep_files(merged_outcome(read_case(text, overrides(set)), {given.begin(), given.end()}));
    results::Json made = faults_json({}), names = results::Json::array();
    for (const auto& [name, content] : files) names.push_back(name);
    made["files"] = std::move(names);
    return made.text();
  });
}

/// A file of the finished result; empty if there is none of this name.
const char* mahlwerk_file(const char* name) {
  const auto at = files.find(name);
  return give(at == files.end() ? "" : at->second);
}

}  // extern "C"
