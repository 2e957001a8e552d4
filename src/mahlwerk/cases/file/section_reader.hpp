// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/file/table.hpp"

namespace mahlwerk::cases {

/// Context of a reader and its results: the faults, and the origin of every value.
struct Findings {
  const Catalogue* catalogue = nullptr;
  std::string folder = {};  ///< folder of the case file; paths of the case are relative to it
  std::vector<Fault> faults = {};
  std::vector<Origin> origins = {};
  /// [s] The milling time that any section states, and that section: "milling"
  std::optional<double> milling_time = std::nullopt;
  std::string_view milling_time_of = {};
  std::set<std::string, std::less<>> fitted_keys = {};  ///< dotted keys that only [fit] gives
  std::vector<std::string> jars_of_mill = {};  ///< of the catalogue; preferred by short names
  Notices remarks = {};                        ///< see Case::remarks
};

constexpr double invalid_value =
    std::numeric_limits<double>::quiet_NaN();  ///< stands for a value with a fault

/// Reads one section of a case. Adds all faults and origins to the findings. Reading continues
/// after a fault, with `invalid_value` for the wrong value.
class SectionReader : public KeyVisitor {
 public:
  /// `table` is null if the case lacks the section. `name` is its dotted name: "mill", "balls.1",
  /// or empty for the top level.
  SectionReader(const Node* table, std::string name, Findings& findings);

  /// Uses the values of the entry for keys that the case does not give.
  void add_defaults(const CatalogueEntry& entry);

  void number(const NumberSpec& spec, double& value) override { value = this->value(spec); }
  void optional_number(const NumberSpec& spec, std::optional<double>& value) override {
    value = optional_number(spec);
  }
  void integer(const IntegerSpec& spec, std::int64_t& value) override;
  void flag(const Flag& flag, bool& value) override;
  void text(const TextSpec& spec, std::string& value) override {
    value =
        (spec.category.empty() ? text(spec.key) : entry_name(spec.key, spec.category)).value_or("");
  }
  bool choose(const Choice& choice, std::size_t& word_index) override;
  void custom(const CustomKey&, const std::function<std::string()>&) override {}
  SectionReader* reader() override { return this; }
  bool gives(std::string_view key) override { return find(key) != nullptr; }
  void ignore_unknown_keys() override { unknown_keys_ignored_ = true; }
  void refuse(std::initializer_list<std::string_view> keys, std::string_view why,
              const std::string& remedy) override;

  /// The value of `key` from the case, else from the catalogue entry, else null. Marks the key as
  /// known.
  const Node* find(std::string_view key);
  /// The key that counts of several that exclude each other: the given one of highest precedence;
  /// empty if none is given. Two keys of equal precedence are a fault.
  std::string_view one_of(std::initializer_list<std::string_view> keys);

  double value(const NumberSpec& spec);  ///< given value or default; a fault without either
  std::optional<double> optional_number(const NumberSpec& spec);  ///< no value if it is not given
  std::optional<std::string> text(std::string_view key);          ///< an empty text is a fault
  /// The name of an entry of the catalogue for a text that may be another name of it, "ZrO2". A
  /// text that names no entry is returned as it is; one that names several is a fault.
  std::optional<std::string> entry_name(std::string_view key, std::string_view category);
  std::string choice(const Choice& choice);  ///< empty after a fault
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t most,
                                      std::int64_t least = 1);

  /// Records the origin of a value. `how` is appended to the source: "volume = \"5 ml\"".
  void record_origin(std::string_view key, std::string value, const Node* from,
                     std::string_view how = "");
  void record_default(std::string_view key, std::string value, std::string_view source);

  void fault(const Node& at, std::string what, std::string remedy, std::string_view code);
  /// A fault for a missing key, unless [fit] chooses its value.
  void missing(std::string_view key, std::string_view about, std::string remedy);
  /// The value of `at` as a quantity with the unit and range of `spec`; `invalid_value` after a
  /// fault.
  double quantity(const Node& at, const NumberSpec& spec);

  /// A fault for each key of the section that was not looked up.
  void report_unknown_keys();

  const std::string& name() const { return name_; }
  std::string heading() const;  ///< "[mill]"
  Findings& findings() { return findings_; }
  const Catalogue& catalogue() const { return *findings_.catalogue; }

 private:
  std::string dotted(std::string_view key) const;
  std::optional<std::string> text_at(std::string_view key, const Node& node);
  /// How to give a missing number: for an entry of the catalogue within the range that it offers.
  std::string remedy_for(const NumberSpec& spec) const;
  void mark(std::string_view key);

  const Node* table_;
  std::string name_;
  Findings& findings_;
  std::map<std::string, Node, std::less<>> catalogue_values_;
  std::string entry_title_;  ///< of the catalogue entry that gives the defaults
  std::vector<std::string> known_;
  bool unknown_keys_ignored_ = false;
};

/// "a", "b" or "c".
std::string quoted_list(const std::vector<std::string>& words);

}  // namespace mahlwerk::cases
