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
#include <stdexcept>

#include "mahlwerk/base/units.hpp"
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
        "run.longest", "run.step_error", "run.time_step_fraction", "breakage.e_infinity",
        "kinetics.exponent", "grinding.sample"})
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

const KeySection& section_of(std::string_view name, std::string_view kind = "") {
  for (const KeySection& s : key_sections())
    if (s.section == name && s.kind == kind) return s;
  throw std::runtime_error("no such section");
}

const KeyInfo& key_of(const KeySection& section, std::string_view name) {
  for (const KeyInfo& key : section.keys)
    if (key.name() == name) return key;
  throw std::runtime_error("no such key");
}

TEST(Keys, each_has_a_sentence_and_each_word_or_its_key_too) {
  for (const KeySection& section : key_sections()) {
    EXPECT_FALSE(section.about.empty()) << section.section << section.kind;
    for (const KeyInfo& key : section.keys) {
      EXPECT_FALSE(key.about.empty()) << key.key;
      EXPECT_FALSE(key.type.empty()) << key.key;
      EXPECT_EQ(key.type == "word" || key.type == "flag", !key.words.empty()) << key.key;
      EXPECT_TRUE(key.meanings.empty() || key.meanings.size() == key.words.size()) << key.key;
    }
  }
}

TEST(Keys, a_default_has_a_source_and_a_required_key_has_none) {
  for (const KeySection& section : key_sections())
    for (const KeyInfo& key : section.keys) {
      EXPECT_TRUE(key.default_value.empty() || !key.default_source.empty()) << key.key;
      EXPECT_FALSE(key.required && !key.default_value.empty()) << key.key;
    }
}

TEST(Keys, sections_and_kinds_hold_the_same_keys_as_the_whole_list) {
  std::set<std::string> listed;
  for (const KeySection& section : key_sections())
    if (section.section != "sweep" && section.section != "optimise" && section.section != "match" &&
        section.section != "fit" && section.section != "uncertainty")
      for (const KeyInfo& key : section.keys) listed.insert(key.key);
  EXPECT_EQ(listed, known_keys());
}

TEST(Keys, a_kind_lists_what_only_it_has) {
  const KeyInfo& orbit = key_of(section_of("mill", "planetary"), "orbit_radius");
  EXPECT_TRUE(orbit.required && orbit.unit == "m" && orbit.range.without_least);
  EXPECT_EQ(key_of(section_of("mill", "figure-eight"), "rock").default_value, "0 deg");
  EXPECT_EQ(key_of(section_of("jar", "cylinder"), "volume").instead_of, "jar.height");
  EXPECT_EQ(section_of("contact", "hertz-mindlin").keys.size(), 0u);
  EXPECT_EQ(key_of(section_of("contact", "jkr"), "surface_energy").unit, "J/m2");
  EXPECT_EQ(key_of(section_of("mill"), "jar_axis").default_source, "depends on the kind");
  EXPECT_EQ(key_of(section_of("mill", "arc-shaker"), "jar_axis").default_value, "horizontal");
}

TEST(Keys, a_key_that_needs_another_choice_says_which) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(key_of(section_of("contact"), "friction").under.at("contact.bounce"), Words{"walton"});
  EXPECT_EQ(key_of(section_of("grinding"), "sample").under.at("grinding.method"),
            (Words{"statistical", "both"}));
  EXPECT_EQ(key_of(section_of("balls"), "largest").under.at("balls.distribution"),
            Words{"uniform"});
  EXPECT_TRUE(key_of(section_of("run"), "longest").under.empty());
  std::vector<double> spreads;  // a range of its own under each distribution
  for (const KeyInfo& key : section_of("balls").keys)
    if (key.name() == "spread") spreads.push_back(key.range.most);
  EXPECT_EQ(spreads, (std::vector{0.3, 2.0}));
}

TEST(Keys, each_has_a_label_and_an_engine_that_reads_it) {
  for (const KeyInfo& key : all_keys()) {
    EXPECT_FALSE(key.label.empty()) << key.key;
    EXPECT_EQ(key.label.find('_'), std::string::npos) << key.key;
    EXPECT_FALSE(key.engines.empty()) << key.key;
  }
  EXPECT_EQ(find_key("balls.2.diameter")->label, "ball diameter");
  EXPECT_EQ(find_key("mill.frequency")->symbol, "$f$");
  EXPECT_EQ(find_key("contact.pairs.1.rolling_friction")->label, "rolling friction");
  EXPECT_EQ(find_key("mill.colour"), nullptr);
}

/// The value of a text in the key's unit; a drum's speed and fillings may be per cent, and a speed
/// ratio "1:-2".
std::optional<double> value_in(std::string_view text, const KeyInfo& key) {
  if (text.find(':') != std::string_view::npos) return std::nullopt;
  if (text.ends_with('%') && !key.unit.empty()) return std::nullopt;
  return parse_in(text, key.unit);
}

TEST(Keys, a_mill_or_jar_can_be_started_from_the_values_of_its_required_keys) {
  int count = 0;
  for (const KeySection& section : key_sections()) {
    if ((section.section != "mill" && section.section != "jar") || section.kind.empty()) continue;
    for (const KeyInfo& key : section.keys) {
      if (!key.required || key.name() == "file") continue;
      ++count;
      ASSERT_FALSE(key.start.empty()) << section.kind << ": " << key.key;
      if (key.type != "number") continue;
      const auto value = value_in(key.start, key);
      EXPECT_TRUE(!value || key.range.holds(*value)) << key.key;
    }
  }
  EXPECT_GE(count, 40);
}

TEST(Keys, usual_values_are_a_range_within_the_allowed_one_that_holds_the_start) {
  int count = 0;
  for (const KeySection& section : key_sections())
    for (const KeyInfo& key : section.keys) {
      if (key.usual.most.empty()) continue;
      ++count;
      const auto least = value_in(key.usual.least, key), most = value_in(key.usual.most, key);
      if (!least) continue;
      EXPECT_LT(*least, *most) << key.key;
      EXPECT_TRUE(key.range.holds(*least) && key.range.holds(*most)) << key.key;
      EXPECT_TRUE(!key.usual.log || *least > 0) << key.key;
      if (key.start.empty()) continue;
      const auto start = value_in(key.start, key);
      EXPECT_TRUE(!start || (*least <= *start && *start <= *most)) << key.key;
    }
  EXPECT_GE(count, 25);
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
