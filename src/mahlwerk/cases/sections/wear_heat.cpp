// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [wear] and [heat]: wear of balls and jar, and temperatures.
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

void describe(KeyVisitor& v, Wear& wear) {
  v.word({"model",
          {"archard", "finnie"},
          "archard",
          "by normal force and sliding distance",
          "wear model",
          {"wear by normal force and sliding distance (wea.1)",
           "wear by energy and angle of each impact (wea.4)"}},
         wear.model);
  v.number({"coefficient", "", positive, "worn volume times hardness over force times distance",
            Wear().coefficient,
            wear.model == Wear::Model::finnie
                ? "as much as Archard's at grazing impacts (wea.5); uncalibrated"
                : "uncalibrated, 1e-6 to 1e-2"},
           wear.coefficient);
}

namespace {

/// [s] Milling in one of the cycles that [heat] gives, if another section states the whole
/// time.
std::optional<double> milling_of_a_cycle(SectionReader& in) {
  if (!in.findings().milling_time) return std::nullopt;
  const Node* cycles = in.find("cycles");
  const double count = cycles == nullptr ? 1 : whole_number(*cycles).value_or(1);
  return *in.findings().milling_time / count;
}

}  // namespace

/// With `pause` or `cycles`, the milling time is required, here or in another section, and with
/// `pause` also `cycles`. By default the mill runs for an hour without a pause.
void describe(KeyVisitor& v, Heat& heat) {
  NumberSpec milling("milling", "s", positive, "milling time of each cycle", Heat().milling,
                     "an hour without a pause");
  IntegerSpec cycles{.key = "cycles",
                     .least = 1,
                     .most = 10'000,
                     .about = "number of cycles of milling and pause",
                     .standard = 1,
                     .source = "without a pause there is one"};
  const bool pauses = v.gives("pause");
  if (pauses) cycles.standard.reset();
  if (v.gives("cycles") || pauses) milling.standard.reset();
  if (SectionReader* in = v.reader())
    if (const auto time = milling_of_a_cycle(*in))
      milling = milling.with_default(*time, "milling time of the case over its cycles");
  v.number(milling, heat.milling);
  v.number({"pause", "s", not_negative, "pause after each milling", Heat().pause, "none"},
           heat.pause);
  v.integer(cycles, heat.cycles);
  v.number({"ambient", "K", positive, "temperature of the air, and of everything at the start",
            Heat().ambient, "room temperature"},
           heat.ambient);
  v.number(
      {"cooling", "W/m2/K", positive, "heat from the jar's wall to the air, by area and kelvin",
       Heat().cooling, "natural to mild forced convection of air, textbooks: 5-50; uncalibrated"},
      heat.cooling);
  v.number({"ball_exchange", "W/m2/K", positive,
            "heat from the balls to the jar, by area of the balls and kelvin", Heat().ball_exchange,
            "gas between balls in motion and the wall, 10-200 (hea.6); uncalibrated"},
           heat.ball_exchange);
  v.number({"share_in_balls",
            "",
            {.least = 0, .most = 1},
            "share of the lost power that heats the balls, the rest the jar",
            Heat().share_in_balls,
            "contacts of equal bodies; uncalibrated"},
           heat.share_in_balls);
}

}  // namespace mahlwerk::cases
