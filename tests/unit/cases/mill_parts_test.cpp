// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Mills of the catalogue that bring parts, and parts that move together.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/catalogue/catalogue_read.hpp"
#include "mahlwerk/cases/catalogue/catalogue_write.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "unit/cases/sample.hpp"
#include "unit/cases/shipped_catalogue.hpp"

namespace mahlwerk::cases::mill_parts_test {
namespace {

using namespace sample;

constexpr std::string_view rest = R"(
[[balls]]
diameter = "20 mm"
density = "2500 kg/m3"
count = 5
[contact]
restitution = 0.5
[run]
engine = "soft"
time = "1 s"
)";

std::string mixer(const std::string& more = "") {
  return "title = \"Mixer\"\n[mill]\nmodel = \"bladed-mixer\"\n[jar]\nmodel = \"mixer-100mm\"\n" +
         more + std::string(rest);
}

Case read_shipped(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_text(text, "trial.toml", shipped(), overrides);
}

std::string complaint(const std::string& text) {
  try {
    read_shipped(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MillParts, are_those_of_the_catalogue_with_their_source) {
  const Case c = read_shipped(mixer());
  ASSERT_EQ(c.machine_parts.size(), 4U);
  for (const MachinePart& part : c.machine_parts) {
    EXPECT_EQ(part.body.motion.speed, 6) << part.name;
    EXPECT_EQ(part.body.motion.pivot, Vec3{}) << "all blades turn about the axis of the vessel";
    EXPECT_NEAR(norm(part.body.position - Vec3{0, 0, -0.045}), 0.02, 1e-15) << part.name;
    EXPECT_NEAR(part.body.axes.ez.z, std::numbers::sqrt2 / 2, 1e-15) << "pitched by 45 degrees";
    // A blade lies along the radius to its middle.
    EXPECT_NEAR(std::abs(dot(part.body.axes.ex, part.body.position)), 0.02, 1e-15) << part.name;
  }
  const auto length = std::ranges::find(c.origins, "parts.1.length", &Origin::key);
  ASSERT_NE(length, c.origins.end());
  EXPECT_TRUE(length->source.starts_with("catalogue mills/bladed-mixer: ")) << length->source;
  EXPECT_TRUE(length->unverified);
}

TEST(MillParts, have_the_keys_that_the_case_gives_under_their_name) {
  const std::string faster =
      "[[parts]]\nname = \"blade-1\"\nspeed = \"60 rpm\"\n"
      "[[parts]]\nname = \"rod\"\nkind = \"cylinder\"\ndiameter = \"8 mm\"\n"
      "length = \"50 mm\"\n";
  const Case c = read_shipped(mixer(faster));
  ASSERT_EQ(c.machine_parts.size(), 5U);
  EXPECT_EQ(c.machine_parts[4].name, "rod") << "the case's own parts follow";
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(c.machine_parts[i].body.motion.speed, 2 * std::numbers::pi, 1e-14);
  const Case set = read_shipped(mixer(), {{"parts.1.speed", "60 rpm", ValueSource::command}});
  EXPECT_EQ(set.machine_parts[3].body.motion, c.machine_parts[3].body.motion);
}

TEST(MillParts, that_the_case_gives_twice_are_refused) {
  const std::string two =
      "[[parts]]\nname = \"a\"\nkind = \"disc\"\ndiameter = \"9 mm\"\n"
      "thickness = \"2 mm\"\n";
  EXPECT_NE(complaint(mixer(two + two)).find("two parts have the name \"a\""), std::string::npos)
      << complaint(mixer(two + two));
}

TEST(MillParts, that_the_case_stops_lose_the_motion_of_the_mill) {
  const Case made =
      read_shipped(mixer("[[parts]]\nname = \"" + read_shipped(mixer()).machine_parts.front().name +
                         "\"\nmotion = \"fixed\"\n"));
  EXPECT_FALSE(made.machine_parts.front().body.motion.moves());
}

TEST(MillParts, of_a_mill_that_the_command_names_are_those_of_that_mill) {
  const Case c = read_shipped(mixer(), {{"mill.model", "minicer-pins", ValueSource::command}});
  EXPECT_EQ(c.machine_parts.size(), 8U);
  EXPECT_EQ(c.machine_parts[0].name, "rotor");
  EXPECT_EQ(c.mill.jar_axis, kinematics::lying) << "the catalogue gives the axis of the jar";
}

TEST(MillParts, are_written_and_read_again_without_the_catalogue) {
  const Case c = read_shipped(mixer());
  const Case again = read_sample(write(c));  // a catalogue without this mill
  EXPECT_EQ(again.machine_parts, c.machine_parts);
}

TEST(MillParts, of_every_mill_stand_in_each_of_its_jars) {
  for (const std::string& name : shipped().names("mills")) {
    const CatalogueEntry mill = shipped().find("mills", name);
    if (mill.parts.empty()) continue;
    EXPECT_FALSE(mill.jars.empty()) << "parts have their places in a certain jar";
    for (const std::string& jar : mill.jars) {
      const std::string text = "[mill]\nmodel = \"" + name + "\"\n[jar]\nmodel = \"" + jar + "\"\n";
      std::string set = std::string(rest);
      set.replace(set.find("20 mm"), 5, "2 mm");
      EXPECT_EQ(complaint(text + set), "") << name << " with " << jar;
    }
  }
}

TEST(MillParts, need_a_name_and_a_source_in_the_catalogue) {
  const std::string good =
      "title = \"A mill\"\nkind = \"still\"\nabout = \"For trial.\"\n"
      "[[parts]]\nname = \"rod\"\nkind = \"cylinder\"\nposition = [\"1 mm\", \"0 mm\", \"-2 mm\"]\n"
      "opening = 0.25\nsource = \"a ruler\"\n";
  const auto said = [](const std::string& text) -> std::string {
    try {
      read_entry(text, "mills", "trial", "trial.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said(good), "");
  EXPECT_NE(said(with(good, "source", "")).find("trial.toml:4: source is missing"),
            std::string::npos);
  EXPECT_NE(said(with(good, "name", "")).find("trial.toml:4: name is missing"), std::string::npos);
  EXPECT_NE(said(good + "confidence = \"measured\"\n").find("trial.toml:10: confidence"),
            std::string::npos);
  const CatalogueEntry entry =
      read_entry(good + "confidence = \"assumed\"\n", "mills", "trial", "trial.toml");
  ASSERT_EQ(entry.parts.size(), 1U);
  EXPECT_TRUE(entry.parts[0].assumed);
  EXPECT_EQ(read_entry(entry_text(entry), "mills", "trial", "trial.toml").parts, entry.parts);
}

/// A still vessel with a shaft and a disc that moves with a part.
std::string vessel(const std::string& of_disc) {
  return "[mill]\nkind = \"still\"\n[jar]\nkind = \"cylinder\"\ndiameter = \"100 mm\"\n"
         "height = \"100 mm\"\n"
         "[[parts]]\nname = \"shaft\"\nkind = \"cylinder\"\ndiameter = \"20 mm\"\n"
         "length = \"90 mm\"\nposition = [\"0 mm\", \"0 mm\", \"5 mm\"]\nmotion = \"turning\"\n"
         "speed = \"300 rpm\"\n"
         "[[parts]]\nname = \"disc\"\nkind = \"disc\"\ndiameter = \"60 mm\"\n"
         "thickness = \"5 mm\"\nposition = [\"0 mm\", \"0 mm\", \"-20 mm\"]\n" +
         of_disc + std::string(rest);
}

TEST(MovesWith, gives_a_part_the_motion_of_another_about_the_same_pivot) {
  const Case c = read_shipped(vessel("moves_with = \"shaft\"\n"));
  EXPECT_EQ(c.machine_parts[1].body.motion, c.machine_parts[0].body.motion);
  EXPECT_NEAR(c.machine_parts[1].body.motion.pivot.z, 0.005, 1e-15);
  EXPECT_EQ(read_shipped(write(c)).machine_parts, c.machine_parts);
}

TEST(MovesWith, refuses_what_cannot_be) {
  EXPECT_NE(complaint(vessel("moves_with = \"axle\"\n")).find("cannot move with \"axle\""),
            std::string::npos);
  EXPECT_NE(complaint(vessel("moves_with = \"disc\"\n")).find("name the part that has the motion"),
            std::string::npos);
  EXPECT_NE(complaint(vessel("moves_with = \"shaft\"\nframe = \"laboratory\"\n"))
                .find("give both parts the same frame"),
            std::string::npos);
  EXPECT_NE(complaint(vessel("moves_with = \"shaft\"\nspeed = \"10 rpm\"\n"))
                .find("speed has no meaning for a part that moves with another"),
            std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::cases::mill_parts_test
