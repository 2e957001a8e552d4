// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mahlwerk/results/quantities/traits.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::json_test {
namespace {

nlohmann::json parsed(const Outcome& o) {
  return nlohmann::json::parse(summary_json(o, "1.2.3"));
}

TEST(SummaryJson, holds_every_quantity_to_the_bit) {
  const Outcome o = fake_outcome();
  const nlohmann::json all = parsed(o);
  for (const Quantity& q : o.summary.quantities) {
    const auto& entry = all.at(q.name);
    const Range range = range_of(q.name);
    EXPECT_EQ(entry.size(), 6U + std::isfinite(range.least) + std::isfinite(range.most));
    EXPECT_EQ(entry.at("label"), label_of(q.name));
    EXPECT_EQ(entry.value("least", range.least), range.least);
    EXPECT_EQ(entry.value("most", range.most), range.most);
    EXPECT_EQ(entry.at("unit"), q.unit);
    EXPECT_EQ(entry.at("about"), q.about);
    if (std::isfinite(q.value))
      EXPECT_EQ(entry.at("value").get<double>(), q.value);
    else  // of a charge that was not sampled
      EXPECT_TRUE(entry.at("value").is_null());
    if (std::isfinite(q.ci95))
      EXPECT_EQ(entry.at("ci95").get<double>(), q.ci95);
    else
      EXPECT_TRUE(entry.at("ci95").is_null());
  }
}

TEST(SummaryJson, tells_what_made_it) {
  const nlohmann::json about = parsed(fake_outcome()).at("_about");
  EXPECT_EQ(about.at("mahlwerk"), "1.2.3");
  EXPECT_EQ(about.at("schema"), 2);
  EXPECT_EQ(about.at("title"), "A <fake> case & more");
  EXPECT_EQ(about.at("seed"), 7);
  EXPECT_EQ(about.at("engine"), "event");
  EXPECT_EQ(about.at("complete"), true);
  EXPECT_EQ(about.at("assumed").size(), 1U);
  EXPECT_EQ(about.at("assumed")[0].at("key"), "gravity");
  EXPECT_EQ(about.at("unverified")[0].at("source"), "catalogue jars/some");
}

TEST(SummaryJson, holds_every_notice_with_its_code) {
  Outcome o = fake_outcome();
  EXPECT_TRUE(parsed(o).at("_about").at("notices").empty());
  o.notices = {invalid("long-contacts", "In contact."), warning("stopped", "It was stopped."),
               note("engine-chosen", "Engine: event.")};
  const nlohmann::json about = parsed(o).at("_about");
  EXPECT_EQ(about.at("notices")[0],
            nlohmann::json(
                {{"code", "long-contacts"}, {"severity", "invalid"}, {"text", "In contact."}}));
  EXPECT_EQ(about.at("notices")[2].at("severity"), "note");
  EXPECT_EQ(about.at("warnings"), nlohmann::json({"In contact.", "It was stopped."}));
  EXPECT_EQ(about.at("notes"), nlohmann::json({"Engine: event."}));
}

TEST(SummaryJson, names_the_engine_that_ran) {
  Outcome o = fake_outcome();
  o.mill_case.run.engine = cases::EngineName::automatic;
  o.engine = cases::EngineName::soft;
  EXPECT_EQ(parsed(o).at("_about").at("engine"), "soft");
}

TEST(SummaryJson, holds_key_quantities_groups_and_what_assumed_values_decide) {
  Outcome o = fake_outcome();
  nlohmann::json all = parsed(o);
  EXPECT_EQ(all.at("_key_quantities")[0], "dissipated_power");
  std::size_t grouped = 0;
  for (const auto& group : all.at("_groups")) grouped += group.at("quantities").size();
  EXPECT_EQ(grouped, o.summary.quantities.size()) << "each quantity is in one group";
  EXPECT_FALSE(all.contains("_sensitivity"));
  o.summary.sensitivity = Sensitivity{
      .time = 2,
      .quantities = {"dissipated_power"},
      .scatter = {0.001},
      .keys = {{"contact.restitution", "0.8", {"0.3", "0.9"}, "default: x", {{{0.006}, {NAN}}}}},
      .left_out = {"contact.friction"}};
  all = parsed(o).at("_sensitivity");
  EXPECT_EQ(all.at("keys")[0].at("range"), nlohmann::json({"0.3", "0.9"}));
  EXPECT_EQ(all.at("keys")[0].at("at_ends").at("dissipated_power"),
            nlohmann::json({0.006, nullptr}));
  EXPECT_EQ(all.at("left_out")[0], "contact.friction");
  EXPECT_EQ(all.at("scatter").at("dissipated_power"), 0.001);
}

TEST(SummaryJson, holds_two_states) {
  EXPECT_FALSE(parsed(fake_outcome()).contains("_states"));
  const auto states = parsed(fake_outcome({100, 900, 102, 98, 904, 101, 99, 100})).at("_states");
  EXPECT_EQ(states.at("states")[1].at("replicates"), nlohmann::json({2, 5}));
  EXPECT_EQ(states.at("states")[1].at("share"), 0.25);
  EXPECT_NEAR(states.at("states")[1].at("dissipated_power").at("value").get<double>(), 0.0902,
              1e-12);
  EXPECT_LE(states.at("chance").get<double>(), 0.01);
}

TEST(SummaryJson, counts_notices_of_many_runs) {
  NoticeCounts counts;
  count(counts, {warning("stopped", "It \"was\" stopped.")});
  EXPECT_EQ(nlohmann::json::parse(notices_json(counts).text()),
            nlohmann::json::array({{{"code", "stopped"},
                                    {"severity", "warning"},
                                    {"count", 1},
                                    {"text", "It \"was\" stopped."}}}));
}

TEST(SummaryJson, tells_what_is_missing) {
  Outcome o = fake_outcome({100});
  o.interrupted = true;
  o.replicates[0].complete = false;
  o.replicates[0].stop_reason = "the ball left the jar";
  const nlohmann::json all = parsed(o);
  EXPECT_EQ(all.at("_about").at("complete"), false);
  EXPECT_EQ(all.at("_about").at("interrupted"), true);
  EXPECT_EQ(all.at("_about").at("replicates")[0].at("stopped"), "the ball left the jar");
  EXPECT_TRUE(all.at("collision_rate").at("ci95").is_null());
}

TEST(SummaryJson, survives_a_title_that_is_not_utf8) {
  Outcome o = fake_outcome();
  o.mill_case.title = "M\xFChle";
  EXPECT_NO_THROW(parsed(o));
}

}  // namespace
}  // namespace mahlwerk::results::json_test
