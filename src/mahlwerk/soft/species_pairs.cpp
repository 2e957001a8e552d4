// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/species_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::soft {

SpeciesPairs::SpeciesPairs(const std::vector<scene::Ball>& balls, const contact::PairTable& pairs,
                           const contact::AnyLaw& law) {
  std::map<std::tuple<std::int32_t, double, double, double>, std::int32_t> known;
  for (const scene::Ball& b : balls) {
    const auto [at, fresh] = known.try_emplace({b.kind, b.radius, b.density, b.inertia_ratio},
                                               static_cast<std::int32_t>(species_.size()));
    if (fresh)
      species_.push_back({b.radius, b.density, b.mass(), b.inertia(), b.kind, b.inertia_ratio});
    species_index_.push_back(at->second);
  }
  row_length_ = static_cast<std::int32_t>(species_.size()) + pairs.faces();
  std::map<double, double> dampings;  // by restitution: computed once for each value
  const auto make_pair = [&](const contact::Pair& pair, double radius, double mass,
                             double slip_factor) {
    return std::visit(
        [&](const auto& l) {
          SpeciesPair made{{pair, radius, mass, slip_factor}, 0, {}, 0, 0};
          const auto [at, fresh] = dampings.try_emplace(pair.restitution);
          if (fresh) at->second = l.damping(pair.restitution);
          made.damping = at->second;
          made.coefficients = l.coefficients(made.effective, made.damping);
          made.pull_off_distance = l.pull_off_distance(made.effective);
          made.stiffness_ratio = l.stiffness_ratio(made.effective);
          return made;
        },
        law);
  };
  for (const Species& a : species_) {
    for (const Species& b : species_)
      pairs_.push_back(
          make_pair(pairs.balls(a.kind, b.kind), a.radius * b.radius / (a.radius + b.radius),
                    a.mass * b.mass / (a.mass + b.mass),
                    contact::slip_factor({a.mass, a.inertia_ratio}, {b.mass, b.inertia_ratio})));
    for (int face = 0; face < pairs.faces(); ++face)
      pairs_.push_back(make_pair(pairs.wall(a.kind, face), a.radius, a.mass,
                                 contact::slip_factor(a.inertia_ratio)));
  }
}

SizeClasses::SizeClasses(std::span<const Species> species, int most)
    : smallest(std::ranges::min(species, {}, &Species::radius).radius) {
  const auto octave = [&](double r) {
    return std::min(static_cast<int>(std::floor(math::log2(r / smallest))), most - 1);
  };
  std::map<int, std::int32_t> numbers;
  for (const Species& s : species) numbers[octave(s.radius)] = 0;
  for (std::int32_t next = 0; auto& [at, number] : numbers) number = next++;
  radius.resize(numbers.size());
  for (const Species& s : species) {
    of.push_back(numbers[octave(s.radius)]);
    double& widest = radius[static_cast<std::size_t>(of.back())];
    widest = std::max(widest, s.radius);
  }
}

}  // namespace mahlwerk::soft
