// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Reading of paper.toml, its faults, and the page made from it.
#include "mahlwerk/report/paper/paper.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report::paper_test {
namespace {

const std::string head = "title = \"T\"\nsource = \"S\"\n";
const std::string figure =
    "[[figure]]\nnumber = \"1\"\ntitle = \"rate <b>\"\ncampaign = \"c\"\n"
    "quantity = \"collision_rate\"\nagainst = \"mill.frequency\"\nlaw = \"linear\"\n";
const std::string claim =
    "[[claim]]\nfigure = \"1\"\nsays = \"it rises | <b>\"\ncampaign = \"c\"\nkind = \"trend\"\n"
    "quantity = \"collision_rate\"\nagainst = \"mill.frequency\"\nis = \"rises\"\nwhy = \"w\"\n";

std::vector<Fault> faults_of(const std::string& text) {
  try {
    read_paper_text(text, "paper.toml");
  } catch (const InputError& e) {
    return e.faults();
  }
  return {};
}

/// Reading `text` gives exactly one fault, with this code and at this line.
void expect_fault(const std::string& text, const std::string& code, int line) {
  const std::vector<Fault> faults = faults_of(text);
  ASSERT_EQ(faults.size(), 1U) << text << describe(faults);
  EXPECT_EQ(faults[0].code, code) << faults[0].what;
  EXPECT_EQ(faults[0].where, "paper.toml:" + std::to_string(line)) << faults[0].what;
}

cases::Case swept_case() {
  cases::Case c = results::fake_outcome().mill_case;
  c.sweep.keys = {{.key = "mill.frequency", .values = {"10 Hz", "20 Hz"}}};
  return c;
}

TEST(Paper, is_read_whole_with_its_defaults) {
  const Paper paper = read_paper_text(
      head + figure + claim +
          "[[claim]]\nfigure = \"2\"\nsays = \"s\"\ncampaign = \"d\"\nkind = \"bound\"\n"
          "at = { \"mill.frequency\" = [10, \"20 Hz\"], \"contact.friction\" = 0.5 }\n"
          "quantity = \"energy_normal_mean\"\nis = \"below\"\nbound = \"3 mJ\"\n",
      "papers/x/paper.toml");
  EXPECT_EQ(paper.folder, "papers/x");
  EXPECT_EQ(paper.campaigns(), (std::vector<std::string>{"c", "d"}));
  ASSERT_EQ(paper.figures.size(), 1U);
  EXPECT_EQ(paper.figures[0].law, LawForm::line);
  ASSERT_EQ(paper.claims.size(), 2U);
  EXPECT_EQ(paper.claims[0].kind, Claim::Kind::trend);
  EXPECT_DOUBLE_EQ(paper.claims[1].bound, 0.003);
  EXPECT_EQ(paper.claims[1].at,
            (PointSelector{{"mill.frequency", {"10", "20 Hz"}}, {"contact.friction", {"0.5"}}}));
}

TEST(Paper, measured_values_are_read_with_their_errors_and_checked_against_the_campaign) {
  const std::string measured =
      "[[measured]]\nname = \"m\"\nsource = \"p. 3\"\nstatus = \"quoted\"\n"
      "values = [[\"10 Hz\", \"3 1/s\", \"1 1/s\"], [\"20 Hz\", \"5 1/s\", \"1 1/s\"]]\n";
  const std::string test =
      "[[claim]]\nfigure = \"1\"\nsays = \"s\"\ncampaign = \"c\"\nkind = \"measured\"\n"
      "quantity = \"collision_rate\"\nagainst = \"mill.frequency\"\nmeasured = \"m\"\n";
  const Paper paper = read_paper_text(head + measured + test, "paper.toml");
  ASSERT_EQ(paper.measured.size(), 1U);
  EXPECT_EQ(paper.measured[0].status, Measurement::Status::quoted);
  ASSERT_EQ(paper.measured[0].values.size(), 2U);
  EXPECT_EQ(paper.measured[0].values[1].at, "20 Hz");
  EXPECT_DOUBLE_EQ(paper.measured[0].values[1].in("1/s"), 5);
  EXPECT_DOUBLE_EQ(paper.measured[0].values[1].error_in("1/s"), 1);
  const auto code_of = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    try {
      const auto found =
          paper_faults(read_paper_text(head + text, "paper.toml"), {{"c", swept_case()}});
      return found.empty() ? std::string() : found[0].code;
    } catch (const InputError& e) {
      return e.faults()[0].code;
    }
  };
  EXPECT_EQ(code_of(measured + test, "p. 3", "p. 4"), "");
  EXPECT_EQ(code_of(measured + test, "[\"20 Hz\"", "[\"21 Hz\""), "paper-unknown-value");
  EXPECT_EQ(code_of(measured + test, "\"5 1/s\"", "\"5 W\""), "bad-quantity");
  EXPECT_EQ(code_of(measured + test, "measured = \"m\"", "measured = \"n\""),
            "paper-unknown-measurement");
  EXPECT_EQ(code_of(measured + test, ", \"1 1/s\"], [\"20", "], [\"20"), "wrong-type");
  EXPECT_EQ(code_of(measured + test, "against = \"mill.frequency\"\n", ""),
            "paper-unknown-measurement");
  // A figure that draws them asks for the same before anything runs.
  const std::string drawing = measured + figure + "measured = \"m\"\n";
  EXPECT_EQ(code_of(drawing, "p. 3", "p. 4"), "");
  EXPECT_EQ(code_of(drawing, "\"5 1/s\"", "\"5 W\""), "bad-quantity");
  EXPECT_EQ(code_of(drawing, "[\"20 Hz\"", "[\"fast\""), "bad-quantity");
}

TEST(Paper, faults_name_the_line_and_come_together) {
  const std::vector<Fault> nameless = faults_of("title = \"T\"\n");
  ASSERT_EQ(nameless.size(), 1U);
  EXPECT_EQ(nameless[0].what, "the paper lacks `source`");
  expect_fault(head + "titel = \"T\"\n", "unknown-key", 3);
  expect_fault(head + figure + "quantiy = \"x\"\n", "unknown-key", 10);
  expect_fault(head + claim + "kindly = 1\n", "unknown-key", 12);
  std::string wrong = claim;
  wrong.replace(wrong.find("\"rises\""), 7, "\"grows\"");
  expect_fault(head + wrong, "unknown-word", 10);
  expect_fault(head + claim + "at = 3\n", "wrong-type", 12);
  wrong = head + "[[claim]]\nfigure = \"1\"\n";
  EXPECT_GE(faults_of(wrong).size(), 4U);  // says, kind, campaign, quantity at least
}

TEST(Paper, what_it_asks_of_campaigns_is_checked_before_they_run) {
  const auto faults = [](const std::string& text) {
    return paper_faults(read_paper_text(text, "paper.toml"), {{"c", swept_case()}});
  };
  EXPECT_TRUE(faults(head + figure + claim).empty());
  const auto expect = [&](std::string text, const std::string& from, const std::string& to,
                          const std::string& code) {
    text.replace(text.find(from), from.size(), to);
    const std::vector<Fault> found = faults(head + text);
    ASSERT_EQ(found.size(), 1U) << describe(found);
    EXPECT_EQ(found[0].code, code);
    EXPECT_TRUE(found[0].where.starts_with("paper.toml:3")) << found[0].where;
  };
  expect(figure, "mill.frequency", "mill.amplitude", "paper-unknown-key");
  expect(figure, "collision_rate", "colision_rate", "paper-unknown-quantity");
  expect(claim, "mill.frequency", "jar.diameter", "paper-unknown-key");
  expect(claim, "collision_rate", "flight_share", "paper-unknown-quantity");
  expect(claim + "at = { \"mill.frequency\" = \"11 Hz\" }\n", "why", "why", "paper-unknown-value");
}

TEST(Paper, the_page_has_each_figure_and_claim_with_what_was_found) {
  const Paper paper = read_paper_text(head + figure + claim, "paper.toml");
  std::map<std::string, RunCampaign> run;
  RunCampaign& c = run["c"];
  c.numbers.title = "c";
  for (const int hits : {100, 300}) {
    c.outcomes.push_back(results::fake_outcome({hits, hits, hits + 1}));
    add(c.numbers, {.number = c.outcomes.size(), .values = {hits == 100 ? "10 Hz" : "20 Hz"}},
        results::summarise(c.outcomes.back()).quantities);
  }
  c.numbers.keys = campaign_keys({"mill.frequency"}, c.numbers.points);
  c.outcomes[1].notices = {warning("two-states", "They are two.")};
  const PaperResult result = paper_result(paper, run);
  ASSERT_EQ(result.verdicts.size(), 1U);
  EXPECT_EQ(result.verdicts[0].holds, Holds::yes) << result.verdicts[0].finding;
  ASSERT_EQ(result.pictures.size(), 1U);
  EXPECT_EQ(result.pictures[0].file, "figure-1");
  EXPECT_NE(result.pictures[0].svg.find("<svg"), std::string::npos);
  ASSERT_EQ(result.pictures[0].tables.size(), 1U);
  EXPECT_TRUE(result.pictures[0].tables.at("figure-1.csv").starts_with("series,kind,"));
  EXPECT_EQ(captions_markdown(result), "**Figure 1.** rate <b>.\n");
  const std::string page = paper_page(result, "1");
  EXPECT_NE(page.find("it rises | &lt;b&gt;"), std::string::npos);
  EXPECT_EQ(page.find("<b>\""), std::string::npos);
  EXPECT_NE(page.find("10.03"), std::string::npos)
      << result.verdicts[0].finding;  // mean of 100,100,101
  EXPECT_NE(claims_markdown(result).find("| 1 | it rises \\| <b> |"), std::string::npos);
  EXPECT_TRUE(claims_csv(result).starts_with("figure,the_paper_says,we_find,holds,why,own\n"));
  EXPECT_NE(claims_text(result).find("Of 1 claim: yes 1."), std::string::npos);
  for (const std::string& told : {page, claims_text(result)})
    EXPECT_NE(told.find("1 of 2 points: two-states: They are two."), std::string::npos) << told;
}

TEST(Paper, figures_with_the_same_number_are_lettered_panels_of_one_file) {
  const auto numbered = [](const std::string& number) {
    std::string text = figure;
    text.replace(text.find("\"1\""), 3, "\"" + number + "\"");
    return text;
  };
  const Paper paper = read_paper_text(head + numbered("4") + numbered("4") + numbered("6b") +
                                          numbered("6") + numbered("2.2") + numbered("4"),
                                      "paper.toml");
  RunCampaign run;
  run.outcomes.push_back(results::fake_outcome());
  add(run.numbers, {.number = 1, .values = {"10 Hz"}}, run.outcomes[0].summary.quantities);
  run.numbers.keys = campaign_keys({"mill.frequency"}, run.numbers.points);
  const PaperResult result = paper_result(paper, {{"c", run}});
  std::vector<std::string> files, tables;
  for (const PaperPicture& picture : result.pictures) {
    files.push_back(picture.file);
    for (const auto& [name, text] : picture.tables) tables.push_back(name);
  }
  EXPECT_EQ(files, (std::vector<std::string>{"figure-4", "figure-6", "figure-2-2"}));
  // 6b keeps the paper's letter; the panel without a letter gets the next free one.
  EXPECT_EQ(tables, (std::vector<std::string>{"figure-4a.csv", "figure-4b.csv", "figure-4c.csv",
                                              "figure-6a.csv", "figure-6b.csv", "figure-2-2.csv"}));
  EXPECT_EQ(result.pictures[1].caption, "b: rate <b>. a: rate <b>.");
  EXPECT_EQ(result.pictures[2].caption, "rate <b>.");
}

TEST(Paper, our_own_statements_stand_apart_from_the_claims_of_the_paper) {
  std::string ours = claim + "own = true\n";
  ours.replace(ours.find("it rises"), 8, "we add");
  const Paper paper = read_paper_text(head + ours + claim, "paper.toml");
  const PaperResult result{.paper = &paper,
                           .pictures = {},
                           .verdicts = {{"a", Holds::no}, {"b", Holds::yes}},
                           .seconds = {}};
  for (const std::string& told :
       {paper_page(result, "1"), claims_text(result), claims_markdown(result)}) {
    ASSERT_NE(told.find("we add"), std::string::npos) << told;
    EXPECT_LT(told.find("it rises"), told.find("we add")) << told;
  }
  EXPECT_NE(claims_text(result).find("Of 1 claim: yes 1. Of 1 statement of ours: no 1."),
            std::string::npos)
      << claims_text(result);
  EXPECT_NE(claims_markdown(result).find("| figure | we say | we find |"), std::string::npos);
  EXPECT_NE(claims_csv(result).find(",a,no,w,yes\n"), std::string::npos) << claims_csv(result);
}

TEST(Paper, words_about_its_own_settings_are_left_out_where_others_were_run) {
  std::string reasoned = claim;
  reasoned.replace(reasoned.find("\"w\""), 3, "\"for reasons\"");
  const Paper paper = read_paper_text(head + reasoned, "paper.toml");
  PaperResult result{.paper = &paper, .pictures = {}, .verdicts = {{}}, .seconds = {}};
  EXPECT_NE(paper_page(result, "1").find("for reasons"), std::string::npos);
  result.changed = {"run.time = 2 s"};
  for (const std::string& told : {paper_page(result, "1"), claims_text(result)}) {
    EXPECT_EQ(told.find("for reasons"), std::string::npos) << told;
    EXPECT_NE(told.find("Run with run.time = 2 s, unlike the campaigns of the paper."),
              std::string::npos)
        << told;
  }
  EXPECT_EQ(claims_csv(result).find("for reasons"), std::string::npos);
  EXPECT_EQ(claims_markdown(result).find("for reasons"), std::string::npos);
}

TEST(Paper, every_paper_of_the_project_asks_for_what_its_campaigns_have) {
  const std::filesystem::path home(MAHLWERK_HOME);
  const cases::Catalogue catalogue(home / "catalogue");
  int papers = 0;
  for (const char* collection : {"papers", "validation"})
    for (const auto& entry : std::filesystem::directory_iterator(home / collection)) {
      const Paper paper = read_paper(entry.path() / "paper.toml");
      std::map<std::string, cases::Case> cases;
      for (const std::string& name : paper.campaigns())
        cases[name] = cases::read(paper.folder / (name + ".toml"), catalogue);
      const std::vector<Fault> faults = paper_faults(paper, cases);
      EXPECT_TRUE(faults.empty()) << describe(faults);
      ++papers;
    }
  EXPECT_GE(papers, 10);
}

}  // namespace
}  // namespace mahlwerk::report::paper_test
