// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities that a case would have with more sections than it has.
#include <set>

#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;

std::set<std::string> names(const Case& mill_case) {
  std::set<std::string> all;
  for (const Measure& m : measures(mill_case)) all.insert(m.name);
  return all;
}

struct Addition {
  std::string section;
  void (*add)(Case& mill_case);
};

void add_powder(Case& mill_case) {
  if (!mill_case.powder) mill_case.powder.emplace();
  mill_case.powder->mass = 1;
}

const std::vector<Addition>& additions() {
  static const std::vector<Addition> list{
      {"[powder] with its mass", add_powder},
      {"[wear]", [](Case& c) { c.wear = cases::Wear(); }},
      {"[heat]", [](Case& c) { c.heat = cases::Heat(); }},
      {"[capture]", [](Case& c) { c.capture = cases::Capture(); }},
      {"[grinding]", [](Case& c) { c.grinding = cases::Grinding(); }},
      {"[kinetics]", [](Case& c) { c.kinetics = cases::Kinetics(); }},
      {"[wear], and [powder] with its mass",
       [](Case& c) {
         c.wear = cases::Wear();
         add_powder(c);
       }},
  };
  return list;
}

}  // namespace

std::vector<MissingQuantity> missing_quantities(const Case& mill_case) {
  std::vector<MissingQuantity> found;
  std::set<std::string> known = names(mill_case);
  for (const Addition& addition : additions()) {
    Case more = mill_case;
    addition.add(more);
    for (const std::string& name : names(more))
      if (known.insert(name).second) found.push_back({name, addition.section});
  }
  return found;
}

}  // namespace mahlwerk::results
