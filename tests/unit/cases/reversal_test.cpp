// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A drive whose sense of rotation changes: which mills have one, which need runs in both senses.
#include "mahlwerk/cases/reversal.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "meshes.hpp"
#include "sample.hpp"
#include "statement.hpp"

namespace mahlwerk::cases::reversal_test {
namespace {

using namespace sample;
const std::string reverse = "[milling]\nreverse = true\n";

/// The case `text` with a reversed drive, and gravity towards -y and -z.
std::string leaning(const std::string& text) {
  return "gravity_direction = [0, -1, -1]\n" + text + reverse;
}

double speed(const Case& c) {
  return std::get<kinematics::Planetary>(*c.mill.motion).speed;
}

TEST(Reversal, replicates_alternate_their_sense_where_the_mirror_image_differs) {
  const Case plain = read_sample(planetary + reverse),
             lean = read_sample(leaning(planetary), {{"run.replicates", "2"}});
  EXPECT_TRUE(plain.milling->reverse);
  EXPECT_EQ(read_sample(write(plain)), plain);
  EXPECT_FALSE(needs_both_senses(plain));
  EXPECT_TRUE(needs_both_senses(lean));
  EXPECT_EQ(speed(CaseBySense(plain).of(1)), speed(plain));
  EXPECT_EQ(speed(CaseBySense(lean).of(0)), speed(lean));
  EXPECT_EQ(speed(CaseBySense(lean).of(1)), -speed(lean));
  EXPECT_EQ(speed(CaseBySense(lean).of(2)), speed(lean));
  EXPECT_EQ(distinct_replicates(plain), 1U);
  EXPECT_EQ(distinct_replicates(lean), 2U);
  EXPECT_EQ(speed(case_of_replicate(lean, 3)), -speed(lean));
}

TEST(Reversal, a_mesh_is_taken_as_unlike_its_mirror_image) {
  Case c = read_sample(planetary + reverse);
  c.jar.shape = tests::mesh_of(tests::prism(tests::regular(4, 0.03), 0.04));
  EXPECT_TRUE(needs_both_senses(c));
}

TEST(Reversal, jars_with_bars_or_arms_are_their_own_mirror_image) {
  geometry::LifterCylinder drum{.diameter = 0.3,
                                .height = 0.1,
                                .lifters = 5,
                                .lifter_height = 0.02,
                                .lifter_width = 0.03,
                                .lifter_face_angle = 1.2,
                                .bars = {}};
  drum.complete();
  geometry::Attritor vessel{.diameter = 0.1,
                            .height = 0.12,
                            .shaft_diameter = 0.012,
                            .shaft_clearance = 0.01,
                            .arms = 4,
                            .arm_diameter = 0.008,
                            .arm_span = 0.08,
                            .arm_clearance = 0.02,
                            .arm_spacing = 0.02,
                            .rotor_speed = 30};
  vessel.complete();
  Random random(4, 1);
  for (const geometry::AnyShape& shape :
       {geometry::AnyShape(drum), geometry::AnyShape(vessel),
        geometry::AnyShape(geometry::PeriodicCylinder{0.1, 0.05})}) {
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      const double x = random.uniform(-0.05, 0.05), y = random.uniform(-0.05, 0.05),
                   z = random.uniform(-0.05, 0.05);
      worst = tests::max_or_nan(worst, std::abs(geometry::nearest_wall(shape, {x, -y, z}, 0.2) -
                                                geometry::nearest_wall(shape, {x, y, z}, 0.2)));
    }
    tests::stays_below(std::string(geometry::name_of(shape)) + ": difference of distances [m]",
                       worst, 1e-15, "the mirror image; rounding of the angles of the bars");
  }
}

TEST(Reversal, a_stirrer_is_reversed_with_its_mill) {
  Case c = read_sample(planetary + reverse);
  c.mill.motion = kinematics::Still{};
  EXPECT_FALSE(has_sense_of_rotation(c));
  c.jar.shape = geometry::Attritor{.rotor_speed = 30};
  EXPECT_TRUE(has_sense_of_rotation(c));
  EXPECT_FALSE(needs_both_senses(c));
  c.gravity_direction = {0, 1, 0};
  EXPECT_EQ(std::get<geometry::Attritor>(*CaseBySense(c).of(1).jar.shape).rotor_speed, -30);
}

TEST(Reversal, what_cannot_be_reversed_is_refused) {
  const auto codes = [](const std::string& text, const std::vector<Override>& set = {}) {
    std::string all;
    for (const Fault& f : faults_of(text, set)) all += f.code + " ";
    return all;
  };
  EXPECT_EQ(codes(planetary + reverse), "");
  EXPECT_EQ(codes(vial + reverse), "nothing-to-reverse ");
  EXPECT_EQ(codes(planetary + reverse + "[heat]\n"), "one-cycle ");
  EXPECT_EQ(codes(planetary + reverse + "[heat]\nmilling = \"5 min\"\ncycles = 6\n"), "");
  EXPECT_EQ(codes(leaning(planetary), {{"run.replicates", "3"}}), "odd-replicates ");
  EXPECT_EQ(codes(leaning(planetary), {{"run.replicates", "4"}}), "");
}

}  // namespace
}  // namespace mahlwerk::cases::reversal_test
