// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Cases: what `mahlwerk check` does with one, without its pilot runs.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/write.hpp"
#include "targets.hpp"

namespace mahlwerk::fuzz {
namespace {

/// What is told of a case that can be read.
void tell(const cases::Case& c) {
  cases::derived_quantities(c);
  cases::size_notes(c);
  cases::grains_note(c);
  cases::jar_warnings(c);
  cases::unusual_values(c);
  cases::ignored_keys(c, cases::EngineName::event);
  cases::ignored_keys(c, cases::EngineName::soft);
  cases::expected_time(c);
  cases::write(c);
  constexpr double memory = 1e9;  // [bytes]
  if (!campaign::run_faults(c).empty() || !campaign::memory_faults({c}, 2, memory).empty()) return;
  if (c.balls.empty()) return;
  cases::bounce_table(c);
  if (!cases::in_time_steps(c.run.engine)) return;
  campaign::soft_notices(c);
  campaign::overlap_warnings(c);
}

void read_case(const std::string& text) {
  const cases::Case c = cases::read_text(text, scratch() / "case.toml", catalogue());
  tell(c);
  constexpr std::size_t most = 10;  // points that are read
  if (c.sweep.empty() || campaign::Plan(c.sweep, c.seed).size() > most) return;
  const cases::CaseFile file(text, scratch() / "case.toml");
  const campaign::Plan plan(c.sweep, c.seed);
  for (std::size_t i = 0; i < plan.size(); ++i) tell(file.read(catalogue(), plan.overrides(i)));
}

/// The cases of the sources that name no other file and have all their values.
std::vector<std::string> cases_of_the_sources() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"examples", "papers", "validation"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(home() / folder))
      if (const auto& file = entry.path();
          file.extension() == ".toml" && file.filename() != "expected.toml")
        files.push_back(file);
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const auto& file : files)
    if (std::string text = contents(file);
        text.find("file = ") == std::string::npos && text.find("[fit") == std::string::npos)
      texts.push_back(std::move(text));
  return texts;
}

/// The rows of a sieve analysis, of balls and of powder.
void read_sieves(const std::string& text) {
  constexpr const char* form = R"(title = "t"
[mill]
kind = "still"
[jar]
kind = "sphere"
diameter = "100 mm"
[[balls]]
mass = "20 g"
density = "7850 kg/m3"
distribution = "sieves"
{0} = {1}
[powder]
mass = "1 g"
density = "2500 kg/m3"
distribution = "sieves"
{0} = {1}
[run]
engine = "event"
time = "1 s"
)";
  try {
    read_case(fmt::format(form, "passing", text));
  } catch (const InputError&) {
    read_case(fmt::format(form, "retained", text));
  }
}

std::vector<std::string> sieves() {
  return {R"([["1 mm", "0 %"], ["2 mm", "40 %"], ["4 mm", "100 %"]])",
          R"([["1 mm", "30 %"], ["2 mm", 0.7], ["4 mm", "0 %"]])"};
}

}  // namespace

Target case_target() {
  return {"case", read_case, cases_of_the_sources};
}
Target sieves_target() {
  return {"sieves", read_sieves, sieves};
}

}  // namespace mahlwerk::fuzz
