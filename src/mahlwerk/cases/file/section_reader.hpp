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

/// What reading goes by, and what it has found so far: all that is wrong, and where every value
/// came from.
struct Findings {
  const Catalogue* catalogue = nullptr;
  std::string folder = {};  ///< in which files are looked for
  std::vector<Fault> faults = {};
  std::vector<Origin> origins = {};
  std::set<std::string, std::less<>> fitted_keys = {};  ///< dotted keys that only [fit] gives
};

constexpr double invalid_value =
    std::numeric_limits<double>::quiet_NaN();  ///< a value that had a fault

/// Reads one section of a case strictly: every fault and every origin goes into the findings, and
/// reading goes on with `invalid_value` in place of what was wrong.
class SectionReader : public KeyVisitor {
 public:
  /// `table` may be null: a section left out. `name` is its dotted name: "mill", "balls.1", or
  /// empty.
  SectionReader(const Node* table, std::string name, Findings& findings);

  /// Values to fall back on where the case is silent.
  void add_defaults(const CatalogueEntry& entry);

  void number(const NumberSpec& spec, double& value) override { value = this->value(spec); }
  void optional_number(const NumberSpec& spec, std::optional<double>& value) override {
    value = optional_number(spec);
  }
  void integer(const IntegerSpec& spec, std::int64_t& value) override;
  void flag(const Flag& flag, bool& value) override;
  void text(std::string_view key, std::string& value) override { value = text(key).value_or(""); }
  bool choose(const Choice& choice, std::size_t& word_index) override;
  void custom(const CustomKey&, const std::function<std::string()>&) override {}
  SectionReader* reader() override { return this; }
  bool gives(std::string_view key) override { return find(key) != nullptr; }
  void ignore_unknown_keys() override { unknown_keys_ignored_ = true; }
  void refuse(std::initializer_list<std::string_view> keys, std::string_view why,
              const std::string& remedy) override;

  /// The value, the case's own before the catalogue's, which then counts as read.
  const Node* find(std::string_view key);
  /// Of keys that exclude each other the one that counts; empty if none is given. Two of the same
  /// standing are a fault.
  std::string_view one_of(std::initializer_list<std::string_view> keys);

  double value(const NumberSpec& spec);                           ///< a fault if it is not given
  std::optional<double> optional_number(const NumberSpec& spec);  ///< nothing if it is not given
  std::optional<std::string> text(std::string_view key);
  std::string choice(const Choice& choice);  ///< empty after a fault
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t most,
                                      std::int64_t least = 1);

  /// Notes where a value came from. `how` is put behind the source: "volume = \"5 ml\"".
  void record_origin(std::string_view key, std::string value, const Node* from,
                     std::string_view how = "");
  void record_default(std::string_view key, std::string value, std::string_view source);

  void fault(const Node& at, std::string what, std::string remedy, std::string_view code);
  /// Silent about what [fit] is to choose.
  void missing(std::string_view key, std::string_view about, std::string remedy);
  /// What `at` says as a quantity in `spec`'s unit and range, or `invalid_value` after a fault.
  double quantity(const Node& at, const NumberSpec& spec);

  /// Reports every key that nobody asked for.
  void report_unknown_keys();

  const std::string& name() const { return name_; }
  std::string heading() const;  ///< "[mill]"
  Findings& findings() { return findings_; }
  const Catalogue& catalogue() const { return *findings_.catalogue; }

 private:
  std::string dotted(std::string_view key) const;
  void mark(std::string_view key);

  const Node* table_;
  std::string name_;
  Findings& findings_;
  std::map<std::string, Node, std::less<>> catalogue_values_;
  std::vector<std::string> known_;
  bool unknown_keys_ignored_ = false;
};

/// "above 0 mm and at most 1 m".
std::string range_text(const Range& range, std::string_view unit);
/// "a", "b" or "c".
std::string quoted_list(const std::vector<std::string>& words);

}  // namespace mahlwerk::cases
