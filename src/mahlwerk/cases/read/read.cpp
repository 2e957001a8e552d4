// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/read/case_reader.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

std::string contents_of(const std::filesystem::path& file) {
  std::error_code trouble;
  const auto status = std::filesystem::status(file, trouble);
  const auto fault = [&](std::string what, std::string remedy) {
    return InputError(
        Fault{file.generic_string(), std::move(what), std::move(remedy), "no-such-file"});
  };
  if (!std::filesystem::exists(status))
    throw fault("there is no such case file", "check the path; a case is a .toml file");
  if (!std::filesystem::is_regular_file(status))
    throw fault("this is not a file", "give the path of a case file, for instance case.toml");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw fault("the case file cannot be read", "check its permissions");
  return text;
}

}  // namespace

CaseFile::CaseFile(const std::filesystem::path& file) : CaseFile(contents_of(file), file) {}

CaseFile::CaseFile(const std::string& text, const std::filesystem::path& file)
    : root_(std::make_shared<const Node>(parse_tree(text, file.generic_string()))), file_(file) {}

namespace {

/// The values of one draw, as overrides after `overrides`.
std::vector<Override> with_draw(std::vector<Override> overrides, const Uncertainty& uncertainty,
                                std::size_t draw) {
  for (const UncertainKey& one : uncertainty.keys)
    overrides.push_back({one.key, one.values[draw], ValueSource::uncertainty});
  return overrides;
}

}  // namespace

bool gives_value(const std::vector<Override>& overrides, std::string_view key) {
  return std::ranges::any_of(overrides,
                             [&](const Override& one) { return one.key == key && !one.unset; });
}

Case CaseFile::read(const Catalogue& catalogue, const std::vector<Override>& overrides) const {
  Case made = read_tree(*root_, file_, catalogue, overrides);
  if (!made.uncertainty) return made;
  std::vector<DrawnSections> drawn;
  for (std::size_t draw = 0; draw < made.uncertainty->count(); ++draw) {
    Case one = read_tree(*root_, file_, catalogue, with_draw(overrides, *made.uncertainty, draw));
    drawn.push_back({std::move(one.mill), std::move(one.contact)});
  }
  made.uncertainty->sections = std::make_shared<const std::vector<DrawnSections>>(std::move(drawn));
  return made;
}

Case read(const std::filesystem::path& file, const Catalogue& catalogue,
          const std::vector<Override>& overrides) {
  return CaseFile(file).read(catalogue, overrides);
}

Case read_text(const std::string& text, const std::filesystem::path& file,
               const Catalogue& catalogue, const std::vector<Override>& overrides) {
  return CaseFile(text, file).read(catalogue, overrides);
}

bool is_key_of_run(std::string_view key) {
  return is_key_of_draw(key) || key.starts_with("jar.") || key.starts_with("balls.") ||
         key.starts_with("power_meter.");
}

bool is_key_of_draw(std::string_view key) {
  return key.starts_with("contact.") || key.starts_with("mill.");
}

std::map<std::string, FitRange> fit_ranges(const std::filesystem::path& file) {
  const Node root = parse_tree(contents_of(file), file.generic_string());
  Findings findings;
  const Node* table = root.find("fit");
  if (table != nullptr && table->kind != Node::Kind::table)
    findings.faults.push_back({table->where, "`fit` must be a section",
                               "write [fit] and its values below", "wrong-type"});
  const DottedLists lists = read_fit(table, findings);
  if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
  std::map<std::string, FitRange> ranges;
  for (const auto& [key, ends] : lists.values)
    ranges.emplace(key, FitRange{ends.front(), ends.back()});
  return ranges;
}

}  // namespace mahlwerk::cases
