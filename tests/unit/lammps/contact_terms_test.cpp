// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/contact_terms.hpp"

#include <gtest/gtest.h>

#include <string>

#include "soft.hpp"

namespace mahlwerk::lammps::contact_terms_test {
namespace {

TEST(ContactTerms, name_twisting_friction_where_the_case_has_it) {
  const contact::ElasticConstants steel{200e9, 0.3};
  const scene::Ball ball{0.005, 7800, {}, {}, {}};
  const contact::EffectivePair pair = tests::touching(tests::pair_of(steel, steel, 0.5, 0.3), ball);
  contact::ContactModel model = tests::of_law(contact::HertzMindlin{});
  EXPECT_EQ(contact_terms(model, pair).find("twisting"), std::string::npos);
  model.twisting = contact::Twisting::marshall;
  EXPECT_NE(contact_terms(model, pair).find(" twisting marshall damping tsuji"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::lammps::contact_terms_test
