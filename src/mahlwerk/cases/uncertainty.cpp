// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/uncertainty.hpp"

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/reversal.hpp"

namespace mahlwerk::cases {

std::size_t distinct_replicates(const Case& c) {
  return (c.uncertainty ? c.uncertainty->count() : 1) * (needs_both_senses(c) ? 2 : 1);
}

Case case_of_replicate(const Case& c, std::size_t replicate) {
  Case made = c;
  if (!c.uncertainty) return CaseBySense(made).of(replicate);
  made.uncertainty.reset();
  const std::vector<DrawnSections>& all = *c.uncertainty->sections;
  const DrawnSections& drawn =
      all[(static_cast<std::size_t>(c.uncertainty->first) + replicate) % all.size()];
  made.mill = drawn.mill;
  made.contact = drawn.contact;
  return CaseBySense(made).of(replicate);
}

}  // namespace mahlwerk::cases
