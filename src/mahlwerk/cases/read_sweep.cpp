// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [sweep], [optimise] and [match]: keys of the case that vary, and what is looked for.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mahlwerk/cases/read_parts.hpp"
#include "mahlwerk/cases/sweep_words.hpp"

namespace mahlwerk::cases {

const std::vector<std::string>& design_words() {
  static const std::vector<std::string> words{"grid",          "latin-hypercube", "sobol",
                                              "one-at-a-time", "morris",          "sobol-indices"};
  return words;
}

const std::vector<std::string>& spacing_words() {
  static const std::vector<std::string> words{"linear", "logarithmic"};
  return words;
}

namespace {

using Places = std::map<std::string, std::string>;

bool is_value(const Node& node) {
  return node.kind == Node::Kind::text || node.kind == Node::Kind::number ||
         node.kind == Node::Kind::boolean;
}

/// A formula stands behind an equals sign: "= 5 ml / jar.diameter".
bool is_formula(const Node& node) {
  return node.kind == Node::Kind::text && node.text.starts_with('=');
}

bool is_range(const Node& node) {
  return node.kind == Node::Kind::table && (node.find("from") != nullptr || node.find("to"));
}

/// Reads dotted keys of one section, each with the values it takes.
class KeyReader {
 public:
  KeyReader(std::string section, Places& places, Findings& findings)
      : section_(std::move(section)), places_(places), findings_(findings) {}

  /// Keys of `table` but the names in `own`, which are the section's.
  void read(const Node& table, const std::set<std::string_view>& own = {}) {
    for (const auto& [key, node] : table.members)
      if (!own.contains(key)) read_key(key, node);
  }

  std::vector<SweptKey> keys() { return std::move(keys_); }
  std::map<std::string, std::string> derived() { return std::move(derived_); }

 private:
  void fault(const Node& at, std::string what, std::string remedy, const char* code) {
    findings_.faults.push_back({at.where, std::move(what), std::move(remedy), code});
  }

  void read_key(const std::string& key, const Node& node) {
    if (const std::string section = key.substr(0, key.find('.'));
        section == "sweep" || section == "optimise" || section == "match" || section == "fit") {
      fault(node, fmt::format("\"{}\" is no value of a run", key),
            "name what a mill's user sets: \"mill.speed\"", "bad-range");
      return;
    }
    if (node.kind == Node::Kind::table && !is_range(node)) {
      for (const auto& [below, value] : node.members) read_key(key + "." + below, value);
      return;
    }
    if (!places_.emplace(key, node.where).second) return;
    if (is_formula(node))
      derived_.emplace(key, node.text.substr(1));
    else if (is_range(node))
      read_range(key, node);
    else
      read_list(key, node);
  }

  void read_range(const std::string& key, const Node& node) {
    Section in(&node, section_, findings_);
    SweptKey made{.key = key, .values = {}, .range = true};
    for (const char* end : {"from", "to"}) {
      const Node* at = in.find(end);
      if (at != nullptr && is_value(*at)) {
        made.values.push_back(at->text);
        continue;
      }
      fault(at != nullptr ? *at : node, fmt::format("the range of \"{}\" lacks `{}`", key, end),
            fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key), "bad-range");
    }
    if (const auto steps = in.whole("steps", most_steps, 2)) made.steps = *steps;
    made.logarithmic = in.gives("spacing") &&
                       in.choice({"spacing", spacing_words(), ""}) == spacing_words().back();
    in.close();
    if (made.values.size() == 2) keys_.push_back(std::move(made));
  }

  void read_list(const std::string& key, const Node& node) {
    SweptKey made{.key = key, .values = {}};
    for (const Node& item : node.items) made.values.push_back(item.text);
    const bool sound = node.kind == Node::Kind::list && !node.items.empty() &&
                       std::ranges::all_of(node.items, is_value) &&
                       std::ranges::none_of(node.items, &std::string::empty, &Node::text);
    if (sound)
      keys_.push_back(std::move(made));
    else
      fault(
          node,
          fmt::format(
              "\"{}\" must be a list of values, none of them empty, or a range or a formula", key),
          fmt::format("write \"{0}\" = [\"...\", \"...\"], \"{0}\" = {{ from = \"...\", to = "
                      "\"...\", steps = 5 }} or \"{0}\" = \"= 2 * other.key\"",
                      key),
          "wrong-type");
  }

  std::string section_;
  Places& places_;
  Findings& findings_;
  std::vector<SweptKey> keys_;
  std::map<std::string, std::string> derived_;
};

std::vector<std::vector<std::string>> read_together(const Node* at, const Sweep& sweep,
                                                    Findings& findings) {
  std::vector<std::vector<std::string>> groups;
  if (at == nullptr) return groups;
  const auto fault = [&](std::string what) {
    findings.faults.push_back(
        {at->where, std::move(what),
         "write together = [[\"mill.speed\", \"run.time\"]]: keys of [sweep] whose lists are "
         "equally long",
         "bad-together"});
  };
  std::set<std::string> used;
  for (const Node& group : at->items) {
    std::vector<std::string> keys;
    std::size_t length = 0;
    for (const Node& item : group.items) {
      const auto key = std::ranges::find(sweep.keys, item.text, &SweptKey::key);
      if (key == sweep.keys.end()) {
        fault(fmt::format("`together` names \"{}\", which [sweep] does not vary", item.text));
        return {};
      }
      const std::size_t own =
          key->range ? static_cast<std::size_t>(key->steps) : key->values.size();
      if (!keys.empty() && own != length) {
        fault(fmt::format("\"{}\" and \"{}\" go together but take {} and {} values", keys.front(),
                          item.text, length, own));
        return {};
      }
      length = own;
      if (!used.insert(item.text).second) {
        fault(fmt::format("`together` names \"{}\" twice", item.text));
        return {};
      }
      keys.push_back(item.text);
    }
    groups.push_back(std::move(keys));
  }
  const bool sound = at->kind == Node::Kind::list && !groups.empty() &&
                     std::ranges::all_of(groups, [](const auto& g) { return g.size() >= 2; });
  if (!sound) fault("`together` must be a list of lists of keys");
  return groups;
}

/// What a design asks of its keys.
void check_design(const Node& table, const Sweep& sweep, const Places& places, Findings& findings) {
  const std::string& word = design_words()[static_cast<std::size_t>(sweep.design)];
  for (const SweptKey& key : sweep.keys) {
    if (needs_ranges(sweep.design) && !key.range)
      findings.faults.push_back(
          {places.at(key.key),
           fmt::format("design = \"{}\" takes ranges, \"{}\" is a list", word, key.key),
           fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key.key), "bad-design"});
    if (!needs_ranges(sweep.design) && key.range && key.steps == 0)
      findings.faults.push_back(
          {places.at(key.key), fmt::format("the range of \"{}\" lacks `steps`", key.key),
           "say how many values of it are run: steps = 5; or choose a design that draws from "
           "ranges: design = \"latin-hypercube\"",
           "bad-range"});
  }
  if (needs_samples(sweep.design) && sweep.samples == 0)
    findings.faults.push_back({table.where, fmt::format("design = \"{}\" lacks `samples`", word),
                               "write for instance samples = 32", "missing-value"});
  if (!needs_samples(sweep.design) && sweep.samples > 0)
    findings.faults.push_back({table.find("samples")->where,
                               fmt::format("samples has no meaning under design = \"{}\"", word),
                               "take it out, or choose another design", "too-much"});
  if (needs_ranges(sweep.design) && !sweep.together.empty())
    findings.faults.push_back({table.find("together")->where,
                               fmt::format("together has no meaning under design = \"{}\"", word),
                               "let one key follow from the other: \"jar.height\" = \"= 2 * "
                               "jar.diameter\"",
                               "too-much"});
  if (sweep.keys.empty() && !sweep.derived.empty())
    findings.faults.push_back(
        {table.where, "[sweep] has formulas, but nothing that varies",
         "vary a key of the case: \"mill.speed\" = [\"300 rpm\", \"400 rpm\"]", "bad-design"});
}

/// A section with `over`, `settings` and `replicates`.
template <class Looks>
void read_search(Section& in, const Node& table, Looks& looks) {
  if (const auto n = in.whole("settings", 100'000, 4)) looks.settings = *n;
  if (const auto n = in.whole("replicates", 100'000, 2)) looks.replicates = *n;
  Places places;
  KeyReader keys(in.name(), places, in.findings());
  const Node* over = in.find("over");
  if (over != nullptr && over->kind == Node::Kind::table) keys.read(*over);
  looks.over = keys.keys();
  if (looks.over.empty()) {
    in.fault(over != nullptr ? *over : table, fmt::format("{} has nothing to choose", in.heading()),
             "write over = { \"mill.speed\" = { from = \"200 rpm\", to = \"600 rpm\" } }",
             "bad-range");
    return;
  }
  for (const SweptKey& key : looks.over)
    if (key.key == "seed" || key.key == "run.replicates" || key.steps > 0)
      in.fault(*over,
               key.steps > 0
                   ? fmt::format("\"{}\" is searched between its ends: it has no steps", key.key)
                   : fmt::format("\"{}\" is nothing to look for a best value of", key.key),
               "take it out", "bad-range");
  const auto derived = keys.derived();
  const auto listed_key = std::ranges::find(looks.over, false, &SweptKey::range);
  if (listed_key != looks.over.end() || !derived.empty()) {
    const std::string& key =
        listed_key != looks.over.end() ? listed_key->key : derived.begin()->first;
    in.fault(*over, fmt::format("\"{}\" must be a range", key),
             fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key), "bad-range");
  }
}

std::vector<Limit> read_limits(Section& in) {
  std::vector<Limit> limits;
  const Node* table = in.find("limits");
  if (table == nullptr) return limits;
  for (const auto& [quantity, node] : table->members) {
    const bool below = node.text.starts_with("below "), above = node.text.starts_with("above ");
    if (node.kind != Node::Kind::text || !(below || above))
      in.fault(node,
               fmt::format("the limit of {} must be \"below ...\" or \"above ...\"", quantity),
               fmt::format("write {} = \"below 1 mg/h\"", quantity), "bad-limit");
    else
      limits.push_back({quantity, below, node.text.substr(6)});
  }
  if (limits.empty() && table->members.empty())
    in.fault(*table, "`limits` must be a table of quantities",
             "write limits = { wear_rate = \"below 1 mg/h\" }", "bad-limit");
  return limits;
}

}  // namespace

Sweep read_sweep(const Node* table, Places& places, Findings& findings) {
  Sweep sweep;
  if (table == nullptr || table->kind != Node::Kind::table) return sweep;
  const std::size_t before = findings.faults.size();
  Section in(table, "sweep", findings);
  if (in.gives("design")) {
    const std::string word = in.choice({"design", design_words(), ""});
    if (word.empty()) return sweep;
    sweep.design =
        static_cast<Design>(std::ranges::find(design_words(), word) - design_words().begin());
  }
  if (const auto n = in.whole("samples", most_samples)) sweep.samples = *n;
  KeyReader reader("sweep", places, findings);
  reader.read(*table, {"design", "samples", "together"});
  sweep.keys = reader.keys();
  sweep.derived = reader.derived();
  std::ranges::sort(sweep.keys, {}, &SweptKey::key);
  sweep.together = read_together(table->find("together"), sweep, findings);
  if (findings.faults.size() == before) check_design(*table, sweep, places, findings);
  return sweep;
}

Optimise read_optimise(const Node* table, Findings& findings) {
  Optimise wanted;
  Section in(table, "optimise", findings);
  const std::string_view goal = in.one_of({"maximise", "minimise"});
  if (goal.empty())
    in.missing("maximise", "the quantity of the summary that is looked at",
               "write for instance maximise = \"dissipated_power\", or minimise = \"d50\"");
  else if (const auto quantity = in.text(goal))
    wanted.quantity = *quantity;
  wanted.maximise = goal != "minimise";
  wanted.limits = read_limits(in);
  read_search(in, *table, wanted);
  in.close();
  return wanted;
}

Match read_match(const Node* table, Findings& findings) {
  Match wanted;
  Section in(table, "match", findings);
  read_search(in, *table, wanted);
  in.close();
  return wanted;
}

}  // namespace mahlwerk::cases
