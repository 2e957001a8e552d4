// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/guard.hpp"

#include <sstream>

namespace mahlwerk::event {
namespace {

const char* remedy(SustainedContactMode sustained_mode) {
  switch (sustained_mode) {
    case SustainedContactMode::none:
      return "Nothing ends them, since [contact] lasting = \"none\". Leave it out: one ball then "
             "rolls and slides, several are carried by the TC rule";
    case SustainedContactMode::roll:
      return "The ball neither rests nor leaves. Try [contact] lasting = \"tc\", or follow the "
             "contact itself by run.engine = \"soft\"";
    case SustainedContactMode::tc:
      break;
  }
  return "Balls are wedged: they have no room for the small bounces of the TC rule. run.engine = "
         "\"soft\" follows such contacts";
}

}  // namespace

RunError zeno_error(double time, double within, std::int64_t events,
                    SustainedContactMode sustained_mode) {
  std::ostringstream text;
  text << "at " << time << " s " << events << " events took place within " << within
       << " s: bounces have collapsed (inelastic collapse) and time no longer advances. "
       << remedy(sustained_mode) << "; see docs/errors.md#inelastic-collapse";
  return RunError(text.str());
}

void reject_energy_gain(const contact::Loss& loss, double mass, double approach, double slip,
                        double time) {
  constexpr double rounding = 1e-9;
  const double energy = 0.5 * mass * (approach * approach + slip * slip);
  const double lost = loss.normal + loss.tangential;
  if (lost >= -rounding * energy) return;
  std::ostringstream text;
  text
      << "at " << time << " s a collision gained " << -lost << " J of the " << energy
      << " J that it had. This is an error of Mahlwerk, not of the case: please report it with the "
         "case file; see docs/errors.md#energy-gained";
  throw RunError(text.str());
}

}  // namespace mahlwerk::event
