// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// speed_over_time of [mill]: rows of time and share of the full speed (kin.21).
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

using kinematics::SpeedProgram;
using kinematics::SpeedRow;

constexpr std::string_view speed_key = "speed_over_time", repeats_key = "speed_repeats",
                           speed_form =
                               "write rows of time and share of the full speed: [[\"0 s\", 0], "
                               "[\"2 s\", \"100 %\"], [\"60 s\", \"100 %\"], [\"63 s\", 0]]";
constexpr std::size_t most_speed_rows = 1000;
constexpr double shortest_change = 1e-3;  // [s] between two rows
constexpr Range shares_of_speed{.least = -1, .most = 1};

bool is_sound(const SpeedProgram& program) {
  if (program.empty()) return true;
  bool sound = program.rows().size() > 1 && program.rows().front().time == 0;
  for (std::size_t i = 0; i < program.rows().size(); ++i) {
    sound = sound && shares_of_speed.holds(program.rows()[i].rate);
    if (i > 0)
      sound = sound &&
              program.rows()[i].time - program.rows()[i - 1].time >= shortest_change * (1 - 1e-9);
  }
  return sound;
}

std::string rows_text(const SpeedProgram& program) {
  std::string rows;
  for (const SpeedRow& row : program.rows())
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", in_quotes(show(row.time, "s")),
                        shortest(row.rate));
  return "[" + rows + "]";
}

std::optional<SpeedRow> read_speed_row(SectionReader& in, const Node& row) {
  if (row.kind != Node::Kind::list || row.items.size() != 2) {
    in.fault(row, fmt::format("a row of `{}` must be a time and a share of the speed", speed_key),
             std::string(speed_form), "wrong-type");
    return std::nullopt;
  }
  constexpr Range times{.least = 0, .most = 1e8};
  const double time = in.quantity(row.items[0], {speed_key, "s", times, "since the start"}),
               rate = in.quantity(row.items[1],
                                  {speed_key, "", shares_of_speed, "share of the full speed"});
  if (std::isnan(time) || std::isnan(rate)) return std::nullopt;
  return SpeedRow{time, rate};
}

/// Empty after a fault.
std::vector<SpeedRow> read_speed_rows(SectionReader& in, const Node& at) {
  if (at.kind != Node::Kind::list || at.items.size() < 2 || at.items.size() > most_speed_rows) {
    in.fault(at, fmt::format("`{}` must be a list of 2 to {} rows", speed_key, most_speed_rows),
             std::string(speed_form), "wrong-type");
    return {};
  }
  std::vector<SpeedRow> rows;
  bool sound = true;
  const auto fault = [&](const Node& row, std::string what, std::string remedy) {
    in.fault(row, std::move(what), std::move(remedy), "bad-speed-over-time");
    sound = false;
  };
  for (const Node& item : at.items) {
    const auto row = read_speed_row(in, item);
    sound = sound && row;
    if (!row) continue;
    if (rows.empty() && row->time != 0)
      fault(item, fmt::format("`{}` does not begin at the start of the run", speed_key),
            "give the first row the time 0 s");
    else if (!rows.empty() && !(row->time - rows.back().time >= shortest_change * (1 - 1e-9)))
      fault(item, fmt::format("the times of `{}` do not increase by 1 ms or more", speed_key),
            "sort the rows by time, each time once; a speed cannot jump");
    rows.push_back(*row);
  }
  if (!sound) rows.clear();
  return rows;
}

}  // namespace

void describe_speed_over_time(KeyVisitor& v, Mill& mill) {
  SectionReader* in = v.reader();
  SpeedProgram& program = mill.speed_over_time;
  if (in == nullptr && program.empty() && !v.visits_all()) return;
  bool repeats = program.repeats();
  const Flag again{repeats_key, false, "the last speed of speed_over_time holds",
                   "whether speed_over_time begins anew after its last row"};
  if (in == nullptr) {
    v.custom({.key = speed_key,
              .about = "speed over time: rows of time and share of the full speed, below 0 in the "
                       "other sense",
              .sound = is_sound(program),
              .default_text = "the full speed throughout"},
             [&] { return rows_text(program); });
    return v.flag(again, repeats);
  }
  const Node* at = in->find(speed_key);
  if (at == nullptr)
    return v.refuse_but_default(again, "without speed_over_time", "give speed_over_time");
  std::vector<SpeedRow> rows = read_speed_rows(*in, *at);
  v.flag(again, repeats);
  if (rows.empty()) return;
  if (repeats && rows.front().rate != rows.back().rate) {
    in->fault(*at, "a speed that repeats would jump from the last row to the first",
              "give both the same speed, or remove speed_repeats", "bad-speed-over-time");
    return;
  }
  program = SpeedProgram(std::move(rows), repeats);
  in->record_origin(speed_key, rows_text(program), at);
}

}  // namespace mahlwerk::cases
