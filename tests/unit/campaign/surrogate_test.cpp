// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::surrogate_test {
namespace {

using cases::sample::Folder;
using tests::states;

struct Setting {
  std::vector<std::string> values;
  double power, ci95, replicates;
};

/// A store with these settings, all done, of the keys mill.speed and contact.restitution.
class Campaign {
 public:
  explicit Campaign(const std::vector<Setting>& settings, std::vector<std::string> following = {},
                    const Notices& notices = {})
      : store_(folder_.path() / "campaign.sqlite", Store::Access::write) {
    CampaignPlan plan;
    plan.title = "a mill";
    plan.version = "1";
    plan.keys = {"mill.speed", "contact.restitution"};
    plan.following_keys = std::move(following);
    for (std::size_t i = 0; i < settings.size(); ++i) plan.runs.push_back(i + 1);
    plan.values = [&](std::size_t i) { return settings[i].values; };
    store_.plan(plan);
    for (std::size_t i = 0; i < settings.size(); ++i) {
      const Setting& s = settings[i];
      RunRecord record;
      record.hash = i + 1;
      record.engine = "event";
      record.quantities = {{"drawn_power", s.power, s.ci95, "W", "power"},
                           {"replicates", s.replicates, NAN, "1", "replicates"}};
      record.notices = notices;
      store_.keep(record);
    }
  }
  const Store& store() const { return store_; }
  CampaignSurrogate surrogate() const { return surrogate_of(store_, "c", {"drawn_power"}, "1"); }
  std::string code() const {
    try {
      surrogate();
    } catch (const InputError& error) {
      return error.faults().front().code;
    }
    return "";
  }
  std::filesystem::path file(const std::string& text) const {
    const std::filesystem::path path = folder_.path() / "mill.json";
    std::ofstream(path) << text;
    return path;
  }

 private:
  Folder folder_;
  Store store_;
};

/// A smooth power [W] of a speed of 200 to 800 rpm and a restitution of 0.3 to 0.9, by positions.
double truth(double x, double y) {
  return 5 + 4 * x * x + 2 * math::sin(3 * y) * (0.5 + x);
}

std::vector<std::string> values_at(double x, double y) {
  return {fmt::format("{:.6f} rpm", 200 + 600 * x), fmt::format("{:.8f}", 0.3 + 0.6 * y)};
}

/// Settings at random places, and at the corners, each with replicates that scatter by `scatter`.
std::vector<Setting> settings(std::size_t count, double scatter, int replicates,
                              std::uint32_t stream) {
  Random random(11, stream);
  std::vector<Setting> made;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = i < 4 ? static_cast<double>(i % 2) : random.uniform(),
                 y = i < 4 ? static_cast<double>(i / 2) : random.uniform();
    std::vector<double> values;
    for (int k = 0; k < replicates; ++k)
      values.push_back(truth(x, y) + scatter * standard_normal(random));
    const observe::Estimate found = observe::estimate(values);
    made.push_back({values_at(x, y), found.mean, found.ci95, static_cast<double>(replicates)});
  }
  return made;
}

std::vector<cases::Override> set(const std::string& speed, const std::string& restitution) {
  return {{"mill.speed", speed}, {"contact.restitution", restitution}};
}

TEST(Surrogate, has_intervals_that_contain_the_true_mean_in_95_of_100_settings) {
  constexpr int data_sets = 20, asked = 100;
  std::vector<double> covered;
  double error = 0;
  for (std::uint32_t k = 0; k < data_sets; ++k) {
    const CampaignSurrogate made = Campaign(settings(30, 0.4, 4, k)).surrogate();
    Random random(12, k);
    double inside = 0;
    for (int i = 0; i < asked; ++i) {
      const double x = random.uniform(), y = random.uniform();
      const std::vector<std::string> values = values_at(x, y);
      const observe::IntervalEstimate p =
          predict(made.quantities[0], made.point(set(values[0], values[1])));
      if (truth(x, y) >= p.low && truth(x, y) <= p.high) inside += 1.0 / asked;
      error += (p.value - truth(x, y)) * (p.value - truth(x, y)) / (data_sets * asked);
    }
    covered.push_back(inside);
  }
  // Settings of one data set share its surrogate: the scatter is that between data sets.
  const observe::Estimate found = observe::estimate(covered);
  states("settings with the true mean in their interval", found.mean, 0.95, 1.5 * found.ci95,
         "95 %, three standard errors of 20 data sets");
  tests::stays_below("root mean square error [W]", std::sqrt(error), 0.4 / 2,
                     "that of one setting's mean of four replicates");
}

TEST(Surrogate, of_exact_values_goes_through_them) {
  std::vector<Setting> all = settings(20, 0, 2, 3);
  const CampaignSurrogate made = Campaign(all).surrogate();
  for (const Setting& s : all)
    states("power [W]",
           predict(made.quantities[0], made.point(set(s.values[0], s.values[1]))).value, s.power,
           1e-3, "(opt.2) with a variance of 1e-10 of the spread's");
  EXPECT_LT(made.quantities[0].hold_out.error, 0.1);
}

TEST(Surrogate, is_read_back_with_the_same_bits) {
  const Campaign campaign(settings(15, 0.3, 3, 1), {}, {warning("not-settled", "It had not.")});
  const CampaignSurrogate made = campaign.surrogate();
  const std::string text = surrogate_text(made);
  const CampaignSurrogate back = read_surrogate(campaign.file(text));
  EXPECT_EQ(surrogate_text(back), text);
  for (const double x : {0.0, 0.37, 1.0}) {
    const auto values = values_at(x, 1 - x);
    const auto point = made.point(set(values[0], values[1]));
    EXPECT_EQ(back.point(set(values[0], values[1])), point);
    const observe::IntervalEstimate a = predict(made.quantities[0], point),
                                    b = predict(back.quantities[0], point);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
  }
  ASSERT_FALSE(back.notices.empty());
  EXPECT_EQ(back.notices.front().first.code, "not-settled");
  EXPECT_EQ(back.notices.front().runs, 15U);
}

TEST(Surrogate, has_the_warnings_of_its_runs_and_not_their_notes) {
  const Campaign campaign(settings(15, 0.3, 3, 1), {},
                          {note("settled", "It had."), warning("not-settled", "It had not."),
                           invalid("contact-time", "It depends.")});
  const results::NoticeCounts said = campaign.surrogate().notices;
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].first.code, "contact-time");
  EXPECT_EQ(said[1].first.code, "not-settled");
}

TEST(Surrogate, has_a_digest_of_its_numbers) {
  std::vector<Setting> all = settings(15, 0.3, 3, 1);
  const std::string before = Campaign(all).surrogate().digest;
  EXPECT_EQ(Campaign(all).surrogate().digest, before);
  all[7].power = std::nextafter(all[7].power, 100);
  EXPECT_NE(Campaign(all).surrogate().digest, before);
}

TEST(Surrogate, takes_logarithms_where_factors_lie_between_settings) {
  std::vector<Setting> all;
  for (int i = 0; i < 12; ++i) {
    const double x = i / 11.0;
    all.push_back(
        {values_at(x, i % 3 / 2.0), math::exp(6 * x - 3), 0.01 * math::exp(6 * x - 3), 3});
  }
  const CampaignSurrogate made = Campaign(all).surrogate();
  EXPECT_TRUE(made.quantities[0].emulator.logarithmic);
  const auto values = values_at(0.45, 0.5);
  const observe::IntervalEstimate p =
      predict(made.quantities[0], made.point(set(values[0], values[1])));
  states("power [W]", p.value, math::exp(6 * 0.45 - 3), 0.03 * p.value, "exp(6 x - 3)");
  EXPECT_GT(p.low, 0);
  EXPECT_LT(p.low, p.value);
  EXPECT_GT(p.high, p.value);
}

TEST(Surrogate, counts_one_replicate_by_its_scatter_over_time_and_says_where_there_is_none) {
  std::vector<Setting> all = settings(20, 0.3, 3, 5);
  for (Setting& s : all) s.replicates = 1;
  EXPECT_TRUE(Campaign(all).surrogate().notices.empty());
  for (Setting& s : all) s.ci95 = NAN;
  const results::NoticeCounts said = Campaign(all).surrogate().notices;
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].first.code, "no-scatter");
}

std::string faults_at(const CampaignSurrogate& made, const std::vector<cases::Override>& setting) {
  std::string codes;
  try {
    made.point(setting);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) codes += (codes.empty() ? "" : " ") + fault.code;
  }
  return codes;
}

TEST(Surrogate, does_not_extrapolate_and_wants_every_key_once) {
  const CampaignSurrogate made = Campaign(settings(15, 0.3, 3, 1)).surrogate();
  EXPECT_EQ(faults_at(made, set("500 rpm", "0.5")), "");
  EXPECT_EQ(faults_at(made, set("200 rpm", "0.9")), "");
  EXPECT_EQ(faults_at(made, set("199 rpm", "0.91")), "out-of-range out-of-range");
  EXPECT_EQ(faults_at(made, set("8.33 Hz", "50 %")), "");  // 499.8 rpm
  EXPECT_EQ(faults_at(made, {{"mill.speed", "500 rpm"},
                             {"contact.restitution", "0.5"},
                             {"mill.speed", "400 rpm"}}),
            "too-much");
  EXPECT_EQ(faults_at(made, set("5 m", "half")), "bad-quantity bad-quantity");
  EXPECT_EQ(faults_at(made, {{"mill.speed", "500 rpm"}}), "missing-value");
  EXPECT_EQ(faults_at(made, {{"mill.sped", "500 rpm"}}), "unknown-key missing-value missing-value");
}

TEST(Surrogate, leaves_out_keys_that_do_not_vary_or_follow_from_others) {
  std::vector<Setting> all = settings(15, 0.3, 3, 1);
  for (Setting& s : all) s.values[1] = "0.5";
  const CampaignSurrogate one = Campaign(all).surrogate();
  ASSERT_EQ(one.keys.size(), 1U);
  EXPECT_EQ(faults_at(one, set("500 rpm", "0.5")), "unknown-key");
  const CampaignSurrogate follows =
      Campaign(settings(15, 0.3, 3, 1), {"contact.restitution"}).surrogate();
  ASSERT_EQ(follows.keys.size(), 1U);
  EXPECT_EQ(follows.following, std::vector<std::string>{"contact.restitution"});
  EXPECT_EQ(faults_at(follows, set("500 rpm", "0.5")), "unknown-key");
}

TEST(Surrogate, of_campaigns_without_enough_numbers_is_refused) {
  std::vector<Setting> all = settings(15, 0.3, 3, 1);
  EXPECT_EQ(Campaign(all).code(), "");
  EXPECT_EQ(Campaign({all.begin(), all.begin() + 3}).code(), "no-surrogate");
  std::vector<Setting> words = all;
  words[3].values[0] = "fast";
  EXPECT_EQ(Campaign(words).code(), "no-surrogate");
  std::vector<Setting> empty = all;
  for (std::size_t i = 2; i < empty.size(); ++i) empty[i].power = NAN;
  EXPECT_EQ(Campaign(empty).code(), "no-surrogate");
  const Campaign known(all);
  try {
    surrogate_of(known.store(), "c", {"drawn_powr"}, "1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults()[0].code, "no-such-quantity");
    EXPECT_EQ(error.faults()[0].remedy, "did you mean drawn_power?");
  }
}

std::string read_fault(const Campaign& at, const std::string& text) {
  try {
    read_surrogate(at.file(text));
  } catch (const InputError& error) {
    return error.faults()[0].code;
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(SurrogateFile, that_is_damaged_is_refused_wherever_the_damage_is) {
  const Campaign at(settings(6, 0.3, 3, 1));
  const std::string whole = surrogate_text(at.surrogate());
  EXPECT_EQ(read_fault(at, whole), "");
  for (std::size_t size = 0; size + 2 < whole.size(); size += 7)
    EXPECT_EQ(read_fault(at, whole.substr(0, size)), "cannot-read") << size;
  for (const std::string key : {"surrogate",      "mahlwerk",
                                "title",          "digest",
                                "settings",       "failed",
                                "engines",        "keys",
                                "from",           "to",
                                "following",      "notices",
                                "quantities",     "unit",
                                "about",          "logarithm",
                                "centre",         "scale",
                                "noise",          "amplitude",
                                "constant",       "length_scales",
                                "points",         "values",
                                "variances",      "widening",
                                "hold_out_error", "hold_out_coverage"}) {
    EXPECT_EQ(read_fault(at, replaced(whole, '"' + key + "\":", "\"other\":")), "cannot-read")
        << key;
    EXPECT_EQ(read_fault(at, replaced(whole, '"' + key + "\":", '"' + key + "\":{},\"other\":")),
              "cannot-read")
        << key;
  }
  EXPECT_EQ(read_fault(at, replaced(whole, "\"surrogate\":1", "\"surrogate\":2")), "cannot-read");
  EXPECT_EQ(read_fault(at, replaced(whole, "\"points\":[[", "\"points\":[[0.5,")), "cannot-read");
  EXPECT_EQ(read_fault(at, replaced(whole, "\"length_scales\":[", "\"length_scales\":[-1,")),
            "cannot-read");
  EXPECT_EQ(read_fault(at, replaced(whole, "\"widening\":", "\"widening\":0.5,\"other\":")),
            "cannot-read");
  EXPECT_EQ(read_fault(at, std::string(100'000, '[') + std::string(100'000, ']')), "cannot-read");
  for (const std::string key : {"amplitude", "constant"})
    EXPECT_EQ(read_fault(at, replaced(whole, '"' + key + "\":", '"' + key + "\":1e308,\"x\":")),
              "cannot-read")
        << key;
  EXPECT_EQ(read_fault(at, "[]"), "cannot-read");
  EXPECT_EQ(read_fault(at, "{\"surrogate\": 1}"), "cannot-read");
}

}  // namespace
}  // namespace mahlwerk::campaign::surrogate_test
