// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read/many_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mahlwerk::cases {
namespace {

/// A key that [sweep] varies cannot have a value from --set.
void refuse_both(const std::vector<Override>& overrides, const Sweep& sweep, Findings& findings) {
  for (const Override& one : overrides)
    if (one.source == ValueSource::command && !one.unset &&
        std::ranges::find(sweep.keys, one.key, &SweptKey::key) != sweep.keys.end())
      findings.faults.push_back(
          {fmt::format("--set {}", one.key), fmt::format("[sweep] varies {}", one.key),
           "change its values in [sweep], or remove it there", "swept-value"});
}

/// Stores the ranges of [fit]. Keys without a value in the case are marked as fitted keys.
void record_fit(const DottedLists& fit, CaseTree& tree, Case& c) {
  for (const auto& [key, ends] : fit.values) {
    c.fit.emplace(key, FitRange{ends.front(), ends.back()});
    if (value_at(tree.root(), key) == nullptr) tree.findings.fitted_keys.insert(key);
  }
}

/// A key of [uncertainty] cannot have a value from another source.
void refuse_drawn(const Uncertainty& uncertainty, const std::string& key, const std::string& where,
                  Findings& findings) {
  if (std::ranges::find(uncertainty.keys, key, &UncertainKey::key) != uncertainty.keys.end())
    findings.faults.push_back(
        {where, fmt::format("{} varies from replicate to replicate by [uncertainty]", key),
         "remove it from [uncertainty], or remove that section", "drawn-value"});
}

/// [uncertainty], unless the values of a draw are given: then its section was read before.
void read_draws(CaseTree& tree, const std::vector<Override>& overrides, Case& c) {
  const Node* table = tree.section("uncertainty");
  if (table == nullptr ||
      std::ranges::find(overrides, ValueSource::uncertainty, &Override::source) != overrides.end())
    return;
  c.uncertainty = read_uncertainty(table, tree.findings);
  for (const Override& one : overrides)
    if (!one.unset)
      refuse_drawn(
          *c.uncertainty, one.key,
          one.source == ValueSource::command ? "--set " + one.key : section_of(one.source).first,
          tree.findings);
  for (const SweptKey& swept : c.sweep.keys)
    refuse_drawn(*c.uncertainty, swept.key, fmt::format("[sweep] \"{}\"", swept.key),
                 tree.findings);
}
}  // namespace

DottedLists read_many_runs(CaseTree& tree, const std::vector<Override>& overrides, Case& c) {
  Findings& findings = tree.findings;
  tree.apply(overrides, ValueSource::command);
  std::map<std::string, std::string> locations;
  c.sweep = read_sweep(tree.section("sweep"), locations, findings);
  refuse_both(overrides, c.sweep, findings);
  tree.apply(overrides, ValueSource::sweep);
  tree.fill_from_sweep(c.sweep, locations);
  tree.apply_formulas(c.sweep, locations);
  if (const Node* table = tree.section("optimise")) c.optimise = read_optimise(table, findings);
  if (const Node* table = tree.section("match")) c.match = read_match(table, findings);
  tree.apply(overrides, ValueSource::optimise);
  tree.apply(overrides, ValueSource::match);
  DottedLists fit = read_fit(tree.section("fit"), findings);
  for (const auto& [key, ends] : fit.values)
    findings.origins.push_back({.key = "fit." + key,
                                .value = fmt::format("{} to {}", ends.front(), ends.back()),
                                .source = fit.locations.at(key)});
  tree.apply(overrides, ValueSource::fit);
  record_fit(fit, tree, c);
  read_draws(tree, overrides, c);
  tree.apply(overrides, ValueSource::uncertainty);
  return fit;
}

}  // namespace mahlwerk::cases
