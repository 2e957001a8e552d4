// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/catalogue/catalogue_keys.hpp"
#include "unit/cases/shipped_catalogue.hpp"

namespace mahlwerk::cases::catalogue_test {
namespace {

namespace fs = std::filesystem;
using sample::for_each_entry;
using sample::shipped;

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::ranges::find(list, word) != list.end();
}

TEST(Catalogue, every_room_is_filled) {
  EXPECT_GE(shipped().names("mills").size(), 20u);
  EXPECT_GE(shipped().names("jars").size(), 7u);
  EXPECT_GE(shipped().names("materials").size(), 16u);
  EXPECT_GE(shipped().names("media").size(), 15u);
  for (const std::string_view category : Catalogue::categories)
    EXPECT_TRUE(std::ranges::is_sorted(shipped().names(category))) << category;
}

TEST(Catalogue, every_check_in_every_file_holds) {
  int checks = 0;
  for_each_entry([&](const CatalogueEntry& entry) {
    for (const CatalogueCheck& check : entry.checks) {
      ++checks;
      double found = 0;
      ASSERT_NO_THROW(found = derived(entry, check.quantity));
      EXPECT_LE(std::abs(found - check.expected), check.tolerance * std::abs(check.expected))
          << check.quantity << ": expected " << check.expected << ", found " << found
          << ", tolerance " << check.tolerance << ", source: " << check.source;
    }
  });
  EXPECT_GE(checks, 20);
}

TEST(Catalogue, the_name_of_a_file_has_small_letters_digits_hyphens_and_points) {
  for_each_entry([&](const CatalogueEntry& entry) {
    EXPECT_EQ(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-."),
              std::string::npos)
        << "rename the file: the name is the word in a case";
  });
}

TEST(Catalogue, every_value_has_a_source_and_is_a_quantity_of_its_keys_unit) {
  for_each_entry([&](const CatalogueEntry& entry) {
    EXPECT_FALSE(entry.values.empty());
    const auto keys = catalogue_keys(entry.category, entry.kind);
    for (const auto& [key, value] : entry.values) {
      SCOPED_TRACE(key + " = " + value.text);
      EXPECT_FALSE(value.source.empty());
      const auto known = std::ranges::find(keys, key, &CatalogueKey::key);
      ASSERT_NE(known, keys.end());
      if (known->unit == an_axis) continue;
      if (known->unit == a_material) {
        EXPECT_TRUE(has(shipped().names("materials"), value.text));
        continue;
      }
      double number = NAN;
      ASSERT_NO_THROW(number = number_of(value.text, *known));
      EXPECT_TRUE(known->range.holds(number));
    }
  });
}

/// Volumetric heat capacity differs little between polymers and metals: a value far off is a
/// mistake.
TEST(Catalogue, every_material_conducts_and_stores_heat_as_solids_do) {
  for_each_entry([&](const CatalogueEntry& entry) {
    if (entry.category != "materials" || entry.values.contains("viscosity")) return;
    const auto number = [&](const char* key, const char* unit) {
      return parse_in(entry.values.at(key).text, unit);
    };
    const double conductivity = number("conductivity", "W/m/K");
    EXPECT_TRUE(conductivity > 0.05 && conductivity < 500) << conductivity;
    const double by_volume = number("density", "kg/m3") * number("heat_capacity", "J/kg/K");
    EXPECT_TRUE(by_volume > 1.5e6 && by_volume < 4.5e6) << by_volume << " J/(m3 K)";
  });
}

TEST(Catalogue, every_liquid_flows_and_weighs_as_solvents_do) {
  int liquids = 0;
  for_each_entry([&](const CatalogueEntry& entry) {
    const auto viscosity = entry.values.find("viscosity");
    if (viscosity == entry.values.end()) return;
    ++liquids;
    const double eta = parse_in(viscosity->second.text, "Pa s");
    EXPECT_TRUE(eta > 2e-4 && eta < 5e-3) << eta;
    const double density = parse_in(entry.values.at("density").text, "kg/m3");
    EXPECT_TRUE(density > 600 && density < 1700) << density;
  });
  EXPECT_EQ(liquids, 5);
}

TEST(Catalogue, what_has_no_public_source_is_marked_unverified_or_has_a_range) {
  for_each_entry([&](const CatalogueEntry& entry) {
    for (const auto& [key, value] : entry.values) {
      const bool weak = value.source.find("no public source") != std::string::npos;
      EXPECT_TRUE(value.unverified || value.assumed || !weak) << key;
    }
  });
}

TEST(Catalogue, an_unknown_name_that_is_near_none_suggests_those_that_share_its_words) {
  const auto remedy = [](const char* category, const char* name) -> std::string {
    try {
      shipped().find(category, name, "here");
    } catch (const InputError& error) {
      return error.faults().front().remedy;
    }
    return "found";
  };
  EXPECT_EQ(remedy("media", "former-5x15mm"),
            "did you mean 'mhadhbi-2021-5x15mm'? `mahlwerk list media` shows them all");
  const std::string steels = remedy("materials", "steel-former-name");
  EXPECT_NE(steels.find("'steel-chen-2016' or 'steel-mhadhbi-2021'"), std::string::npos) << steels;
  EXPECT_EQ(remedy("materials", "unobtainium"), "`mahlwerk list materials` shows them all");
}

TEST(Catalogue, every_mill_is_a_known_motion_and_its_jars_exist) {
  const auto motions = catalogue_kinds("mills");
  const auto jars = shipped().names("jars");
  for_each_entry([&](const CatalogueEntry& entry) {
    if (entry.category != "mills") return;
    EXPECT_TRUE(has(motions, entry.kind)) << entry.kind;
    for (const std::string& jar : entry.jars) EXPECT_TRUE(has(jars, jar)) << jar;
    for (const auto& [key, value] : entry.values) {  // least <= most
      if (!key.ends_with("_least")) continue;
      const auto most = entry.values.find(key.substr(0, key.size() - 5) + "most");
      if (most == entry.values.end()) continue;
      const auto keys = catalogue_keys(entry.category, entry.kind);
      const auto known = *std::ranges::find(keys, key, &CatalogueKey::key);
      EXPECT_LE(number_of(value.text, known), number_of(most->second.text, known)) << key;
    }
  });
}

TEST(Catalogue, every_jar_can_be_built_and_every_planetary_g_figure_is_checked) {
  for_each_entry([&](const CatalogueEntry& entry) {
    if (entry.category == "jars") {
      const bool by_volume = !entry.values.contains("height") && entry.kind != "sphere";
      EXPECT_GT(
          by_volume ? parse_in(entry.values.at("volume").text, "m3") : derived(entry, "jar_volume"),
          0);
    }
    if (entry.kind != "planetary" || !entry.values.contains("speed_most")) return;
    if (entry.name == "fritsch-p4") return;  // no g figure is known for it
    EXPECT_TRUE(std::ranges::any_of(
        entry.checks,
        [](const CatalogueCheck& check) {
          return check.quantity == "relative_centrifugal_acceleration" && check.tolerance <= 0.03;
        }))
        << "give the maker's g figure: [[check]] of relative_centrifugal_acceleration within 3 %, "
           "or "
           "name the mill here if none is known";
  });
}

TEST(Catalogue, ball_sets_give_diameter_and_a_whole_number_of_balls) {
  for_each_entry([&](const CatalogueEntry& entry) {
    if (entry.category != "media") return;
    EXPECT_GT(parse_in(entry.values.at("diameter").text, "m"), 0);
    const double count = parse_in(entry.values.at("count").text, "");
    EXPECT_EQ(count, std::round(count));
  });
}

TEST(Catalogue, the_p7_of_mhadhbi_reads_as_the_file_says) {
  const CatalogueEntry p7 = shipped().find("mills", "fritsch-p7-classic");
  EXPECT_EQ(p7.kind, "planetary");
  EXPECT_EQ(p7.values.at("ratio").text, "1:-2");
  EXPECT_EQ(p7.jars, (std::vector<std::string>{"fritsch-12ml", "fritsch-45ml-steel"}));
  // Omega^2 R_p / 9.81 at 800 rpm and 70 mm, physics sheet 1.8: 50.1
  EXPECT_NEAR(derived(p7, "relative_centrifugal_acceleration"), 50.08, 0.01);
  EXPECT_TRUE(shipped().find("mills", "retsch-pm100").values.at("orbit_radius").assumed);
  EXPECT_FALSE(p7.values.at("orbit_radius").unverified);
}

TEST(Catalogue, a_ratio_is_jar_over_disc) {
  const auto keys = catalogue_keys("mills", "planetary");
  const auto ratio = *std::ranges::find(keys, "ratio", &CatalogueKey::key);
  EXPECT_DOUBLE_EQ(number_of("1:-2", ratio), -2);
  EXPECT_DOUBLE_EQ(number_of("1:-2.19", ratio), -2.19);
  EXPECT_DOUBLE_EQ(number_of("-1.82", ratio), -1.82);
  EXPECT_THROW(number_of("1:", ratio), UnitError);
}

TEST(Catalogue, an_unknown_name_gets_the_nearest_ones) {
  const auto said = [](std::string_view category, std::string_view name) -> Fault {
    try {
      shipped().find(category, name, "case.toml:4");
    } catch (const InputError& error) {
      return error.faults().at(0);
    }
    return {};
  };
  const Fault misspelt = said("mills", "fritsch-p7-clasic");
  EXPECT_EQ(misspelt.where, "case.toml:4");
  EXPECT_NE(misspelt.remedy.find("'fritsch-p7-classic'"), std::string::npos) << misspelt.remedy;
  const Fault part = said("mills", "pm10");
  EXPECT_NE(part.remedy.find("'retsch-pm100' or 'retsch-pm100-cm'"), std::string::npos)
      << part.remedy;
  const Fault words = said("mills", "Fritsch P7");
  EXPECT_EQ(words.code, "ambiguous-name");
  EXPECT_NE(words.what.find("'fritsch-p7-classic'"), std::string::npos) << words.what;
  EXPECT_NE(said("jars", "zzzzzz").remedy.find("mahlwerk list jars"), std::string::npos);
  EXPECT_THROW(shipped().names("mill"), InputError);
}

TEST(Catalogue, a_name_cannot_leave_its_room) {
  for (const char* name : {"../jars/fritsch-45ml-steel", "..", "", "/etc/passwd", "thped.toml",
                           "../mills/thped", "./thped"})
    EXPECT_THROW(shipped().find("mills", name), InputError) << name;
}

TEST(Catalogue, a_folder_without_a_catalogue_is_refused) {
  EXPECT_THROW(Catalogue("no/such/folder"), InputError);
  EXPECT_THROW(Catalogue(fs::path(MAHLWERK_HOME) / "src"), InputError);
}

TEST(Derived, quantities_match_hand_calculation) {
  CatalogueEntry entry;
  entry.kind = "vibration";
  entry.values = {{"frequency_most", {"25 Hz", "x"}}, {"amplitude", {"25 mm", "x"}}};
  // physics sheet 1.1: Gamma 62.9 and 3.93 m/s at 25 Hz and 25 mm
  EXPECT_NEAR(derived(entry, "peak_acceleration_number"), 62.88, 0.01);
  EXPECT_NEAR(derived(entry, "peak_wall_speed"), 3.927, 0.001);
  EXPECT_THROW(derived(entry, "jar_volume"), InputError);
  EXPECT_THROW(derived(entry, "ball_mass"), InputError);
  EXPECT_THROW(derived(entry, "peak_wal_speed"), InputError);
}

TEST(Nearest, is_empty_if_nothing_is_near) {
  EXPECT_EQ(nearest_name("steal", {"steel", "stone"}), "steel");
  EXPECT_EQ(nearest_name("xyzzy", {"steel", "stone"}), "");
}

}  // namespace
}  // namespace mahlwerk::cases::catalogue_test
