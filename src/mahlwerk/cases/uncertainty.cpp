// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/uncertainty.hpp"

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::cases {

Case case_of_replicate(const Case& c, std::size_t replicate) {
  Case made = c;
  if (!c.uncertainty) return made;
  made.uncertainty.reset();
  const std::vector<DrawnSections>& all = *c.uncertainty->sections;
  const DrawnSections& drawn =
      all[(static_cast<std::size_t>(c.uncertainty->first) + replicate) % all.size()];
  made.mill = drawn.mill;
  made.contact = drawn.contact;
  return made;
}

}  // namespace mahlwerk::cases
