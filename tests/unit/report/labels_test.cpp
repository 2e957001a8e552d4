// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Labels of axes and equations of laws.
#include <gtest/gtest.h>

#include "mahlwerk/report/plot/axis_labels.hpp"
#include "mahlwerk/report/plot/law_words.hpp"
#include "mahlwerk/report/plot/rich_text.hpp"

namespace mahlwerk::report::labels_test {
namespace {

TEST(RichText, is_plain_without_its_marks) {
  EXPECT_EQ(plain_text("$E_{n}$ = 2 mJ ($f$/17 Hz)^{1.99}"), "En = 2 mJ (f/17 Hz)1.99");
  for (const char* text : {"5 $", "f_mat", "x_w_min ^ 2", "a_{b"})
    EXPECT_EQ(plain_text(text), text);
}

TEST(AxisLabels, have_name_symbol_and_unit) {
  EXPECT_EQ(quantity_axis("energy_normal_mean_above_threshold", {1e-3, "mJ"}),
            "mean normal energy above threshold, $E_{n}$ (mJ)");
  EXPECT_EQ(quantity_axis("collision_rate", {1, "1/s"}), "collision rate, $n$ (1/s)");
  EXPECT_EQ(quantity_axis("flight_share", {1, "1"}), "share of time in flight, $φ$ (–)");
  EXPECT_EQ(quantity_axis("wall_slip_ratio", {1, "1"}), "wall slip ratio (–)");
  EXPECT_EQ(key_axis("mill.frequency", "Hz"), "vibration frequency, $f$ (Hz)");
  EXPECT_EQ(key_axis("mill.ratio", ""), "speed ratio, $k$ (–)");
  EXPECT_EQ(key_axis("contact.lasting", ""), "lasting");
  EXPECT_EQ(key_axis("balls.2.diameter", "mm"), "ball diameter, $d$ (mm)");
  EXPECT_EQ(key_axis("powder.ball_to_powder", ""), "ball to powder (–)");
}

TEST(LawWords, are_the_equation_in_the_units_of_the_axes_and_its_r_squared) {
  const LawAxes axes{"$f$", "Hz", "$E_{c}$", {1e-3, "mJ"}};
  FittedLaw law{.form = LawForm::power,
                .coefficients = {0.00667, 1.99},
                .reference = 16.7,
                .r_squared = 0.99998};
  EXPECT_EQ(law_words(law, axes), "$E_{c}$ = 6.67 mJ ($f$/16.7 Hz)^{1.99}, $R$² = 0.99998");
  law = {.form = LawForm::line, .coefficients = {0.002, -0.0005}, .r_squared = 0.9919};
  EXPECT_EQ(law_words(law, axes), "$E_{c}$ = 2 − 0.5 $f$, $R$² = 0.9919");
  law = {.form = LawForm::parabola, .coefficients = {-0.002, 0.0005, 1e-6}, .r_squared = 0.5};
  EXPECT_EQ(law_words(law, {"", "", "", {1, "J"}}),
            "$y$ = −0.002 + 0.0005 $x$ + 1e-06 $x$², $R$² = 0.5000");
}

}  // namespace
}  // namespace mahlwerk::report::labels_test
