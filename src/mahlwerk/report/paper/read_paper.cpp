// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Strict reader of paper.toml.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/report/paper/paper.hpp"

namespace mahlwerk::report {
namespace {

using cases::Findings;
using cases::Node;
using cases::SectionReader;
using Words = std::vector<std::string>;
using Kind = Claim::Kind;

// In the order of the enumerations.
const Words drawn_words{"quantity", "trajectories", "snapshots"};
const Words kind_words{"law",   "trend",   "compare",  "alike",         "regime",
                       "bound", "maximum", "measured", "capture-bounds"};
const Words table_words{"quantity", "captured"};
const Words law_words{"linear", "power", "quadratic"};
const Words claimed_law_words{"linear", "power"};
const Words status_words{"verified", "quoted", "unverified"};

template <class Enum>
Enum chosen(SectionReader& in, std::string_view key, const Words& words,
            std::string standard = "") {
  const std::string word = in.choice({key, words, std::move(standard), "docs/papers.md"});
  const auto at = std::ranges::find(words, word);
  return at == words.end() ? Enum{} : static_cast<Enum>(at - words.begin());
}

std::string needed(SectionReader& in, std::string_view key, std::string_view about) {
  if (!in.gives(key)) in.missing(key, about, fmt::format("write {} = \"...\"", key));
  return in.text(key).value_or("");
}

/// Name of a campaign. It is also the name of the folder of its results.
std::string campaign_in(SectionReader& in) {
  const std::string name = needed(in, "campaign", "the case file beside this one, without .toml");
  if (name.find_first_of("/\\") != std::string::npos)
    in.fault(*in.find("campaign"), fmt::format("\"{}\" is not the name of a campaign", name),
             "name the case file beside this one, without .toml", "wrong-type");
  return name;
}

bool is_value(const Node& node) {
  return node.kind == Node::Kind::text || node.kind == Node::Kind::number;
}

/// { "mill.ratio" = [-3, -2], "contact.friction" = 0.5 }
PointSelector read_selector(SectionReader& in) {
  PointSelector where;
  const Node* table = in.find("at");
  if (table == nullptr) return where;
  for (const cases::Member& member : table->members) {
    std::vector<std::string>& values = where[member.key];
    if (is_value(member.value)) values.push_back(member.value.text);
    for (const Node& item : member.value.items)
      if (is_value(item)) values.push_back(item.text);
  }
  const bool sound = !table->members.empty() &&
                     std::ranges::none_of(where, [](const auto& w) { return w.second.empty(); });
  if (!sound)
    in.fault(*table, "`at` must name keys of the campaign's [sweep] with values",
             "write at = { \"mill.ratio\" = [-3, -2], \"contact.friction\" = 0.5 }", "wrong-type");
  return where;
}

std::string value_of(SectionReader& in, std::string_view key, std::string_view about) {
  const Node* node = in.find(key);
  if (node != nullptr && is_value(*node)) return node->text;
  in.missing(key, about, fmt::format("write {} = ..., as in [sweep]", key));
  return "";
}

/// band_over = ["breakage.f_mat"], nominal = { "breakage.f_mat" = "1 kg/J/m" }
void read_band(SectionReader& in, PaperFigure& figure) {
  if (const Node* keys = in.find("band_over")) {
    for (const Node& key : keys->items)
      if (key.kind == Node::Kind::text) figure.band_over.push_back(key.text);
    if (figure.band_over.empty() || figure.band_over.size() != keys->items.size())
      in.fault(*keys, "`band_over` must list keys of the campaign's [sweep]",
               "write band_over = [\"breakage.f_mat\"]", "wrong-type");
  }
  const Node* values = in.find("nominal");
  if (values == nullptr) return;
  for (const cases::Member& member : values->members)
    if (is_value(member.value)) figure.nominal[member.key] = member.value.text;
  if (figure.nominal.empty() || figure.nominal.size() != values->members.size())
    in.fault(*values, "`nominal` must give one value to keys of `band_over`",
             "write nominal = { \"breakage.f_mat\" = \"1 kg/J/m\" }", "wrong-type");
}

PaperFigure read_figure(SectionReader& in) {
  PaperFigure figure;
  figure.number = needed(in, "number", "the paper's number of the figure");
  figure.title = needed(in, "title", "what is drawn");
  figure.about = in.text("about").value_or("");
  figure.campaign = campaign_in(in);
  figure.drawn = chosen<PaperFigure::Drawn>(in, "draws", drawn_words, "quantity");
  figure.at = read_selector(in);
  if (figure.drawn == PaperFigure::Drawn::quantity) {
    figure.quantity = needed(in, "quantity", "its name in summary.json");
    figure.against = needed(in, "against", "a key of the campaign's [sweep]");
    if (in.gives("law")) figure.law = chosen<LawForm>(in, "law", law_words);
    read_band(in, figure);
    if (const auto name = in.text("measured")) figure.measurements.push_back(*name);
  } else {
    in.refuse({"quantity", "against", "law", "band_over", "nominal", "measured"},
              "in this kind of figure", "remove it");
    figure.seen_from_jar =
        in.gives("seen_from") && in.choice({"seen_from", {"carrier", "jar"}, ""}) == "jar";
  }
  return figure;
}

void read_bound(SectionReader& in, Claim& claim) {
  claim.is = in.choice({"is", {"above", "below"}, ""});
  claim.bound_text = value_of(in, "bound", "the bound: \"0.5\", \"3 mJ\"");
  if (claim.bound_text.empty()) return;
  try {
    claim.bound = parse_quantity(claim.bound_text).value;
  } catch (const UnitError& error) {
    in.fault(*in.find("bound"), error.what(), "write, for instance, bound = \"3 mJ\"",
             "bad-quantity");
  }
}

void read_law(SectionReader& in, Claim& claim) {
  claim.law = chosen<LawForm>(in, "law", claimed_law_words);
  if (claim.law == LawForm::power) {
    if (!in.gives("exponent"))
      in.missing("exponent", "the power that is claimed", "write exponent = 2");
    claim.exponent = in.optional_number({"exponent", "", any_number, "the power that is claimed"});
    if (in.gives("is")) claim.is = in.choice({"is", {"above", "below"}, ""});
  } else if (in.gives("is")) {
    claim.is = in.choice({"is", {"rises", "falls"}, ""});
  }
}

/// Whether `within` belongs to the claim: a tolerance of the exponent, the curvature or the ratio.
bool has_tolerance(const Claim& claim) {
  if (claim.kind == Kind::law) return claim.law == LawForm::line || claim.is.empty();
  return claim.kind == Kind::alike;
}

void read_measured_claim(SectionReader& in, Claim& claim) {
  claim.measured = needed(in, "measured", "the name of a section [[measured]]");
  if (in.gives("relative_to"))
    claim.relative_to = value_of(in, "relative_to", "the value of `against` that is the unit");
}

void read_test(SectionReader& in, Claim& claim) {
  if (claim.kind == Kind::capture_bounds) return;
  if (claim.kind != Kind::regime)
    claim.quantity = needed(in, "quantity", "its name in summary.json");
  const bool along =
      claim.kind != Kind::regime && claim.kind != Kind::bound && claim.kind != Kind::measured;
  if (along || in.gives("against"))
    claim.against = needed(in, "against", "a key of the campaign's [sweep]");
  if (claim.kind == Kind::law) read_law(in, claim);
  if (has_tolerance(claim))
    claim.within = in.optional_number({"within", "", positive, "the tolerance"}).value_or(0.1);
  if (claim.kind == Kind::trend) claim.is = in.choice({"is", {"rises", "falls"}, ""});
  if (claim.kind == Kind::compare) {
    claim.is = in.choice({"is", {"larger", "smaller"}, ""});
    claim.first = value_of(in, "first", "the value of `against` that is compared with");
    claim.second = value_of(in, "second", "the value at which it is larger or smaller");
  }
  if (claim.kind == Kind::maximum) {
    claim.first = value_of(in, "first", "one end of the range of `against` with the maximum");
    claim.second = value_of(in, "second", "the other end of this range");
  }
  if (claim.kind == Kind::measured) read_measured_claim(in, claim);
  if (claim.kind == Kind::regime)
    claim.is = in.choice({"is",
                          {"cascading", "cataracting", "centrifuging", "rigid", "resting",
                           "rolling", "rolling on the wall", "sliding", "slumping", "surging"},
                          ""});
  if (claim.kind == Kind::bound) read_bound(in, claim);
}

Claim read_claim(SectionReader& in) {
  Claim claim;
  claim.figure = needed(in, "figure", "the figure or section of the paper");
  claim.says = needed(in, "says", "what the paper says");
  claim.why = in.text("why").value_or("");
  in.flag({"own", false, "a claim of the paper"}, claim.own);
  claim.kind = chosen<Kind>(in, "kind", kind_words);
  claim.campaign = campaign_in(in);
  claim.at = read_selector(in);
  read_test(in, claim);
  return claim;
}

/// A quantity in SI units; reports a fault if the text is none.
double si_value(SectionReader& in, const Node& node, const std::string& text) try {
  return parse_quantity(text).value;
} catch (const UnitError& error) {
  in.fault(node, error.what(), "write a number with its unit, as in \"83 W\"", "bad-quantity");
  return 0;
}

/// A row of `values`: [key, value, error], [value, error] without a key.
Measurement::Value read_measured_value(SectionReader& in, const Node& row, bool keyed) {
  const std::size_t first = keyed ? 1 : 0;
  const bool sound = row.kind == Node::Kind::list && row.items.size() == first + 2 &&
                     std::ranges::all_of(row.items, is_value);
  if (!sound) {
    in.fault(row, "a measured value consists of the value of the key, the value and its error",
             keyed ? "write [\"70 rpm\", \"83 W\", \"4 W\"]" : "write [\"83 W\", \"4 W\"]",
             "wrong-type");
    return {};
  }
  Measurement::Value value{.at = keyed ? row.items[0].text : "",
                           .text = row.items[first].text,
                           .error_text = row.items[first + 1].text};
  si_value(in, row, value.text);  // for its faults
  si_value(in, row, value.error_text);
  return value;
}

Measurement read_measurement(SectionReader& in) {
  Measurement made;
  made.name = needed(in, "name", "a name for claims and figures");
  made.source = needed(in, "source", "where the numbers stand");
  made.error_is = in.text("error_is").value_or("");
  made.status = chosen<Measurement::Status>(in, "status", status_words);
  const Node* rows = in.find("values");
  if (rows == nullptr || rows->kind != Node::Kind::list || rows->items.empty()) {
    in.missing("values", "the measured values with their errors",
               "write values = [[\"70 rpm\", \"83 W\", \"4 W\"]]");
    return made;
  }
  const bool keyed = rows->items.front().items.size() != 2;
  for (const Node& row : rows->items) made.values.push_back(read_measured_value(in, row, keyed));
  return made;
}

/// energies = ["1 uJ", "1 mJ"]
void read_energies(SectionReader& in, PaperTable& table) {
  const Node* list = in.find("energies");
  if (list == nullptr || list->items.empty() || !std::ranges::all_of(list->items, is_value)) {
    in.missing("energies", "the energies of the rows", "write energies = [\"1 uJ\", \"1 mJ\"]");
    return;
  }
  for (const Node& item : list->items) {
    table.energies.push_back(si_value(in, item, item.text));
    table.energy_texts.push_back(item.text);
    if (!(table.energies.back() > 0))
      in.fault(item, "an energy must be above 0", "write energies = [\"1 uJ\", \"1 mJ\"]",
               "out-of-range");
  }
}

PaperTable read_table(SectionReader& in) {
  PaperTable table;
  table.name = needed(in, "name", "the name of its files");
  if (table.name.find_first_of("/\\.") != std::string::npos)
    in.fault(*in.find("name"), "the name of a table is a file name without its ending",
             "write a word, as in name = \"free-numbers\"", "wrong-type");
  table.title = needed(in, "title", "what it shows");
  table.about = in.text("about").value_or("");
  table.campaign = campaign_in(in);
  table.kind = chosen<PaperTable::Kind>(in, "kind", table_words, "quantity");
  table.against = needed(in, "against", "the key of [sweep] whose values are the columns");
  table.at = read_selector(in);
  if (table.kind == PaperTable::Kind::quantity) {
    table.quantity = needed(in, "quantity", "its name in summary.json");
    in.flag({"ratio", false, "no such column"}, table.ratio);
  } else {
    table.one = in.text("one").value_or("balls.1");
    table.other = needed(in, "other", "the other body of the pair, as in capture.csv");
    read_energies(in, table);
  }
  return table;
}

template <class One, class Read>
std::vector<One> read_list(SectionReader& top, const char* key, Findings& findings,
                           const Read& read) {
  std::vector<One> list;
  const Node* nodes = top.find(key);
  if (nodes == nullptr) return list;
  if (nodes->kind != Node::Kind::list) {
    top.fault(*nodes, fmt::format("`{}` must be a list of sections", key),
              fmt::format("write [[{}]] and its values below", key), "wrong-type");
    return list;
  }
  for (std::size_t i = 0; i < nodes->items.size(); ++i) {
    SectionReader in(&nodes->items[i], fmt::format("{}.{}", key, i + 1), findings);
    list.push_back(read(in));
    list.back().where = nodes->items[i].where;
    in.report_unknown_keys();
  }
  return list;
}

}  // namespace

Paper read_paper_text(const std::string& text, const std::filesystem::path& file) {
  const Node root = cases::parse_tree(text, file.generic_string());
  Findings findings;
  SectionReader top(&root, "", findings);
  Paper paper;
  paper.folder = file.parent_path();
  for (const char* key : {"title", "source"})
    if (!top.gives(key))
      top.fault(root, fmt::format("the paper lacks `{}`", key),
                fmt::format("write {} = \"...\" at its top", key), "missing-value");
  paper.title = top.text("title").value_or("");
  paper.source = top.text("source").value_or("");
  paper.about = top.text("about").value_or("");
  paper.figures = read_list<PaperFigure>(top, "figure", findings, read_figure);
  paper.licence = top.text("licence").value_or("");
  top.flag({"quick", true, "part of --quick"}, paper.quick);
  paper.claims = read_list<Claim>(top, "claim", findings, read_claim);
  paper.tables = read_list<PaperTable>(top, "table", findings, read_table);
  paper.measured = read_list<Measurement>(top, "measured", findings, read_measurement);
  top.report_unknown_keys();
  if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
  return paper;
}

Paper read_paper(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream)
    throw InputError(Fault{file.generic_string(), "there is no such file, or it cannot be read",
                           "name a folder with a paper.toml", "no-such-paper"});
  return read_paper_text(text, file);
}

}  // namespace mahlwerk::report
