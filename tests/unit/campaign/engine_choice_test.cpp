// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/engine_choice.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/campaign/run/engine_notices.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::engine_choice_test {
namespace {

using namespace cases::sample;

cases::Case with_engine(const char* engine, const std::string& lines) {
  return read_sample(with(planetary, "restitution", lines), {{"run.engine", engine}});
}
std::string joined(const std::vector<std::string>& notes) {
  std::string all;
  for (const std::string& note : notes) all += note + "\n";
  return all;
}

std::string texts(const Notices& notices) {
  std::string all;
  for (const Notice& one : notices) all += one.text + "\n";
  return all;
}

constexpr const char* sticky = "law = \"jkr\"\nsurface_energy = \"1 J/m2\"\nrestitution = 0.5";
constexpr const char* dry = "law = \"jkr\"\nsurface_energy = \"0 J/m2\"\nrestitution = 0.5";

TEST(EngineChoice, takes_the_soft_engine_where_balls_stick_together) {
  const EngineChoice c = choose_engine(with_engine("auto", sticky));
  EXPECT_EQ(c.engine, cases::EngineName::soft);
  EXPECT_NE(joined(c.reason).find("jkr"), std::string::npos);
  EXPECT_EQ(joined(choose_engine(with_engine("auto", dry)).reason).find("jkr"), std::string::npos);
}

/// The planetary sample with so many balls.
cases::Case with_balls(int count, const std::string& time = "1 s") {
  return read_sample(
      planetary,
      {{"run.engine", "auto"}, {"run.time", time}, {"balls.count", std::to_string(count)}});
}

TEST(EngineChoice, takes_the_event_engine_for_one_ball_and_the_soft_one_for_two) {
  EXPECT_EQ(choose_engine(with_balls(1)).engine, cases::EngineName::event);
  EXPECT_EQ(choose_engine(with_balls(2)).engine, cases::EngineName::soft);
}

TEST(EngineChoice, softens_contacts_of_a_long_run_until_it_is_short_and_says_so) {
  const EngineChoice brief = choose_engine(with_balls(5, "1 s")),
                     lengthy = choose_engine(with_balls(5, "2000 s"));
  EXPECT_FALSE(brief.softening);
  ASSERT_TRUE(lengthy.softening);
  EXPECT_LT(*lengthy.softening, 1);
  EXPECT_NE(joined(lengthy.reason).find("softened"), std::string::npos);
  const cases::Case decided = decided_case(with_balls(5, "2000 s"), lengthy);
  EXPECT_EQ(decided.contact.softening, *lengthy.softening);
  EXPECT_EQ(decided.run.engine, cases::EngineName::soft);
}

TEST(EngineChoice, keeps_a_softening_that_the_case_gives) {
  cases::Case given = read_sample(planetary, {{"run.engine", "auto"},
                                              {"run.time", "2000 s"},
                                              {"balls.count", "5"},
                                              {"contact.softening", "1"}});
  EXPECT_FALSE(choose_engine(given).softening);
}

TEST(EngineChoice, event_engine_says_that_it_knows_no_cohesion) {
  const auto notes = [](const cases::Case& mill_case) {
    results::Outcome outcome{.mill_case = mill_case, .replicates = {}};
    outcome.engine = cases::EngineName::event;
    return texts(engine_notices(outcome, {cases::EngineName::event, {}}));
  };
  EXPECT_NE(notes(with_engine("event", sticky)).find("separate without a pull-off force"),
            std::string::npos);
  EXPECT_EQ(notes(with_engine("event", dry)).find("separate without a pull-off force"),
            std::string::npos);
}

TEST(EngineChoice, event_engine_says_how_many_hits_share_a_body) {
  const auto notes = [](std::int64_t within) {
    results::Outcome outcome{.mill_case = with_engine("event", dry), .replicates = {}};
    outcome.engine = cases::EngineName::event;
    results::Replicate r = results::empty_replicate(outcome.mill_case);
    r.tally.above.count = 1000;
    r.at_settled.hits_within = 50;
    r.energy_balance.hits_within = 50 + within;
    outcome.replicates.push_back(std::move(r));
    Notices found;
    for (const Notice& one : engine_notices(outcome, {cases::EngineName::event, {}}))
      if (one.code == "simultaneous-hits") found.push_back(one);
    return found;
  };
  EXPECT_TRUE(notes(100).empty()) << "10 % is the limit";
  const Notices some = notes(200);
  ASSERT_EQ(some.size(), 1U);
  EXPECT_NE(some.front().text.find("Above 10 %"), std::string::npos) << some.front().text;
  const Notices many = notes(420);
  ASSERT_EQ(many.size(), 1U);
  EXPECT_EQ(many.front().severity, Severity::warning);
  EXPECT_EQ(many.front().text.rfind("42 % of the hits", 0), 0U) << many.front().text;
  EXPECT_NE(many.front().text.find("Above 30 %"), std::string::npos) << many.front().text;
}

}  // namespace
}  // namespace mahlwerk::campaign::engine_choice_test
