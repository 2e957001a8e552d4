// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Verdicts on the vertical vibration mill are those of the mill, not of the seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "program.hpp"

namespace mahlwerk::tests::paper_seeds_test {
namespace {

namespace fs = std::filesystem;

class PaperSeeds : public ProgramTest {
 protected:
  /// The verdicts of a run, one line a claim.
  std::string verdicts(int seed) const {
    // Without sizes of powder, which take most of its time.
    const ProgramResult run = mahlwerk(
        "papers vertical-vibration-mill --leave-out size --leave-out free-numbers --leave-out "
        "sticking --leave-out spex --quiet --force --out out --seed " +
        std::to_string(seed));
    EXPECT_EQ(run.code, 0) << run.output;
    std::ifstream in(here_ / "out/claims.csv");
    const std::string csv{std::istreambuf_iterator<char>(in), {}};
    const std::regex verdict(R"re((^|\n)([^,\n]*|"[^"\n]*"),.*?,(yes|partly|no|undecided),)re");
    std::string all;
    for (std::sregex_iterator it(csv.begin(), csv.end(), verdict), end; it != end; ++it)
      all += (*it)[2].str() + " " + (*it)[3].str() + "\n";
    return all;
  }
};

TEST_F(PaperSeeds, six_seeds_give_the_same_verdicts) {
  if (mahlwerk("papers no-such-paper").output.find("python3-mahlwerk") != std::string::npos)
    GTEST_SKIP() << "the Python package is not built";
  const std::string first = verdicts(1);
  EXPECT_GE(std::ranges::count(first, '\n'), 8) << first;
  for (const int seed : {2, 3, 4, 5, 6}) EXPECT_EQ(verdicts(seed), first) << "seed " << seed;
}

}  // namespace
}  // namespace mahlwerk::tests::paper_seeds_test
