// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Notes on powder that is simulated as grains, and on balls with a size distribution.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"

namespace mahlwerk::cases {

std::string grains_note(const Case& c) {
  if (!c.powder || !c.powder->grain_size) return "";
  const double grain = *c.powder->grain_size;
  std::string text = fmt::format("Powder as grains: {} spheres of {}", c.balls.back().count,
                                 show_rounded(grain, "m"));
  if (!c.powder->size) return text + "; the case does not give the powder's own size.";
  const double ratio = grain / *c.powder->size;  // (chg.9)
  if (ratio == 1) return text + ", the powder's own size.";
  return text +
         fmt::format(
             ". Each grain represents {:.4g} particles of {} (coarse-graining ratio {:.4g}): "
             "mass, volume and momentum are the powder's; the number of contacts, their "
             "energies and the surface are not.",
             ratio * ratio * ratio, show_rounded(*c.powder->size, "m"), ratio);  // (chg.10)
}

std::vector<std::string> size_notes(const Case& c) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    const std::vector<SizeClass>& classes = c.balls[i].classes;
    if (classes.empty()) continue;
    std::string list;
    for (const SizeClass& size : classes)
      list += fmt::format("{}{} x {}", list.empty() ? "" : ", ", size.count,
                          show_rounded(size.diameter, "m"));
    notes.push_back(
        fmt::format("Sizes of {}, {} in {} classes: {}.", set_name(c, i),
                    distribution_words()[static_cast<std::size_t>(c.balls[i].distribution.law)],
                    classes.size(), list));
  }
  return notes;
}

}  // namespace mahlwerk::cases
