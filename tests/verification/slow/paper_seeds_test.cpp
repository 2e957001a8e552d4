// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Verdicts on the vertical vibration mill are those of the mill, not of the seed.
#include <gtest/gtest.h>

#include <regex>

#include "program.hpp"

namespace mahlwerk::tests::paper_seeds_test {
namespace {

namespace fs = std::filesystem;

class PaperSeeds : public ProgramTest {
 protected:
  /// Copies the paper with the sections about motion only: sizes of powder take most of its time.
  void paper_without_powder() const {
    const fs::path from = fs::path(MAHLWERK_HOME) / "papers/vertical-vibration-mill";
    fs::create_directory(here_ / "mine");
    for (const char* campaign : {"amplitude", "diameter", "frequency"})
      fs::copy_file(from / (std::string(campaign) + ".toml"),
                    here_ / "mine" / (std::string(campaign) + ".toml"));
    std::ifstream in(from / "paper.toml");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::ofstream out(here_ / "mine" / "paper.toml");
    std::size_t at = 0;
    while (at < text.size()) {
      const std::size_t next = std::min(text.find("\n[[", at + 1), text.size());
      const std::string section = text.substr(at, next - at);
      const bool head = at == 0;
      const bool motion = section.find("campaign = \"amplitude\"") != std::string::npos ||
                          section.find("campaign = \"diameter\"") != std::string::npos ||
                          section.find("campaign = \"frequency\"") != std::string::npos;
      if (head || motion) out << section;
      at = next;
    }
  }

  /// The verdicts of a run, one line a claim.
  std::string verdicts(int seed) const {
    const ProgramResult run =
        mahlwerk("papers mine --quiet --force --out out --seed " + std::to_string(seed));
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
  paper_without_powder();
  const std::string first = verdicts(1);
  EXPECT_GE(std::ranges::count(first, '\n'), 8) << first;
  for (const int seed : {2, 3, 4, 5, 6}) EXPECT_EQ(verdicts(seed), first) << "seed " << seed;
}

}  // namespace
}  // namespace mahlwerk::tests::paper_seeds_test
