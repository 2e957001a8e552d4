// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The values of a case that its results depend on: marks assumptions and finds ignored keys.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::cases {
namespace {

/// Whether an engine reads a value. A value that it does not read is no assumption of its results.
/// "auto" may read all values.
bool engine_reads(std::string_view dotted, const Case& c, EngineName engine) {
  static const std::vector<std::string_view> of_soft{
      "law",          "rolling",        "rolling_damping",
      "softening",    "curved_walls",   "rescaled_unloading",
      "partial_slip", "time_step",      "time_step_fraction",
      "hop",          "youngs_modulus", "poisson_ratio"};
  static const std::vector<std::string_view> of_event{
      "lasting", "lasting_friction", "lasting_speed", "contact_time", "tangential_restitution"};
  static const std::vector<std::string_view> not_in_lammps{"hop", "rolling_damping",
                                                           "rescaled_unloading"};
  if (engine == EngineName::automatic) return true;
  const auto& of_other = engine == EngineName::event ? of_soft : of_event;
  const std::string_view key = dotted.substr(dotted.rfind('.') + 1);  // npos + 1 == 0 without a dot
  const bool elastic = key == "youngs_modulus" || key == "poisson_ratio";
  if (engine == EngineName::lammps && std::ranges::find(not_in_lammps, key) != not_in_lammps.end())
    return false;
  const bool twists = c.contact.model.twisting != contact::Twisting::none;  // (evt.24)
  if (dotted.starts_with("kinetics.") || (elastic && (c.capture || twists)))
    return true;  // powder models, too
  const bool of_law = std::ranges::find(law_keys(), key) != law_keys().end();
  return std::ranges::find(of_other, key) == of_other.end() &&
         !(of_law && engine == EngineName::event);
}

/// Whether a value is needed: properties for wear and heat only with [wear] or [heat].
bool is_relevant(std::string_view dotted, const Case& c) {
  const std::string_view key = dotted.substr(dotted.rfind('.') + 1);
  if (key == "hardness") {  // a default yield pressure follows from it
    const auto* law = std::get_if<contact::ThorntonNing>(
        &static_cast<const contact::Laws&>(*c.contact.model.law));
    return c.wear.has_value() || (law != nullptr && law->yield_pressure == 0);
  }
  if (key == "conductivity" || key == "heat_capacity") return c.heat.has_value();
  const bool moved = c.sensors.accelerometer && !c.sensors.accelerometer->mass;
  if (key == "wall") return c.heat || moved;
  return dotted != "jar.density" || c.wear || c.heat || moved;
}

}  // namespace

void drop_irrelevant_assumptions(Case& c) {
  for (Origin& origin : c.origins) {
    const bool asked = is_relevant(origin.key, c);
    origin.assumed = origin.assumed && asked && engine_reads(origin.key, c, c.run.engine);
    origin.unverified = origin.unverified && asked;
  }
}

namespace {

/// Where the event engine has no twisting friction although the case asks for it.
Notices free_twisting(const Case& c, EngineName engine) {
  if (engine != EngineName::event || c.contact.model.twisting == contact::Twisting::none ||
      c.contact.lasting != SustainedContactModel::tc)
    return {};
  return {note("twisting-in-impacts",
               "The event engine has twisting friction in impacts only: bodies in a sustained "
               "contact, which is a series of small bounces (lasting = \"tc\"), turn freely about "
               "the normal. engine = \"soft\" has it there, too.")};
}

}  // namespace

Notices ignored_keys(const Case& c, EngineName engine) {
  std::string keys;
  Notices notes = free_twisting(c, engine);
  for (const Origin& origin : c.origins) {
    const bool given =
        !origin.source.starts_with("default: ") && !origin.source.starts_with("catalogue");
    if (given && !engine_reads(origin.key, c, engine))
      keys += (keys.empty() ? "" : ", ") + origin.key;
  }
  if (!keys.empty())
    notes.push_back(note(
        "ignored-keys", fmt::format("The {} engine, which ran, ignores these keys of the case: {}.",
                                    name_of(engine), keys)));
  return notes;
}

}  // namespace mahlwerk::cases
