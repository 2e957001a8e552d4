// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities that a case would have with more sections than it has.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "mahlwerk/cases/part.hpp"
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
  std::function<void(Case&)> add;
};

void add_powder(Case& mill_case) {
  if (!mill_case.powder) mill_case.powder.emplace();
  mill_case.powder->mass = 1;
}

std::vector<Addition> additions() {
  std::vector<Addition> list{{"[powder] with its mass", add_powder}}, with_powder;
  for (const cases::Part* part : cases::parts())
    for (const cases::PartSection& one : part->sections) {
      if (one.add == nullptr) continue;
      list.push_back({fmt::format("[{}]", one.spec.name), one.add});
      with_powder.push_back({fmt::format("[{}], and [powder] with its mass", one.spec.name),
                             [add = one.add](Case& c) {
                               add(c);
                               add_powder(c);
                             }});
    }
  std::ranges::move(with_powder, std::back_inserter(list));
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
