// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/data_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/text.hpp"

namespace mahlwerk::tests::data_folder_test {
namespace {

namespace fs = std::filesystem;

class DataFolder : public ::testing::Test {
 protected:
  void TearDown() override {
    unsetenv("MAHLWERK_CATALOGUE");
    set_data_folder({});
  }
};

TEST_F(DataFolder, is_the_chosen_one) {
  set_data_folder(MAHLWERK_HOME);
  EXPECT_EQ(data_folder("catalogue"), fs::canonical(fs::path(MAHLWERK_HOME) / "catalogue"));
  EXPECT_EQ(data_folder("papers"), fs::canonical(fs::path(MAHLWERK_HOME) / "papers"));
}

TEST_F(DataFolder, of_the_catalogue_alone_is_that_of_the_environment) {
  set_data_folder(MAHLWERK_HOME);
  setenv("MAHLWERK_CATALOGUE", "/of/mine", 1);
  EXPECT_EQ(data_folder("catalogue"), "/of/mine");
  EXPECT_EQ(data_folder("papers"), fs::canonical(fs::path(MAHLWERK_HOME) / "papers"));
}

TEST_F(DataFolder, that_is_missing_is_reported_with_its_place) {
  set_data_folder("/nowhere");
  try {
    data_folder("validation");
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().at(0).where, "/nowhere/validation");
    EXPECT_EQ(e.faults().at(0).code, "no-data");
  }
}

TEST_F(DataFolder, documents_are_those_of_the_installation_or_of_the_sources) {
  const fs::path here = fs::temp_directory_path() / "mahlwerk-documents-test";
  fs::create_directories(here / "share/mahlwerk/examples");
  fs::create_directories(here / "share/doc/mahlwerk/docs");
  std::ofstream(here / "share/doc/mahlwerk/docs/errors.md") << "x";
  set_data_folder(here / "share/mahlwerk");
  EXPECT_EQ(document("docs/errors.md#a"),
            (fs::canonical(here) / "share/doc/mahlwerk/docs/errors.md#a").string());
  EXPECT_EQ(document("docs/nothing.md"), "docs/nothing.md");
  set_data_folder(MAHLWERK_HOME);
  EXPECT_EQ(document("docs/errors.md#a"),
            (fs::canonical(MAHLWERK_HOME) / "docs/errors.md#a").string());
  set_data_folder("/nowhere");
  EXPECT_EQ(document("docs/errors.md#a"), "docs/errors.md#a");
  fs::remove_all(here);
}

TEST(ContainsWord, is_regardless_of_case) {
  EXPECT_TRUE(contains_word("Drawn Power", "power"));
  EXPECT_TRUE(contains_word("drawn", ""));
  EXPECT_FALSE(contains_word("drawn", "drawn power"));
}

}  // namespace
}  // namespace mahlwerk::tests::data_folder_test
