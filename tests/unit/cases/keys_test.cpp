// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::keys_test {
namespace {

using namespace sample;

std::set<std::string> known_keys() {
  std::set<std::string> known;
  for (const KeyInfo& key : all_keys()) known.insert(key.key);
  return known;
}

/// The keys in a case file, without list indices.
std::set<std::string> keys_of(const std::string& written) {
  std::set<std::string> keys;
  std::istringstream lines(written);
  std::string prefix;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('['))
      prefix =
          line.substr(line.find_first_not_of('['), line.find(']') - line.find_first_not_of('[')) +
          ".";
    else if (line.find(" = ") != std::string::npos)
      keys.insert(prefix + line.substr(0, line.find(" = ")));
  }
  return keys;
}

TEST(Keys, each_is_listed_once) {
  EXPECT_EQ(known_keys().size(), all_keys().size());
  EXPECT_GT(all_keys().size(), 150u);
  for (const char* key :
       {"title", "gravity", "mill.ratio_convention", "mill.file", "jar.volume", "jar.crease_angle",
        "balls.filling", "balls.retained", "powder.grain_size", "contact.stiffness",
        "contact.pairs.between", "contact.restitution_speed", "contact.restitution_table",
        "run.longest", "run.time_step_fraction", "breakage.e_infinity", "kinetics.exponent",
        "grinding.sample"})
    EXPECT_TRUE(known_keys().contains(key)) << key;
}

TEST(Keys, every_key_that_is_written_is_listed) {
  const std::filesystem::path home = MAHLWERK_HOME;
  const Catalogue real(home / "catalogue");
  const auto known = known_keys();
  int count = 0;
  for (const auto& folder : std::filesystem::directory_iterator(home / "examples")) {
    if (!std::filesystem::exists(folder.path() / "case.toml")) continue;
    Case c = read(folder.path() / "case.toml", real);
    c.sweep = {};  // has keys of its own
    for (const std::string& key : keys_of(write(c))) EXPECT_TRUE(known.contains(key)) << key;
    ++count;
  }
  EXPECT_GE(count, 9);
}

TEST(Keys, each_is_in_the_docs) {
  std::ifstream stream(MAHLWERK_HOME "/docs/cases.md");
  const std::string docs{std::istreambuf_iterator<char>(stream), {}};
  for (const KeyInfo& key : all_keys()) {
    const std::string word = key.key.substr(key.key.rfind('.') + 1);
    const std::regex said("`[^`\\n]*\\b" + word + "\\b|(^|\\n|[{ ])\"?" + word + "\"? = ");
    EXPECT_TRUE(std::regex_search(docs, said)) << key.key;
  }
}

}  // namespace
}  // namespace mahlwerk::cases::keys_test
