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
  v.flag({"collisions", false, "no record of every collision is kept",
          "whether every collision is stored in collisions.h5"},
         observe.collisions);
  if (v.reader() != nullptr || v.visits_all() || observe.final_state)
    v.flag({"final_state", false, "the balls at the end are not kept",
            "whether the state of the balls at the end is stored, to start another run from it"},
           observe.final_state);
  v.optional_number(NumberSpec("frames", "s", positive, "time between two frames for replay")
                        .with_default_text("no frames are stored"),
                    observe.frames);
  v.word({"frames_format",
          {"both", "xyz", "vtk"},
          "both",
          "for OVITO and for ParaView",
          "file format of the frames",
          {"both formats", "extended XYZ, for OVITO", "VTK with the jar, for ParaView"}},
         observe.frames_format);
}

}  // namespace mahlwerk::cases
