// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [optimise] and [match]: targets and search ranges.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/key_reader.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/writer.hpp"

namespace mahlwerk::cases {
namespace {

/// Records the location of each range, for faults of values in it.
void record_ranges(SectionReader& in, const Node& over, const std::vector<SweptKey>& keys) {
  for (const SweptKey& key : keys) {
    const Node* direct = over.find(key.key);
    const Node* at = direct != nullptr ? direct : value_at(over, key.key);
    in.record_origin("over." + key.key,
                     fmt::format("{} to {}", key.values.front(), key.values.back()),
                     at != nullptr ? at : &over);
  }
}

const IntegerSpec most_settings{.key = "settings",
                                .least = 4,
                                .most = 100'000,
                                .about = "largest number of settings that are tried",
                                .standard = Optimise().settings,
                                .source = "project convention"};
const IntegerSpec most_replicates{.key = "replicates",
                                  .least = 2,
                                  .most = 100'000,
                                  .about = "largest number of replicates of one setting",
                                  .standard = Optimise().replicates,
                                  .source = "project convention"};

/// A section with `over`, `settings` and `replicates`.
template <class Search>
void read_search(SectionReader& in, const Node& table, Search& search) {
  const auto read = [&](const IntegerSpec& spec, std::int64_t& value) {
    if (const auto n = in.integer(spec.key, spec.most, spec.least)) value = *n;
  };
  read(most_settings, search.settings);
  read(most_replicates, search.replicates);
  KeyReader::Locations locations;
  KeyReader keys(in.name(), locations, in.findings());
  const Node* over = in.find("over");
  if (over != nullptr && over->kind == Node::Kind::table) keys.read(*over);
  search.over = keys.keys();
  if (over != nullptr) record_ranges(in, *over, search.over);
  if (search.over.empty()) {
    in.fault(
        over != nullptr ? *over : table, fmt::format("{} has no key to search over", in.heading()),
        "write over = { \"mill.speed\" = { from = \"200 rpm\", to = \"600 rpm\" } }", "bad-range");
    return;
  }
  for (const SweptKey& key : search.over)
    if (key.key == "seed" || key.key == "run.replicates" || key.steps > 0)
      in.fault(*over,
               key.steps > 0
                   ? fmt::format("\"{}\" is searched between its ends: it has no steps", key.key)
                   : fmt::format("\"{}\" has no best value to search for", key.key),
               "remove it", "bad-range");
  const auto derived = keys.derived();
  const auto listed_key = std::ranges::find(search.over, false, &SweptKey::range);
  if (listed_key != search.over.end() || !derived.empty()) {
    const std::string& key =
        listed_key != search.over.end() ? listed_key->key : derived.begin()->first;
    in.fault(*over, fmt::format("\"{}\" must be a range", key),
             fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key), "bad-range");
  }
}

std::vector<Limit> read_limits(SectionReader& in) {
  std::vector<Limit> limits;
  const Node* table = in.find("limits");
  if (table == nullptr) return limits;
  for (const auto& [quantity, node] : table->members) {
    in.record_origin("limits." + quantity, node.text, &node);
    const bool below = node.text.starts_with("below "), above = node.text.starts_with("above ");
    if (node.kind != Node::Kind::text || !(below || above))
      in.fault(node,
               fmt::format("the limit of {} must be \"below ...\" or \"above ...\"", quantity),
               fmt::format("write for instance {} = \"below 1 mg/h\"", quantity), "bad-limit");
    else
      limits.push_back({quantity, below, node.text.substr(6)});
  }
  if (limits.empty() && table->members.empty())
    in.fault(*table, "`limits` must be a table of quantities",
             "write limits = { wear_rate_jar = \"below 1 mg/h\" }", "bad-limit");
  return limits;
}

template <class Search>
void write_search(Writer& out, const Search& search) {
  out.plain("settings", std::to_string(search.settings));
  out.plain("replicates", std::to_string(search.replicates));
  std::string over;
  for (const SweptKey& key : search.over)
    over +=
        fmt::format("{}{} = {}", over.empty() ? "" : ", ", in_quotes(key.key), values_text(key));
  out.plain("over", "{ " + over + " }");
}

}  // namespace

Optimise read_optimise(const Node* table, Findings& findings) {
  Optimise search;
  SectionReader in(table, "optimise", findings);
  const std::string_view goal = in.one_of({"maximise", "minimise"});
  if (goal.empty())
    in.missing("maximise", "the quantity of the summary to make largest",
               "write for instance maximise = \"dissipated_power\", or minimise = \"d50\"");
  else if (const auto quantity = in.text(goal))
    search.quantity = *quantity;
  search.maximise = goal != "minimise";
  search.limits = read_limits(in);
  read_search(in, *table, search);
  in.report_unknown_keys();
  return search;
}

void list_match_keys(KeyVisitor& v) {
  Match search;
  v.custom({.key = "over",
            .about = "keys of the case with the range in which they are searched, from and to",
            .type = "table",
            .required = true},
           [] { return std::string(); });
  v.integer(most_settings, search.settings);
  v.integer(most_replicates, search.replicates);
}

void list_optimise_keys(KeyVisitor& v) {
  const auto none = [] { return std::string(); };
  v.custom({.key = "maximise",
            .about = "quantity of the summary to make largest",
            .type = "text",
            .required = true},
           none);
  v.custom({.key = "minimise",
            .about = "quantity of the summary to make smallest",
            .type = "text",
            .instead = "maximise"},
           none);
  v.custom({.key = "limits",
            .about = "quantities of the summary with a bound that a setting must keep: "
                     "\"below 1 mg/h\" or \"above ...\"",
            .type = "table",
            .default_text = "no limits"},
           none);
  list_match_keys(v);
}

Match read_match(const Node* table, Findings& findings) {
  Match search;
  SectionReader in(table, "match", findings);
  read_search(in, *table, search);
  in.report_unknown_keys();
  return search;
}

void write(Writer& out, const Optimise& search) {
  out.section("optimise");
  out.plain(search.maximise ? "maximise" : "minimise", in_quotes(search.quantity));
  std::string limits;
  for (const Limit& limit : search.limits)
    limits += fmt::format("{}{} = {}", limits.empty() ? "" : ", ", in_quotes(limit.quantity),
                          in_quotes((limit.below ? "below " : "above ") + limit.bound));
  if (!limits.empty()) out.plain("limits", "{ " + limits + " }");
  write_search(out, search);
}

void write(Writer& out, const Match& search) {
  out.section("match");
  write_search(out, search);
}

}  // namespace mahlwerk::cases
