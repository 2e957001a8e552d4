// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/evaluations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::evaluations_test {
namespace {

namespace fs = std::filesystem;
using cases::sample::Folder;
using List = std::vector<double>;

constexpr double never = 1e9;  // [s] between two writes

FitEvaluations kept_in(const fs::path& file, const char* what = "a fit") {
  return FitEvaluations(file, what, never, {});
}

/// A file with two predictions of the same values: by all replicates, and by the first.
fs::path two_predictions(const fs::path& file) {
  FitEvaluations made = kept_in(file);
  made.keep({}, {0.1, 3}, {1, std::numeric_limits<double>::quiet_NaN()});
  made.keep(0, {0.1, 3}, {2, 5e-324});
  EXPECT_FALSE(fs::exists(file)) << "a write is not due yet";
  made.flush();
  return file;
}

TEST(FitEvaluations, predictions_are_read_with_every_bit) {
  const Folder folder;
  const FitEvaluations read = kept_in(two_predictions(folder.path() / "evaluations"));
  ASSERT_EQ(read.count(), 2U);
  const List* all = read.find({}, {0.1, 3});
  const List* first = read.find(0, {0.1, 3});
  ASSERT_TRUE(all != nullptr && first != nullptr);
  EXPECT_EQ(all->at(0), 1);
  EXPECT_TRUE(std::isnan(all->at(1)));
  EXPECT_EQ(*first, (List{2, 5e-324}));
  EXPECT_EQ(read.find(1, {0.1, 3}), nullptr);
  EXPECT_EQ(read.find({}, {std::nextafter(0.1, 1), 3}), nullptr);
}

TEST(FitEvaluations, those_of_another_fit_and_damaged_ones_are_not_used) {
  const Folder folder;
  const fs::path file = two_predictions(folder.path() / "evaluations");
  EXPECT_EQ(kept_in(file, "another").count(), 0U);
  std::ifstream in(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_EQ(kept_in(file).count(), 0U) << "byte " << at;
    std::ofstream(file, std::ios::binary) << whole.substr(0, at);
    EXPECT_EQ(kept_in(file).count(), 0U) << "cut at " << at;
  }
  EXPECT_EQ(kept_in(folder.path() / "none").count(), 0U);
}

TEST(FitEvaluations, the_best_is_that_of_the_smallest_finite_sum) {
  const Folder folder;
  FitEvaluations made = kept_in(folder.path() / "evaluations");
  EXPECT_FALSE(made.best());
  made.note({1}, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(made.best());
  for (const double sum : {3.0, 1.0, 2.0}) made.note({10 * sum}, sum);
  ASSERT_TRUE(made.best());
  EXPECT_EQ(made.best()->values, List{10});
  EXPECT_EQ(made.best()->sum, 1);
}

TEST(FitEvaluations, a_file_that_cannot_be_written_is_told_and_the_fit_goes_on) {
  const Folder folder;
  const fs::path file = folder.path() / "missing" / "evaluations";
  std::vector<Fault> told;
  FitEvaluations made(file, "a fit", never, [&](const Fault& why) { told.push_back(why); });
  made.keep({}, {1}, {2});
  made.flush();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].code, "cannot-write");
  EXPECT_NE(made.find({}, {1}), nullptr);
}

}  // namespace
}  // namespace mahlwerk::campaign::evaluations_test
