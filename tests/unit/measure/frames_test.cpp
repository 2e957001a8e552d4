// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/measure/mark_tracker.hpp"
#include "noise.hpp"

namespace mahlwerk::measure::frames_test {
namespace {

class FrameFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  void write(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }
  std::string refusal() const {
    try {
      FrameReader reader(file_);
      while (reader.next()) {
      }
    } catch (const InputError& e) {
      return e.faults().front().what;
    }
    return "";
  }

  const std::string file_ = (std::filesystem::temp_directory_path() /
                             ("mahlwerk-frames-" + std::to_string(::getpid()) + ".pgm"))
                                .string();
};

/// A picture with a Gaussian spot of 2 pixels at x, y.
Picture spot_at(double x, double y, double height, tests::Noise& noise) {
  Picture made{64, 48, {}};
  for (std::size_t row = 0; row < made.height; ++row)
    for (std::size_t column = 0; column < made.width; ++column) {
      const double dx = static_cast<double>(column) - x, dy = static_cast<double>(row) - y;
      made.grey.push_back(
          static_cast<float>(0.4 + height * std::exp(-(dx * dx + dy * dy) / 8) + noise()));
    }
  return made;
}

TEST_F(FrameFile, of_grey_coloured_and_wide_pictures_is_read) {
  std::string grey, coloured, wide;
  for (int i = 0; i < 64; ++i) {
    grey += static_cast<char>(4 * i);
    coloured +=
        std::string{static_cast<char>(4 * i), static_cast<char>(4 * i), static_cast<char>(4 * i)};
    wide += std::string{static_cast<char>(4 * i), static_cast<char>(4 * i)};
  }
  const std::pair<const char*, std::string> all[] = {
      {"P5\n# a comment\n8 8\n255\n", grey}, {"P6 8 8 255\n", coloured}, {"P5 8 8 65535\n", wide}};
  for (const auto& [header, bytes] : all) {
    write(header + bytes + header + bytes);
    FrameReader reader(file_);
    for (int n = 0; n < 2; ++n) {
      const auto picture = reader.next();
      ASSERT_TRUE(picture) << header;
      EXPECT_NEAR(picture->at(3, 2), 4 * 19 / 255.0, 1e-6) << header;
    }
    EXPECT_FALSE(reader.next());
  }
}

TEST_F(FrameFile, that_is_damaged_is_refused) {
  const std::string whole = "P5 8 8 255\n" + std::string(64, 'x');
  const std::pair<std::string, const char*> faults[] = {
      {"", "empty"},
      {"P5 8 8 255\n" + std::string(63, 'x'), "cut off"},
      {whole + "P2 8 8 255\n", "no binary PGM"},
      {whole + "P5 9 8 255\n" + std::string(72, 'x'), "the first 8 x 8"},
      {"P5 8 x", "header is damaged"},
      {"P5 8 8 0\n", "cannot be read"},
      {"P5 999999999 999999999 255\n", "cannot be read"},
      {"\x89PNG\r\n", "no binary PGM"}};
  for (const auto& [bytes, because] : faults) {
    write(bytes);
    EXPECT_NE(refusal().find(because), std::string::npos) << because << ": " << refusal();
  }
}

TEST(MarkTracker, finds_bright_and_dark_spots_to_a_tenth_of_a_pixel) {
  for (const double height : {0.4, -0.3}) {
    tests::Noise noise(3, 0.02);
    MarkTracker tracker({{{30, 24}}}, 20);
    double worst = 0;
    for (int n = 0; n < 60; ++n) {
      const double x = 30.4 + 15 * std::sin(0.25 * n), y = 24.2 + 6 * std::sin(0.25 * n + 1);
      tracker.follow(spot_at(x, n == 0 ? 24.2 : y, height, noise));
      if (n == 0) continue;
      worst = std::max({worst, std::abs(tracker.marks()[0].x.back() - x),
                        std::abs(tracker.marks()[0].y.back() - y)});
    }
    EXPECT_LT(worst, 0.25) << height;
  }
}

TEST(MarkTracker, says_where_a_mark_is_lost) {
  tests::Noise noise(3, 0.001);
  MarkTracker tracker({{{30, 24}}}, 20);
  tracker.follow(spot_at(30, 24, 0.4, noise));
  try {
    tracker.follow(spot_at(30, 24, 0, noise));
    FAIL() << "there is no mark";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().front().what, "mark 1, picture 2: there is no spot in its window");
  }
}

}  // namespace
}  // namespace mahlwerk::measure::frames_test
