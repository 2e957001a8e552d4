// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [sweep]: keys of the case that vary, and the design.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/key_reader.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/sweep_words.hpp"
#include "mahlwerk/cases/sections/writer.hpp"

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
        fault(fmt::format("\"{}\" and \"{}\" vary together but take {} and {} values", keys.front(),
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

/// Checks the keys against the requirements of the design.
void check_design(const Node& table, const Sweep& sweep, const KeyReader::Locations& locations,
                  Findings& findings) {
  const std::string& word = design_words()[static_cast<std::size_t>(sweep.design)];
  for (const SweptKey& key : sweep.keys) {
    if (needs_ranges(sweep.design) && !key.range)
      findings.faults.push_back(
          {locations.at(key.key),
           fmt::format("design = \"{}\" takes ranges, \"{}\" is a list", word, key.key),
           fmt::format("write \"{}\" = {{ from = ..., to = ... }}", key.key), "bad-design"});
    if (needs_ranges(sweep.design) && key.steps > 0)
      findings.faults.push_back(
          {locations.at(key.key),
           fmt::format("steps has no meaning under design = \"{}\": it draws from the range", word),
           "remove it, or write design = \"grid\"", "too-much"});
    if (!needs_ranges(sweep.design) && key.range && key.steps == 0)
      findings.faults.push_back(
          {locations.at(key.key), fmt::format("the range of \"{}\" lacks `steps`", key.key),
           "give the number of its values: steps = 5; or choose a design that draws from "
           "ranges: design = \"latin-hypercube\"",
           "bad-range"});
  }
  if (needs_samples(sweep.design) && table.find("samples") == nullptr)
    findings.faults.push_back({table.where, fmt::format("design = \"{}\" lacks `samples`", word),
                               "write for instance samples = 32", "missing-value"});
  if (!needs_samples(sweep.design) && table.find("samples") != nullptr)
    findings.faults.push_back({table.find("samples")->where,
                               fmt::format("samples has no meaning under design = \"{}\"", word),
                               "remove it, or choose another design", "too-much"});
  if (needs_ranges(sweep.design) && !sweep.together.empty())
    findings.faults.push_back({table.find("together")->where,
                               fmt::format("together has no meaning under design = \"{}\"", word),
                               "let one key follow from the other: \"jar.height\" = \"= 2 * "
                               "jar.diameter\"",
                               "too-much"});
  if (!sweep.derived.empty() && locations.size() == sweep.derived.size())
    findings.faults.push_back(
        {table.where, "[sweep] has formulas, but no key that varies",
         "vary a key of the case: \"mill.speed\" = [\"300 rpm\", \"400 rpm\"]", "bad-design"});
}

}  // namespace

Sweep read_sweep(const Node* table, KeyReader::Locations& locations, Findings& findings) {
  Sweep sweep;
  if (table == nullptr || table->kind != Node::Kind::table) return sweep;
  SectionReader in(table, "sweep", findings);
  const std::string word =
      in.gives("design") ? in.choice({"design", design_words(), ""}) : design_words().front();
  if (!word.empty())
    sweep.design =
        static_cast<Design>(std::ranges::find(design_words(), word) - design_words().begin());
  if (const auto n = in.integer("samples", max_samples)) sweep.samples = *n;
  KeyReader reader("sweep", locations, findings);
  reader.read(*table, {"design", "samples", "together"});
  sweep.keys = reader.keys();
  sweep.derived = reader.derived();
  std::ranges::sort(sweep.keys, {}, &SweptKey::key);
  sweep.together = read_together(table->find("together"), sweep, findings);
  if (!word.empty()) check_design(*table, sweep, locations, findings);
  return sweep;
}

void list_sweep_keys(KeyVisitor& v) {
  Sweep sweep;
  const auto none = [] { return std::string(); };
  v.word({"design",
          design_words(),
          design_words().front(),
          "every combination of the values",
          "how the points of the campaign are chosen",
          {"every combination; for curves and maps",
           "the range of each key is sampled evenly; for many keys and few runs",
           "evenly distributed over all keys; more samples begin with the same points",
           "the case itself, then each key alone at both ends of its range",
           "elementary effects: which keys matter, and which only in combination",
           "share of each key in the variance"}},
         sweep.design);
  if (needs_samples(sweep.design))
    v.integer({"samples", 1, max_samples,
               "number of points; trajectories of morris, base points of sobol-indices"},
              sweep.samples);
  if (!needs_ranges(sweep.design))
    v.custom({.key = "together",
              .about = "groups of keys whose lists advance together",
              .default_text = "each key varies by itself"},
             none);
  v.custom(
      {.key = any_key,
       .about =
           "a key of the case by its dotted name: a list of values, a range with from, to, steps "
           "and spacing, or a formula that begins with =",
       .required = true},
      none);
}

void write(Writer& out, const Sweep& sweep) {
  out.section("sweep");
  out.plain("design", in_quotes(design_words()[static_cast<std::size_t>(sweep.design)]));
  if (sweep.samples > 0) out.plain("samples", std::to_string(sweep.samples));
  std::string groups;
  for (const auto& group : sweep.together)
    groups += (groups.empty() ? "" : ", ") + list_text(group);
  if (!groups.empty()) out.plain("together", "[" + groups + "]");
  for (const SweptKey& key : sweep.keys) out.plain(in_quotes(key.key), values_text(key));
  for (const auto& [key, formula] : sweep.derived)
    out.plain(in_quotes(key), in_quotes("=" + formula));
}

}  // namespace mahlwerk::cases
