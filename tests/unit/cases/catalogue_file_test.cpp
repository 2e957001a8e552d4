// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a file of the catalogue may say, and what it is told otherwise.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/cases/catalogue/catalogue_read.hpp"
#include "mahlwerk/cases/catalogue/catalogue_write.hpp"
#include "unit/cases/shipped_catalogue.hpp"

namespace mahlwerk::cases::catalogue_file_test {
namespace {

namespace fs = std::filesystem;
using sample::for_each_entry;

/// All faults of a file's text, as a user reads them.
std::string complaint(const std::string& text, std::string_view category = "mills") {
  try {
    read_entry(text, category, "trial", "trial.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string good = R"(title = "A mill"
kind = "planetary"
about = "For trial."

[orbit_radius]
value = "70 mm"
source = "a ruler"
)";

TEST(CatalogueFile, a_good_one_has_no_fault) {
  EXPECT_EQ(complaint(good), "");
}

TEST(CatalogueFile, a_value_needs_its_text_and_its_source) {
  EXPECT_NE(complaint(good + "[ratio]\nvalue = \"1:-2\"\n").find("trial.toml:8: source is missing"),
            std::string::npos);
  EXPECT_NE(complaint(good + "[ratio]\nsource = \"x\"\n").find("trial.toml:8: value is missing"),
            std::string::npos);
  EXPECT_NE(complaint(good + "[ratio]\nvalue = \"-2\"\nsource = \" \"\n").find("trial.toml:10:"),
            std::string::npos);
  EXPECT_NE(complaint("ratio = \"1:-2\"\n" + good).find("trial.toml:1: ratio has no source"),
            std::string::npos);
}

TEST(CatalogueFile, a_measured_value_has_the_ends_of_its_interval) {
  const std::string measured =
      good + "[ratio]\nvalue = \"-2\"\nsource = \"x\"\nconfidence = \"measured\"\n";
  EXPECT_NE(complaint(measured).find("ratio is measured without a range"), std::string::npos);
  EXPECT_NE(
      complaint(good + "from = \"69 mm\"\nto = \"71 mm\"\n").find("no assumed or measured number"),
      std::string::npos);
  const CatalogueEntry entry =
      read_entry(measured + "from = \"-2.1\"\nto = \"-1.9\"\n", "mills", "trial", "trial.toml");
  const CatalogueValue& ratio = entry.values.at("ratio");
  EXPECT_EQ(ratio.range[0], "-2.1");
  EXPECT_FALSE(ratio.assumed || ratio.unverified);
}

TEST(CatalogueFile, that_is_written_reads_as_the_entry) {
  for_each_entry([](const CatalogueEntry& entry) {
    const CatalogueEntry again =
        read_entry(entry_text(entry), entry.category, entry.name, entry.file);
    EXPECT_EQ(again.title, entry.title);
    EXPECT_EQ(again.about, entry.about);
    EXPECT_EQ(again.kind, entry.kind);
    EXPECT_EQ(again.names, entry.names);
    EXPECT_EQ(again.jars, entry.jars);
    ASSERT_EQ(again.values.size(), entry.values.size());
    for (const auto& [key, value] : entry.values) {
      const CatalogueValue& other = again.values.at(key);
      EXPECT_EQ(other.text + other.source + other.range[0] + other.range[1],
                value.text + value.source + value.range[0] + value.range[1]);
      EXPECT_TRUE(other.assumed == value.assumed && other.unverified == value.unverified) << key;
    }
    ASSERT_EQ(again.checks.size(), entry.checks.size());
    for (std::size_t i = 0; i < entry.checks.size(); ++i) {
      EXPECT_EQ(again.checks[i].expected, entry.checks[i].expected);
      EXPECT_NEAR(again.checks[i].tolerance, entry.checks[i].tolerance, 1e-15);
    }
  });
}

TEST(CatalogueFile, unknown_keys_are_faults_with_line_and_suggestion) {
  const std::string top = complaint(good + "[orbit_radios]\nvalue = \"7 mm\"\nsource = \"x\"\n");
  EXPECT_NE(top.find("trial.toml:8: unknown key 'orbit_radios'"), std::string::npos) << top;
  EXPECT_NE(top.find("'orbit_radius'"), std::string::npos) << top;
  const std::string inner =
      complaint(good + "[ratio]\nvalue = \"-2\"\nsource = \"x\"\nsauce = \"y\"\n");
  EXPECT_NE(inner.find("trial.toml:11: unknown key 'sauce'"), std::string::npos) << inner;
  EXPECT_NE(complaint(good, "materials").find("unknown key 'kind'"), std::string::npos);
  EXPECT_NE(complaint(good, "jars").find("unknown kind 'planetary'"), std::string::npos);
}

TEST(CatalogueFile, values_must_be_quantities_in_range) {
  const auto with = [](const std::string& value) {
    return complaint(good + "[speed_most]\nvalue = \"" + value + "\"\nsource = \"x\"\n");
  };
  EXPECT_EQ(with("400 rpm"), "");
  for (const char* bad : {"400", "400 mm", "-3 rpm", "0 rpm", "nan rpm", "fast", "400 rpn"})
    EXPECT_NE(with(bad).find("trial.toml:9: speed_most"), std::string::npos) << bad;
  EXPECT_NE(complaint(good + "[speed_most]\nvalue = 400\nsource = \"x\"\n").find("trial.toml:9:"),
            std::string::npos);
}

TEST(CatalogueFile, checks_are_strict_too) {
  const auto with = [](const std::string& check) {
    return complaint(good + "[[check]]\n" + check);
  };
  const std::string whole =
      "quantity = \"jar_volume\"\nequals = 45\nwithin = \"2 %\"\nsource = \"x\"\n";
  EXPECT_EQ(with(whole), "");
  EXPECT_NE(with("quantity = \"jar_volum\"\nequals = 45\nwithin = \"2 %\"\nsource = \"x\"\n")
                .find("did you mean 'jar_volume'?"),
            std::string::npos);
  EXPECT_NE(with(whole + "units = 3\n").find("unknown key 'units'"), std::string::npos);
  const std::string empty = with("");
  for (const char* key : {"quantity", "equals", "within", "source"})
    EXPECT_NE(empty.find(key), std::string::npos) << key;
  for (const char* within : {"2 mm", "0 %", "200 %", "-1 %"})
    EXPECT_NE(with("quantity = \"jar_volume\"\nequals = 1\nsource = \"x\"\nwithin = \"" +
                   std::string(within) + "\"\n")
                  .find("trial.toml:12: within"),
              std::string::npos)
        << within;
}

TEST(CatalogueFile, all_faults_come_together) {
  try {
    read_entry("kind = \"planetry\"\n[a]\n", "mills", "trial", "trial.toml");
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().size(), 3u) << error.what();  // title, about, kind
  }
  EXPECT_NE(complaint("title = \n").find("trial.toml:1"), std::string::npos);
  EXPECT_NE(complaint(good + "jars = 3\n").find("unknown key 'jars'"), std::string::npos);
  EXPECT_NE(complaint("jars = [3]\n" + good).find("jars must be a list of names"),
            std::string::npos);
}

TEST(CatalogueFile, one_from_disc_names_its_path) {
  const fs::path root =
      fs::temp_directory_path() / ("mahlwerk-catalogue-" + std::to_string(getpid()));
  fs::create_directories(root / "mills");
  std::ofstream(root / "mills" / "mine.toml") << good << "[oops]\n";
  std::ofstream(root / "mills" / "fine.toml") << good;
  const Catalogue mine(root);
  EXPECT_EQ(mine.names("mills"), (std::vector<std::string>{"fine", "mine"}));
  EXPECT_TRUE(mine.names("jars").empty());
  EXPECT_EQ(mine.find("mills", "fine").values.at("orbit_radius").source, "a ruler");
  try {
    mine.find("mills", "mine");
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().at(0).where, (root / "mills" / "mine.toml").string() + ":8");
  }
  fs::remove_all(root);
}

}  // namespace
}  // namespace mahlwerk::cases::catalogue_file_test
