// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [fit]: keys of the case, each with the range to search.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/key_reader.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/writer.hpp"
#include "mahlwerk/cases/write.hpp"

namespace mahlwerk::cases {
namespace {

class RangeReader {
 public:
  explicit RangeReader(Findings& findings) : findings_(findings) {}

  DottedLists read(const Node* table) {
    if (table != nullptr && table->kind == Node::Kind::table) read_table(*table, "");
    return std::move(lists_);
  }

 private:
  void read_table(const Node& table, const std::string& prefix) {
    for (const auto& [key, node] : table.members) {
      if (node.kind == Node::Kind::table)
        read_table(node, prefix + key + ".");
      else
        read_values(prefix + key, node);
    }
  }
  void read_values(const std::string& key, const Node& node) {
    std::vector<std::string> values;
    bool sound = node.kind == Node::Kind::list && node.items.size() == 2;
    for (const Node& item : node.items) {
      sound = sound && (item.kind == Node::Kind::text || item.kind == Node::Kind::number ||
                        item.kind == Node::Kind::boolean);
      values.push_back(item.text);
    }
    if (!sound)
      findings_.faults.push_back(
          {node.where, fmt::format("\"{}\" must be two values, the least and the most", key),
           fmt::format("write \"{}\" = [\"...\", \"...\"], texts or numbers", key), "wrong-type"});
    else
      lists_.values.emplace(key, std::move(values));
    lists_.locations.emplace(key, node.where);
  }

  Findings& findings_;
  DottedLists lists_;
};

/// Reports ends of a range of a key of the mill that are no quantities, or do not increase. Whether
/// the key exists is found when it gets a value.
void check_range_of_run(const std::string& key, const FitRange& range, const std::string& location,
                        Findings& findings) {
  const auto fault = [&](std::string what, std::string remedy, const char* code) {
    findings.faults.push_back(
        {location, fmt::format("{} of [fit]: {}", key, what), std::move(remedy), code});
  };
  try {
    const Quantity least = parse_quantity(range[0]), most = parse_quantity(range[1]);
    if (least.dimension != most.dimension)
      fault(fmt::format("\"{}\" and \"{}\" have different units", range[0], range[1]),
            "give both ends in units of the same kind", "bad-quantity");
    else if (!(least.value < most.value))
      fault(fmt::format("\"{}\" is not below \"{}\"", range[0], range[1]),
            "write the least first, then the most", "out-of-range");
  } catch (const UnitError& error) {
    fault(error.what(), "write two numbers with their units, the least and the most",
          "bad-quantity");
  }
}

/// Reports ends of a range that cannot be read, lie outside the range of the number, or do not
/// increase.
void check_range(const FitParameter& number, const FitRange& range, const std::string& location,
                 Findings& findings) {
  std::array<double, 2> ends{};
  for (std::size_t i = 0; i < 2; ++i) {
    try {
      ends[i] = parse_in(range[i], number.unit);
    } catch (const UnitError& error) {
      findings.faults.push_back({location, fmt::format("{} of [fit]: {}", number.key, error.what()),
                                 fmt::format("write for instance \"{}\"", example_of(number.unit)),
                                 "bad-quantity"});
      return;
    }
    if (!number.range.holds(ends[i]))
      findings.faults.push_back(
          {location, fmt::format("{} of [fit]: \"{}\" is out of range", number.key, range[i]),
           fmt::format("{}: {}", number.about, range_text(number.range, number.unit)),
           "out-of-range"});
  }
  if (!(ends[0] < ends[1]))
    findings.faults.push_back(
        {location,
         fmt::format("{} of [fit]: \"{}\" is not below \"{}\"", number.key, range[0], range[1]),
         "write the least first, then the most", "out-of-range"});
}

}  // namespace

DottedLists read_fit(const Node* table, Findings& findings) {
  return RangeReader(findings).read(table);
}

void check_fit(const Case& c, const std::map<std::string, std::string>& locations,
               Findings& findings) {
  const std::vector<FitParameter> all = fit_parameters(c);
  const bool sound = findings.faults.empty();  // otherwise a model may be unknown
  for (const auto& [key, range] : c.fit) {
    const std::string& location = locations.at(key);
    const auto number = std::ranges::find(all, key, &FitParameter::key);
    if (is_key_of_run(key)) {
      check_range_of_run(key, range, location, findings);
    } else if (number == all.end()) {
      if (!sound) continue;
      std::vector<std::string> known;
      for (const FitParameter& one : all) known.push_back(one.key);
      const std::string near = nearest_word(key, known);
      findings.faults.push_back(
          {location, fmt::format("[fit] cannot choose {}", key),
           !near.empty() ? fmt::format("did you mean \"{}\"?", near)
           : known.empty()
               ? "it chooses keys of [contact], [mill], [jar], [[balls]] and [power_meter], and "
                 "numbers of [capture], [breakage], [fragments], [grinding] and [kinetics], of "
                 "which the case "
                 "has none"
               : fmt::format("it may choose {}, or a key of [contact], [mill], [jar], [[balls]] "
                             "or [power_meter]",
                             quoted_list(known)),
           "unknown-key"});
      continue;
    } else {
      check_range(*number, range, location, findings);
    }
    if (findings.fitted_keys.contains(key))
      findings.faults.push_back(
          {location, fmt::format("{} has no value yet: [fit] only gives the range to search", key),
           "`mahlwerk fit case.toml data.csv` finds it from measurements, or give one",
           "unfitted"});
  }
}

void list_fit_keys(KeyVisitor& v) {
  v.custom(
      {.key = any_key,
       .about =
           "the dotted name of a key of [contact], [mill], [jar], [[balls]] or [power_meter], "
           "or of a number of [capture], [breakage], [fragments], [grinding] or [kinetics], with "
           "the least and the largest value of the search",
       .required = true},
      [] { return std::string(); });
}

void write(Writer& out, const std::map<std::string, FitRange>& fit) {
  out.section("fit");
  for (const auto& [key, ends] : fit) out.plain(in_quotes(key), list_text({ends[0], ends[1]}));
}

}  // namespace mahlwerk::cases
