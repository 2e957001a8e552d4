// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults/faults.hpp"
#include "mahlwerk/cases/file/formula.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view no_such_key = "unknown-key";

class CaseReader final : public SectionTables {
 public:
  CaseReader(Node root, std::filesystem::path file, const Catalogue& catalogue)
      : root_(std::move(root)),
        file_(std::move(file)),
        findings_{.catalogue = &catalogue, .folder = file_.parent_path().generic_string()} {}

  Case read(const std::vector<Override>& overrides) {
    c_.file = file_.generic_string();
    apply(overrides, ValueSource::command);
    std::map<std::string, std::string> locations;
    c_.sweep = read_sweep(section("sweep", false), locations, findings_);
    refuse_both(overrides);
    apply(overrides, ValueSource::sweep);
    fill_from_sweep(locations);
    apply_formulas(locations);
    if (const Node* table = section("optimise", false))
      c_.optimise = read_optimise(table, findings_);
    if (const Node* table = section("match", false)) c_.match = read_match(table, findings_);
    apply(overrides, ValueSource::optimise);
    apply(overrides, ValueSource::match);
    const DottedLists fit = read_fit(section("fit", false), findings_);
    for (const auto& [key, ends] : fit.values)
      findings_.origins.push_back({.key = "fit." + key,
                                   .value = fmt::format("{} to {}", ends.front(), ends.back()),
                                   .source = fit.locations.at(key)});
    apply(overrides, ValueSource::fit);
    record_fit(fit);
    read_draws(overrides);
    apply(overrides, ValueSource::uncertainty);
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

  const Node* table(std::string_view name) override { return section(name, false); }

 private:
  Node given(const Override& one) const {
    const auto& [key, value, source] = one;
    if (source == ValueSource::command)
      return value_from_text(value, "--set " + key, Precedence::command);
    if (source == ValueSource::sweep)
      return value_from_text(value, fmt::format("[sweep] {} = {}", key, value), Precedence::sweep);
    const auto& [section, place] = section_of(source);
    const auto range =
        std::ranges::find(findings_.origins, fmt::format("{}{}", place, key), &Origin::key);
    const std::string line = range == findings_.origins.end() ? section : range->source;
    const std::string where = fmt::format("{}: [{}] {} = {}", line, section, key, value);
    Node node = value_from_text(value, where, Precedence::command);
    node.source = fmt::format("{}: found by {}", line, section);
    return node;
  }

  /// The section that varies a key, and what its keys are called in origins.
  static std::pair<std::string, std::string> section_of(ValueSource source) {
    if (source == ValueSource::optimise) return {"optimise", "optimise.over."};
    if (source == ValueSource::match) return {"match", "match.over."};
    if (source == ValueSource::fit) return {"fit", "fit."};
    return {"uncertainty", "uncertainty."};
  }

  /// [uncertainty], unless the values of a draw are given: then its section was read before.
  /// Another source cannot give its keys, too.
  void read_draws(const std::vector<Override>& overrides) {
    const Node* table = section("uncertainty", false);
    if (table == nullptr || std::ranges::find(overrides, ValueSource::uncertainty,
                                              &Override::source) != overrides.end())
      return;
    c_.uncertainty = read_uncertainty(table, findings_);
    for (const Override& one : overrides)
      refuse_drawn(one.key, one.source == ValueSource::command ? "--set " + one.key
                                                               : section_of(one.source).first);
    for (const SweptKey& swept : c_.sweep.keys)
      refuse_drawn(swept.key, fmt::format("[sweep] \"{}\"", swept.key));
  }
  void refuse_drawn(const std::string& key, const std::string& where) {
    if (std::ranges::find(c_.uncertainty->keys, key, &UncertainKey::key) !=
        c_.uncertainty->keys.end())
      findings_.faults.push_back(
          {where, fmt::format("{} varies from replicate to replicate by [uncertainty]", key),
           "remove it from [uncertainty], or remove that section", "drawn-value"});
  }

  void apply(const std::vector<Override>& overrides, ValueSource source) {
    for (const Override& one : overrides) {
      if (one.source != source) continue;
      Node value = given(one);
      const std::string where = value.where, trouble = set_value(root_, one.key, std::move(value));
      if (!trouble.empty())
        findings_.faults.push_back({where, trouble,
                                    "name a value of the case: mill.speed, "
                                    "balls.2.diameter",
                                    std::string(no_such_key)});
    }
  }

  /// A key that [sweep] varies cannot have a value from --set.
  void refuse_both(const std::vector<Override>& overrides) {
    for (const Override& one : overrides)
      if (one.source == ValueSource::command &&
          std::ranges::find(c_.sweep.keys, one.key, &SweptKey::key) != c_.sweep.keys.end())
        findings_.faults.push_back(
            {fmt::format("--set {}", one.key), fmt::format("[sweep] varies {}", one.key),
             "change its values in [sweep], or remove it there", "swept-value"});
  }

  /// Evaluates the formulas of [sweep] and sets their keys.
  void apply_formulas(const std::map<std::string, std::string>& locations) {
    for (const auto& entry : c_.sweep.derived) {
      const std::string &key = entry.first, &formula = entry.second;
      const std::string& where = locations.at(key);
      const auto fault = [&](std::string what, std::string remedy) {
        findings_.faults.push_back({where, fmt::format("the formula of \"{}\": {}", key, what),
                                    std::move(remedy), "bad-formula"});
      };
      try {
        Node value = value_from_text(text_of(derived(key, 0)), where, Precedence::sweep);
        value.source = fmt::format("[sweep]: ={}", formula);
        if (std::string trouble = set_value(root_, key, std::move(value)); !trouble.empty())
          fault(std::move(trouble), "name a value of the case: \"jar.height\"");
      } catch (const FormulaError& error) {
        fault(error.what(), "write for instance \"= 5 ml / (pi/4 * jar.diameter^2)\"");
      }
    }
  }

  /// The value of a key, from its formula if it has one.
  Quantity derived(std::string_view key, std::size_t depth) const {
    if (depth > c_.sweep.derived.size())
      throw FormulaError(fmt::format("{} depends on itself", key));
    const auto formula = c_.sweep.derived.find(std::string(key));
    if (formula != c_.sweep.derived.end())
      return evaluate(formula->second,
                      [&](std::string_view other) { return derived(other, depth + 1); });
    const Node* node = value_at(root_, key);
    if (const auto gravity = case_fields().front(); node == nullptr && key == gravity.key)
      return parse_quantity(show(*gravity.standard, gravity.unit));
    if (node == nullptr || (node->kind != Node::Kind::text && node->kind != Node::Kind::number))
      throw FormulaError(fmt::format("the case gives no quantity for {}", key));
    try {
      return parse_quantity(node->text);
    } catch (const UnitError& error) {
      throw FormulaError(fmt::format("{} = \"{}\": {}", key, node->text, error.what()));
    }
  }

  /// A key without a value in the case gets the first value of its sweep.
  void fill_from_sweep(const std::map<std::string, std::string>& locations) {
    for (const SweptKey& swept : c_.sweep.keys) {
      const std::string& key = swept.key;
      if (value_at(root_, key) != nullptr) continue;
      const std::string& where = locations.at(key);
      Node value = value_from_text(swept.values.front(), where, Precedence::sweep);
      value.source = fmt::format("first value of [sweep] \"{}\"", key);
      const std::string trouble = set_value(root_, key, std::move(value));
      if (!trouble.empty())
        findings_.faults.push_back({where, trouble,
                                    "sweep over a value of the case: \"mill.speed\"",
                                    std::string(no_such_key)});
    }
  }

  /// Stores the ranges of [fit]. Keys without a value in the case are marked as fitted keys.
  void record_fit(const DottedLists& fit) {
    for (const auto& [key, ends] : fit.values) {
      c_.fit.emplace(key, FitRange{ends.front(), ends.back()});
      if (value_at(root_, key) == nullptr) findings_.fitted_keys.insert(key);
    }
  }

  /// The table of a section, or null. A value that is not a table is a fault.
  const Node* section(std::string_view name, bool needed) {
    const Node* found = root_.find(name);
    if (found != nullptr && found->kind == Node::Kind::table) return found;
    if (found != nullptr)
      findings_.faults.push_back({found->where, fmt::format("`{}` must be a section", name),
                                  fmt::format("write [{}] and its values below", name),
                                  "wrong-type"});
    else if (needed)
      findings_.faults.push_back({file_.generic_string(), fmt::format("there is no [{}]", name),
                                  fmt::format("add the section [{}]", name), "missing-value"});
    return nullptr;
  }

  void read_top() {
    SectionReader in(&root_, "", findings_);
    for (const SectionSpec& one : section_list())
      if (!one.name.empty() && one.name.find('.') == std::string_view::npos) in.find(one.name);
    if (const auto title = in.text("title")) {
      c_.title = *title;
    } else {
      c_.title = file_.stem().string();
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
    const Node* table = section(name, needed);
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
    const Node* name = value_at(root_, "mill.model");
    if (name == nullptr || name->kind != Node::Kind::text) return;
    const auto called = findings_.catalogue->entries_called("mills", name->text);
    if (called.size() == 1)
      findings_.jars_of_mill = findings_.catalogue->find("mills", called.front()).jars;
  }

  void read_sections() {
    find_jars_of_mill();
    c_.jar = described<Jar>("jar", true).value_or(invalid_jar());
    Node no_balls;
    no_balls.where = file_.generic_string();
    const Node* balls = root_.find("balls");
    c_.balls = read_balls(balls ? balls : &no_balls, c_.jar, findings_);
    c_.mill = described<Mill>("mill", true, c_).value_or(Mill());
    c_.powder = described<Powder>("powder", false, c_.balls, c_.jar);  // adds grains to the balls
    c_.contact = read_contact(section("contact", false), c_, findings_);
    c_.liquid = described<Liquid>("liquid", false);
    c_.run = described<Run>("run", true).value_or(Run());
    c_.observe = read_table<Observe>(section("observe", false), "observe");
    c_.milling = described<MillingTime>("milling", false);
    find_milling_time(root_, findings_);
    for (const Part* part : parts()) read_part(*part);
  }

  void read_part(const Part& part) {
    if (part.read != nullptr) return part.read(*this, c_, findings_);
    for (const PartSection& one : part.sections) {
      const Node* table = section(one.spec.name, false);
      if (table == nullptr) continue;
      SectionReader in(table, std::string(one.spec.name), findings_);
      one.describe(in, c_);
      in.report_unknown_keys();
    }
  }

  /// Sorts faults by line of the case file, so that a user can correct the file from top to bottom.
  /// Other faults are last.
  std::vector<Fault> in_order(std::vector<Fault> all) const {
    const std::string here = file_.generic_string() + ":";
    const auto line = [&](const Fault& f) {
      long n = f.where + ":" == here ? 0 : std::numeric_limits<long>::max();
      if (f.where.starts_with(here))
        std::from_chars(f.where.data() + here.size(), f.where.data() + f.where.size(), n);
      return n;
    };
    std::ranges::stable_sort(all, {}, line);
    return all;
  }

  Node root_;
  std::filesystem::path file_;
  Findings findings_;
  Case c_;
};

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
    : root_(parse_tree(text, file.generic_string())), file_(file) {}

namespace {

/// The values of one draw, as overrides after `overrides`.
std::vector<Override> with_draw(std::vector<Override> overrides, const Uncertainty& uncertainty,
                                std::size_t draw) {
  for (const UncertainKey& one : uncertainty.keys)
    overrides.push_back({one.key, one.values[draw], ValueSource::uncertainty});
  return overrides;
}

}  // namespace

Case CaseFile::read(const Catalogue& catalogue, const std::vector<Override>& overrides) const {
  Case made = CaseReader(root_, file_, catalogue).read(overrides);
  if (!made.uncertainty) return made;
  std::vector<DrawnSections> drawn;
  for (std::size_t draw = 0; draw < made.uncertainty->count(); ++draw) {
    Case one =
        CaseReader(root_, file_, catalogue).read(with_draw(overrides, *made.uncertainty, draw));
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
