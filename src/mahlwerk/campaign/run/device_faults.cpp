// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/device_faults.hpp"

#include <fmt/format.h>

#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::campaign {
namespace {

const std::string run_device = "run.device";

std::vector<Fault> memory_faults_of_card(const cases::Case& mill_case) {
  const double needed = card_memory(mill_case), free = soft::free_card_memory();
  if (needed <= free) return {};
  return {{cases::location_of(mill_case, run_device),
           fmt::format("{} balls need about {} of the graphics card's memory, but {} are free",
                       cases::balls_count(mill_case.balls), bytes_in_words(needed),
                       bytes_in_words(free)),
           fmt::format("take fewer or larger balls: about {:.2g} fit; or write device = \"cpu\"",
                       free / needed * static_cast<double>(cases::balls_count(mill_case.balls))),
           "not-enough-memory"}};
}

}  // namespace

double card_memory(const cases::Case& mill_case) {
  constexpr double of_triangle = 500;  // [bytes]
  double needed = soft::card_memory_per_ball(soft_settings(mill_case).rules) *
                  static_cast<double>(cases::balls_count(mill_case.balls));
  if (const auto* mesh = std::get_if<geometry::Mesh>(&*mill_case.jar.shape))
    needed += of_triangle * static_cast<double>(mesh->surface().triangles.size());
  return needed;
}

std::vector<Fault> device_faults(const cases::Case& mill_case) {
  if (mill_case.run.device != cases::DeviceName::gpu) return {};
  const auto fault = [&](std::string what, std::string remedy) {
    return std::vector<Fault>{{cases::location_of(mill_case, run_device), std::move(what),
                               std::move(remedy), "not-on-graphics-card"}};
  };
  if (mill_case.run.engine != cases::EngineName::soft)
    return fault(
        fmt::format("device = \"gpu\": engine = \"{}\" does not compute on a graphics card",
                    cases::name_of(mill_case.run.engine)),
        "write engine = \"soft\", or device = \"cpu\"");
  if (const std::string lacks =
          soft::device_lacks(cases::chamber(mill_case), soft_settings(mill_case).rules);
      !lacks.empty())
    return fault(fmt::format("device = \"gpu\" does not compute {} yet", lacks),
                 "write device = \"cpu\"");
  try {
    return memory_faults_of_card(mill_case);
  } catch (const InputError& e) {
    std::vector<Fault> found = e.faults();
    for (Fault& f : found)
      if (f.where == run_device) f.where = cases::location_of(mill_case, run_device);
    return found;
  }
}

}  // namespace mahlwerk::campaign
