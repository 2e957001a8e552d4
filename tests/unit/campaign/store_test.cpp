// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/store/store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/store/sqlite.hpp"

namespace mahlwerk::campaign::store_test {
namespace {

namespace fs = std::filesystem;

class StoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "mahlwerk-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    here_ = name;
  }
  void TearDown() override { fs::remove_all(here_); }
  fs::path file(const std::string& name = "campaign.sqlite") const { return here_ / name; }

  fs::path here_;
};

/// A plan with points that refer to these runs.
CampaignPlan planned(std::vector<RunHash> runs, const std::string& unit = " rpm") {
  CampaignPlan p;
  p.title = "A \"campaign\"; DROP TABLE runs";
  p.version = "1";
  p.case_file = "/somewhere/case.toml";
  p.overrides = {{"run.time", "3 s"}, {.key = "powder", .value = "", .unset = true}};
  p.keys = {"mill.speed", "balls.material"};
  p.runs = std::move(runs);
  p.values = [unit](std::size_t i) {
    return std::vector<std::string>{std::to_string(100 * (i + 1)) + unit, i % 2 ? "steel" : "zro2"};
  };
  return p;
}

RunRecord finished(RunHash hash, double rate) {
  RunRecord f;
  f.hash = hash;
  f.resolved = "title = \"x\"\n";
  f.engine = "event";
  f.quantities = {{"rate", rate, 0.5, "1/s", "how often"},
                  {"energy", 2 * rate, NAN, "J", "how hard", 0.25}};
  return f;
}

std::vector<Point> points(const Store& store, const std::vector<std::string>& names) {
  std::vector<Point> list;
  store.read(names, [&](const Point& p) { list.push_back(p); });
  return list;
}

TEST_F(StoreTest, what_is_kept_is_there_again) {
  {
    Store store(file(), Store::Access::write);
    store.plan(planned({7, 8, 9}));
    store.keep(finished(8, 3.25));
    store.fail(9, "it's \"too\" large");
  }
  const Store store(file(), Store::Access::read);
  EXPECT_EQ(store.title(), "A \"campaign\"; DROP TABLE runs");
  EXPECT_EQ(store.case_file(), "/somewhere/case.toml");
  EXPECT_EQ(store.overrides().at(0).value, "3 s");
  EXPECT_FALSE(store.overrides().at(0).unset);
  EXPECT_EQ(store.overrides().at(1).key, "powder");
  EXPECT_TRUE(store.overrides().at(1).unset);
  const RunCounts counts = store.counts();
  EXPECT_EQ(counts.points, 3U);
  EXPECT_EQ(counts.waiting, 1U);
  EXPECT_EQ(counts.done, 1U);
  EXPECT_EQ(counts.failed, 1U);
  const auto list = points(store, {"energy", "nothing", "rate"});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].values, (std::vector<std::string>{"200 rpm", "steel"}));
  EXPECT_EQ(list[1].state, RunState::done);
  EXPECT_EQ(list[1].value[0], 6.5);
  EXPECT_EQ(list[1].ci95[0], 0.25);  // over time, because there is none over replicates
  EXPECT_TRUE(std::isnan(list[1].value[1]));
  EXPECT_EQ(list[1].value[2], 3.25);
  EXPECT_EQ(list[1].ci95[2], 0.5);
  EXPECT_EQ(list[2].failure, "it's \"too\" large");
  EXPECT_TRUE(std::isnan(list[0].value[0]));
}

TEST_F(StoreTest, notices_are_kept_and_counted_by_points_of_the_plan) {
  Store store(file(), Store::Access::write);
  store.plan(planned({1, 2, 3, 2}));
  RunRecord f = finished(1, 5);
  f.notices = {note("engine-chosen", "Engine: event.")};
  store.keep(f);
  f = finished(2, 6);
  f.notices = {warning("old", "Goes with the next attempt.")};
  store.keep(f);
  f.notices = {invalid("long-contacts", "it's 77 %"), note("engine-chosen", "Engine: soft.")};
  store.keep(f);
  const results::NoticeCounts counts = store.notices();
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].first, invalid("long-contacts", "it's 77 %"));
  EXPECT_EQ(counts[0].runs, 2U) << "two points share the run";
  EXPECT_EQ(counts[1].first, note("engine-chosen", "Engine: event."));
  EXPECT_EQ(counts[1].runs, 3U);
  const auto list = points(store, {});
  EXPECT_EQ(list[0].warnings, "");
  EXPECT_EQ(list[1].warnings, "long-contacts");
  std::ostringstream csv;
  store.write_csv(csv);
  EXPECT_NE(csv.str().find(",message,warnings,"), std::string::npos) << csv.str();
  EXPECT_NE(csv.str().find(",long-contacts,"), std::string::npos) << csv.str();
}

TEST_F(StoreTest, notices_of_a_shard_are_taken_over) {
  {
    Store shard(file("other.sqlite"), Store::Access::shard);
    shard.plan(planned({1, 2}));
    RunRecord f = finished(2, 6);
    f.notices = {warning("stopped", "It stopped.")};
    shard.keep(f);
  }
  Store store(file(), Store::Access::write);
  store.plan(planned({1, 2}));
  store.merge(file("other.sqlite"));
  ASSERT_EQ(store.notices().size(), 1U);
  EXPECT_EQ(store.notices()[0].first, warning("stopped", "It stopped."));
  EXPECT_EQ(points(store, {})[1].warnings, "stopped");
}

TEST_F(StoreTest, a_new_plan_keeps_the_runs_it_shares_with_the_old_one) {
  Store store(file(), Store::Access::write);
  store.plan(planned({1, 2}));
  store.keep(finished(2, 5));
  store.plan(planned({2, 3, 2}, " Hz"));
  const auto list = points(store, {"rate"});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].value[0], 5);
  EXPECT_EQ(list[2].value[0], 5);  // two points may share a run
  EXPECT_EQ(list[0].values[0], "100 Hz");
  EXPECT_EQ(store.counts().waiting, 1U);
  EXPECT_EQ(store.counts().done, 1U);
  EXPECT_EQ(store.states().size(), 3U);
}

/// Runs with different quantities: the soft engine adds `overlap`, and each of two powders has a
/// `property` with a description of its own.
std::vector<RunRecord> three_forms() {
  std::vector<RunRecord> list{finished(1, 5), finished(2, 6), finished(3, 7)};
  auto& soft = list[1].quantities;
  soft.insert(soft.begin() + 1, {"overlap", 0.01, NAN, "1", "how deep"});
  list[1].quantities.push_back({"property", 1, NAN, "1", "colour, after milling"});
  list[2].quantities.push_back({"property", 2, NAN, "1", "smell, after milling"});
  return list;
}

std::string heads_of(const Store& store) {
  std::ostringstream csv;
  store.write_csv(csv);
  const std::string text = csv.str().substr(0, csv.str().find('\n'));
  return text.substr(text.find("message,"));
}

TEST_F(StoreTest, columns_are_in_one_order_whichever_run_ends_first) {
  const std::vector<std::vector<std::size_t>> orders{{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}};
  for (const auto& order : orders) {
    const fs::path place = file(std::to_string(&order - orders.data()));
    Store store(place, Store::Access::write);
    store.plan(planned({1, 2, 3}));
    for (const std::size_t i : order) store.keep(three_forms()[i]);
    EXPECT_EQ(
        heads_of(store),
        "message,warnings,rate_per_s,rate_ci95_per_s,overlap,overlap_ci95,energy_J,energy_ci95_J,"
        "property,property_ci95");
    EXPECT_EQ(store.quantities().back().about, "colour, after milling");
    const auto list = points(store, {"overlap", "property", "rate"});
    EXPECT_EQ(list[1].value, (std::vector<double>{0.01, 1, 6}));
    EXPECT_EQ(list[2].value[1], 2);
  }
}

TEST_F(StoreTest, columns_of_shards_are_in_the_order_of_the_whole) {
  Store whole(file("whole"), Store::Access::write);
  whole.plan(planned({1, 2, 3}));
  for (const RunRecord& one : three_forms()) whole.keep(one);
  {
    Store first(file("first"), Store::Access::shard), second(file("second"), Store::Access::shard);
    for (Store* shard : {&first, &second}) shard->plan(planned({1, 2, 3}));
    first.keep(three_forms()[2]);
    first.keep(three_forms()[0]);
    second.keep(three_forms()[1]);
  }
  Store merged(file("merged"), Store::Access::write);
  merged.merge(file("first"));
  merged.merge(file("second"));
  EXPECT_EQ(heads_of(merged), heads_of(whole));
}

TEST_F(StoreTest, a_quantity_that_comes_later_gets_a_column) {
  Store store(file(), Store::Access::write);
  store.plan(planned({1, 2}));
  store.keep(finished(1, 5));
  RunRecord more = finished(2, 6);
  more.quantities.push_back({"d50", 1e-6, 1e-7, "m", "median"});
  store.keep(more);
  const auto list = points(store, {"d50", "rate"});
  EXPECT_TRUE(std::isnan(list[0].value[0]));
  EXPECT_EQ(list[1].value[0], 1e-6);
  EXPECT_EQ(list[0].value[1], 5);
  std::ostringstream csv;
  store.write_csv(csv);
  EXPECT_EQ(
      csv.str().substr(0, csv.str().find('\n')),
      "point,mill.speed_rpm,balls.material,status,engine,regime,wall_seconds,cpu_seconds,"
      "folder,message,warnings,rate_per_s,rate_ci95_per_s,energy_J,energy_ci95_J,d50_m,d50_ci95_m");
}

TEST_F(StoreTest, what_failed_waits_again_only_when_asked) {
  Store store(file(), Store::Access::write);
  store.plan(planned({1, 2, 3}));
  store.fail(1, "no");
  store.keep(finished(2, 5));
  store.plan(planned({1, 2, 3}));
  EXPECT_EQ(store.states().at(1), RunState::failed);
  EXPECT_EQ(store.retry(), 1U);
  EXPECT_EQ(store.states().at(1), RunState::waiting);
  EXPECT_EQ(store.states().at(2), RunState::done);
}

TEST_F(StoreTest, shards_join_with_each_run_once) {
  for (const RunHash own : {1, 2}) {
    Store shard(file("campaign.shard-" + std::to_string(own) + "-of-2.sqlite"),
                Store::Access::shard);
    shard.plan(planned({1, 2, 3}));
    shard.keep(finished(own, static_cast<double>(own)));
    if (own == 1) shard.fail(3, "stopped");
  }
  Store store(file(), Store::Access::write);
  EXPECT_EQ(store.merge(file("campaign.shard-1-of-2.sqlite")), 2U);
  EXPECT_EQ(store.merge(file("campaign.shard-2-of-2.sqlite")), 1U);
  EXPECT_EQ(store.merge(file("campaign.shard-1-of-2.sqlite")), 0U);
  const auto list = points(store, {"rate"});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].value[0], 1);
  EXPECT_EQ(list[1].value[0], 2);
  EXPECT_EQ(list[2].failure, "stopped");
  EXPECT_EQ(store.title(), "A \"campaign\"; DROP TABLE runs");
  EXPECT_EQ(store.keys(), (std::vector<std::string>{"mill.speed", "balls.material"}));
}

TEST_F(StoreTest, what_is_no_store_is_said_to_be_none) {
  std::ofstream(file()) << "This is a letter, and rather a long one, to whom it may concern.";
  EXPECT_THROW(Store(file(), Store::Access::write), InputError);
  EXPECT_THROW(Store(file("nothing.sqlite"), Store::Access::read), InputError);
  {
    Database other(file("other.sqlite"), Database::Access::write);
    other.run("CREATE TABLE friends(name TEXT)");
  }
  EXPECT_THROW(Store(file("other.sqlite"), Store::Access::write), InputError);
  EXPECT_THROW(Store(file("other.sqlite"), Store::Access::read), InputError);
}

TEST_F(StoreTest, a_transaction_that_is_not_committed_leaves_nothing) {
  Database database(file(), Database::Access::write);
  database.run("CREATE TABLE t(x)");
  try {
    Transaction all(database);
    database.run("INSERT INTO t VALUES(1)");
    throw 1;
  } catch (int) {
  }
  EXPECT_EQ(database.query_text("SELECT count(*) FROM t"), "0");
}

TEST_F(StoreTest, one_process_at_a_time_holds_a_campaign) {
  EXPECT_FALSE(CampaignLock::held(file("campaign.lock")));
  {
    const CampaignLock lock(file("campaign.lock"));
    EXPECT_TRUE(CampaignLock::held(file("campaign.lock")));
    EXPECT_THROW(CampaignLock(file("campaign.lock")), InputError);
  }
  EXPECT_FALSE(CampaignLock::held(file("campaign.lock")));
  const CampaignLock again(file("campaign.lock"));
}

TEST_F(StoreTest, a_damaged_store_is_refused_with_what_is_wrong) {
  const auto reason = [&](const std::string& damage) -> std::string {
    fs::remove(file());
    {
      Store store(file(), Store::Access::shard);
      store.plan(planned({7, 8}));
    }
    Database(file(), Database::Access::write).run(damage);
    try {
      const Store store(file(), Store::Access::read);
      store.runs();
      store.states();
      return "";
    } catch (const InputError& error) {
      return error.faults().front().what;
    }
  };
  EXPECT_EQ(reason("UPDATE campaign SET value = value"), "");
  EXPECT_EQ(reason("UPDATE points SET hash = 'zebra' WHERE point = 1"),
            "the store is damaged: \"zebra\" is not the identity of a run");
  EXPECT_EQ(reason("UPDATE runs SET hash = '' WHERE hash LIKE '%7'"),
            "the store is damaged: \"\" is not the identity of a run");
  EXPECT_EQ(reason("UPDATE runs SET status = 'undone'"),
            "the store is damaged: a run is \"undone\"");
}

}  // namespace
}  // namespace mahlwerk::campaign::store_test
