// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/solver.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::soft {

double free_card_memory() {
  return static_cast<double>(graphics_card()->free_bytes());
}

double card_memory_per_ball(const Settings& settings) {
  constexpr double plain = 4000, more = 12000;
  const contact::ContactModel& model = settings.model;
  return contact::adhesion(*model.law).empty() && !model.partial_slip &&
                 model.twisting == contact::Twisting::none
             ? plain
             : more;
}

std::string device_lacks(const scene::Chamber& chamber, const Settings& settings) {
  if (kinematics::drive_of(*chamber.motion) != nullptr)
    return "a mill that a motor turns ([drive])";
  if (!chamber.parts.empty()) return "parts in the jar ([[parts]])";
  if (settings.liquid) return "a liquid";
  if (settings.flow) return "balls that leave the jar and enter it ([flow])";
  if (settings.breakage) return "grains that break ([bed_breakage])";
  if (settings.model.curved_walls) return "the curvature of walls (contact.curved_walls)";
  return {};
}

std::unique_ptr<scene::Engine> make_device_engine(const scene::Chamber& chamber,
                                                  const std::vector<scene::Ball>& balls,
                                                  const Settings& settings,
                                                  const contact::PairTable& pairs, double start) {
  return std::make_unique<DeviceSolver>(chamber, balls, settings, pairs, start);
}

}  // namespace mahlwerk::soft
