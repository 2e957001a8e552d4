// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `new`: a commented case to start from.
#include <map>
#include <vector>

#include "mahlwerk/cases/keys.hpp"
#include "program.hpp"

namespace mahlwerk::tests::new_case_test {
namespace {

namespace fs = std::filesystem;

class NewCase : public ProgramTest {
 protected:
  /// Writes the case, checks it and runs it for a moment.
  void expect_runs(const std::string& options) {
    const std::string file = "case-" + std::to_string(++count_) + ".toml";
    const ProgramResult made = mahlwerk("new " + options + " " + file);
    ASSERT_EQ(made.code, 0) << options << '\n' << made.output;
    const ProgramResult check = mahlwerk("check " + file);
    EXPECT_EQ(check.code, 0) << options << '\n' << check.output;
    const ProgramResult run =
        mahlwerk("run " + file + " --quiet --force --out out --set run.replicates=1 " +
                 "--set run.time=\"10 ms\"");
    EXPECT_EQ(run.code, 0) << options << '\n' << run.output;
  }
  static std::vector<std::string> kinds(std::string_view section) {
    std::vector<std::string> found;
    for (const cases::KeySection& s : cases::key_sections())
      if (s.section == section && !s.kind.empty()) found.push_back(s.kind);
    return found;
  }
  int count_ = 0;
};

TEST_F(NewCase, of_every_mill_of_the_catalogue_runs_at_once) {
  for (const auto& file : fs::directory_iterator(MAHLWERK_HOME "/catalogue/mills"))
    expect_runs("--mill " + file.path().stem().string());
  EXPECT_GE(count_, 21);
}

TEST_F(NewCase, of_every_kind_of_mill_runs_at_once) {
  for (const std::string& kind : kinds("mill")) expect_runs("--kind " + kind);
  EXPECT_GE(count_, 8);
}

TEST_F(NewCase, of_every_kind_of_jar_runs_at_once) {
  for (const std::string& kind : kinds("jar")) expect_runs("--kind still --jar-kind " + kind);
  EXPECT_GE(count_, 10);
}

TEST_F(NewCase, names_parts_of_the_catalogue_and_marks_what_it_assumes) {
  const ProgramResult e =
      mahlwerk("new --mill spex-8000m --jar spex-vial-62ml --balls spex-2x12.7mm my.toml");
  ASSERT_EQ(e.code, 0) << e.output;
  const std::string written = text("my.toml");
  for (const char* part : {"\nmodel = \"spex-8000m\"", "\nmodel = \"spex-vial-62ml\"",
                           "\nmodel = \"spex-2x12.7mm\"", "#frequency = \"17.67 Hz\""})
    EXPECT_NE(written.find(part), std::string::npos) << part;
  EXPECT_EQ(mahlwerk("check my.toml").code, 0);
  const std::string assumed = mahlwerk("new --mill retsch-mm400 --jar-kind capsule").output;
  EXPECT_NE(assumed.find("ASSUMED"), std::string::npos);
  EXPECT_NE(assumed.find("the machine offers 3 Hz to 30 Hz"), std::string::npos);
}

TEST_F(NewCase, a_default_that_is_switched_on_is_read_and_is_the_default) {
  ASSERT_EQ(mahlwerk("new --mill fritsch-p7-classic my.toml").code, 0);
  std::string written = text("my.toml");
  int count = 0;
  for (std::size_t at = written.find("\n#"); at != std::string::npos;
       at = written.find("\n#", at + 1)) {
    const std::string line = written.substr(at + 1, written.find('\n', at + 1) - at - 1);
    const bool other = line.starts_with("#orbit_radius") || line.ends_with("...") ||
                       line.starts_with("#ratio") || line.starts_with("#lasting");
    if (line.starts_with("# ") || other) continue;
    written.erase(at + 1, 1);
    ++count;
  }
  EXPECT_GT(count, 40);
  std::ofstream(here_ / "given.toml") << written;
  const std::string run = " --quiet --set run.replicates=1 --set run.time=\"10 ms\" --out ";
  ASSERT_EQ(mahlwerk("run my.toml" + run + "a").code, 0);
  const ProgramResult e = mahlwerk("run given.toml" + run + "b");
  ASSERT_EQ(e.code, 0) << e.output;
  EXPECT_EQ(text("a/replicates.csv"), text("b/replicates.csv"));
}

TEST_F(NewCase, replaces_no_file_and_writes_none_that_is_faulty) {
  ASSERT_EQ(mahlwerk("new --kind tabulated my.toml").code, 0);
  const std::string before = text("my.toml");
  EXPECT_EQ(mahlwerk("new --kind planetary my.toml").code, 2);
  EXPECT_EQ(text("my.toml"), before);
  EXPECT_EQ(mahlwerk("new --kind planetary my.toml --force").code, 0);
  EXPECT_NE(text("my.toml"), before);
  EXPECT_EQ(mahlwerk("new --mill spex-8000m --balls 500ml-25x20mm --jar thped-capsule-10mm "
                     "bad.toml")
                .code,
            2);
  EXPECT_FALSE(exists("bad.toml"));
}

TEST_F(NewCase, without_a_mill_lists_what_can_be_given) {
  const ProgramResult e = mahlwerk("new");
  EXPECT_EQ(e.code, 0);
  for (const char* word : {"retsch-mm400", "planetary", "spex-vial-62ml", "lifter-cylinder"})
    EXPECT_NE(e.output.find(word), std::string::npos) << word;
  const ProgramResult wrong = mahlwerk("new --mill retsch-mm40 my.toml");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.output.find("retsch-mm400"), std::string::npos) << wrong.output;
  EXPECT_NE(mahlwerk("new --kind planetry").output.find("did you mean 'planetary'"),
            std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::tests::new_case_test
