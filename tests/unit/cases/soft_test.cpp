// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Keys of a case for the soft engine: moduli, contact law, time step.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::soft_test {
namespace {

using namespace sample;
using contact::ElasticConstants;
using contact::Rolling;

/// The planetary mill; these lines replace its restitution, in line 15 of the file.
std::string with_contact(const std::string& lines) {
  return with(planetary, "restitution", lines);
}
Contact contact_of(const std::string& lines) {
  return read_sample(with_contact(lines)).contact;
}
/// The only fault as "line code"; all faults if their number is not one.
std::string fault(const std::string& text) {
  const auto found = faults_of(text);
  if (found.size() != 1) return fault_of(text);
  return found[0].where.substr(found[0].where.find(':') + 1) + " " + found[0].code;
}
bool assumed(const Case& c, std::string_view key) {
  const auto at = std::ranges::find(c.origins, key, &Origin::key);
  return at != c.origins.end() && at->assumed;
}

TEST(ReadModuli, from_the_case_the_material_or_steel) {
  const Case c = read_sample(planetary);
  EXPECT_EQ(c.balls[0].elastic, (ElasticConstants{200e9, 0.265}));
  EXPECT_EQ(c.jar.elastic, (ElasticConstants{200e9, 0.265}));
  EXPECT_EQ(source_of(c, "jar.youngs_modulus"), "catalogue materials/steel: test sheet");
  EXPECT_FALSE(assumed(c, "jar.youngs_modulus"));
  const Case own =
      read_sample(with(planetary, "material", "material = \"steel\"\nyoungs_modulus = \"70 GPa\""));
  EXPECT_EQ(own.balls[0].elastic, (ElasticConstants{70e9, 0.265}));
  EXPECT_EQ(source_of(own, "balls.1.youngs_modulus"), "case.toml:10");
  const Case tic = read_sample(planetary, {{"balls.material", "tic"}, {"jar.material", "glass"}});
  EXPECT_EQ(tic.balls[0].elastic, (ElasticConstants{210e9, 0.3}));
  EXPECT_EQ(source_of(tic, "balls.1.youngs_modulus"),
            "default: steel, handbook; uncalibrated; the catalogue gives none for tic");
  EXPECT_EQ(tic.jar.elastic, (ElasticConstants{210e9, 0.3}));  // unknown to the catalogue: allowed
  const Case none = read_sample(drum, {{"balls.2.poisson_ratio", "0.5"}});
  EXPECT_EQ(none.balls[1].elastic, (ElasticConstants{210e9, 0.5}));
  EXPECT_EQ(source_of(none, "jar.poisson_ratio"), "default: steel, handbook; uncalibrated");
}

TEST(ReadModuli, the_command_line_s_material_is_before_the_file_s_modulus) {
  const std::string text =
      with(drum, "density", "density = \"1 g/cm3\"\nyoungs_modulus = \"3 GPa\"");
  EXPECT_EQ(read_sample(text).balls[0].elastic.youngs_modulus, 3e9);
  EXPECT_EQ(read_sample(text, {{"balls.material", "steel"}}).balls[0].elastic.youngs_modulus,
            200e9);
}

TEST(ReadModuli, out_of_range) {
  const auto ball = [](const std::string& line) { return fault(with(planetary, "count", line)); };
  EXPECT_EQ(ball("youngs_modulus = \"0 Pa\""), "7 out-of-range");
  EXPECT_EQ(ball("youngs_modulus = 200"), "7 bad-quantity");
  EXPECT_EQ(ball("youngs_modulus = \"200 g\""), "7 bad-quantity");
  EXPECT_EQ(ball("poisson_ratio = 0.51"), "7 out-of-range");
  EXPECT_EQ(ball("poisson_ratio = -1"), "7 out-of-range");
}

TEST(ReadOrigins, what_an_engine_does_not_look_at_is_not_assumed) {
  const auto of = [](const char* engine) { return read_sample(drum, {{"run.engine", engine}}); };
  for (const char* key : {"balls.1.youngs_modulus", "jar.poisson_ratio", "contact.law",
                          "contact.rolling", "contact.softening", "run.hop"}) {
    EXPECT_FALSE(assumed(of("event"), key)) << key;
    EXPECT_TRUE(assumed(of("soft"), key)) << key;
    EXPECT_TRUE(assumed(of("auto"), key)) << key;
    EXPECT_NE(source_of(of("event"), key), "") << key;
  }
  for (const char* key : {"contact.lasting", "contact.contact_time"}) {
    EXPECT_TRUE(assumed(of("event"), key)) << key;
    EXPECT_FALSE(assumed(of("soft"), key)) << key;
  }
  EXPECT_TRUE(assumed(of("soft"), "contact.friction"));
}

TEST(ReadLaw, defaults) {
  const Contact c = contact_of("restitution = 0.35");
  EXPECT_EQ(c.model, contact::ContactModel());
  EXPECT_TRUE(std::holds_alternative<contact::HertzMindlin>(*c.model.law));
  EXPECT_EQ(c.model.rolling, Rolling::cdt);
  EXPECT_EQ(c.softening, 1);
  EXPECT_EQ(c.rolling_friction, 0.01);
  const Case damped = read_sample(with_contact("law = \"adams-impact\""));
  EXPECT_EQ(*damped.contact.model.law, contact::AnyLaw(contact::AdamsImpact()));
  EXPECT_TRUE(assumed(damped, "contact.damping_depth"));
  EXPECT_TRUE(
      assumed(read_sample(with_contact("law = \"walton-braun\"")), "contact.stiffness_speed"));
}

TEST(ReadLaw, every_word_and_its_numbers) {
  for (const contact::AnyLaw& law : contact::all_laws()) {
    const std::string word(contact::name_of(law));
    std::string lines = "law = \"" + word + "\"\n";
    if (word == "jkr") lines += "surface_energy = \"0 J/m2\"";
    if (word == "sjkr") lines += "cohesion = \"10 kJ/m3\"";
    if (word == "capillary") lines += "surface_tension = \"72.8 mN/m\"";
    const Contact c = contact_of(lines);
    EXPECT_EQ(*c.model.law, law) << word;
    EXPECT_EQ(c.cohesion, word == "sjkr" ? 1e4 : 0);
  }
  const auto spring = contact_of("law = \"linear-spring\"\nstiffness = \"1e6 N/m\"").model;
  EXPECT_EQ(spring.law, contact::AnyLaw(contact::LinearSpring{{.stiffness = 1e6}}));
  const auto quick = contact_of("law = \"walton-braun\"\nstiffness_speed = \"2 m/s\"").model;
  EXPECT_EQ(quick.law, contact::AnyLaw(contact::WaltonBraun{{.stiffness_speed = 2}}));
  const auto adams =
      contact_of("law = \"adams-impact\"\ndamping = \"published\"\ndamping_depth = \"1 um\"");
  contact::AdamsImpact published;
  published.published_damping = true;
  published.damping_depth = 1e-6;
  EXPECT_EQ(*adams.model.law, contact::AnyLaw(published));
  contact::ThorntonNing yielding;
  yielding.yield_pressure = 3e9;
  EXPECT_EQ(*contact_of("law = \"thornton-ning\"\nyield_pressure = \"3 GPa\"").model.law,
            contact::AnyLaw(yielding));
  const Contact wet = contact_of(
      "law = \"capillary\"\nsurface_tension = \"50 mN/m\"\nbridge_volume = \"0.01 ul\"\n"
      "contact_angle = \"30 deg\"");
  EXPECT_EQ(wet.surface_tension, 0.05);
  const auto& capillary = std::get<contact::Capillary>(*wet.model.law);
  EXPECT_DOUBLE_EQ(capillary.bridge_volume, 1e-11);
  EXPECT_NEAR(capillary.contact_angle, std::numbers::pi / 6, 1e-15);
  EXPECT_TRUE(contact_of("curved_walls = true").model.curved_walls);
  EXPECT_TRUE(contact_of("rescaled_unloading = true").model.rescaled_unloading);
}

TEST(ReadLaw, rolling_resistance) {
  EXPECT_EQ(contact_of("rolling = \"none\"").rolling_friction, 0);
  EXPECT_EQ(contact_of("rolling = \"epsd\"\nrolling_damping = 0.3").model.rolling_damping, 0.3);
  const Case undamped = read_sample(with_contact("rolling = \"epsd\"\nrolling_damping = 0"));
  EXPECT_EQ(read_sample(write(undamped)).contact.model.rolling_damping, 0) << "not the default";
  const std::string viscous = "rolling = \"viscous\"\n";
  EXPECT_EQ(contact_of(viscous + "rolling_friction = \"0.2 s/m\"").rolling_friction, 0.2);
  EXPECT_EQ(fault(with_contact(viscous)), "14 missing-value");
  EXPECT_EQ(fault(with_contact(viscous + "rolling_friction = 0.2")), "16 bad-quantity");
  EXPECT_EQ(fault(with_contact("rolling_friction = \"0.2 s/m\"")), "15 bad-quantity");
  EXPECT_EQ(fault(with_contact("rolling = \"none\"\nrolling_friction = 0.2")), "16 too-much");
  EXPECT_EQ(fault(with_contact("rolling_damping = 0.3")), "15 too-much");
}

TEST(ReadLaw, what_another_law_has_is_a_fault) {
  EXPECT_EQ(fault(with_contact("law = \"jkr\"")), "14 missing-value");
  EXPECT_EQ(fault(with_contact("law = \"sjkr\"")), "14 missing-value");
  EXPECT_EQ(fault(with_contact("law = \"jkr\"\nsurface_energy = \"-1 J/m2\"")), "16 out-of-range");
  EXPECT_EQ(fault(with_contact("law = \"jkr\"\nsurface_energy = \"1 J\"")), "16 bad-quantity");
  for (const char* line :
       {"surface_energy = \"1 J/m2\"", "cohesion = \"1 J/m3\"", "stiffness = \"1 N/m\"",
        "stiffness_speed = \"1 m/s\"", "damping = \"exact\"", "damping_depth = \"1 um\""})
    EXPECT_EQ(fault(with_contact(line)), "15 too-much") << line;
  EXPECT_NE(fault_of(with_contact("cohesion = \"1 J/m3\""))
                .find("cohesion has no meaning under law = \"hertz-mindlin\""),
            std::string::npos);
  EXPECT_EQ(fault(with_contact("law = \"linear-spring\"\nstiffness = \"1 N/m\"\n"
                               "stiffness_speed = \"1 m/s\"")),
            "16 too-much");
  EXPECT_EQ(fault(with_contact("law = \"jrk\"\nsurface_energy = \"1 J/m2\"")), "15 unknown-word");
  EXPECT_EQ(fault(with_contact("softening = 1.5")), "15 out-of-range");
}

TEST(ReadLaw, pairs_inherit_and_differ) {
  const std::string jkr = "law = \"jkr\"\nsurface_energy = \"1 J/m2\"\nrolling_friction = 0.05\n";
  const std::string pair = "pairs = [{between = [\"balls\", \"jar\"]";
  const Contact c = contact_of(jkr + pair + ", surface_energy = \"2 J/m2\"}]");
  EXPECT_EQ(c.pairs[0].surface_energy, 2);
  EXPECT_EQ(c.pairs[0].rolling_friction, 0.05);
  EXPECT_EQ(c.surface_energy, 1);
  EXPECT_EQ(fault(with_contact(pair + ", cohesion = \"2 J/m3\"}]")), "15 too-much");
}

TEST(ReadStep, a_time_or_a_share) {
  const auto run = [](const std::string& lines) {
    return read_sample(with(planetary, "settle", lines)).run;
  };
  EXPECT_FALSE(run("").time_step.has_value());
  EXPECT_EQ(run("").time_step_fraction, 0.25);
  EXPECT_EQ(run("").step_error, 0.01);
  EXPECT_EQ(run("step_error = \"0.5 %\"").step_error, 0.005);
  EXPECT_TRUE(run("").free_flight_skip);
  EXPECT_EQ(run("time_step = \"1 us\"").time_step, 1e-6);
  EXPECT_EQ(run("time_step_fraction = \"10 %\"").time_step_fraction, 0.1);
  EXPECT_FALSE(run("hop = false").free_flight_skip);
  EXPECT_EQ(run("start_frame = \"jar\"").start_frame, StartFrame::jar);
  const auto bad = [](const std::string& lines) { return fault(with(planetary, "settle", lines)); };
  EXPECT_EQ(bad("time_step = \"0 s\""), "20 out-of-range");
  EXPECT_EQ(bad("time_step_fraction = 0"), "20 out-of-range");
  EXPECT_EQ(bad("time_step_fraction = 1.1"), "20 out-of-range");
  EXPECT_EQ(bad("step_error = 0"), "20 out-of-range");
  EXPECT_EQ(bad("time_step = \"1 us\"\ntime_step_fraction = 0.1"), "21 too-much");
  EXPECT_EQ(bad("time_step = \"1 us\"\nstep_error = 0.1"), "21 too-much");
  EXPECT_EQ(bad("start_frame = \"disc\""), "20 unknown-word");
  const Case c =
      read_sample(with(planetary, "settle", "time_step_fraction = 0.1\nstep_error = 0.02"),
                  {{"run.time_step", "2 us"}});
  EXPECT_EQ(c.run.time_step, 2e-6);
}

TEST(Twisting, makes_the_event_engine_read_the_moduli_and_says_where_it_does_not_act) {
  const auto codes = [](const Case& c) {
    std::string all;
    for (const Notice& one : ignored_keys(c, c.run.engine)) all += one.code + " ";
    return all;
  };
  const Override marshall{"contact.twisting", "marshall"};
  EXPECT_FALSE(assumed(read_sample(vial), "balls.1.youngs_modulus"));
  EXPECT_TRUE(assumed(read_sample(vial, {marshall}), "balls.1.youngs_modulus"));
  EXPECT_EQ(codes(read_sample(vial, {marshall})), "") << "one ball rolls: lasting = roll";
  EXPECT_EQ(codes(read_sample(vial, {marshall, {"contact.lasting", "tc"}})),
            "twisting-in-impacts ");
  EXPECT_EQ(codes(read_sample(vial, {marshall, {"contact.lasting", "tc"}, {"run.engine", "soft"}})),
            "ignored-keys ")
      << "the soft engine has it everywhere";
}

// Expected: the keys that a case gives and whose description does not name the engine.
TEST(IgnoredKeys, are_those_that_the_engine_does_not_read) {
  const std::vector<Override> given{
      {"contact.softening", "0.5"},        {"contact.tangential_restitution", "0.2"},
      {"contact.lasting_speed", "1 mm/s"}, {"run.hop", "false"},
      {"run.time_step", "1 us"},           {"contact.rolling_friction", "0.02"}};
  const Case c = read_sample(vial, given);
  for (const EngineName engine :
       {EngineName::event, EngineName::soft, EngineName::lammps, EngineName::automatic}) {
    const Notices notes = ignored_keys(c, engine);
    const std::string text = notes.empty() ? "" : notes.back().text;
    for (const Override& one : given) {
      const KeyInfo& key = *find_key(one.key);
      const bool read = engine == EngineName::automatic ||
                        std::ranges::find(key.engines, name_of(engine)) != key.engines.end();
      EXPECT_EQ(text.find(one.key) == std::string::npos, read) << one.key << ": " << text;
    }
  }
  EXPECT_EQ(find_key("contact.softening")->engines, (std::vector<std::string>{"soft", "lammps"}));
  EXPECT_EQ(find_key("run.hop")->engines, std::vector<std::string>{"soft"});
  EXPECT_EQ(find_key("contact.lasting_speed")->engines, std::vector<std::string>{"event"});
  EXPECT_EQ(find_key("contact.rolling_friction")->engines.size(), 3U);
}

}  // namespace
}  // namespace mahlwerk::cases::soft_test
