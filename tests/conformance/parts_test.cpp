// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every part (cases/part.hpp): its sections are read back as they are written, it has something to
// say only of a case with its section, and its records go on from a saved state.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "lammps_cases.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/observe/recorder.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::tests::parts_test {
namespace {

using cases::Case;
using cases::Part;

/// Three balls and quartz in a vibration mill.
const std::string plain = R"([mill]
kind = "vibration"
amplitude = "5 mm"
frequency = "20 Hz"
[jar]
kind = "cylinder"
diameter = "50 mm"
height = "60 mm"
[[balls]]
diameter = "12 mm"
count = 3
density = "7850 kg/m3"
[powder]
mass = "5 g"
size = "0.1 mm"
density = "2650 kg/m3"
[contact]
restitution = 0.6
friction = 0.3
[run]
engine = "event"
time = "0.5 s"
settle = "0.1 s"
replicates = 2
)";

/// The sections that switch a part on, by its name, with the parts that it needs.
std::string sample(std::string_view part) {
  static const std::map<std::string_view, std::string> lines{
      {"wear", "[wear]\n"},
      {"heat", "[heat]\n"},
      {"grinding",
       "[capture]\nmodel = \"barrios\"\nfracture_energy = \"100 J/kg\"\n"
       "[breakage]\nmodel = \"vogel-peukert\"\nf_mat = \"1 kg/J/m\"\n"
       "x_w_min = \"1e-4 J m/kg\"\n[fragments]\nmodel = \"austin\"\nshare = 0.5\ngamma = 0.8\n"
       "beta = 3\n[grinding]\ntime = \"10 min\"\n"},
      {"bed_breakage",
       "[breakage]\nmodel = \"vogel-peukert\"\nf_mat = \"1 kg/J/m\"\n"
       "x_w_min = \"1e-4 J m/kg\"\n[fragments]\nmodel = \"halves\"\n[bed_breakage]\n"},
      {"powder_feedback",
       "[capture]\nmodel = \"barrios\"\nfracture_energy = \"100 J/kg\"\n"
       "[powder_feedback]\nabsorbed_energy = \"500 J/kg\"\n"},
      {"kinetics", "[kinetics]\ndose_constant = \"1 MJ/kg\"\ntime = \"10 min\"\n"},
      {"flow",
       "[flow]\noutlet = [\"0 mm\", \"0 mm\", \"-15 mm\"]\nfeed = \"recirculate\"\n"
       "inlet = [\"0 mm\", \"0 mm\", \"10 mm\"]\n"
       "inlet_size = [\"20 mm\", \"20 mm\", \"20 mm\"]\n"},
      {"mixing", "[mixing]\ncolour = \"height\"\n"},
      {"drive", "[drive]\ninertia = \"1e-3 kg m2\"\ntorque = \"0.1 N m\"\n"},
      {"power_meter", "[power_meter]\ninterval = \"50 ms\"\n"},
      {"microphone", "[microphone]\n"},
      {"accelerometer", "[accelerometer]\n"},
      {"thermocouple", "[heat]\n[thermocouple]\n"}};
  const auto found = lines.find(part);
  return found == lines.end() ? "no sample of this part" : found->second;
}

/// The same in a drum by the soft engine.
std::string in_drum() {
  std::string text = plain;
  const auto replace = [&](std::string_view from, std::string_view to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"vibration\"\namplitude = \"5 mm\"\nfrequency = \"20 Hz\"",
          "\"tumbling\"\nspeed = \"60 rpm\"");
  replace("engine = \"event\"", "engine = \"soft\"");
  replace("friction = 0.3", "friction = 0.3\nsoftening = 1e-3");
  return text;
}

Case case_with(const Part& part) {
  std::string text = (part.name == "drive" ? in_drum() : plain) + sample(part.name);
  const auto replace = [&](const std::string& from, std::string_view to) {
    text.replace(text.find(from), from.size(), to);
  };
  if (part.name == "flow" || part.name == "bed_breakage")  // the event engine refuses it
    replace("engine = \"event\"", "engine = \"soft\"");
  if (part.name == "bed_breakage") replace("size = \"0.1 mm\"", "size = \"3 mm\"\nas = \"grains\"");
  return case_of_text(text);
}

class Parts : public ::testing::TestWithParam<const Part*> {};

TEST_P(Parts, sections_of_a_case_are_those_of_the_register) {
  for (const cases::PartSection& one : GetParam()->sections)
    EXPECT_TRUE(std::ranges::any_of(cases::section_list(), [&](const cases::SectionSpec& spec) {
      return spec.name == one.spec.name && !spec.many_runs;
    })) << one.spec.name;
}

TEST_P(Parts, are_read_back_as_they_are_written) {
  const Case c = case_with(*GetParam());
  const std::string text = cases::write(c);
  EXPECT_TRUE(case_of_text(text) == c) << text;
  EXPECT_FALSE(case_of_text(plain) == c);
  for (const cases::PartSection& one : GetParam()->sections) {
    EXPECT_TRUE(one.present(c)) << one.spec.name;
    EXPECT_NE(text.find(fmt::format("\n[{}]\n", one.spec.name)), std::string::npos) << text;
  }
}

TEST_P(Parts, with_defaults_have_the_section) {
  for (const cases::PartSection& one : GetParam()->sections) {
    Case c = case_of_text(plain);
    EXPECT_FALSE(one.present(c)) << one.spec.name;
    if (one.add == nullptr) continue;
    one.add(c);
    EXPECT_TRUE(one.present(c)) << one.spec.name;
  }
}

TEST_P(Parts, belong_to_cases_with_a_section_of_theirs_only) {
  const Part& part = *GetParam();
  const auto belongs = [&](const Case& c) {
    const std::vector<const Part*> there = cases::parts_of(c);
    return std::ranges::find(there, &part) != there.end();
  };
  const Case without = case_of_text(plain), with = case_with(part);
  EXPECT_FALSE(belongs(without));
  EXPECT_TRUE(belongs(with));
  for (const results::Measure& m : part.quantities())
    EXPECT_TRUE(results::applying({m}, without).empty()) << m.name;
  std::vector<Fault> faults;
  if (part.check != nullptr) part.check(with, faults);
  EXPECT_TRUE(faults.empty());
}

TEST_P(Parts, name_the_section_that_a_missing_quantity_needs) {
  const std::vector<results::MissingQuantity> missing =
      results::missing_quantities(case_of_text(plain));
  const results::Measures own = results::applying(GetParam()->quantities(), case_with(*GetParam()));
  ASSERT_FALSE(own.empty());
  const auto found = std::ranges::find(missing, own.front().name, &results::MissingQuantity::name);
  ASSERT_NE(found, missing.end()) << own.front().name;
  EXPECT_TRUE(std::ranges::any_of(GetParam()->sections, [&](const cases::PartSection& one) {
    return found->section == fmt::format("[{}]", one.spec.name);
  })) << found->section;
}

void check_tables(const std::vector<results::NamedTable>& tables) {
  EXPECT_FALSE(tables.empty());
  for (const results::NamedTable& one : tables) {
    EXPECT_FALSE(one.about.empty()) << one.name;
    EXPECT_FALSE(one.table.rows.empty()) << one.name;
    for (const auto& row : one.table.rows) EXPECT_EQ(row.size(), one.table.columns.size());
  }
}

TEST_P(Parts, have_quantities_with_intervals_tables_and_a_panel) {
  const Part& part = *GetParam();
  const results::Outcome outcome = campaign::run(case_with(part));
  const results::Measures there = results::applying(part.quantities(), outcome.mill_case);
  EXPECT_FALSE(there.empty());
  for (const results::Measure& m : there) {
    const results::Quantity& q = named(outcome.summary.quantities, m.name);
    EXPECT_EQ(q.unit, m.unit) << m.name;
    // Of three balls, which do not mix and make no bed.
    const bool none =
        m.name == "mixing_time" || m.name == "packing_fraction" || m.name == "bed_porosity";
    EXPECT_TRUE(none || std::isfinite(q.value)) << m.name;
    EXPECT_TRUE(none || std::isfinite(q.ci95)) << m.name;
    EXPECT_FALSE(m.about.empty()) << m.name;
  }
  if (part.tables != nullptr) check_tables(part.tables(outcome));
  EXPECT_TRUE(part.panel == nullptr || !part.panel(outcome).empty());
}

/// Hits on the jar and between balls, one every third of a millisecond, with a pause of 2 ms after
/// ten of them.
std::vector<scene::Collision> hits(int count) {
  std::vector<scene::Collision> all;
  for (int i = 0; i < count; ++i)
    all.push_back({.time = (i + 1) / 3e3 + i / 10 * 2e-3,
                   .duration = 1e-4 * (i % 3),
                   .other = i % 4 == 0 ? 1 : -1,
                   .where = {},
                   .normal = {0, 0.6, 0.8},
                   .mass = 0.01,
                   .approach = 0.1 * (1 + i % 7),
                   .impulse = 1e-3 * (1 + i % 5)});
  return all;
}

/// Hands a recorder the hits with these indices, and what it asks for in between.
void feed(observe::Recorder& recorder, const std::vector<scene::Collision>& all, std::size_t from,
          std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    const scene::EnergyBalance now{.time = all[i].time, .wall_work = 0.1 * all[i].time};
    if (recorder.next() <= now.time) {
      recorder.take(now);
      const double x = 0.01 * (all[i].approach - 0.4);
      if (recorder.wants_balls())
        recorder.take_balls(
            now, now.time,
            {{0.006, 7850, {x, 0, x}, {}, {}}, {0.006, 7850, {0, 0.01, -x}, {}, {}}});
    }
    recorder.collisions({&all[i], 1});
  }
}

std::string bytes_of(observe::Recorder& recorder) {
  Archive archive;
  recorder.serialize(archive);
  return archive.bytes();
}

class Recorders : public Parts {};

TEST_P(Recorders, go_on_from_a_saved_state_with_the_same_bits) {
  const Part& part = *GetParam();
  const Case c = case_with(part);
  const auto all = hits(900);
  const std::size_t half = 198;  // between two pauses, before the end of the shortest record
  const auto whole = part.recorder(c), first = part.recorder(c), second = part.recorder(c);
  for (const auto* one : {&whole, &first, &second}) (*one)->begin(0.01);
  const std::string nothing = bytes_of(*whole);
  feed(*whole, all, 0, all.size());
  feed(*first, all, 0, half);
  const auto copy = first->copy();
  Archive saved(bytes_of(*first));
  second->serialize(saved);
  saved.finish();
  feed(*second, all, half, all.size());
  EXPECT_TRUE(bytes_of(*second) == bytes_of(*whole));
  EXPECT_FALSE(bytes_of(*whole) == nothing);
  feed(*first, all, half, all.size());  // a copy has its own records
  EXPECT_FALSE(bytes_of(*copy) == bytes_of(*first));
}

std::vector<const Part*> with_records() {
  std::vector<const Part*> chosen;
  std::ranges::copy_if(cases::parts(), std::back_inserter(chosen),
                       [](const Part* part) { return part->recorder != nullptr; });
  return chosen;
}

std::string name_of(const ::testing::TestParamInfo<const Part*>& of) {
  return std::string(of.param->name);
}

INSTANTIATE_TEST_SUITE_P(All, Parts, ::testing::ValuesIn(cases::parts()), name_of);
INSTANTIATE_TEST_SUITE_P(All, Recorders, ::testing::ValuesIn(with_records()), name_of);

}  // namespace
}  // namespace mahlwerk::tests::parts_test
