// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/faults.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::faults_test {
namespace {

using namespace sample;
TEST(CaseFaults, unknown_keys_name_the_nearest_known_one) {
  EXPECT_TRUE(only(with(vial, "frequency", "frequency = \"10 Hz\"\nfrequancy = \"10 Hz\""),
                   "case.toml:6", "did you mean `frequency`?", "unknown-key"));
  EXPECT_TRUE(
      only("titel = \"x\"\n" + vial, "case.toml:1", "did you mean `title`?", "unknown-key"));
  EXPECT_TRUE(only(vial + "[obsrve]\n", "case.toml:24", "did you mean `observe`?", "unknown-key"));
  EXPECT_TRUE(only(with(vial, "count", "cuont = 1"), "case.toml:13", "did you mean `count`?",
                   "unknown-key"));
  EXPECT_TRUE(only(with(vial, "kind = \"capsule\"", "kind = \"capsule\"\nfillet = \"1 mm\""),
                   "case.toml:10", "unknown key `fillet` in [jar]", "unknown-key"));
  EXPECT_TRUE(only(vial, "--set mill.frequancy", "did you mean `frequency`?", "unknown-key",
                   {{"mill.frequancy", "3 Hz"}}));
  EXPECT_TRUE(only(vial, "--set mil.frequency", "did you mean `mill`?", "unknown-key",
                   {{"mil.frequency", "3 Hz"}}));
  EXPECT_TRUE(only(vial + "[sweep]\n\"mill.frequancy\" = [\"3 Hz\"]\n", "case.toml:25",
                   "did you mean `frequency`?", "unknown-key"));
}

TEST(CaseFaults, overrides_that_name_nothing) {
  EXPECT_TRUE(only(vial, "--set balls.2.diameter", "ball sets in the case: 1", "unknown-key",
                   {{"balls.2.diameter", "3 mm"}}));
  EXPECT_TRUE(only(vial, "--set balls.0.diameter", "ball sets", "unknown-key",
                   {{"balls.0.diameter", "3 mm"}}));
  EXPECT_TRUE(only(vial, "--set mill..x", "is not a key", "unknown-key", {{"mill..x", "3"}}));
  EXPECT_TRUE(only(vial, "--set mill.frequency.x", "names nothing", "unknown-key",
                   {{"mill.frequency.x", "3"}}));
  EXPECT_TRUE(only(vial, "--set ", "is not a key", "unknown-key", {{"", "3"}}));
}

TEST(CaseFaults, a_missing_unit_and_other_bad_quantities) {
  EXPECT_TRUE(only(with(vial, "diameter", "diameter = 12"), "case.toml:10",
                   "diameter = 12: the unit is missing; write for instance \"12 mm\"",
                   "bad-quantity"));
  EXPECT_TRUE(only(with(vial, "diameter", "diameter = \"12\""), "case.toml:10",
                   "the unit is missing", "bad-quantity"));
  EXPECT_TRUE(only(with(vial, "frequency", "frequency = \"10 mm\""), "case.toml:5",
                   "is not a frequency", "bad-quantity"));
  EXPECT_TRUE(only(with(vial, "frequency", "frequency = \"10 Hzz\""), "case.toml:5",
                   "did you mean \"Hz\"", "bad-quantity"));
  EXPECT_TRUE(
      only(with(vial, "restitution", "restitution = nan"), "case.toml:17", "nan", "bad-quantity"));
  EXPECT_TRUE(
      only(with(vial, "restitution", "restitution = inf"), "case.toml:17", "inf", "bad-quantity"));
  EXPECT_TRUE(only(with(vial, "amplitude", "amplitude = \"nan mm\""), "case.toml:6", "nan",
                   "bad-quantity"));
  EXPECT_TRUE(only(vial, "--set jar.diameter", "the unit is missing", "bad-quantity",
                   {{"jar.diameter", "12"}}));
}

TEST(CaseFaults, wrong_types) {
  const auto wrong = [](const std::string& key, const std::string& line, int at, const char* what) {
    return only(with(vial, key, line), "case.toml:" + std::to_string(at), what, "wrong-type");
  };
  EXPECT_TRUE(wrong("frequency", "frequency = true", 5, "`frequency` must be a quantity"));
  EXPECT_TRUE(wrong("frequency", "frequency = [\"10 Hz\"]", 5, "`frequency` must be a quantity"));
  EXPECT_TRUE(wrong("kind", "kind = 3", 4, "`kind` must be a text"));
  EXPECT_TRUE(wrong("threshold", "collisions = \"yes\"", 23, "must be true or false"));
  EXPECT_TRUE(only("powder = 3\n" + vial, "case.toml:1", "write [powder]", "wrong-type"));
  EXPECT_TRUE(only(vial + "[sweep]\n\"mill.frequency\" = \"3 Hz\"\n", "case.toml:25",
                   "list of values", "wrong-type"));
  EXPECT_TRUE(only(vial + "[sweep]\n\"mill.frequency\" = []\n", "case.toml:25", "list of values",
                   "wrong-type"));
  EXPECT_TRUE(only(vial + "[sweep]\n\"mill.frequency\" = [[1]]\n", "case.toml:25", "list of values",
                   "wrong-type"));
}

TEST(CaseFaults, unknown_words) {
  const auto unknown = [](const std::string& key, const std::string& line, int at,
                          const char* what) {
    return only(with(vial, key, line), "case.toml:" + std::to_string(at), what, "unknown-word");
  };
  EXPECT_TRUE(unknown("kind", "kind = \"vibrating\"", 4, "did you mean \"vibration\"?"));
  EXPECT_TRUE(unknown("engine", "engine = \"evnt\"", 20, "did you mean \"event\"?"));
  EXPECT_TRUE(unknown("restitution", "law = \"hertz\"", 17, "\"linear-spring\""));
  EXPECT_TRUE(unknown("restitution", "lasting = \"stay\"", 17, "\"roll\", \"tc\" or \"none\""));
  EXPECT_TRUE(unknown("restitution", "bounce = \"Walton\"", 17, "did you mean \"walton\"?"));
  EXPECT_TRUE(
      unknown("frequency", "frequency = \"10 Hz\"\njar_axis = \"tilted\"", 6, "\"horizontal\""));
}

TEST(CaseFaults, missing_things) {
  const auto missing = [](const std::string& key, int at, const char* what) {
    return only(with(vial, key, ""), "case.toml:" + std::to_string(at), what, "missing-value");
  };
  EXPECT_TRUE(missing("frequency", 3, "frequency = \"10 Hz\""));
  EXPECT_TRUE(missing("volume", 8, "or give `volume`"));
  EXPECT_TRUE(missing("diameter = \"8", 12, "[[balls]] lacks `diameter`"));
  EXPECT_TRUE(missing("density", 12, "or material with a name"));
  EXPECT_TRUE(missing("time", 19, "[run] lacks `time`"));
  EXPECT_TRUE(missing("kind = \"capsule", 8, "\"rounded-cylinder\""));
  EXPECT_TRUE(only(with(planetary, "ball_to", ""), "case.toml:10", "or give `ball_to_powder`",
                   "missing-value"));
  EXPECT_TRUE(only(with(planetary, "material = \"steel", "material = \"mystery\""), "case.toml:6",
                   "the catalogue gives none for mystery", "missing-value"));
}

TEST(CaseFaults, missing_sections_are_named_together) {
  std::set<std::string> what;
  for (const Fault& f : faults_of("")) {
    EXPECT_EQ(f.where, "case.toml");
    what.insert(f.what);
  }
  EXPECT_EQ(what, (std::set<std::string>{"there is no [jar]", "there is no [mill]",
                                         "there is no [run]", "there are no balls"}));
  EXPECT_TRUE(only(
      "balls = 3\n" + vial.substr(0, vial.find("[[balls]]")) + vial.substr(vial.find("[contact]")),
      "case.toml:1", "list of ball sets", "missing-value"));
}

TEST(CaseFaults, two_that_exclude_each_other) {
  const auto both = [](const std::string& text, int at, const char* what) {
    return only(text, "case.toml:" + std::to_string(at), what, "too-much");
  };
  EXPECT_TRUE(both(with(vial, "volume", "volume = \"5 ml\"\nheight = \"36 mm\""), 11,
                   "both `height` and `volume`"));
  EXPECT_TRUE(
      both(with(vial, "count", "count = 1\nmass = \"2 g\""), 14, "both `count` and `mass`"));
  EXPECT_TRUE(
      both(with(vial, "count", "mass = \"2 g\"\nfilling = 0.1"), 14, "both `mass` and `filling`"));
  EXPECT_TRUE(
      both(with(planetary, "size", "mass = \"2 g\""), 12, "both `mass` and `ball_to_powder`"));
  EXPECT_TRUE(both(with(vial, "tangential", "friction = 0.3\nbounce = \"constant\""), 18,
                   "no meaning under bounce"));
}

TEST(CaseFaults, names_the_catalogue_lacks) {
  EXPECT_TRUE(only(with(planetary, "model", "model = \"p8\""), "case.toml:2", "did you mean 'p7'",
                   "unknown-name"));
  EXPECT_TRUE(only(with(planetary, "material", "material = \"steal\""), "case.toml:9",
                   "did you mean 'steel'", "unknown-name"));
  EXPECT_TRUE(only(with(planetary, "count", "model = \"six\""), "case.toml:7",
                   "ball set called 'six'", "unknown-name"));
}

TEST(CaseFaults, ratios_that_are_none) {
  const auto bad = [](const std::string& line, int at, const char* code) {
    return only(with(planetary, "speed", "speed = \"400 rpm\"\n" + line),
                "case.toml:" + std::to_string(at), "", code);
  };
  EXPECT_TRUE(bad("ratio = \"0:-2\"", 4, "bad-quantity"));
  EXPECT_TRUE(bad("ratio = \"1:\"", 4, "bad-quantity"));
  EXPECT_TRUE(bad("ratio = \"1:2:3\"", 4, "bad-quantity"));
  EXPECT_TRUE(bad("ratio = nan", 4, "bad-quantity"));
  EXPECT_TRUE(bad("ratio = -2\nratio_convention = \"other\"", 5, "unknown-word"));
  EXPECT_TRUE(bad("ratio_convention = \"absolute\"", 4, "missing-value"));  // without a ratio
  EXPECT_TRUE(only(with(planetary, "ball_to", "ball_to_powder = \"0:1\""), "case.toml:12",
                   "above 0", "out-of-range"));
  EXPECT_TRUE(only(with(planetary, "ball_to", "ball_to_powder = \"a:1\""), "case.toml:12", "30:1",
                   "bad-quantity"));
}

TEST(CaseFaults, frames_that_nobody_can_want) {
  const auto every = [](const std::string& text) { return vial + "frames = \"" + text + "\"\n"; };
  EXPECT_TRUE(faults_of(every("1 ms")).empty());
  EXPECT_TRUE(faults_of(every("100 s")).empty()) << "one frame";
  EXPECT_TRUE(only(every("1 us"), "case.toml:24", "frames = \"63 us\"", "too-many-frames"));
  EXPECT_TRUE(faults_of(every("63 us")).empty());
  EXPECT_TRUE(only(every("0 s"), "case.toml:24", "above 0", "out-of-range"));
  EXPECT_TRUE(only(every("5 m"), "case.toml:24", "", "bad-quantity"));
  EXPECT_TRUE(only(every("1 ms") + "frames_format = \"vtkhdf\"\n", "case.toml:25",
                   "\"both\", \"xyz\" or \"vtk\"", "unknown-word"));
}

TEST(CaseFaults, parts_that_do_not_go_together) {
  EXPECT_TRUE(only(with(vial, "diameter = \"8", "diameter = \"20 mm\""), "case.toml:14",
                   "the ball (20 mm) is not smaller than the jar (12 mm)", "ball-too-large"));
  EXPECT_TRUE(only(with(vial, "diameter = \"8", "diameter = \"11.99999 mm\""), "case.toml:14",
                   "12 mm", "ball-too-large"));
  EXPECT_TRUE(faults_of(with(vial, "diameter = \"8", "diameter = \"11.9999 mm\"")).empty());
  EXPECT_TRUE(only(with(vial, "volume", "volume = \"0.9 ml\""), "case.toml:11", "0.9048 ml",
                   "volume-too-small"));
  EXPECT_TRUE(
      only(with(vial, "count", "count = 14"), "case.toml:13", "more than 74 %", "too-many-balls"));
  EXPECT_TRUE(faults_of(with(vial, "count", "count = 13")).empty());
  EXPECT_TRUE(
      only(with(vial, "kind = \"capsule\"", "kind = \"rounded-cylinder\"\nfillet = \"6.1 mm\""),
           "case.toml:10", "half the jar's", "fillet-too-large"));
  EXPECT_TRUE(only(with(drum, "diameter = \"20 mm", "diameter = \"60 mm\""), "case.toml:12",
                   "the ball (60 mm) is not smaller than the jar (60 mm)", "ball-too-large"));
}

TEST(CaseFaults, text_that_is_no_toml) {
  EXPECT_EQ(faults_of("title = \"x\"\nseed = = 3\n").at(0).where, "case.toml:2");
  EXPECT_EQ(faults_of("[mill]\nspeed = 400 rpm\n").at(0).where, "case.toml:2");
  EXPECT_EQ(faults_of("seed = 1\nseed = 2\n").at(0).where, "case.toml:2");
  EXPECT_EQ(faults_of("title = \"x\n").at(0).code, "not-toml");
}

TEST(CaseFaults, all_faults_come_together_and_by_line) {
  std::string text = with(vial, "frequency", "frequency = 10");
  text = with(text, "amplitude", "amplitud = \"25 mm\"");
  text = with(text, "diameter = \"8", "diameter = \"20 mm\"");
  text = with(text, "restitution", "restitution = 7");
  text = with(text, "engine", "engine = \"evnt\"");
  std::vector<std::string> places;
  for (const Fault& f : faults_of(text, {{"observe.treshold", "1 m/s"}}))
    places.push_back(f.where + " " + f.code);
  EXPECT_EQ(places,
            (std::vector<std::string>{"case.toml:3 missing-value", "case.toml:5 bad-quantity",
                                      "case.toml:6 unknown-key", "case.toml:14 ball-too-large",
                                      "case.toml:17 out-of-range", "case.toml:20 unknown-word",
                                      "--set observe.treshold unknown-key"}));
}

TEST(CaseFaults, a_case_made_by_a_program_is_checked_too) {
  const auto codes = [](auto change) {
    Case c = read_sample(vial);
    change(c);
    std::vector<std::string> found;
    for (const Fault& f : faults(c)) found.push_back(f.code);
    return found;
  };
  using Codes = std::vector<std::string>;
  const Codes out{"out-of-range"};
  EXPECT_EQ(codes([](Case&) {}), Codes{});
  EXPECT_EQ(codes([](Case& c) { c.balls[0].diameter = -1; }), out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].diameter = NAN; }), out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].count = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.balls.clear(); }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.rule.restitution = 2; }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.rule.friction = NAN; }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.pairs.push_back({{"balls", "jar"}, {2, 0, 0}}); }), out);
  EXPECT_EQ(codes([](Case& c) {
              c.contact.pairs.push_back({{"balls", "jar"}, {1, 2, -1}});
            }),
            (Codes{"out-of-range", "out-of-range"}));
  EXPECT_EQ(codes([](Case& c) {
              c.contact.pairs.push_back({{"balls", "lid"}, {1, 0, 0}});
            }),
            Codes{"unknown-name"});
  EXPECT_EQ(codes([](Case& c) { c.run.time = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.run.replicates = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.run.time_step = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.run.time_step_fraction = 2; }), out);
  EXPECT_EQ(codes([](Case& c) { c.run.step_error = 0.2; }), out);
  EXPECT_EQ(codes([](Case& c) { c.jar.elastic.youngs_modulus = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].elastic.poisson_ratio = -1; }), out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].substance.hardness = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.jar.substance.conductivity = -1; }), out);
  EXPECT_EQ(codes([](Case& c) { c.jar.density = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.jar.wall = NAN; }), out);
  EXPECT_EQ(codes([](Case& c) { c.parts.set(cases::Wear{.coefficient = 0}); }), out);
  EXPECT_EQ(codes([](Case& c) { c.heat = Heat(); }), Codes{});
  EXPECT_EQ(codes([](Case& c) { c.heat = Heat{.ambient = -1}; }), out);
  EXPECT_EQ(codes([](Case& c) { c.heat = Heat{.pause = -1}; }), out);
  EXPECT_EQ(codes([](Case& c) { c.heat = Heat{.cycles = 0}; }), out);
  EXPECT_EQ(codes([](Case& c) { c.heat = Heat{.share_in_balls = 1.1}; }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.softening = 0; }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.cohesion = -1; }), out);
  EXPECT_EQ(codes([](Case& c) { c.contact.model.law = contact::LinearSpring{{.stiffness = -1}}; }),
            out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].positions = {{0, 0, 0}, {0, 0, 0.01}}; }), out);
  EXPECT_EQ(codes([](Case& c) {
              c.balls[0].positions = {{0, NAN, 0}};
            }),
            (Codes{"out-of-range", "outside-jar"}));
  EXPECT_EQ(codes([](Case& c) { c.gravity = INFINITY; }), out);
  EXPECT_EQ(codes([](Case& c) { c.mill.jar_axis = {0, 1, 0}; }), out);
  EXPECT_EQ(codes([](Case& c) { std::get<kinematics::Vibration>(*c.mill.motion).frequency = 0; }),
            out);
  EXPECT_EQ(codes([](Case& c) { c.balls[0].diameter = 0.02; }), Codes{"ball-too-large"});
  EXPECT_EQ(codes([](Case& c) {
              c.run.time_step = 1e-6;
              c.run.time_step_fraction = 2;
            }),
            out);
  EXPECT_EQ(codes([](Case& c) { c.contact.model.rolling = static_cast<contact::Rolling>(9); }),
            out);
}

}  // namespace
}  // namespace mahlwerk::cases::faults_test
