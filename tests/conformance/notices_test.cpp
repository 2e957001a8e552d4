// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

// docs/warnings.md has a heading for every notice code of the program, and for no other code.
namespace mahlwerk::notices_test {
namespace {

namespace fs = std::filesystem;
using Codes = std::set<std::string>;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void find(const std::string& text, const std::regex& pattern, Codes& found) {
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
    found.insert((*i)[1].str());
}

TEST(Notices, every_code_has_a_heading_in_the_docs) {
  const fs::path home = MAHLWERK_HOME;
  const std::regex made(R"([^.>\w](?:note|warning|invalid)\(\s*"([^"]*)\")"),
      heading("\n### (\\S+)\n");
  Codes used, told;
  for (const char* part : {"src", "apps"})
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(home / part))
      if (file.path().extension() == ".cpp") find(text_of(file.path()), made, used);
  find(text_of(home / "docs" / "warnings.md"), heading, told);
  EXPECT_GT(used.size(), 10U) << "the pattern still finds the codes";
  EXPECT_EQ(used, told);
}

}  // namespace
}  // namespace mahlwerk::notices_test
