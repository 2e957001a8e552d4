// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [observe]: the statistics and records of a run.
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

void describe(KeyVisitor& v, Observe& observe) {
  v.number({"threshold", "m/s", not_negative,
            "slower collisions are left out of the rates above the threshold", 0.1,
            "project convention; rates are given with and without it"},
           observe.threshold);
  v.flag({"collisions", false, "no record of every collision is kept"}, observe.collisions);
  if (v.reader() != nullptr || v.visits_all() || observe.final_state)
    v.flag({"final_state", false, "the balls at the end are not kept"}, observe.final_state);
  v.optional_number({"frames", "s", positive, "time between two frames for replay"},
                    observe.frames);
  v.word({"frames_format", {"both", "xyz", "vtk"}, "both", "for OVITO and for ParaView"},
         observe.frames_format);
}

}  // namespace mahlwerk::cases
