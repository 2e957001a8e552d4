// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/read/many_runs.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

class CaseReader final : public SectionTables {
 public:
  CaseReader(const Node& root, const std::filesystem::path& file, const Catalogue& catalogue)
      : tree_(root, file, catalogue) {}

  Case read(const std::vector<Override>& overrides) {
    c_.file = tree_.file().generic_string();
    tree_.add_parts_of_mill(overrides);
    const DottedLists fit = read_many_runs(tree_, overrides, c_);
    read_top();
    read_sections();
    check_fit(c_, fit.locations, findings_);
    c_.origins = std::move(findings_.origins);
    c_.remarks = std::move(findings_.remarks);
    if (findings_.faults.empty()) drop_irrelevant_assumptions(c_);
    auto more = findings_.faults.empty() ? faults(c_) : inconsistencies(c_);
    std::ranges::move(more, std::back_inserter(findings_.faults));
    if (!findings_.faults.empty()) throw InputError(in_order(std::move(findings_.faults)));
    return std::move(c_);
  }

  const Node* table(std::string_view name) override { return tree_.section(name); }

 private:
  void read_top() {
    SectionReader in(&tree_.root(), "", findings_);
    for (const SectionSpec& one : section_list())
      if (!one.name.empty() && one.name.find('.') == std::string_view::npos) in.find(one.name);
    if (const auto title = in.text("title")) {
      c_.title = *title;
    } else {
      c_.title = tree_.file().stem().string();
      in.record_default("title", fmt::format("\"{}\"", c_.title), "the file's name");
    }
    c_.seed = read_seed(in);
    in.fields(c_, case_fields());
    describe_gravity_direction(in, c_.gravity_direction);
    in.report_unknown_keys();
  }

  std::uint64_t read_seed(SectionReader& in) {
    const Node* at = in.find("seed");
    if (at == nullptr) {
      in.record_default("seed", "1", "any value will do");
      return 1;
    }
    std::uint64_t seed = 0;
    const char* end = at->text.data() + at->text.size();
    const auto [stop, error] = std::from_chars(at->text.data(), end, seed);
    const bool written = at->is_integer || at->kind == Node::Kind::text;
    if (!written || error != std::errc{} || stop != end)
      in.fault(*at, fmt::format("seed = {} must be a whole number from 0 on", at->text),
               "write for instance seed = 1", "out-of-range");
    else
      in.record_origin("seed", std::to_string(seed), at);
    return seed;
  }

  /// Reads a section with its function `describe`; no value if the case lacks the section, which is
  /// a fault if it is `needed`.
  template <class What, class... Around>
  std::optional<What> described(const char* name, bool needed, Around&... around) {
    const Node* table = tree_.section(name, needed);
    if (table == nullptr) return std::nullopt;
    return read_table<What>(table, name, around...);
  }
  template <class What, class... Around>
  What read_table(const Node* table, const char* name, Around&... around) {
    What what;
    SectionReader in(table, name, findings_);
    describe(in, what, around...);
    in.report_unknown_keys();
    return what;
  }

  /// The jars of the mill in the catalogue, among which short names of jars are looked for first.
  void find_jars_of_mill() {
    const Node* name = value_at(tree_.root(), "mill.model");
    if (name == nullptr || name->kind != Node::Kind::text) return;
    const auto called = findings_.catalogue->entries_called("mills", name->text);
    if (called.size() == 1)
      findings_.jars_of_mill = findings_.catalogue->find("mills", called.front()).jars;
  }

  void read_sections() {
    find_jars_of_mill();
    c_.jar = described<Jar>("jar", true).value_or(invalid_jar());
    c_.machine_parts = read_machine_parts(tree_.root().find("parts"), findings_);
    Node no_balls;
    no_balls.where = tree_.file().generic_string();
    const Node* balls = tree_.root().find("balls");
    c_.balls = read_balls(balls ? balls : &no_balls, c_.jar, findings_);
    c_.mill = described<Mill>("mill", true, c_).value_or(Mill());
    c_.powder = described<Powder>("powder", false, c_.balls, c_.jar);  // adds grains to the balls
    c_.contact = read_contact(tree_.section("contact"), c_, findings_);
    c_.liquid = described<Liquid>("liquid", false);
    c_.run = described<Run>("run", true).value_or(Run());
    c_.observe = read_table<Observe>(tree_.section("observe"), "observe");
    c_.milling = described<MillingTime>("milling", false);
    find_milling_time(tree_.root(), findings_);
    for (const Part* part : parts()) read_part(*part);
  }

  void read_part(const Part& part) {
    if (part.read != nullptr) return part.read(*this, c_, findings_);
    for (const PartSection& one : part.sections) {
      const Node* table = tree_.section(one.spec.name);
      if (table == nullptr) continue;
      SectionReader in(table, std::string(one.spec.name), findings_);
      one.describe(in, c_);
      in.report_unknown_keys();
    }
  }

  /// Sorts faults by line of the case file, so that a user can correct the file from top to bottom.
  /// Other faults are last.
  std::vector<Fault> in_order(std::vector<Fault> all) const {
    const std::string here = tree_.file().generic_string() + ":";
    const auto line = [&](const Fault& f) {
      long n = f.where + ":" == here ? 0 : std::numeric_limits<long>::max();
      if (f.where.starts_with(here))
        std::from_chars(f.where.data() + here.size(), f.where.data() + f.where.size(), n);
      return n;
    };
    std::ranges::stable_sort(all, {}, line);
    return all;
  }

  CaseTree tree_;
  Findings& findings_ = tree_.findings;
  Case c_;
};

}  // namespace

Case read_tree(const Node& root, const std::filesystem::path& file, const Catalogue& catalogue,
               const std::vector<Override>& overrides) {
  return CaseReader(root, file, catalogue).read(overrides);
}

}  // namespace mahlwerk::cases
