// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Drives that cannot be reversed, and replicates that do not hold both senses equally.
#include <fmt/format.h>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/reversal.hpp"

namespace mahlwerk::cases {

void bad_reversal(const Case& c, std::vector<Fault>& found) {
  if (!c.milling || !c.milling->reverse) return;
  const std::string at = location_of(c, "milling.reverse");
  if (!has_sense_of_rotation(c)) {
    found.push_back(
        {at, "neither mill nor stirrer has a sense of rotation that could be reversed",
         "remove `reverse`; kinds with a sense are planetary, tumbling, circular, and a "
         "jar of kind \"attritor\" with a rotor_speed",
         "nothing-to-reverse"});
    return;
  }
  if (c.heat && c.heat->cycles == 1)
    found.push_back({at, "the sense of rotation changes after each cycle, and [heat] has one cycle",
                     "write [heat] cycles, for instance cycles = 6, or remove `reverse`",
                     "one-cycle"});
  if (needs_both_senses(c) && c.run.replicates % 2 == 1)
    found.push_back(
        {at,
         fmt::format("jar and gravity are not their own mirror image, so half of the replicates "
                     "must turn the other way, and run.replicates is {}",
                     c.run.replicates),
         fmt::format("write replicates = {}", c.run.replicates + 1), "odd-replicates"});
}

}  // namespace mahlwerk::cases
