// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/jar_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/geometry/capsule.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/rounded_cylinder.hpp"
#include "mahlwerk/geometry/sphere.hpp"
#include "mahlwerk/measure/propagation.hpp"

namespace mahlwerk::measure {
namespace {

using observe::Estimate;

constexpr Estimate water_density{998.2, 1.1};  // [kg/m3] 20 degC; 15 to 25 degC

InputError jar_fault(std::string what, std::string remedy) {
  return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
}

/// Mean of the readings, with the scatter of the mean and the error of the instrument.
Estimate mean_reading(const std::vector<double>& readings, double instrument,
                      std::string_view name) {
  std::vector<double> values;
  std::ranges::copy_if(readings, std::back_inserter(values),
                       [](double v) { return !std::isnan(v); });
  if (values.empty())
    throw jar_fault(
        fmt::format("there is no {}", name),
        "give columns \"diameter (mm), depth (mm), water (g)\" as the shape needs them");
  for (const double value : values)
    if (!(value > 0 && value < 1e3))
      throw jar_fault(fmt::format("a {} is {:g} in SI units", name, value),
                      "correct the reading or the unit of its column");
  const Estimate made = observe::estimate(values);
  const double scatter = std::isnan(made.ci95) ? 0 : made.ci95;
  return {made.mean, std::sqrt(scatter * scatter + instrument * instrument)};
}

/// [m3] Volume of the shape.
double volume_of(std::string_view shape, double diameter, double height, double fillet) {
  if (shape == "sphere") return geometry::Sphere{diameter}.volume();
  if (shape == "capsule") return geometry::Capsule{diameter, height}.volume();
  if (shape == "cylinder") return geometry::Cylinder{diameter, height}.volume();
  return geometry::RoundedCylinder{diameter, height, fillet}.volume();
}

/// The fillet with which a rounded cylinder has the volume; a half or 0 where none has.
double fillet_for(double diameter, double height, double volume) {
  double low = 0, high = 0.5 * std::min(diameter, height) * (1 - 1e-9);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (volume_of("rounded-cylinder", diameter, height, middle) > volume ? low : high) = middle;
  }
  return low;
}

/// Volume by water, with the evaporated rest and the temperature; NaN if nothing was weighed.
Estimate volume_by_water(const JarReadings& readings, const JarInstruments& instruments) {
  std::vector<Estimate> inputs;
  if (!readings.water.empty())
    inputs = {mean_reading(readings.water, instruments.balance, "mass of water"), {0, 0}};
  else if (!readings.full.empty())
    inputs = {mean_reading(readings.full, instruments.balance, "mass of the full jar"),
              mean_reading(readings.empty, instruments.balance, "mass of the empty jar")};
  else
    return {};
  if (!(inputs[0].mean > inputs[1].mean))
    throw jar_fault("the full jar is no heavier than the empty one", "exchange both columns");
  inputs.push_back(water_density);
  return propagated(
             inputs,
             [](const std::vector<double>& in) { return std::vector{(in[0] - in[1]) / in[2]}; })
      .results[0];
}

void check_volumes(const Estimate& water, const Estimate& sizes, std::string_view shape,
                   Findings& found) {
  if (std::isnan(water.mean)) {
    found.remarks.emplace_back(
        "Nothing confirms the shape. Fill the jar with water to the rim of its lid and weigh it.");
    return;
  }
  const double off = sizes.mean / water.mean - 1, both = water.ci95 + sizes.ci95;
  const std::string said =
      fmt::format("the sizes make {}, the water {}", show_rounded(sizes.mean, "m3", 3),
                  show_rounded(water.mean, "m3", 3));
  if (std::abs(off) > 0.1)
    throw jar_fault(fmt::format("{}: one of them is wrong, or the jar is no {}", said, shape),
                    "measure again, or choose another shape: --shape capsule, cylinder, "
                    "rounded-cylinder or sphere");
  if (std::abs(sizes.mean - water.mean) > both)
    found.remarks.push_back(fmt::format(
        "Beyond their errors {}, {:+.1f} %: the jar is not quite a {}.", said, 100 * off, shape));
}

/// Diameter, depth and volume by water to diameter, height, fillet and volume.
std::vector<double> sizes_from(std::string_view shape, const std::vector<double>& in) {
  const double diameter = in[0];
  const double height = shape == "sphere" ? 0 : in[1] - (shape == "capsule" ? diameter : 0);
  const double fillet = shape == "rounded-cylinder" ? fillet_for(diameter, height, in[2]) : 0;
  return {diameter, height, fillet, volume_of(shape, diameter, std::max(0.0, height), fillet)};
}

}  // namespace

JarFound jar_sizes(std::string_view shape, const JarReadings& readings,
                   const JarInstruments& instruments) {
  if (std::ranges::find(measured_shapes, shape) == measured_shapes.end())
    throw jar_fault(fmt::format("a jar of the shape \"{}\" is not measured so", shape),
                    "choose --shape capsule, cylinder, rounded-cylinder or sphere; other shapes "
                    "can be given as a mesh");
  JarFound made;
  made.volume = volume_by_water(readings, instruments);
  if (shape == "rounded-cylinder" && std::isnan(made.volume.mean))
    throw jar_fault("the fillet of a rounded cylinder follows from the volume, which is not there",
                    "weigh the jar empty and full of water");
  const Propagated sizes = propagated(
      {mean_reading(readings.diameter, instruments.caliper, "diameter"),
       shape == "sphere" ? Estimate{} : mean_reading(readings.depth, instruments.caliper, "depth"),
       made.volume},
      [&](const std::vector<double>& in) { return sizes_from(shape, in); });
  const std::vector<Estimate>& all = sizes.results;
  if (shape == "capsule" && all[1].mean < 0)
    throw jar_fault("the depth is less than the diameter, so the jar is no capsule",
                    "measure the depth from end to end, or give --shape sphere or cylinder");
  made.by_sizes = all[3];
  made.sizes.list = {{"jar.diameter", "inner diameter", "m", all[0]}};
  if (shape != "sphere")
    made.sizes.list.push_back(
        {"jar.height", shape == "capsule" ? "height of the cylindrical part" : "inner height", "m",
         all[1]});
  if (shape == "rounded-cylinder")
    made.sizes.list.push_back({"jar.fillet", "radius of the rounded edges", "m", all[2]});
  if (!readings.wall.empty())
    made.sizes.list.push_back({"jar.wall", "thickness of the wall", "m",
                               mean_reading(readings.wall, instruments.caliper, "wall")});
  if (!readings.empty.empty())
    made.sizes.list.push_back({"", "mass of the empty jar", "kg",
                               mean_reading(readings.empty, instruments.balance, "mass")});
  check_volumes(made.volume, made.by_sizes, shape, made.sizes);
  return made;
}

}  // namespace mahlwerk::measure
