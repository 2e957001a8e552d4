// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/citation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/report/record/reference_text.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report::citation_test {
namespace {

/// The keys of a case that choose a model, and what the table of references calls their subject.
/// Jar shapes are left out: they are geometry.
const std::map<std::string, std::string> choices{{"mill.kind", "mill motion"},
                                                 {"contact.law", "contact law"},
                                                 {"contact.rolling", "rolling resistance"},
                                                 {"contact.twisting", "twisting friction"},
                                                 {"contact.bounce", "bounce rule"},
                                                 {"contact.restitution_law", "restitution"},
                                                 {"contact.lasting", "sustained contacts"},
                                                 {"liquid.kind", "liquid"},
                                                 {"capture.model", "capture"},
                                                 {"breakage.model", "breakage"},
                                                 {"fragments.model", "fragments"},
                                                 {"grinding.method", "sizes over time"},
                                                 {"kinetics.model", "kinetics"},
                                                 {"wear.model", "wear"}};

std::set<std::string> models_of(std::string_view subject) {
  std::set<std::string> found;
  for (const CitedModel& one : cited_models())
    if (one.subject == subject) found.emplace(one.model);
  return found;
}

bool holds(const std::vector<const CitedModel*>& used, std::string_view subject,
           std::string_view model) {
  return std::ranges::any_of(
      used, [&](const CitedModel* one) { return one->subject == subject && one->model == model; });
}

TEST(Citation, every_model_of_every_register_has_references_or_needs_none) {
  for (const auto& [key, subject] : choices) {
    const cases::KeyInfo* info = cases::find_key(key);
    ASSERT_NE(info, nullptr) << key;
    EXPECT_EQ(models_of(subject), std::set(info->words.begin(), info->words.end()))
        << "add a row to report/record/models.cpp for each model of " << key;
  }
  for (const CitedModel& one : cited_models())
    EXPECT_NE(one.keys.empty(), one.why_none.empty())
        << one.subject << " " << one.model << ": give keys, or say why it needs none";
}

TEST(Citation, every_key_that_chooses_a_model_is_known) {
  const std::set<std::string> names{"kind", "model", "law"};
  const std::set<std::string_view> no_models{"jar.kind", "parts.kind",
                                             "kinetics.law"};  // shapes, forms
  for (const cases::KeyInfo& key : cases::all_keys()) {
    if (!names.contains(std::string(key.name())) || key.words.empty()) continue;
    EXPECT_TRUE(choices.contains(key.key) || no_models.contains(key.key))
        << key.key << " chooses a model: name it in `choices`, or say here why it needs none";
  }
}

TEST(Citation, every_key_of_a_model_is_in_the_bibliography) {
  for (const CitedModel& one : cited_models())
    for (const std::string_view key : one.keys) EXPECT_NO_THROW(reference(key)) << key;
  EXPECT_THROW(reference("nobody1900"), std::out_of_range);
}

TEST(Citation, no_reference_is_unused) {
  std::set<std::string_view> used;
  for (const CitedModel& one : cited_models()) used.insert(one.keys.begin(), one.keys.end());
  for (const Reference& one : references()) EXPECT_TRUE(used.contains(one.key)) << one.key;
}

TEST(Citation, each_reference_stands_once_and_says_who_what_where_and_when) {
  EXPECT_TRUE(std::ranges::is_sorted(references(), std::ranges::less_equal(), &Reference::key));
  std::set<std::string> dois;
  for (const Reference& one : references()) {
    EXPECT_TRUE(std::regex_match(one.key, std::regex("[a-z]+[0-9]{4}"))) << one.key;
    EXPECT_TRUE(one.key.ends_with(std::to_string(one.year))) << one.key;
    EXPECT_FALSE(one.authors.empty() || one.title.empty() || one.published.empty()) << one.key;
    EXPECT_EQ(one.volume.empty(), one.kind != Reference::Kind::article) << one.key;
    if (one.doi.empty()) continue;
    EXPECT_TRUE(one.doi.starts_with("10.")) << one.doi;
    EXPECT_TRUE(dois.insert(one.doi).second) << one.doi << " stands twice";
  }
}

TEST(Citation, a_reference_is_a_line_and_an_entry_of_bibtex) {
  EXPECT_EQ(reference_text(reference("luding1998")),
            "S. Luding and S. McNamara. How to handle the inelastic collapse of a dissipative "
            "hard-sphere gas with the TC model. Granular Matter 1 (1998) 113-128. "
            "https://doi.org/10.1007/s100350050017");
  EXPECT_EQ(reference_text(reference("king2001")),
            "R. P. King. Modeling and Simulation of Mineral Processing Systems. "
            "Butterworth-Heinemann (2001).");
  EXPECT_EQ(bibtex(reference("lian1993")),
            "@article{lian1993,\n  author = {Lian, G. and Thornton, C. and Adams, M. J.},\n"
            "  title = {{A theoretical study of the liquid bridge forces between two rigid "
            "spherical bodies}},\n  journal = {Journal of Colloid and Interface Science},\n"
            "  year = {1993},\n  volume = {161},\n  pages = {138--147}\n}\n");
  EXPECT_EQ(names_text("Thompson, A. P. and others"), "A. P. Thompson et al.");
  EXPECT_EQ(names_text("A, B. and C, D. and E, F."), "B. A, D. C and F. E");
}

TEST(Citation, characters_of_latex_are_escaped) {
  const Reference odd{.key = "odd",
                      .kind = Reference::Kind::other,
                      .authors = "{Nobody}",
                      .title = "50 % of {a_b} & #1",
                      .published = "x"};
  EXPECT_NE(bibtex(odd).find("{{50 \\% of (a\\_b) \\& \\#1}}"), std::string::npos) << bibtex(odd);
}

TEST(Citation, a_run_cites_the_models_of_its_engine_only) {
  cases::Case c = results::fake_outcome().mill_case;
  c.contact.model.law = contact::AnyLaw(contact::Jkr());
  c.contact.model.rolling = contact::Rolling::epsd;
  const auto event = used_models(c, {.engine = cases::EngineName::event});
  EXPECT_FALSE(holds(event, "contact law", "jkr"));
  EXPECT_TRUE(holds(event, "restitution", "constant"));
  const auto soft = used_models(c, {.engine = cases::EngineName::soft});
  EXPECT_TRUE(holds(soft, "contact law", "jkr"));
  EXPECT_TRUE(holds(soft, "rolling resistance", "epsd"));
  EXPECT_FALSE(holds(soft, "restitution", "constant"));
  const auto lammps = used_models(c, {.engine = cases::EngineName::lammps});
  EXPECT_TRUE(holds(lammps, "motion of balls", "lammps"));
}

TEST(Citation, many_balls_and_the_tc_rule_have_their_own_references) {
  cases::Case c = results::fake_outcome().mill_case;
  c.balls.front().count = 1;
  EXPECT_TRUE(holds(used_models(c, {}), "motion of balls", "one-ball event"));
  c.balls.front().count = 7;
  c.contact.lasting = cases::SustainedContactModel::tc;
  EXPECT_TRUE(holds(used_models(c, {}), "motion of balls", "many-ball event"));
  EXPECT_TRUE(holds(used_models(c, {}), "sustained contacts", "tc"));
}

/// A drum of 200 mm, 40 % of it filled in bulk, at a share of the critical speed of its shell.
cases::Case drum(double speed) {
  cases::Case c = results::fake_outcome().mill_case;
  geometry::Cylinder jar;
  jar.diameter = 0.2, jar.height = 0.1;
  c.jar.shape = jar;
  c.mill.jar_axis = kinematics::Tumbling::jar_axis;
  c.mill.motion = kinematics::Tumbling{speed * std::sqrt(2 * c.gravity / jar.diameter)};
  c.balls = {{180, 0.02, 7800, ""}};
  return c;
}

TEST(Citation, the_formulas_of_mill_power_are_cited_where_they_are_given) {
  const auto usual = used_models(drum(0.75), {}), fast = used_models(drum(1.3), {});
  for (const char* formula : {"bond", "hogg-fuerstenau", "morrell-c"}) {
    EXPECT_TRUE(holds(usual, "power by formula", formula)) << formula;
    EXPECT_FALSE(holds(fast, "power by formula", formula)) << formula;
  }
  EXPECT_FALSE(
      holds(used_models(results::fake_outcome().mill_case, {}), "power by formula", "bond"));
}

TEST(Citation, the_mixing_index_is_cited_with_the_section_that_asks_for_it) {
  cases::Case c = results::fake_outcome().mill_case;
  EXPECT_FALSE(holds(used_models(c, {}), "mixing index", "lacey"));
  c.origins.push_back({"mixing.colour", "\"sets\"", "default: two sets"});
  EXPECT_TRUE(holds(used_models(c, {}), "mixing index", "lacey"));
}

TEST(Citation, the_values_of_the_catalogue_are_cited_with_their_sources) {
  cases::Case c = results::fake_outcome().mill_case;
  c.origins = {{"mill.arm", "136 mm", "catalogue mills/retsch-mm400: a film"},
               {"mill.swing", "3.8 deg", "catalogue mills/retsch-mm400: a film"},
               {"mill.kind", "\"arc-shaker\"", "catalogue mills/retsch-mm400"},
               {"mill.frequency", "25 Hz", "case.toml:4"}};
  const Citation made = citation(c, {}, {}, "1.2");
  const Reference& last = made.references.back();
  EXPECT_EQ(last.key, "mahlwerk-mills-retsch-mm400");
  EXPECT_EQ(last.note, "arm, swing: a film");
  EXPECT_NE(made.paragraph.find("Values of the catalogue: mills/retsch-mm400 ["),
            std::string::npos);
}

TEST(Citation, the_program_is_the_first_reference_and_every_number_has_one) {
  const cases::Case c = results::fake_outcome().mill_case;
  const Citation made = citation(c, {.engine = cases::EngineName::soft}, {}, "1.2");
  EXPECT_EQ(made.references.front().key, "mahlwerk");
  EXPECT_TRUE(made.paragraph.starts_with("The mill was simulated with Mahlwerk 1.2 [1] by "));
  for (const CitedUse& one : made.models)
    for (const std::size_t number : one.numbers) EXPECT_LE(number, made.references.size());
  const std::string text = citation_text(made);
  for (std::size_t i = 1; i <= made.references.size(); ++i)
    EXPECT_NE(text.find("\n[" + std::to_string(i) + "] "), std::string::npos) << i;
}

}  // namespace
}  // namespace mahlwerk::report::citation_test
