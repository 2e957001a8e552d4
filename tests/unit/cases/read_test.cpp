// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::read_test {
namespace {

using namespace sample;
using kinematics::Planetary;
using kinematics::Tumbling;
using kinematics::Vibration;
constexpr double pi = std::numbers::pi;

double planetary_ratio(const std::string& mill) {
  const std::string text = planetary.substr(planetary.find("[jar]"));
  return std::get<Planetary>(*read_sample("[mill]\n" + mill + text).mill.motion).ratio;
}

TEST(ReadCase, the_vial_of_chen_2016) {
  const Case c = read_sample(vial);
  EXPECT_EQ(c.title, "vial");
  EXPECT_EQ(c.seed, 3U);
  EXPECT_EQ(c.gravity, 9.81);
  EXPECT_EQ(std::get<Vibration>(*c.mill.motion), (Vibration{{}, 10, 0.025, 0, 0}));
  EXPECT_EQ(c.mill.jar_axis, kinematics::upright);
  const auto& jar = std::get<geometry::Capsule>(*c.jar.shape);
  EXPECT_NEAR(jar.height, 36.210e-3, 5e-7);  // physics: 5 ml in a capsule of 12 mm
  EXPECT_NEAR(jar.volume(), 5e-6, 1e-18);
  ASSERT_EQ(c.balls.size(), 1U);
  EXPECT_NEAR(c.balls[0].mass(), 2.1044e-3, 5e-8);
  EXPECT_EQ(c.contact.rule.restitution, 0.9);
  EXPECT_EQ(c.contact.rule.tangential_restitution, 0.9);
  EXPECT_TRUE(std::isinf(c.contact.rule.friction));
  EXPECT_EQ(c.contact.lasting, SustainedContactModel::roll);
  EXPECT_EQ(c.run.time, 60);
  EXPECT_EQ(c.run.replicates, 5);
  EXPECT_EQ(c.run.start_speed, 0.1);
  EXPECT_EQ(c.observe.threshold, 0.1);
  EXPECT_FALSE(c.observe.collisions);
  EXPECT_TRUE(engine_faults(c).empty());
}

TEST(ReadCase, every_value_has_its_origin) {
  const Case c = read_sample(vial, {{"run.time", "10 s"}});
  EXPECT_EQ(source_of(c, "mill.frequency"), "case.toml:5");
  EXPECT_EQ(source_of(c, "jar.height"), "case.toml:11: follows from volume = \"5 ml\"");
  EXPECT_EQ(source_of(c, "run.time"), "--set run.time");
  EXPECT_EQ(source_of(c, "run.start_speed"), "default: Chen et al. 2016");
  EXPECT_EQ(source_of(c, "balls.1.diameter"), "case.toml:14");
  const Case p = read_sample(planetary);
  EXPECT_EQ(source_of(p, "mill.orbit_radius"), "catalogue mills/p7: test sheet");
  EXPECT_EQ(source_of(p, "balls.1.density"), "catalogue materials/steel: test sheet");
  for (const char* key : {"title",
                          "seed",
                          "gravity",
                          "mill.kind",
                          "mill.ratio",
                          "mill.ratio_convention",
                          "mill.jar_axis",
                          "jar.kind",
                          "jar.diameter",
                          "jar.material",
                          "jar.youngs_modulus",
                          "jar.poisson_ratio",
                          "balls.1.count",
                          "balls.1.material",
                          "balls.1.youngs_modulus",
                          "balls.1.poisson_ratio",
                          "powder.mass",
                          "powder.density",
                          "powder.size",
                          "contact.law",
                          "contact.rolling",
                          "contact.curved_walls",
                          "contact.rescaled_unloading",
                          "contact.partial_slip",
                          "contact.twisting",
                          "contact.softening",
                          "contact.restitution_law",
                          "contact.bounce",
                          "contact.friction",
                          "contact.tangential_restitution",
                          "contact.lasting_friction",
                          "contact.rolling_friction",
                          "contact.lasting",
                          "contact.lasting_speed",
                          "contact.contact_time",
                          "run.engine",
                          "run.settle",
                          "run.start_frame",
                          "run.step_error",
                          "run.time_step_fraction",
                          "run.hop",
                          "run.replicates",
                          "observe.threshold",
                          "observe.collisions"})
    EXPECT_NE(source_of(p, key), "") << key;
}

TEST(ReadCase, the_planetary_mill_of_mhadhbi_2021) {
  const Case c = read_sample(planetary);
  EXPECT_EQ(c.title, "case");  // the stem of the file name
  const auto& mill = std::get<Planetary>(*c.mill.motion);
  EXPECT_EQ(c.mill.model, "p7");
  EXPECT_EQ(mill.orbit_radius, 0.07);
  EXPECT_DOUBLE_EQ(mill.speed, 400 * 2 * pi / 60);
  EXPECT_EQ(mill.ratio, -2);
  EXPECT_EQ(std::get<geometry::Cylinder>(*c.jar.shape).height, 0.0325);
  EXPECT_EQ(c.jar.material, "steel");
  EXPECT_EQ(c.balls[0].count, 5);
  EXPECT_EQ(c.balls[0].density, 7700);
  ASSERT_TRUE(c.powder.has_value());
  EXPECT_DOUBLE_EQ(c.powder->mass, 5 * c.balls[0].mass() / 70);
  EXPECT_EQ(c.powder->density, 4930);
  EXPECT_EQ(c.powder->size, 40e-6);
  EXPECT_EQ(c.contact.rule.friction, 0.5);
  EXPECT_EQ(c.contact.rule.tangential_restitution, 0);
}

TEST(ReadCase, a_drum_s_speed_in_every_unit) {
  const double critical = std::sqrt(9.81 / (0.1 - 0.01));  // the largest ball determines it
  const auto speed = [](const std::string& text) {
    return std::get<Tumbling>(
               *read_sample(with(drum, "speed", "speed = \"" + text + "\"")).mill.motion)
        .speed;
  };
  EXPECT_DOUBLE_EQ(speed("75 %"), 0.75 * critical);
  EXPECT_DOUBLE_EQ(speed("-75 %"), -0.75 * critical);
  EXPECT_DOUBLE_EQ(speed("60 rpm"), 2 * pi);
  EXPECT_DOUBLE_EQ(speed("1 Hz"), 2 * pi);
  EXPECT_DOUBLE_EQ(speed("2 rad/s"), 2);
  EXPECT_DOUBLE_EQ(speed("90 deg/s"), pi / 2);
  const Case c = read_sample(drum);
  EXPECT_EQ(c.mill.jar_axis, kinematics::lying);
  EXPECT_NE(source_of(c, "mill.speed").find("75 % of the critical speed"), std::string::npos);
}

TEST(ReadCase, speed_ratios_in_both_conventions) {
  const std::string rest = "kind = \"planetary\"\norbit_radius = \"70 mm\"\nspeed = \"400 rpm\"\n";
  EXPECT_EQ(planetary_ratio(rest + "ratio = -2\n"), -2);
  EXPECT_EQ(planetary_ratio(rest + "ratio = -2.5\n"), -2.5);
  EXPECT_EQ(planetary_ratio(rest + "ratio = \"1:-2\"\n"), -2);
  EXPECT_EQ(planetary_ratio(rest + "ratio = \"2 : -5\"\n"), -2.5);
  EXPECT_EQ(planetary_ratio(rest + "ratio = \"1:-2\"\nratio_convention = \"relative\"\n"), -2);
  EXPECT_EQ(planetary_ratio(rest + "ratio = -1\nratio_convention = \"absolute\"\n"), -2);
  EXPECT_EQ(planetary_ratio("model = \"p7\"\nspeed = \"400 rpm\"\nratio = -3\n"), -3);
}

TEST(ReadCase, balls_by_number_mass_filling_or_none) {
  const auto count = [](const std::string& line) {
    return read_sample(with(planetary, "count", line)).balls[0].count;
  };
  EXPECT_EQ(count("count = 5"), 5);
  EXPECT_EQ(count("mass = \"68 g\""), 5);     // 13.6 g each
  EXPECT_EQ(count("mass = \"74.7 g\""), 5);   // 5.49 balls
  EXPECT_EQ(count("mass = \"1 g\""), 1);      // never none
  EXPECT_EQ(count("filling = \"20 %\""), 5);  // solid volume fraction, as in Mhadhbi 2021
  EXPECT_EQ(count("filling = 0.4"), 10);
  EXPECT_EQ(count("# nothing said"), 1);
}

TEST(ReadCase, a_ball_set_of_the_catalogue) {
  std::string text = with(planetary, "count", "model = \"five\"");
  text = with(with(text, "diameter", ""), "material", "");
  const Case c = read_sample(text);
  EXPECT_EQ(c.balls[0].count, 5);
  EXPECT_EQ(c.balls[0].diameter, 0.015);
  EXPECT_EQ(c.balls[0].density, 7700);
  EXPECT_EQ(read_sample(with(text, "model = \"five\"", "model = \"five\"\nmass = \"28 g\""))
                .balls[0]
                .count,
            2);
}

TEST(ReadCase, powder_by_mass_or_ratio) {
  EXPECT_EQ(read_sample(with(planetary, "ball_to", "mass = \"2 g\"")).powder->mass, 0.002);
  EXPECT_DOUBLE_EQ(read_sample(with(planetary, "ball_to", "ball_to_powder = 10")).powder->mass,
                   5 * read_sample(planetary).balls[0].mass() / 10);
  EXPECT_FALSE(read_sample(vial).powder.has_value());
}

TEST(ReadCase, a_volume_gives_the_size_that_is_left) {
  const auto jar = [](const std::string& lines) {
    std::string text = with(with(vial, "diameter", ""), "volume", "");
    return *read_sample(with(text, "kind = \"capsule\"", lines)).jar.shape;
  };
  EXPECT_NEAR(std::get<geometry::Capsule>(
                  jar("kind = \"capsule\"\ndiameter = \"10 mm\"\nvolume = \"5 ml\""))
                  .height,
              56.995e-3, 5e-7);
  EXPECT_NEAR(std::get<geometry::Cylinder>(
                  jar("kind = \"cylinder\"\ndiameter = \"42 mm\"\nvolume = \"45 ml\""))
                  .height,
              32.48e-3, 5e-6);
  const auto rounded = std::get<geometry::RoundedCylinder>(jar(
      "kind = \"rounded-cylinder\"\ndiameter = \"42 mm\"\nvolume = \"45 ml\"\nfillet = \"5 mm\""));
  EXPECT_NEAR(rounded.volume(), 45e-6, 1e-15);
  EXPECT_GT(rounded.height, 32.48e-3);
  EXPECT_NEAR(std::get<geometry::Sphere>(jar("kind = \"sphere\"\nvolume = \"5 ml\"")).volume(),
              5e-6, 1e-18);
}

TEST(ReadCase, the_rule_of_the_bounce_follows_from_what_is_given) {
  const auto rule = [](const std::string& lines) {
    return read_sample(with(with(vial, "restitution", ""), "tangential_restitution", lines))
        .contact.rule;
  };
  EXPECT_EQ(rule(""), (contact::BounceRule{0.8, 0, 0.3}));
  EXPECT_EQ(rule("tangential_restitution = 0.4"), (contact::BounceRule{0.8, 0.4, INFINITY}));
  EXPECT_EQ(rule("tangential_restitution = -0.4\nfriction = 0.1"),
            (contact::BounceRule{0.8, -0.4, 0.1}));
  EXPECT_EQ(rule("friction = 0.1"), (contact::BounceRule{0.8, 0, 0.1}));
  EXPECT_EQ(rule("bounce = \"constant\""), (contact::BounceRule{0.8, 0, INFINITY}));
  EXPECT_EQ(rule("bounce = \"walton\"\ntangential_restitution = 0.4"),
            (contact::BounceRule{0.8, 0.4, 0.3}));
}

TEST(ReadCase, other_choices) {
  const Case c = read_sample(vial + "collisions = true\n", {{"contact.lasting", "tc"},
                                                            {"mill.jar_axis", "horizontal"},
                                                            {"mill.tilt", "90 deg"},
                                                            {"gravity", "0 m/s2"},
                                                            {"seed", "18446744073709551615"}});
  EXPECT_EQ(c.contact.lasting, SustainedContactModel::tc);
  EXPECT_EQ(c.mill.jar_axis, kinematics::lying);
  EXPECT_EQ(c.gravity, 0);
  EXPECT_EQ(c.seed, 18446744073709551615U);
  EXPECT_TRUE(c.observe.collisions);
}

TEST(ReadCase, overrides_win) {
  EXPECT_EQ(read_sample(vial, {{"balls.diameter", "6 mm"}}).balls[0].diameter, 0.006);
  EXPECT_EQ(read_sample(vial, {{"balls.1.diameter", "\"6 mm\""}}).balls[0].diameter, 0.006);
  EXPECT_EQ(read_sample(drum, {{"balls.2.diameter", "6 mm"}}).balls[1].diameter, 0.006);
  EXPECT_EQ(read_sample(vial, {{"contact.restitution", "0.5"}}).contact.rule.restitution, 0.5);
  EXPECT_EQ(read_sample(vial, {{"title", "12"}}).title, "12");
  EXPECT_EQ(read_sample(vial, {{"run.replicates", "7"}, {"run.replicates", "8"}}).run.replicates,
            8);
  EXPECT_EQ(read_sample(vial, {{"observe.collisions", "true"}}).observe.collisions, true);
  EXPECT_EQ(read_sample(planetary, {{"mill.ratio", "1:-3"}}).mill.model, "p7");
  // One of several alternatives replaces what the file says.
  EXPECT_EQ(read_sample(planetary, {{"balls.mass", "27 g"}}).balls[0].count, 2);
  EXPECT_EQ(
      std::get<geometry::Capsule>(*read_sample(vial, {{"jar.height", "20 mm"}}).jar.shape).height,
      0.02);
  EXPECT_EQ(read_sample(vial, {{"balls.material", "tic"}}).balls[0].density, 4930);
  EXPECT_EQ(read_sample(planetary, {{"powder.mass", "1 g"}}).powder->mass, 0.001);
  EXPECT_EQ(read_sample(vial, {{"mill.model", "shaky"}}).mill.model, "shaky");
  EXPECT_EQ(read_sample(vial, {{"powder.mass", "1 g"}}).powder->mass, 0.001);
}

TEST(ReadCase, with_kind_a_model_is_a_name_only) {
  const Case c = read_sample(with(vial, "kind", "kind = \"vibration\"\nmodel = \"my own\""));
  EXPECT_EQ(c.mill.model, "my own");
  EXPECT_EQ(std::get<Vibration>(*c.mill.motion).frequency, 10);
}

TEST(ReadCase, a_sweep_is_kept_as_text) {
  const Case c = read_sample(vial +
                             "[sweep]\n\"mill.frequency\" = [\"13 Hz\", \"16 Hz\"]\n"
                             "contact.restitution = [0.9, 0.5, 1]\n");
  ASSERT_EQ(c.sweep.keys.size(), 2U);
  EXPECT_EQ(c.sweep.keys[0].key, "contact.restitution");
  EXPECT_EQ(c.sweep.keys[0].values, (std::vector<std::string>{"0.9", "0.5", "1"}));
  EXPECT_EQ(c.sweep.keys[1].key, "mill.frequency");
  EXPECT_EQ(c.sweep.keys[1].values, (std::vector<std::string>{"13 Hz", "16 Hz"}));
  EXPECT_EQ(std::get<Vibration>(*c.mill.motion).frequency, 10);  // the case itself keeps its own
}

TEST(ReadCase, what_only_the_sweep_gives_is_not_missing) {
  const Case c = read_sample(with(vial, "frequency", "") +
                             "[sweep]\n\"mill.frequency\" = [\"13 Hz\", \"16 Hz\"]\n");
  EXPECT_EQ(std::get<Vibration>(*c.mill.motion).frequency, 13);
  EXPECT_EQ(source_of(c, "mill.frequency"), "first value of [sweep] \"mill.frequency\"");
}

TEST(ReadCase, a_measured_motion_comes_from_its_file) {
  const Folder folder;
  folder.write("motion.csv",
               "time_s,x_m,y_m,z_m,angle_rad\n0,0,0,0,0\n0.1,0,0,0.01,0\n\n0.2, 0, 0, -0.01, 0\r\n"
               "0.3,0,0,0,0\n");
  const std::string text =
      with(with(with(vial, "kind", "kind = \"tabulated\"\nfile = \"motion.csv\""), "frequency", ""),
           "amplitude", "");
  folder.write("case.toml", text);
  const Case c = read(folder.path() / "case.toml", catalogue());
  EXPECT_EQ(c.mill.motion_file, "motion.csv");
  const auto& motion = std::get<kinematics::Tabulated>(*c.mill.motion);
  ASSERT_EQ(motion.samples().size(), 4U);
  EXPECT_EQ(motion.samples()[2].centre, (Vec3{0, 0, -0.01}));
  EXPECT_DOUBLE_EQ(motion.period(), 0.3);
}

TEST(ReadCase, the_examples_read_with_the_real_catalogue) {
  const std::filesystem::path home = MAHLWERK_HOME;
  const Catalogue real(home / "catalogue");
  const Case c = read(home / "examples/01-one-ball/case.toml", real);
  EXPECT_EQ(std::get<geometry::Capsule>(*c.jar.shape),
            std::get<geometry::Capsule>(*read_sample(vial).jar.shape));
  std::string mhadhbi = with(planetary, "model", "model = \"fritsch-p7-classic\"");
  mhadhbi = with(mhadhbi, "model = \"pot", "model = \"fritsch-45ml-steel\"");
  mhadhbi = with(mhadhbi, "material = \"steel", "material = \"steel-1.4034\"");
  const Case b = read_text(mhadhbi + "[sweep]\n\"mill.speed\" = [\"200 rpm\", \"300 rpm\"]\n",
                           "mhadhbi.toml", real);
  EXPECT_EQ(std::get<Planetary>(*b.mill.motion).orbit_radius, 0.07);
}

}  // namespace
}  // namespace mahlwerk::cases::read_test
