// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/commands/reporting/listener.hpp"
#include "mahlwerk/commands/reporting/terminal.hpp"

namespace mahlwerk::commands {
namespace {

using results::Json;

bool errors_as_json = false;

std::string_view name_of(int code) {
  switch (code) {
    case bad_input:
      return "bad-input";
    case stopped_by_physics:
      return "stopped";
    case output_lost:
      return "output-lost";
    case interrupted:
      return "interrupted";
    default:
      return "internal-error";
  }
}

bool is_plain(char c) {
  constexpr std::string_view others = "_-./:=,+@%";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         others.find(c) != std::string_view::npos;
}

}  // namespace

results::Json fault_json(const Fault& fault) {
  return Json::object({{"code", fault.code},
                       {"where", fault.where},
                       {"what", fault.what},
                       {"remedy", fault.remedy}});
}

void set_json_messages() {
  errors_as_json = true;
}

bool json_messages() {
  return errors_as_json;
}

void to_stdout(std::string_view text) {
  if (listener() != nullptr) return;
  fmt::print("{}", page_for(Stream::output, printable(text)));
}

void verbatim_to_stdout(std::string_view text) {
  if (listener() == nullptr) fmt::print("{}", printable(text));
}

void title_to_stdout(std::string_view text) {
  if (listener() != nullptr) return;
  const std::string line = wrapped_line(printable(text), terminal_width(Stream::output));
  fmt::print("{}\n", styled(Style::heading, line, Stream::output));
}

void places_to_stdout(const Places& places) {
  if (listener() != nullptr) return;
  constexpr std::size_t least = 10;
  std::size_t width = least;
  for (const auto& [name, path] : places) width = std::max(width, name.size() + 2);
  for (const auto& [name, path] : places)
    fmt::print("{:<{}}{}\n", fmt::format("{}:", name), width,
               linked(printable(path.string()), path.string(), Stream::output));
}

void json_to_stdout(const results::Json& json) {
  if (listener() != nullptr) return listener()->result(json.text());
  fmt::print("{}\n", json.text(2));
}

void to_stderr(std::string_view text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
  std::fflush(stderr);
}

void print_warning(const Fault& warning) {
  if (listener() != nullptr) return listener()->warning(warning);
  to_stderr(errors_as_json ? Json::object({{"warning", fault_json(warning)}}).text() + '\n'
                           : faults_for(Stream::errors, Style::warning,
                                        "warning: " + mahlwerk::describe({warning}) + '\n'));
}

WriteErrorReporter::WriteErrorReporter() : listener_(listener()) {}

void WriteErrorReporter::operator()(const Fault& trouble) {
  const std::lock_guard lock(mutex_);
  if (first_) return;
  first_ = trouble;
  if (listener_ != nullptr) return listener_->warning(trouble);
  print_warning(trouble);
}

void WriteErrorReporter::repeat() const {
  const std::lock_guard lock(mutex_);
  if (first_ && listener_ == nullptr) print_warning(*first_);
}

int report_end(int code, std::string_view words, const std::vector<Fault>& faults) {
  if (listener() != nullptr) {
    listener()->ended(code, faults);
    return code;
  }
  if (!errors_as_json) {
    to_stderr(faults_for(Stream::errors, Style::error, printable(words) + '\n'));
    return code;
  }
  Json list = Json::array();
  for (const Fault& fault : faults) list.push_back(fault_json(fault));
  const Json said =
      Json::object({{"ended", name_of(code)}, {"exit", code}, {"faults", std::move(list)}});
  to_stderr(said.text() + '\n');
  return code;
}

int report_end(int code, const std::vector<Fault>& faults) {
  return report_end(code, mahlwerk::describe(faults), faults);
}

std::string shell_word(std::string_view text) {
  if (!text.empty() && text.front() != '-' && std::ranges::all_of(text, is_plain))
    return std::string(text);
  std::string word = has_control(text) ? "$'" : "'";
  const bool escapes = word.size() > 1;  // $'...' interprets backslash escapes
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (escapes && (byte < 0x20 || byte == 0x7F))
      word += fmt::format("\\{:03o}", byte);
    else if (escapes && (c == '\'' || c == '\\'))
      word += fmt::format("\\{}", c);
    else
      word += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return word + "'";
}

}  // namespace mahlwerk::commands
