// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/ball_charge.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

double sphere_volume(double diameter) {
  return std::numbers::pi / 6 * diameter * diameter * diameter;
}

double sphere_diameter(double volume) {
  return math::cbrt(6 / std::numbers::pi * volume);
}

double Cohort::volume() const {
  return number * sphere_volume(diameter);
}

double volume_of(const BallCharge& charge) {
  double sum = 0;
  for (const Cohort& c : charge) sum += c.volume();
  return sum;
}

double wear_down(BallCharge& charge, const std::vector<double>& volumes) {
  double lost = 0;
  for (std::size_t i = 0; i < charge.size(); ++i) {
    const double whole = sphere_volume(charge[i].diameter), worn = std::min(volumes[i], whole);
    charge[i].diameter = sphere_diameter(whole - worn);
    lost += charge[i].number * worn;
  }
  std::ranges::stable_sort(charge, std::greater<>(), &Cohort::diameter);
  return lost;
}

double scrap_below(BallCharge& charge, double size) {
  double left = 0;
  for (const Cohort& c : charge)
    if (c.diameter < size) left += c.volume();
  std::erase_if(charge, [&](const Cohort& c) { return c.diameter < size; });
  return left;
}

void add_fresh(BallCharge& charge, double size, double volume) {
  if (!(volume > 0)) return;
  const Cohort fresh{size, volume / sphere_volume(size)};
  const auto at = std::ranges::find_if(charge, [&](const Cohort& c) { return c.diameter < size; });
  charge.insert(at, fresh);
}

void join_cohorts(BallCharge& charge, std::size_t most) {
  while (charge.size() > most) {
    std::size_t alike = 0;
    const auto step = [&](std::size_t i) { return charge[i].diameter - charge[i + 1].diameter; };
    for (std::size_t i = 0; i + 1 < charge.size(); ++i)
      if (step(i) < step(alike)) alike = i;
    Cohort &one = charge[alike], &other = charge[alike + 1];
    const double number = one.number + other.number, volume = one.volume() + other.volume();
    one = {sphere_diameter(volume / number), number};
    charge.erase(charge.begin() + static_cast<std::ptrdiff_t>(alike) + 1);
  }
}

std::vector<long long> whole_numbers(const BallCharge& charge) {
  std::vector<long long> numbers;
  double carried = 0;  // [m3]
  for (const Cohort& c : charge) {
    const double one = sphere_volume(c.diameter), wanted = c.volume() + carried;
    const double number = std::max(0.0, std::floor(wanted / one + 0.5));
    numbers.push_back(static_cast<long long>(number));
    carried = wanted - number * one;
  }
  return numbers;
}

double steady_mass_below(double size, double scrap, double fresh, double exponent) {
  const auto moment = [&](double d) { return math::pow(d / fresh, 4 - exponent); };
  const double least = moment(scrap);
  return (moment(std::clamp(size, scrap, fresh)) - least) / (1 - least);
}

}  // namespace mahlwerk::powder
