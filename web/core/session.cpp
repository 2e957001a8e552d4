// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <utility>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/conclude.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/powder_feedback.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/observe/replay.hpp"
#include "mahlwerk/report/replay.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "page_limits.hpp"

namespace mahlwerk::web {
namespace {

using results::Json;

constexpr std::string_view case_name = "case.toml";

/// The engine of a case. The choice of the last case is kept: pilot runs of "auto" take as long as
/// a short replicate, and a worker computes several replicates of one case.
campaign::EngineChoice engine_of(const cases::Case& mill_case) {
  if (mill_case.run.engine != cases::EngineName::automatic &&
      mill_case.parts.find<cases::PowderFeedback>() == nullptr)
    return {mill_case.run.engine, {}};
  static std::string known;  // the case of `choice`
  static campaign::EngineChoice choice;
  if (std::string text = cases::write(mill_case); text != known) {
    choice = campaign::choose_engine_and_bounce(mill_case);
    known = std::move(text);
  }
  return choice;
}

/// The line in "case.toml:14"; 0 for another place.
int line_of(std::string_view where) {
  const std::string start = std::string(case_name) + ":";
  if (!where.starts_with(start)) return 0;
  int line = 0;
  std::from_chars(where.data() + start.size(), where.data() + where.size(), line);
  return line;
}

Json notices_json(const Notices& notices) {
  Json list = Json::array();
  for (const Notice& one : notices)
    list.push_back(Json::object(
        {{"severity", name_of(one.severity)}, {"code", one.code}, {"text", one.text}}));
  return list;
}

void restore(campaign::ReplicateRun& replica, std::string_view state) try {
  Archive in{std::string(state)};
  replica.serialize(in);
  in.finish();
} catch (const RunError& e) {
  throw InputError(
      Fault{"finish", e.what(), "compute the replicates of this case again", "bad-checkpoint"});
}

Json origins_json(const std::vector<cases::Origin>& origins) {
  Json list = Json::array();
  for (const cases::Origin& one : origins)
    list.push_back(Json::object({{"key", one.key},
                                 {"value", one.value},
                                 {"source", one.source},
                                 {"assumed", one.assumed},
                                 {"unverified", one.unverified}}));
  return list;
}

}  // namespace

std::string first_picture(const cases::Case& mill_case) {
  const std::vector<scene::Ball> balls = cases::starting_balls(mill_case, 0);
  observe::Replay film(cases::chamber(mill_case), balls.size(), 0, mill_case.run.time);
  film.add(0, 0, balls);
  return report::replay_data(mill_case, film);
}

const cases::Catalogue& catalogue() {
  static const cases::Catalogue known("/catalogue");
  return known;
}

cases::Case read_case(const std::string& text, const Overrides& set) try {
  cases::Case mill_case =
      cases::read_text(text, std::filesystem::path(case_name), catalogue(), set);
  std::vector<Fault> wrong = page_faults(mill_case);
  if (wrong.empty()) wrong = campaign::run_faults(mill_case);
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return mill_case;
} catch (const InputError& e) {
  std::vector<Fault> faults = e.faults();
  for (Fault& one : faults)
    if (one.code == "no-such-file")
      one.remedy = "the page reads no files: compute this case with the program";
  throw InputError(std::move(faults));
}

Json faults_json(const std::vector<Fault>& faults) {
  Json list = Json::array();
  for (const Fault& one : faults)
    list.push_back(Json::object({{"where", one.where},
                                 {"line", line_of(one.where)},
                                 {"column", 0},
                                 {"text", one.what},
                                 {"remedy", one.remedy},
                                 {"code", one.code}}));
  return Json::object({{"faults", std::move(list)}});
}

Json description(const cases::Case& mill_case) {
  Json made = faults_json({});
  made["title"] = mill_case.title;
  made["engine"] = name_of(mill_case.run.engine);
  made["balls"] = cases::balls_count(mill_case.balls);
  made["replicates"] = mill_case.run.replicates;
  made["time"] = mill_case.run.time;
  made["settle"] = cases::least_settling(mill_case);
  made["origins"] = origins_json(mill_case.origins);
  Notices notices = cases::jar_warnings(mill_case);
  append(notices, cases::unusual_values(mill_case));
  append(notices, left_to_program(mill_case));
  made["notices"] = notices_json(notices);
  return made;
}

Session::Session(cases::Case mill_case, int replicate)
    : mill_case_(std::move(mill_case)),
      choice_(engine_of(mill_case_)),
      decided_(campaign::decided_case(mill_case_, choice_)),
      replica_(decided_, replicate) {}

Json Session::advance(double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto spent = [&] {
    return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
  };
  so_far_.reset();
  tables_.clear();
  while (!replica_.done()) {
    replica_.run_slice();
    if (spent() >= milliseconds) break;
  }
  replica_.cpu_seconds() += 1e-3 * spent();
  const scene::EnergyBalance& now = replica_.energy_balance();
  return Json::object(
      {{"done", replica_.done()},
       {"simulated", now.time},
       {"total",
        replica_.counting_begins().value_or(cases::least_settling(decided_)) + decided_.run.time},
       {"collisions", now.collisions},
       {"residual", now.worst_collision},
       {"stop_reason", replica_.stop_reason()}});
}

const results::Outcome& Session::outcome_so_far() {
  if (so_far_) return *so_far_;
  so_far_.emplace(campaign::begun_outcome(mill_case_, choice_));
  so_far_->replicates = {replica_.result()};
  so_far_->interrupted = !replica_.done();
  so_far_->summary = results::summarise(*so_far_);
  return *so_far_;
}

const std::vector<results::NamedTable>& Session::tables_so_far() {
  if (tables_.empty()) tables_ = results::tables(outcome_so_far());
  return tables_;
}

std::string Session::film() const {
  const observe::Replay& film = replica_.replay();
  return film.times().size() < 2 ? "null" : report::replay_data(mill_case_, film);
}

std::string Session::state() {
  Archive out;
  replica_.serialize(out);
  return out.bytes();
}

results::Outcome merged_outcome(const cases::Case& mill_case,
                                const std::vector<std::string_view>& states) {
  const campaign::EngineChoice choice = engine_of(mill_case);
  const cases::Case decided = campaign::decided_case(mill_case, choice);
  results::Outcome outcome = campaign::begun_outcome(mill_case, choice);
  const results::Replicate empty = outcome.replicates.front();
  outcome.replicates.clear();
  for (std::size_t r = 0; r < static_cast<std::size_t>(mill_case.run.replicates); ++r) {
    if (r >= states.size() || states[r].empty()) {
      outcome.replicates.push_back(empty);
      outcome.replicates.back().complete = false;
      outcome.interrupted = true;
      continue;
    }
    campaign::ReplicateRun replica(decided, static_cast<int>(r));
    restore(replica, states[r]);
    outcome.interrupted = outcome.interrupted || !replica.done();
    outcome.replicates.push_back(replica.result());
  }
  campaign::conclude(outcome, choice);
  return outcome;
}

}  // namespace mahlwerk::web
