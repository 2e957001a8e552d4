// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every contact law in the register carries the metadata with which a case names it, sets its
// parameters and writes them out; cases/ has no line specific to any of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "register_types.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::tests::law_register_test {
namespace {

namespace sample = cases::sample;

template <class L>
class LawsOfCases : public ::testing::Test {};
TYPED_TEST_SUITE(LawsOfCases, TypesOf<contact::AnyLaw::Models>::type, NameOfModel);

TEST(LawRegister, names_are_unique_and_each_says_what_it_is) {
  std::set<std::string_view> names;
  for (const contact::AnyLaw& law : contact::all_laws()) {
    EXPECT_TRUE(names.insert(contact::name_of(law)).second) << contact::name_of(law);
    std::visit([]<class L>(const L&) { EXPECT_FALSE(L::about.empty()) << L::name; }, law);
  }
}

TYPED_TEST(LawsOfCases, fields_have_a_key_a_unit_a_range_and_a_sentence) {
  const TypeParam fresh;
  std::set<std::string_view> keys;
  for (const auto& s : contact::switches_of<TypeParam>()) {
    EXPECT_TRUE(keys.insert(s.key).second) << s.key;
    EXPECT_NE(s.words[0], s.words[1]) << s.key;
    EXPECT_FALSE(s.source.empty()) << s.key;
    EXPECT_FALSE(fresh.*s.second) << s.key << ": the first word is the default";
  }
  for (const auto& f : TypeParam::fields()) {
    EXPECT_TRUE(keys.insert(f.key).second) << f.key;
    EXPECT_FALSE(f.about.empty()) << f.key;
    EXPECT_NO_THROW(parse_in(show(1, f.unit), f.unit)) << f.key;
    EXPECT_LT(f.range.least, f.range.most) << f.key;
    EXPECT_TRUE(f.instead_of.empty() || keys.contains(f.instead_of)) << f.key;
    if (f.is_optional()) {
      EXPECT_FALSE(f.standard.has_value()) << f.key;
      EXPECT_EQ(fresh.*f.value, 0) << f.key;
    } else if (f.standard) {
      EXPECT_TRUE(f.range.holds(*f.standard) && !f.source.empty()) << f.key;
      EXPECT_EQ(fresh.*f.value, *f.standard) << f.key;
    }
  }
}

/// Overrides that select a law for the planetary mill and set every key that has no default.
template <class L>
std::vector<cases::Override> choosing(const std::string& key = "", const std::string& text = "") {
  std::vector<cases::Override> given{{"contact.law", std::string(L::name)}};
  for (const auto& f : L::fields())
    if (!f.standard && !f.is_optional() && f.key != key)
      given.push_back({"contact." + std::string(f.key), show(1, f.unit)});
  for (const auto& parameter : contact::adhesion_of<L>())
    for (const auto& f : cases::touch_fields<cases::Contact>())
      if (f.key == parameter.key)
        given.push_back({"contact." + std::string(f.key), show(0.5, f.unit)});
  if (!key.empty()) given.push_back({"contact." + key, text});
  return given;
}
cases::Case written_and_read(const cases::Case& c) {
  return cases::read_text(cases::write(c), "case.toml", sample::catalogue());
}

TYPED_TEST(LawsOfCases, is_read_by_its_name_and_written_back_with_every_number_and_word) {
  using L = TypeParam;
  const auto read = [](const std::vector<cases::Override>& given) {
    const cases::Case c = sample::read_sample(sample::planetary, given);
    EXPECT_TRUE(written_and_read(c) == c) << cases::write(c);
    EXPECT_TRUE(std::holds_alternative<L>(*c.contact.model.law));
    return std::get<L>(*c.contact.model.law);
  };
  read(choosing<L>());
  for (const auto& f : L::fields()) {
    const double value = f.range.holds(0.25) ? 0.25 : 0.5 * (f.range.least + f.range.most);
    const L found = read(choosing<L>(std::string(f.key), show(value, f.unit)));
    EXPECT_EQ(found.*f.value, value) << f.key;
    EXPECT_TRUE(contact::is_given(found, f)) << f.key;
  }
  for (const auto& s : contact::switches_of<L>())
    for (const bool second : {false, true}) {
      const std::string word(s.words[second ? 1 : 0]);
      EXPECT_EQ(read(choosing<L>(std::string(s.key), word)).*s.second, second) << word;
    }
}

TYPED_TEST(LawsOfCases, refuses_the_numbers_that_it_does_not_read) {
  using L = TypeParam;
  const auto refused = [](std::string_view key, const std::string& text) {
    const auto found = sample::faults_of(sample::planetary, choosing<L>(std::string(key), text));
    ASSERT_EQ(found.size(), 1u) << key;
    EXPECT_EQ(found[0].code, "too-much") << key;
    EXPECT_EQ(found[0].what, fmt::format("{} has no meaning under law = \"{}\"", key, L::name));
  };
  std::set<std::string_view> own;
  for (const auto& s : contact::switches_of<L>()) own.insert(s.key);
  for (const auto& f : L::fields()) own.insert(f.key);
  for (const auto& parameter : contact::adhesion_of<L>()) own.insert(parameter.key);
  for (const std::string_view key : cases::law_keys())
    if (!own.contains(key)) refused(key, "1");
  for (const auto& parameter :
       {contact::surface_energy, contact::cohesion, contact::surface_tension})
    if (!own.contains(parameter.key)) refused(parameter.key, "1");
}

}  // namespace
}  // namespace mahlwerk::tests::law_register_test
