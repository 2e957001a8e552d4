// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue/catalogue_read.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/catalogue/catalogue_keys.hpp"
#include "mahlwerk/cases/sections/fields.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view bad_file = "bad-catalogue-file";

/// A value as TOML.
std::string as_written(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return in_quotes(*text);
  std::ostringstream out;
  if (const toml::array* list = node.as_array())
    for (const toml::node& item : *list)
      out << (&item == list->get(0) ? "[" : ", ") << as_written(item);
  else
    node.visit([&](const auto& value) { out << value; });
  return out.str() + (node.is_array() ? "]" : "");
}

class EntryReader {
 public:
  explicit EntryReader(CatalogueEntry& entry) : entry_(entry) {}

  void read(const toml::table& top) {
    entry_.title = text(top, "title");
    entry_.about = text(top, "about");
    read_kind(top);
    const auto keys = catalogue_keys(entry_.category, entry_.kind);
    for (const auto& [key, node] : top) read_top(key.str(), node, keys);
    if (entry_.values.empty() && entry_.parts.empty() && faults_.empty())
      fault(top, "the file gives no value", "add at least one value with its source");
    if (!faults_.empty()) throw InputError(std::move(faults_));
  }

 private:
  void fault(const toml::node& at, std::string what, std::string remedy) {
    faults_.push_back({fmt::format("{}:{}", entry_.file, at.source().begin.line), std::move(what),
                       std::move(remedy), std::string(bad_file)});
  }

  /// The text of a key that is required and must not be blank.
  std::string text(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    const auto found = node ? node->value_exact<std::string>() : std::nullopt;
    if (found && found->find_first_not_of(" \t\n") != std::string::npos) return *found;
    const toml::node& at = node ? *node : table;
    fault(at, fmt::format("{} {}", key, node ? "must be a text that is not empty" : "is missing"),
          fmt::format("write {} = \"...\"", key));
    return {};
  }

  void check_keys(const toml::table& table, const std::vector<std::string>& known) {
    for (const auto& [key, node] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        fault(node, fmt::format("unknown key '{}'", key.str()), suggestion(key.str(), known));
  }

  void read_kind(const toml::table& top) {
    const auto kinds = catalogue_kinds(entry_.category);
    if (kinds.empty()) return;  // read_top() refuses a kind where there is none
    entry_.kind = text(top, "kind");
    if (entry_.kind.empty() || std::ranges::find(kinds, entry_.kind) != kinds.end()) return;
    fault(*top.get("kind"), fmt::format("unknown kind '{}'", entry_.kind),
          suggestion(entry_.kind, kinds));
    kind_known_ = false;
  }

  void read_top(std::string_view key, const toml::node& node,
                const std::vector<CatalogueKey>& keys) {
    if (key == "title" || key == "about") return;
    if (key == "names") return read_list(node, "names", entry_.names);
    if (key == "kind" && !catalogue_kinds(entry_.category).empty()) return;
    if (key == "jars" && entry_.category == "mills") return read_list(node, "jars", entry_.jars);
    if (key == "parts" && entry_.category == "mills") return read_parts(node);
    if (key == "check") return read_checks(node);
    const auto known = std::ranges::find(keys, key, &CatalogueKey::key);
    if (known != keys.end()) return read_value(*known, node);
    if (!kind_known_) return;  // the keys of an unknown kind are unknown, too
    std::vector<std::string> words{"title", "names", "about", "check"};
    for (const CatalogueKey& k : keys) words.push_back(k.key);
    fault(node, fmt::format("unknown key '{}'", key), suggestion(key, words));
  }

  void read_value(const CatalogueKey& key, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table)
      return fault(node, fmt::format("{} has no source", key.key),
                   fmt::format("write [{}] with value = \"...\" and source = \"...\"", key.key));
    check_keys(*table, {"value", "source", "confidence", "from", "to"});
    CatalogueValue value{text(*table, "value"), text(*table, "source")};
    bool measured = false;
    if (table->contains("confidence")) {
      const std::string word = text(*table, "confidence");
      value.unverified = word == "unverified";
      value.assumed = word == "assumed";
      measured = word == "measured";
      if (!value.unverified && !value.assumed && !measured)
        fault(*table->get("confidence"),
              "confidence can only be \"unverified\", \"assumed\" or \"measured\"",
              "leave it out if the source can be looked up");
    }
    if (!value.text.empty()) check_number(key, value.text, *table->get("value"));
    read_range(key, *table, value.assumed || measured, value);
    entry_.values.emplace(key.key, std::move(value));
  }

  /// `from` and `to` of an assumed or measured number.
  void read_range(const CatalogueKey& key, const toml::table& table, bool ranged,
                  CatalogueValue& value) {
    const bool given = table.contains("from") || table.contains("to");
    const bool wanted = ranged && is_number(key.unit);
    if (given != wanted)
      return fault(
          table,
          wanted ? fmt::format("{} is {} without a range", key.key,
                               value.assumed ? "assumed" : "measured")
                 : fmt::format("{} has a range, but is no assumed or measured number", key.key),
          "give `from` and `to` together with confidence = \"assumed\" or \"measured\"");
    if (!given) return;
    value.range = {text(table, "from"), text(table, "to")};
    const std::array ends{"from", "to"};
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (!value.range[i].empty()) check_number(key, value.range[i], *table.get(ends[i]));
  }

  void check_number(const CatalogueKey& key, const std::string& written, const toml::node& node) {
    if (key.unit == an_axis && written != "vertical" && written != "horizontal")
      fault(node, fmt::format("{} = \"{}\" is not a direction", key.key, written),
            fmt::format("write {}", an_axis));
    if (!is_number(key.unit)) return;
    try {
      const double number = number_of(written, key);
      if (!std::isfinite(number) || !key.range.holds(number))
        fault(node, fmt::format("{} = \"{}\" is out of range", key.key, written), key.about);
    } catch (const UnitError& error) {
      fault(node, fmt::format("{}: {}", key.key, error.what()), key.about);
    }
  }

  void read_list(const toml::node& node, std::string_view key, std::vector<std::string>& into) {
    const auto no_list = [&](const toml::node& at) {
      fault(at, fmt::format("{} must be a list of names", key),
            fmt::format("write {} = [\"...\"]", key));
    };
    const toml::array* list = node.as_array();
    if (!list) return no_list(node);
    for (const toml::node& name : *list) {
      if (const auto found = name.value_exact<std::string>())
        into.push_back(*found);
      else
        no_list(name);
    }
  }

  /// The keys of a part are those of a case, and are checked when a case reads them.
  void read_parts(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (!list || !list->is_array_of_tables())
      return fault(node, "parts must be a list of tables", "write [[parts]]");
    for (const toml::node& part : *list) read_part(*part.as_table());
  }

  void read_part(const toml::table& table) {
    CataloguePart part{.keys = {}, .source = text(table, "source")};
    text(table, "name");
    if (table.contains("confidence")) {
      const std::string word = text(table, "confidence");
      part.unverified = word == "unverified";
      part.assumed = word == "assumed";
      if (!part.unverified && !part.assumed)
        fault(*table.get("confidence"),
              "confidence of a part can only be \"unverified\" or \"assumed\"",
              "leave it out if the source can be looked up");
    }
    for (const auto& [key, node] : table)
      if (key != "source" && key != "confidence")
        part.keys.emplace_back(key.str(), as_written(node));
    entry_.parts.push_back(std::move(part));
  }

  void read_checks(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (!list || !list->is_array_of_tables())
      return fault(node, "check must be a list of tables", "write [[check]]");
    for (const toml::node& check : *list) read_check(*check.as_table());
  }

  void read_check(const toml::table& table) {
    check_keys(table, {"quantity", "equals", "within", "source"});
    CatalogueCheck check{text(table, "quantity"), 0, 0, text(table, "source")};
    std::vector<std::string> known;
    for (const CheckQuantity& q : check_quantities()) known.emplace_back(q.name);
    if (!check.quantity.empty() && std::ranges::find(known, check.quantity) == known.end())
      fault(*table.get("quantity"), fmt::format("unknown quantity '{}'", check.quantity),
            suggestion(check.quantity, known));
    const auto equals = table["equals"].value<double>();
    if (!equals)
      fault(table, "equals must be a number in the quantity's unit", "write equals = 95");
    check.expected = equals.value_or(0);
    const std::string within = text(table, "within");
    if (!within.empty()) check.tolerance = tolerance(within, *table.get("within"));
    entry_.checks.push_back(std::move(check));
  }

  double tolerance(const std::string& within, const toml::node& at) {
    const std::string remedy = "write within = \"2 %\"";
    try {
      const double share = parse_in(within, "");
      if (share > 0 && share < 1) return share;
      fault(at, fmt::format("within = \"{}\" is not a tolerance", within), remedy);
    } catch (const UnitError& error) {
      fault(at, fmt::format("within: {}", error.what()), remedy);
    }
    return 0;
  }

  CatalogueEntry& entry_;
  std::vector<Fault> faults_;
  bool kind_known_ = true;
};

toml::table parsed(std::string_view text, std::string_view file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(Fault{fmt::format("{}:{}", file, error.source().begin.line),
                           std::string(error.description()), "correct the TOML there",
                           std::string(bad_file)});
  }
}

}  // namespace

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string line;  // fmt::join of texts causes a false warning of g++ 12
  for (const std::string& word : words) line.append(line.empty() ? "" : between).append(word);
  return line;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const std::string near = nearest_name(word, known);
  if (!near.empty()) return fmt::format("did you mean '{}'?", near);
  return known.empty() ? "remove it" : "one of: " + joined(known, ", ");
}

CatalogueEntry read_entry(std::string_view text, std::string_view category, std::string_view name,
                          std::string_view file) {
  CatalogueEntry entry;
  entry.category = category;
  entry.name = name;
  entry.file = file;
  EntryReader(entry).read(parsed(text, file));
  return entry;
}

}  // namespace mahlwerk::cases
