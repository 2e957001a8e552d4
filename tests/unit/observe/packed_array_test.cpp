// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// An array of counts that gives back the memory of what is zero.
#include "mahlwerk/observe/packed_array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::observe::packed_array_test {
namespace {

using Counts = PackedArray<std::int64_t>;
constexpr std::size_t size = 300;

/// About one element of `every` is not zero.
Counts random_counts(std::uint32_t seed, double every) {
  Random random(seed, 0);
  Counts made(size);
  for (std::size_t i = 0; i < size; ++i)
    if (random.uniform() * every < 1) made[i] = static_cast<std::int64_t>(i) - 100;
  return made;
}

std::vector<std::int64_t> all(const Counts& counts) {
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < counts.size(); ++i) values.push_back(counts[i]);
  return values;
}

TEST(PackedArray, packing_and_unpacking_change_no_element) {
  for (const double every : {1.0, 3.0, 50.0, 1e9}) {
    const std::vector<std::int64_t> right = all(random_counts(1, every));
    Counts packed = random_counts(1, every);
    packed.pack();
    packed.pack();  // once more is as well
    EXPECT_EQ(all(packed), right) << every;
    packed.unpack();
    EXPECT_EQ(all(packed), right) << every;
    packed[7] = 5;
    EXPECT_EQ(all(packed)[7], 5);
  }
}

TEST(PackedArray, merging_adds_elements_whether_packed_or_not) {
  const auto add = [](std::int64_t& mine, std::int64_t more) { mine += more; };
  std::vector<std::int64_t> right = all(random_counts(1, 3));
  const std::vector<std::int64_t> more = all(random_counts(2, 3));
  for (std::size_t i = 0; i < size; ++i) right[i] += more[i];
  for (const bool one : {false, true})
    for (const bool other : {false, true}) {
      Counts a = random_counts(1, 3), b = random_counts(2, 3);
      if (one) a.pack();
      if (other) b.pack();
      a.merge(b, add);
      EXPECT_EQ(all(a), right) << one << other;
    }
}

TEST(PackedArray, a_state_is_the_same_packed_or_not_and_is_read_back) {
  std::string bytes;
  for (const bool packed : {false, true}) {
    Counts counts = random_counts(3, 4), read(size);
    if (packed) counts.pack();
    Archive out;
    counts.serialize(out);
    if (bytes.empty()) bytes = out.bytes();
    EXPECT_TRUE(out.bytes() == bytes);
    EXPECT_LT(out.bytes().size(), size * 5) << "zeros are not written";
    if (!packed) counts[0] = 1;  // counting goes on
    Archive in(bytes);
    read.serialize(in);
    in.finish();
    EXPECT_EQ(all(read), all(random_counts(3, 4)));
  }
}

TEST(PackedArray, a_damaged_state_is_refused) {
  const auto refused = [](std::vector<std::uint32_t> where, std::vector<std::int64_t> values) {
    Archive out;
    out(where)(values);
    Archive in(out.bytes());
    Counts read(size);
    EXPECT_THROW(read.serialize(in), RunError);
  };
  refused({1, 2}, {5});
  refused({2, 1}, {5, 6});
  refused({1, 1}, {5, 6});
  refused({size}, {5});
}

}  // namespace
}  // namespace mahlwerk::observe::packed_array_test
