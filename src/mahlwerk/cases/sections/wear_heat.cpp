// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [wear] and [heat]: what the mill takes off and how warm it gets.
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {

Wear read_wear(const Node* table, Findings& findings) {
  Wear wear;
  Section in(table, "wear", findings);
  const bool finnie =
      in.choice({"model", wear_models(), "archard", "by force and way slid"}) == "finnie";
  if (finnie) wear.model = Wear::Model::finnie;
  Wanted wanted(wear_coefficient);
  if (finnie) wanted.source = "as much as Archard's at grazing impacts (wea.5); uncalibrated";
  wear.coefficient = in.value(wanted);
  in.close();
  return wear;
}

namespace {

/// How long the mill mills and rests. Who says one of the times of a cycle must say all.
void read_cycles(Section& in, Heat& heat) {
  const bool pauses = in.gives("pause"), cycles = in.gives("cycles");
  Wanted milling(cycle_milling);
  if (pauses || cycles) milling.standard.reset();
  heat.milling = in.value(milling);
  heat.pause = in.value(Wanted(pause_time));
  if (cycles)
    heat.cycles = in.whole("cycles", most_cycles).value_or(1);
  else if (pauses)
    in.missing("cycles", "how often the mill mills and rests", "write for instance cycles = 10");
  else
    in.note_default("cycles", "1", "without a pause there is one");
}

}  // namespace

Heat read_heat(const Node* table, Findings& findings) {
  Heat heat;
  Section in(table, "heat", findings);
  read_cycles(in, heat);
  for (const auto& field : heat_fields()) heat.*field.value = in.value(Wanted(field));
  in.close();
  return heat;
}

}  // namespace mahlwerk::cases
