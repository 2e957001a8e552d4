// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/json.hpp"

#include <cmath>

#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::results {
namespace {

constexpr int schema = 2;  // of summary.json; grows only when a name or a meaning changes

Json origins(const cases::Case& mill_case, bool cases::Origin::*chosen) {
  Json list = Json::array();
  for (const cases::Origin& o : mill_case.origins) {
    if (!(o.*chosen)) continue;
    Json one = Json::object({{"key", o.key}, {"value", o.value}, {"source", o.source}});
    if (!o.range[0].empty()) {
      one["from"] = o.range[0];
      one["to"] = o.range[1];
    }
    list.push_back(std::move(one));
  }
  return list;
}

Json texts(const Notices& notices, bool warnings) {
  Json list = Json::array();
  for (const Notice& one : notices)
    if (one.warns() == warnings) list.push_back(one.text);
  return list;
}

Json about(const Outcome& outcome, std::string_view version) {
  Json runs = Json::array();
  for (const Replicate& r : outcome.replicates) {
    Json run = Json::object({{"complete", r.complete && r.time() > 0},
                             {"time", r.time()},
                             {"settling", r.at_settled.time}});
    if (!r.stop_reason.empty()) run["stopped"] = r.stop_reason;
    runs.push_back(std::move(run));
  }
  const bool whole = complete(outcome);
  return Json::object({{"mahlwerk", version},
                       {"schema", schema},
                       {"title", outcome.mill_case.title},
                       {"seed", outcome.mill_case.seed},
                       {"engine", name_of(outcome.engine)},
                       {"regime", outcome.summary.regime},
                       {"regime_reason", outcome.summary.regime_reason},
                       {"notes", texts(outcome.notices, false)},
                       {"warnings", texts(outcome.notices, true)},
                       {"notices", notices_json(outcome.notices)},
                       {"threshold", outcome.mill_case.observe.threshold},
                       {"complete", whole},
                       {"interrupted", outcome.interrupted && !whole},
                       {"replicates", std::move(runs)},
                       {"assumed", origins(outcome.mill_case, &cases::Origin::assumed)},
                       {"unverified", origins(outcome.mill_case, &cases::Origin::unverified)},
                       {"wall_seconds", outcome.wall_seconds},
                       {"cpu_seconds", outcome.cpu_seconds}});
}

Json object(const Quantity& q) {
  Json made = Json::object({{"value", q.value},
                            {"ci95", q.ci95},
                            {"ci95_time", q.ci95_time},
                            {"unit", q.unit},
                            {"label", label_of(q.name)},
                            {"about", q.about}});
  const Range range = range_of(q.name);
  if (std::isfinite(range.least)) made["least"] = range.least;
  if (std::isfinite(range.most)) made["most"] = range.most;
  return made;
}

Json table_of(const std::vector<PairSummary>& pairs) {
  Json list = Json::array();
  for (const PairSummary& pair : pairs) {
    Json row = Json::object({{"between", Json::array({pair.one, pair.other})}});
    for (const Quantity& q : pair.quantities) row[q.name] = object(q);
    list.push_back(std::move(row));
  }
  return list;
}

Json parts_of(const std::vector<PartSummary>& parts) {
  Json list = Json::array();
  for (const PartSummary& part : parts) {
    Json row = Json::object({{"name", part.name}});
    for (const Quantity& q : part.quantities) row[q.name] = object(q);
    list.push_back(std::move(row));
  }
  return list;
}

Json states_of(const TwoStates& found) {
  Json states = Json::array();
  for (const State& state : found.states) {
    Json one = Json::object({{"replicates", state.replicates}, {"share", found.share(state)}});
    for (const Quantity& q : state.quantities)
      one[q.name] = Json::object({{"value", q.value}, {"ci95", q.ci95}, {"unit", q.unit}});
    states.push_back(std::move(one));
  }
  return Json::object({{"chance", found.p_value}, {"states", std::move(states)}});
}

Json motion_states_of(const std::vector<MotionStateSummary>& found) {
  Json list = Json::array();
  const auto value = [](const observe::Estimate& of, const char* unit) {
    return Json::object({{"value", of.mean}, {"ci95", of.ci95}, {"unit", unit}});
  };
  for (const MotionStateSummary& s : found)
    list.push_back(Json::object({{"name", s.name},
                                 {"share", value(s.share, "1")},
                                 {"replicates", static_cast<std::int64_t>(s.replicates)},
                                 {"visit", s.visit},
                                 {"dissipated_power", value(s.power, "W")},
                                 {"collision_rate_above_threshold", value(s.hit_rate, "1/s")},
                                 {"energy_normal_mean_above_threshold", value(s.hit_energy, "J")},
                                 {"turns_per_cycle", value(s.turns, "1")},
                                 {"axial_ratio", value(s.axial_ratio, "1")}}));
  return list;
}

Json groups_of(const std::vector<Quantity>& quantities) {
  Json list = Json::array();
  for (const QuantityGroup& group : quantity_groups(quantities))
    list.push_back(Json::object({{"heading", group.heading}, {"quantities", group.names}}));
  return list;
}

Json sensitivity_of(const Sensitivity& found) {
  Json keys = Json::array(), scatter = Json::object();
  for (std::size_t i = 0; i < found.quantities.size(); ++i)
    scatter[found.quantities[i]] = found.scatter[i];
  for (const AssumedInfluence& one : found.keys) {
    Json at_ends = Json::object();
    for (std::size_t i = 0; i < found.quantities.size(); ++i)
      at_ends[found.quantities[i]] = Json::array({one.at_ends[0][i], one.at_ends[1][i]});
    keys.push_back(Json::object({{"key", one.key},
                                 {"value", one.value},
                                 {"range", Json::array({one.ends[0], one.ends[1]})},
                                 {"source", one.source},
                                 {"at_ends", std::move(at_ends)}}));
  }
  return Json::object({{"time", found.time},
                       {"replicates", found.replicates},
                       {"scatter", std::move(scatter)},
                       {"keys", std::move(keys)},
                       {"left_out", found.left_out}});
}

}  // namespace

Json notices_json(const NoticeCounts& counts) {
  Json list = Json::array();
  for (const NoticeCount& one : counts)
    list.push_back(Json::object({{"code", one.first.code},
                                 {"severity", name_of(one.first.severity)},
                                 {"count", one.runs},
                                 {"text", one.first.text}}));
  return list;
}

Json notices_json(const Notices& notices) {
  Json list = Json::array();
  for (const Notice& one : notices)
    list.push_back(Json::object(
        {{"code", one.code}, {"severity", name_of(one.severity)}, {"text", one.text}}));
  return list;
}

Json summary_of(const Outcome& outcome, std::string_view version) {
  const Summary& summary = outcome.summary;
  Json all;
  all["_about"] = about(outcome, version);
  for (const Quantity& q : summary.quantities) all[q.name] = object(q);
  all["_key_quantities"] = key_quantities(summary.quantities);
  all["_groups"] = groups_of(summary.quantities);
  if (summary.sensitivity) all["_sensitivity"] = sensitivity_of(*summary.sensitivity);
  if (!summary.pairs.empty()) all["_pairs"] = table_of(summary.pairs);
  if (!summary.parts.empty()) all["_parts"] = parts_of(summary.parts);
  if (!summary.motion_states.empty())
    all["_motion_states"] = motion_states_of(summary.motion_states);
  if (summary.two_states) all["_states"] = states_of(*summary.two_states);
  return all;
}

std::string summary_json(const Outcome& outcome, std::string_view version) {
  return summary_of(outcome, version).text(2) + '\n';
}

}  // namespace mahlwerk::results
