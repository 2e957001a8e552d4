// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/contact_records.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/contact/hertz.hpp"
#include "statement.hpp"

namespace mahlwerk::event::contact_records_test {
namespace {

using tests::states;

/// Two steel balls of 6 mm.
const contact::EffectivePair pair{{.modulus = 1.15e11}, 0.0015, 4.4e-4};

scene::Collision bounce(double time, double approach, std::int32_t ball = 0,
                        std::int32_t other = 1) {
  scene::Collision c;
  c.time = time;
  c.ball = ball;
  c.other = other;
  c.mass = pair.mass;
  c.approach = approach;
  c.impulse = 1e-3 * approach;
  c.lost_normal = 2e-3 * approach;
  c.lost_tangential = 3e-3 * approach;
  return c;
}

/// Adds a bounce and returns whether it begins a contact.
bool begins(ContactRecords& records, const scene::Collision& c) {
  if (records.join(
          {c.time, c.ball, c.other, c.approach, c.impulse, c.lost_normal, c.lost_tangential}, pair))
    return false;
  records.begin(c);
  return true;
}

TEST(ContactRecords, joining_time_is_that_of_two_contacts_by_hertz) {
  // (dem.9): 2.943 (5 m / (4 k))^(2/5) u^(-1/5), k = 4/3 E* sqrt(R*).
  const double k = 4.0 / 3 * 1.15e11 * std::sqrt(0.0015);
  const auto duration = [&](double u) {
    return 2.9432751843247047 * std::pow(1.25 * 4.4e-4 / k, 0.4) * std::pow(u, -0.2);
  };
  states("joining time at 0.5 and 0.1 m/s [s]", joining_time(pair, 0.5, 0.1),
         duration(0.5) + duration(0.1), 1e-15, "dem.9");
  states("joining time of bounces at no speed [s]", joining_time(pair, 0, 0), 2 * duration(1e-3),
         1e-15, "as at 1 mm/s");
}

TEST(ContactRecords, bounces_within_the_joining_time_are_one_record) {
  const double within = 0.99 * joining_time(pair, 0.5, 0.2), apart = joining_time(pair, 0.5, 0.3);
  ContactRecords records(2, joining_time(pair, 0, 0));
  EXPECT_TRUE(begins(records, bounce(1, 0.5))) << "the first begins a contact";
  EXPECT_FALSE(begins(records, bounce(1 + within, 0.2))) << "the second continues it";
  EXPECT_TRUE(begins(records, bounce(1 + within + 1.01 * apart, 0.3))) << "the third is late";
  states("loss of open contacts [J]", records.lost(), 5e-3 * (0.5 + 0.2 + 0.3), 1e-17, "the sum");
  std::vector<scene::Collision> finished;
  records.finish_before(2, finished);
  ASSERT_EQ(finished.size(), 2U);
  states("time of the first [s]", finished[0].time, 1, 0, "its first bounce");
  states("duration [s]", finished[0].duration, within, 1e-15, "first to last bounce");
  states("approach [m/s]", finished[0].approach, 0.5, 0, "of the first bounce");
  states("impulse [N s]", finished[0].impulse, 1e-3 * 0.7, 1e-18, "the sum");
  states("loss [J]", finished[0].lost(), 5e-3 * 0.7, 1e-17, "the sum");
  states("approach of the next [m/s]", finished[1].approach, 0.3, 0, "its own");
  states("loss of open contacts [J]", records.lost(), 0, 0, "none is open");
}

TEST(ContactRecords, that_are_open_when_counting_begins_hold_what_follows) {
  const double within = 0.99 * joining_time(pair, 0.5, 0.2);
  ContactRecords records(2, joining_time(pair, 0, 0));
  EXPECT_TRUE(begins(records, bounce(1, 0.5)));
  records.begin_counting();
  states("loss of open contacts [J]", records.lost(), 0, 0, "it was dissipated before");
  EXPECT_FALSE(begins(records, bounce(1 + within, 0.2)));
  std::vector<scene::Collision> finished;
  records.finish_before(2, finished);
  ASSERT_EQ(finished.size(), 1U);
  states("loss [J]", finished[0].lost(), 5e-3 * 0.2, 1e-17, "of the bounce that followed");
  states("impulse [N s]", finished[0].impulse, 1e-3 * 0.2, 1e-18, "of the bounce that followed");
  states("approach [m/s]", finished[0].approach, 0.5, 0, "of the first bounce");
}

TEST(ContactRecords, bounces_of_other_pairs_are_other_records) {
  ContactRecords records(3, joining_time(pair, 0, 0));
  for (const auto& [ball, other] : {std::pair{0, 1}, {0, 2}, {1, 2}, {0, ~0}, {0, ~1}})
    EXPECT_TRUE(begins(records, bounce(1, 0.5, ball, other)));
  std::vector<scene::Collision> finished;
  records.finish_before(2, finished);
  EXPECT_EQ(finished.size(), 5U);
}

TEST(ContactRecords, end_in_the_order_of_their_last_bounces_whenever_they_are_asked_for) {
  const double longest = joining_time(pair, 0, 0), step = 0.4 * joining_time(pair, 0.5, 0.5);
  const auto ends = [&](bool often) {
    ContactRecords records(4, longest);
    std::vector<scene::Collision> finished;
    for (int i = 0; i < 300; ++i) {
      const double time = i * step;
      begins(records, bounce(time, 0.5, i * i % 3, 3));
      if (often) records.finish_before(time, finished);
    }
    records.finish_before(1, finished);
    return finished;
  };
  const auto often = ends(true), once = ends(false);
  ASSERT_EQ(often.size(), once.size());
  ASSERT_GT(often.size(), 50U);
  for (std::size_t i = 0; i < often.size(); ++i) {
    EXPECT_EQ(often[i].time, once[i].time) << i;
    EXPECT_EQ(often[i].duration, once[i].duration) << i;
    if (i == 0) continue;
    EXPECT_GE(often[i].time + often[i].duration, often[i - 1].time + often[i - 1].duration) << i;
  }
}

TEST(ContactRecords, of_a_damaged_archive_are_refused) {
  ContactRecords records(2, 1);
  begins(records, bounce(1, 0.5));
  Archive out;
  records.serialize(out);
  Archive good(out.bytes());
  ContactRecords(2, 1).serialize(good);
  Archive other_count(out.bytes());
  EXPECT_THROW(ContactRecords(3, 1).serialize(other_count), RunError);
  std::string bytes = out.bytes();
  bytes[bytes.size() - 4] = 7;  // the latest contact
  Archive damaged(bytes);
  EXPECT_THROW(ContactRecords(2, 1).serialize(damaged), RunError);
}

}  // namespace
}  // namespace mahlwerk::event::contact_records_test
