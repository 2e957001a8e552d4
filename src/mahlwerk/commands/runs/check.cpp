// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// check: reports the faults of a case, or the quantities that follow from it, without running it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/device_faults.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/forecast.hpp"
#include "mahlwerk/campaign/run/later_motion.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/sweep/checked_points.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/mill_power.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/terminal.hpp"
#include "mahlwerk/commands/runs/cheaper.hpp"
#include "mahlwerk/lammps/notices.hpp"

namespace mahlwerk::commands {
namespace {

/// [s] Reading a case and writing results and report.
constexpr double around_a_run = 0.1;

struct CheckResult {
  cases::Case mill_case;
  std::vector<cases::DerivedQuantity> follows;
  std::vector<Fault> engine;  ///< why this version cannot run it, or some of its points
  std::size_t points = 1;     ///< number of points of a campaign
  std::size_t bad_points = 0;
  std::vector<std::string> notes;  ///< on the chosen engine and on values of the case
};

void add(const Notices& notices, std::vector<std::string>& lines) {
  for (const Notice& one : notices) lines.push_back((one.warns() ? "Warning: " : "") + one.text);
}

/// The time step of the soft engine or of LAMMPS, what bounds it, and what these engines assume.
void add_time_steps(const cases::Case& decided, CheckResult& c) {
  const campaign::SoftSettings s = campaign::soft_settings(decided);
  c.follows.insert(
      c.follows.end(),
      {{"time_step", s.rules.time_step, "s", "of the soft engine, and in LAMMPS"},
       {"rayleigh_time", s.steps.rayleigh, "s", "of the smallest or softest ball (dem.28)"},
       {"contact_time", s.steps.contact, "s", "of the shortest collision (dem.29)"},
       {"largest_overlap", s.steps.overlap, "", "over the radius, at the highest speed (dem.8)"}});
  add(campaign::soft_notices(decided), c.notes);
  if (decided.run.engine == cases::EngineName::lammps) add(lammps::model_notices(decided), c.notes);
  add(campaign::overlap_warnings(decided), c.notes);
}

constexpr const char* megabytes = "MB";  // no unit of a case

/// Memory and disk that a run needs.
void add_costs(const std::vector<cases::Case>& points, int cores, double collisions,
               CheckResult& c) {
  const bool sums_up = c.mill_case.sweep.empty();  // a sweep keeps its replicates whole
  constexpr double mega = 1e6;
  double files = 0;
  for (const cases::Case& point : points) files += campaign::disk_needed(point, collisions);
  c.follows.insert(
      c.follows.end(),
      {{"memory", campaign::memory_of_run({points.front()}, cores, sums_up) / mega, megabytes,
        "at most, of all replicates that run together and the results of those that "
        "have ended"},
       {"files", files / mega, megabytes, "about, of all results on the disk"}});
  if (points.front().run.device == cases::DeviceName::gpu)
    c.follows.push_back({"card_memory", campaign::card_memory(points.front()) / mega, megabytes,
                         "about, of the graphics card for each replicate that runs"});
}

CheckResult check_case(const std::filesystem::path& file, const cases::Catalogue& known,
                       const std::vector<cases::Override>& set) {
  CheckResult c;
  c.mill_case = cases::read(file, known, set);
  const cases::Case one_run = cases::of_one_run(c.mill_case);
  const campaign::CheckedPoints points(one_run, file, known, set);
  c.points = points.size();
  c.bad_points = points.bad();
  c.engine = points.faults();
  const bool sweeps = !c.mill_case.sweep.empty();
  if (points.good().empty() && sweeps) throw InputError(c.engine);
  const cases::Case& first = sweeps ? points.good().front() : one_run;
  c.follows = cases::derived_quantities(first);
  if (points.good().empty()) return c;
  // Before the pilot run, which needs the memory.
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (const cases::Case& point : points.good()) {  // one after the other is in memory
    const auto memory =
        campaign::memory_faults({point}, cores, campaign::memory_available(), !sweeps);
    c.engine.insert(c.engine.end(), memory.begin(), memory.end());
    if (!memory.empty()) return c;
  }
  const campaign::EngineChoice choice = campaign::choose_engine(first);
  const cases::Case decided = campaign::decided_case(first, choice);
  c.notes = cases::size_notes(first);
  if (cases::evolves(c.mill_case))
    c.notes.emplace_back(
        "Shapes and sizes follow their wear: the costs are those of the run of one stage.");
  if (std::string grains = cases::grains_note(first); !grains.empty())
    c.notes.push_back(std::move(grains));
  c.notes.insert(c.notes.end(), choice.reason.begin(), choice.reason.end());
  add(cases::jar_warnings(first), c.notes);
  add(cases::mill_power_notices(first), c.notes);
  add(cases::unusual_values(first), c.notes);
  add(cases::ignored_keys(first, choice.engine), c.notes);
  if (cases::in_time_steps(choice.engine)) add_time_steps(decided, c);
  const campaign::Forecast ahead = campaign::forecast(decided);
  const double further = campaign::assumed_values_cost(decided, ahead.settling) +
                         campaign::later_motion_cost(first, ahead.settling);
  const double seconds =
      sweeps ? ahead.each * static_cast<double>(first.run.replicates) *
                   static_cast<double>(points.size()) / cores
             : ahead.each * static_cast<double>(ahead.share) * (1 + further) + around_a_run;
  const std::vector<Fault> disk = campaign::disk_faults(
      points.good(), ahead.collisions, campaign::disk_available(std::filesystem::current_path()));
  c.engine.insert(c.engine.end(), disk.begin(), disk.end());
  if (std::string lines = sweeps ? "" : cheaper(decided, seconds); !lines.empty())
    c.notes.push_back(std::move(lines));
  if (cases::settles(decided))
    c.follows.push_back({"settling_time", cases::least_settling(decided), "s",
                         "at least, before counting begins (run.settle = \"auto\")"});
  if (!first.run.until)
    c.follows.push_back({"counted_time", decided.run.time, "s",
                         decided.run.time == first.run.time ? "of each replicate, run.time"
                                                            : "of each replicate, whole periods"});
  c.follows.push_back(
      {"run_time", seconds, "s",
       sweeps ? "estimate of all points on this machine, all cores, from a pilot run of the first"
       : first.run.until
           ? "estimate on this machine, all cores, if the precision is reached as soon as usual"
           : "estimate on this machine, all cores, from a pilot run"});
  add_costs(points.good(), cores, ahead.collisions, c);
  return c;
}

std::string in_words(const contact::BounceRule& rule) {
  const contact::Restitution& e = rule.restitution;
  using Law = contact::Restitution::Law;
  std::string words = fmt::format("restitution {}", show_rounded(e.value(), ""));
  if (e.law() == Law::viscoelastic)
    words += fmt::format(" at {}, viscoelastic", show_rounded(e.speed(), "m/s"));
  if (e.law() == Law::tabulated)
    words = fmt::format(
        "restitution {} at {} to {} at {}, tabulated", show_rounded(e.points().front().second, ""),
        show_rounded(e.points().front().first, "m/s"), show_rounded(e.points().back().second, ""),
        show_rounded(e.points().back().first, "m/s"));
  words += fmt::format(", tangential {}", show_rounded(rule.tangential_restitution, ""));
  return words + (std::isfinite(rule.friction)
                      ? fmt::format(", friction {}", show_rounded(rule.friction, ""))
                      : ", no friction limit");
}

/// Prints the bounce rule of each pair if the case has rules by pair.
void print_pairs(const cases::Case& mill_case) {
  if (mill_case.contact.pairs.empty() && mill_case.machine_parts.empty()) return;
  const contact::BounceTable table = cases::bounce_table(mill_case);
  const std::vector<std::string> faces = cases::wall_face_names(mill_case);
  const auto line = [](const std::string& one, const std::string& other,
                       const contact::BounceRule& rule) {
    to_stdout(fmt::format("  {:<38} {}\n", one + " on " + other, in_words(rule)));
  };
  to_stdout("\n");
  title_to_stdout("bounces:");
  for (int i = 0; i < table.kinds(); ++i) {
    const std::string set = cases::set_name(mill_case, static_cast<std::size_t>(i));
    for (int j = i; j < table.kinds(); ++j)
      line(set, cases::set_name(mill_case, static_cast<std::size_t>(j)), table.balls(i, j));
    for (int face = 0; face < table.faces(); ++face)
      line(set, faces[static_cast<std::size_t>(face)], table.wall(i, face));
  }
}

std::string verdict(const CheckResult& c) {
  if (c.engine.empty()) return "fine";
  if (c.bad_points == 0) return "this version cannot run it";
  return fmt::format("{} of {} points cannot be run", c.bad_points,
                     std::min(c.points, campaign::CheckedPoints::most));
}

/// The plausible range of an assumed value: "128 mm to 144 mm; ".
std::string range_of(const cases::Origin& origin) {
  return origin.range[0].empty() ? "" : fmt::format("{} to {}; ", origin.range[0], origin.range[1]);
}

std::string shown(const cases::DerivedQuantity& one) {
  return one.unit == megabytes ? fmt::format("{} {}", show_rounded(one.value, "", 2), megabytes)
                               : show_rounded(one.value, one.unit);
}

void print(const CheckResult& c, const std::filesystem::path& file) {
  to_stdout(fmt::format("{}: {}\n\n", file.string(), verdict(c)));
  if (!c.mill_case.sweep.empty())
    to_stdout(fmt::format(
        "a campaign of {} points, {} replicates each; quantities of the first point:\n\n", c.points,
        c.mill_case.run.replicates));
  for (const cases::DerivedQuantity& one : c.follows)
    to_stdout(fmt::format("  {:<38} {:<14} {}\n", one.name, shown(one), one.about));
  print_pairs(c.mill_case);
  std::string assumed;
  for (const cases::Origin& origin : c.mill_case.origins)
    if (origin.assumed)
      assumed += fmt::format("  {:<38} {:<14} {}{}\n", origin.key, origin.value, range_of(origin),
                             origin.source);
  if (!assumed.empty())
    to_stdout(fmt::format("\nassumed, because the case does not give it:\n{}", assumed));
  for (const std::string& note : c.notes) to_stdout(fmt::format("\n{}\n", note));
  if (!c.engine.empty())
    fmt::print("\n{}\n", faults_for(Stream::output, Style::error, mahlwerk::describe(c.engine)));
}

results::Json as_json(const CheckResult& c, const std::filesystem::path& file) {
  using results::Json;
  Json follows = Json::object();
  for (const cases::DerivedQuantity& one : c.follows)
    follows[one.name] =
        Json::object({{"value", one.value}, {"unit", one.unit}, {"about", one.about}});
  Json assumed = Json::object(), faults = Json::array();
  for (const cases::Origin& origin : c.mill_case.origins)
    if (origin.assumed) assumed[origin.key] = origin.value;
  for (const Fault& fault : c.engine) faults.push_back(fault_json(fault));
  return Json::object({{"file", file.string()},
                       {"title", c.mill_case.title},
                       {"points", c.points},
                       {"points_that_cannot_run", c.bad_points},
                       {"follows", std::move(follows)},
                       {"assumed", std::move(assumed)},
                       {"notes", c.notes},
                       {"runs", c.engine.empty()},
                       {"faults", std::move(faults)}});
}

struct CheckArguments {
  std::string target;
  Changes changes;
  bool json = false;
};

int check(const CheckArguments& given) {
  const cases::Catalogue known = catalogue();
  results::Json json = results::Json::array();
  std::vector<Fault> wrong;
  bool runs = true;
  for (const std::filesystem::path& file : case_files(given.target)) try {
      const CheckResult c = check_case(file, known, given.changes.overrides());
      runs = runs && c.engine.empty();
      if (!given.json) {
        print(c, file);
        continue;
      }
      json.push_back(as_json(c, file));
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  if (given.json) json_to_stdout(json);
  return runs ? success : bad_input;
}

}  // namespace

Command check_command() {
  const auto given = std::make_shared<CheckArguments>();
  return {"check", "check a case without running it: report its faults, or derived quantities",
          joined({{several_cases(given->target)}, options_of(given->changes), {json(given->json)}}),
          [given] { return check(*given); }};
}

}  // namespace mahlwerk::commands
