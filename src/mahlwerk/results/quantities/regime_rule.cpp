// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/regime_rule.hpp"

namespace mahlwerk::results {
namespace {

/// The wall carries the charge round: mass on all sides that keeps to the wall.
bool carried_round(const RegimeSigns& s) {
  return s.emptiest_sector > 0.1 &&
         (s.flight_share < 0.02 || (s.jar_lag < 0.2 && s.flight_share < 0.1));
}

/// The wall passes under the charge, which stays in place: it neither flows down a surface nor is
/// carried up.
bool passes_under(const RegimeSigns& s) {
  constexpr double most = 0.5, flows = 0.4;
  return s.wall_slip > most && s.carrier_motion < flows;
}

/// The wall lifts the charge and throws it. The few large balls of a planetary mill are more often
/// without support than those of a bed.
bool thrown(const RegimeSigns& s, bool drum) {
  constexpr double throws = 0.1;  // Mellmann: at a lower Froude number balls roll down the bed
  constexpr double many = 0.2;
  if (!(s.froude > throws) || !(s.airborne_share > (drum ? 0.05 : 0.12))) return false;
  return !passes_under(s) || s.airborne_share > many;
}

/// A charge that slides back between its stops is fast at times.
bool slips(const RegimeSigns& s, bool stops) {
  const bool stays = s.flight_share < 0.02 && s.carrier_motion < 0.1 && s.wall_slip > 0.1;
  return stays || passes_under(s) || (stops && s.wall_slip > 0.5);
}

}  // namespace

std::string_view regime_word(const RegimeSigns& s, bool drum) {
  // The charge moves for less than half of the time. A faster drum keeps it moving; a start that is
  // counted would pass for a stop.
  constexpr double steady = 2, slow = 0.01;
  const bool stops = s.intermittency > steady && s.froude < slow;
  if (carried_round(s)) return drum ? "centrifuging" : "rolling";
  if (s.jar_lag < 0.2) return "rigid";
  if (thrown(s, drum)) return "cataracting";
  if (slips(s, stops)) return stops ? "surging" : "sliding";
  if (s.wall_share > 0.95) return "rolling on the wall";
  return stops ? "slumping" : "cascading";
}

}  // namespace mahlwerk::results
