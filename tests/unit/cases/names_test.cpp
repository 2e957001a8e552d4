// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Names of the catalogue as people write them, and names that are empty.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::names_test {
namespace {

using namespace sample;

const Catalogue& shipped() {
  static const Catalogue catalogue(std::filesystem::path(MAHLWERK_HOME) / "catalogue");
  return catalogue;
}

Case read_shipped(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_text(text, "case.toml", shipped(), overrides);
}

const Notice* find(const Notices& notices, std::string_view code) {
  const auto at = std::ranges::find(notices, code, &Notice::code);
  return at == notices.end() ? nullptr : &*at;
}

const std::string mixer = R"(title = "mixer"
[mill]
model = "retsch-mm400"
frequency = "30 Hz"
[jar]
model = "retsch-mm-25ml"
[[balls]]
count = 1
diameter = "15 mm"
material = "steel-1.4034"
[powder]
mass = "0.5 g"
[run]
time = "10 s"
)";

TEST(Names, an_empty_name_is_an_error_wherever_it_stands) {
  EXPECT_TRUE(only(with(planetary, "model = \"pot\"", "model = \"\""), "case.toml:5",
                   "`model` of [jar] is empty", "empty-text"));
  EXPECT_TRUE(only(with(planetary, "material", "material = \"  \""), "case.toml:9",
                   "`material` of [[balls]] is empty", "empty-text"));
  for (const char* key : {"mill.model", "mill.kind", "jar.model", "jar.material", "balls.material",
                          "balls.model", "powder.material", "run.start_from"}) {
    SCOPED_TRACE(key);
    const auto found = faults_of(planetary, {{key, ""}});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().code, "empty-text");
    EXPECT_EQ(found.front().where, std::string("--set ") + key);
    EXPECT_EQ(found.size(), 1U) << "and no second fault of what follows";
  }
}

TEST(Names, a_mill_without_kind_and_model_is_an_error) {
  EXPECT_TRUE(only(with(with(planetary, "speed", ""), "[jar]", "[jar]").replace(7, 12, ""),
                   "case.toml:1", "[mill] lacks `kind`", "missing-value"));
}

TEST(Names, names_are_found_as_people_write_them) {
  const auto one = [](std::string_view category, std::string_view word) {
    const auto found = shipped().entries_called(category, word);
    return found.size() == 1 ? found.front() : "";
  };
  EXPECT_EQ(one("mills", "MM 400"), "retsch-mm400");
  EXPECT_EQ(one("mills", "MM400"), "retsch-mm400");
  EXPECT_EQ(one("mills", "Retsch MM400"), "retsch-mm400");
  EXPECT_EQ(one("mills", "PM100"), "retsch-pm100");
  EXPECT_EQ(one("mills", "pm-400"), "retsch-pm400");
  EXPECT_EQ(one("mills", "SPEX 8000M"), "spex-8000m");
  EXPECT_EQ(one("mills", "Fritsch P7 premium"), "fritsch-p7-premium");
  EXPECT_EQ(one("mills", "Emax"), "retsch-emax");
  EXPECT_EQ(one("materials", "ZrO2"), "zirconia-ytzp");
  EXPECT_EQ(one("materials", "WC"), "tungsten-carbide-co6");
  EXPECT_EQ(one("materials", "stainless steel"), "steel-304");
  EXPECT_EQ(one("materials", "Steel"), "steel-1.4034");
  EXPECT_EQ(one("materials", "Al2O3"), "alumina-99.5");
  EXPECT_TRUE(shipped().entries_called("mills", "MM 4000").empty());
  EXPECT_TRUE(shipped().entries_called("mills", "--").empty());
}

TEST(Names, the_resolved_case_has_the_name_of_the_entry) {
  const Case c = read_shipped(mixer, {{"mill.model", "MM 400"},
                                      {"jar.model", "25 ml"},
                                      {"jar.material", "ZrO2"},
                                      {"balls.material", "WC"}});
  EXPECT_EQ(c.mill.model, "retsch-mm400");
  EXPECT_EQ(c.jar.model, "retsch-mm-25ml") << "of four jars of 25 ml the mill's own counts";
  EXPECT_EQ(c.jar.material, "zirconia-ytzp");
  EXPECT_EQ(c.balls[0].material, "tungsten-carbide-co6");
  EXPECT_EQ(source_of(c, "mill.model"), "--set mill.model: written as \"MM 400\"");
  EXPECT_EQ(read_shipped(write(c)), c);
}

TEST(Names, a_name_of_several_entries_lists_them) {
  try {
    read_shipped(mixer, {{"mill.model", "Fritsch P7"}});
    FAIL() << "expected a fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults()[0].code, "ambiguous-name");
    EXPECT_EQ(error.faults()[0].what,
              "model = \"Fritsch P7\" may be any of \"fritsch-p7-classic\" or "
              "\"fritsch-p7-premium\"");
  }
}

TEST(Names, two_entries_share_a_name_only_where_people_do_not_tell_them_apart) {
  for (const char* category : {"materials", "media"})
    for (const std::string& name : shipped().names(category)) {
      const CatalogueEntry entry = shipped().find(category, name);
      for (const std::string& other : entry.names)
        EXPECT_EQ(shipped().entries_called(category, other), std::vector{name}) << other;
    }
}

TEST(Names, every_mill_of_the_catalogue_runs_by_its_name_or_says_what_is_missing) {
  for (const std::string& name : shipped().names("mills")) {
    SCOPED_TRACE(name);
    const CatalogueEntry entry = shipped().find("mills", name);
    std::string chosen;  // what the user of such a mill sets
    for (const char* key : {"speed", "frequency", "amplitude", "ratio"}) {
      const auto most = entry.values.find(std::string(key) + "_most");
      if (most != entry.values.end())
        chosen += std::string(key) + " = \"" + most->second.text + "\"\n";
    }
    const std::string jar =  // the parts of a mill have their places in its jar
        entry.parts.empty() ? "kind = \"cylinder\"\ndiameter = \"40 mm\"\nheight = \"40 mm\"\n"
                            : "model = \"" + entry.jars.front() + "\"\n";
    const std::string text = "[mill]\nmodel = \"" + name + "\"\n" + chosen + "[jar]\n" + jar +
                             "[[balls]]\ndiameter = \"5 mm\"\nmaterial = \"WC\"\n[run]\ntime "
                             "= \"1 s\"\n";
    try {
      read_shipped(text);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) {
        EXPECT_EQ(fault.code, "missing-value") << fault.what;
        const bool choice = fault.what.find("`ratio`") != std::string::npos ||
                            fault.what.find("`speed`") != std::string::npos;
        EXPECT_TRUE(choice && entry.about.find("must give") != std::string::npos) << fault.what;
      }
    }
  }
}

TEST(Names, a_mixer_mill_by_its_name_has_assumed_numbers_with_a_range) {
  const Case c = read_shipped(mixer);
  const auto& shaker = std::get<kinematics::ArcShaker>(*c.mill.motion);
  EXPECT_EQ(shaker.arm, 0.136);
  EXPECT_EQ(shaker.swing, parse_in("3.8 deg", "rad"));
  const auto arm = std::ranges::find(c.origins, "mill.arm", &Origin::key);
  ASSERT_NE(arm, c.origins.end());
  EXPECT_TRUE(arm->assumed);
  EXPECT_EQ(arm->range, (std::array<std::string, 2>{"128 mm", "144 mm"}));
  const Notices notices = unusual_values(c);
  const Notice* assumed = find(notices, "assumed-mill");
  ASSERT_NE(assumed, nullptr);
  // (128 * 3.4 / (136 * 3.8))^2 - 1 and (144 * 4.2 / (136 * 3.8))^2 - 1
  EXPECT_NE(assumed->text.find("by -29 to +37 %"), std::string::npos) << assumed->text;
  EXPECT_EQ(
      find(unusual_values(read_shipped(mixer, {{"mill.arm", "136 mm"}, {"mill.swing", "3.8 deg"}})),
           "assumed-mill"),
      nullptr);
}

TEST(Names, a_missing_number_of_a_mill_is_proposed_from_its_own_range) {
  EXPECT_TRUE(
      only(with(planetary, "speed", ""), "case.toml:1",
           "Test mills/p7 offers 100 rpm to 800 rpm: write for instance speed = \"800 rpm\"",
           "missing-value"));
}

TEST(Names, a_speed_that_the_maker_does_not_offer_gets_a_warning_and_is_taken) {
  const auto warned = [](const std::string& line) {
    return unusual_values(read_sample(with(planetary, "speed", line)));
  };
  for (const char* beyond : {"900 rpm", "1 Hz", "-900 rpm", "99.9 rpm"}) {
    const Notices notices = warned(fmt::format("speed = \"{}\"", beyond));
    const Notice* told = find(notices, "beyond-mill-range");
    ASSERT_NE(told, nullptr) << beyond;
    EXPECT_TRUE(told->warns());
    EXPECT_TRUE(told->text.starts_with(fmt::format(
        "mill.speed is {}, which Test mills/p7 does not offer: its range is 100 rpm to 800 rpm",
        beyond)))
        << told->text;
  }
  for (const char* offered : {"100 rpm", "800 rpm", "-800 rpm"})
    EXPECT_EQ(find(warned(fmt::format("speed = \"{}\"", offered)), "beyond-mill-range"), nullptr)
        << offered;
}

TEST(Names, a_jar_of_another_mill_gets_a_warning) {
  const Notices notices = unusual_values(read_shipped(mixer, {{"jar.model", "retsch-pm-250ml"}}));
  const Notice* jar = find(notices, "jar-of-another-mill");
  ASSERT_NE(jar, nullptr);
  EXPECT_TRUE(jar->warns());
  EXPECT_NE(jar->text.find("Retsch PM 100"), std::string::npos) << jar->text;
  EXPECT_NE(jar->text.find("retsch-mm-25ml"), std::string::npos) << jar->text;
  EXPECT_EQ(find(unusual_values(read_shipped(mixer)), "jar-of-another-mill"), nullptr);
}

TEST(Names, a_ball_set_of_the_catalogue_may_bring_its_material) {
  const Case c = read_shipped(R"([mill]
model = "spex-8000m"
[jar]
model = "spex-vial-62ml"
[[balls]]
model = "spex-2x12.7mm"
[run]
time = "1 s"
)");
  EXPECT_EQ(c.balls[0].material, "steel-100cr6");
  const auto material = std::ranges::find(c.origins, "balls.1.material", &Origin::key);
  ASSERT_NE(material, c.origins.end());
  EXPECT_TRUE(material->assumed);
}

TEST(Names, balls_by_mass_are_the_nearest_number_and_the_deviation_is_told) {
  const auto heavy = [](const std::string& mass) {
    return unusual_values(read_sample(with(with(planetary, "count", "mass = \"" + mass + "\""),
                                           "diameter", "diameter = \"20 mm\"")));
  };
  // One ball of 20 mm of 7700 kg/m3: 32.254 g. 40 g is 1.24 balls, 50 g is 1.55.
  const Notices one = heavy("40 g"), two = heavy("50 g");
  ASSERT_NE(find(one, "count-rounded"), nullptr);
  ASSERT_NE(find(two, "count-rounded"), nullptr);
  EXPECT_NE(find(one, "count-rounded")
                ->text.find("The nearest whole number is 1, which makes "
                            "32.25 g: -19.4 %"),
            std::string::npos)
      << find(one, "count-rounded")->text;
  EXPECT_NE(find(two, "count-rounded")
                ->text.find("The nearest whole number is 2, which makes "
                            "64.51 g: +29.0 %"),
            std::string::npos)
      << find(two, "count-rounded")->text;
  EXPECT_TRUE(find(one, "count-rounded")->warns());
  EXPECT_EQ(find(heavy("64.6 g"), "count-rounded"), nullptr);
}

}  // namespace
}  // namespace mahlwerk::cases::names_test
