// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Comparison of Mahlwerk with the other open soft-sphere codes: five balls in a planetary mill. The
// codes take turns. The motion of the balls is reported over several starts, because the balls fall
// into one of two modes of motion, and the smallest difference decides which one.
#include "peers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "benchmarks.hpp"
#include "child.hpp"
#include "peers_programs.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 5, replicates = 5, together = 8, our_steps = 1000000;
constexpr double between_modes = 3.5;  // [W] separates the power of the two modes
constexpr const char* name = "peers";
constexpr const char* what = "planetary mill, 5 balls of 15 mm";

void say(const std::string& text) {
  fmt::print(stderr, "{}: {}\n", name, text);
}

/// The installed codes. The others are reported with the package to install.
std::vector<Program> present() {
  std::vector<Program> found;
  for (const Program& one : programs)
    if (!find_program(one.command).empty())
      found.push_back(one);
    else
      say(fmt::format("{} is left out, it is not installed (Debian: apt-get install {})", one.name,
                      one.package));
  return found;
}

/// Number of starts of a code for the physics; LIGGGHTS and YADE take two minutes for each.
int starts_of(const Program& program) {
  const char* wish = std::getenv("MAHLWERK_PEERS_PHYSICS");
  const bool full = wish != nullptr && std::string_view(wish) == "full";
  if (program.name == "LAMMPS") return replicates;
  if (program.numbers != "once") return 0;  // the same physics as with the other deck
  if (full) return program.name == "LIGGGHTS" ? 2 : 1;
  say(fmt::format("{}, physics left out; set MAHLWERK_PEERS_PHYSICS=full for it", program.name));
  return 0;
}

struct Speeds {
  std::string code;
  std::vector<double> found;
};

Row row(const std::string& code, const std::string& metric, const std::vector<double>& values,
        double value) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {name, what, code, metric, value, *least, *most};
}

void add_ratios(std::vector<Row>& rows, const Speeds& ours, const Speeds& other) {
  std::vector<double> ratios;  // of each turn
  for (std::size_t i = 0; i < std::min(ours.found.size(), other.found.size()); ++i)
    ratios.push_back(ours.found[i] / other.found[i]);
  if (!ratios.empty())
    rows.push_back(row(ours.code, "times_as_fast_as_" + other.code, ratios, median(ratios)));
}

/// Speeds of Mahlwerk, of one run and of replicates side by side, and of the other codes.
struct AllSpeeds {
  Speeds one{"mahlwerk", {}}, side_by_side{fmt::format("mahlwerk_{}_replicates", together), {}};
  std::vector<Speeds> peers;
};

void add_speeds(std::vector<Row>& rows, const AllSpeeds& all) {
  const auto add = [&](const Speeds& one) {
    if (!one.found.empty())
      rows.push_back(row(one.code, "particle_steps_per_cpu_second", one.found, median(one.found)));
  };
  add(all.one), add(all.side_by_side);
  for (const Speeds& peer : all.peers) add(peer);
  add_ratios(rows, all.side_by_side, all.one);
  for (const Speeds& peer : all.peers) add_ratios(rows, all.one, peer);
  for (const Speeds& peer : all.peers) add_ratios(rows, all.side_by_side, peer);
}

/// Speeds of all codes, measured in turns, so that drifts of the machine affect all alike. A code
/// that fails is not run again.
AllSpeeds measure_speeds(const std::vector<Program>& peers) {
  std::vector<Start> starts;
  for (int i = 0; i < together; ++i) starts.push_back(start(i));
  AllSpeeds all;
  for (const Program& peer : peers) all.peers.push_back({std::string(peer.name), {}});
  for (int turn = 0; turn < turns; ++turn) {
    say(fmt::format("speeds, turn {} of {}", turn + 1, turns));
    all.one.found.push_back(mahlwerk_speed(std::span(starts).first(1), our_steps));
    all.side_by_side.found.push_back(mahlwerk_speed(starts, our_steps));
    for (std::size_t i = 0; i < peers.size(); ++i) {
      if (std::ssize(all.peers[i].found) < turn) continue;
      const Expected<double> speed = speed_of(peers[i], start(0));
      if (speed.fault.empty())
        all.peers[i].found.push_back(speed.value);
      else
        say(fmt::format("{} {}", peers[i].name, speed.fault));
    }
  }
  return all;
}

void add_physics(std::vector<Row>& rows, const std::string& code, const std::vector<Physics>& all) {
  if (all.empty()) return;
  using Value = double (*)(const Physics&);
  static constexpr std::pair<const char*, Value> values[] = {
      {"wall_power_W", [](const Physics& p) { return p.power; }},
      {"kinetic_energy_J", [](const Physics& p) { return p.kinetic; }},
      {"rotational_energy_J", [](const Physics& p) { return p.rotational; }},
      {"kinetic_energy_on_disc_J", [](const Physics& p) { return p.kinetic_on_plate; }},
      {"ball_ball_impacts_per_second", [](const Physics& p) { return p.ball_ball.rate; }},
      {"ball_ball_impact_speed_m_s", [](const Physics& p) { return p.ball_ball.speed; }},
      {"ball_side_impacts_per_second", [](const Physics& p) { return p.ball_side.rate; }},
      {"ball_side_impact_speed_m_s", [](const Physics& p) { return p.ball_side.speed; }},
  };
  const auto count = static_cast<double>(all.size());
  for (const auto& [metric, value] : values) {
    std::vector<double> found;
    found.reserve(all.size());
    for (const Physics& one : all) found.push_back(value(one));
    double sum = 0;
    for (const double one : found) sum += one;
    rows.push_back(row(code, metric, found, sum / count));
  }
  const auto strong = static_cast<double>(std::count_if(
      all.begin(), all.end(), [](const Physics& p) { return p.power > between_modes; }));
  rows.push_back({name, what, code, "starts_above_3.5_W", strong});
  rows.push_back({name, what, code, "starts_below_3.5_W", count - strong});
}

std::vector<Physics> observe(const Program& peer) {
  std::vector<Physics> all;
  const int count = starts_of(peer);
  for (int i = 0; i < count; ++i) {
    say(fmt::format("{}, physics, start {} of {}", peer.name, i + 1, count));
    const Expected<Physics> found = physics_of(peer, start(i));
    if (found.fault.empty())
      all.push_back(found.value);
    else
      say(fmt::format("{} {}", peer.name, found.fault));
  }
  return all;
}

std::vector<Physics> observe_ours() {
  std::vector<Physics> all;
  for (int i = 0; i < replicates; ++i) all.push_back(mahlwerk_physics(start(i)));
  return all;
}

std::vector<Row> measure() {
  std::vector<Row> rows;
  const std::vector<Program> peers = present();
  const AllSpeeds speeds = measure_speeds(peers);
  add_speeds(rows, speeds);
  add_physics(rows, "mahlwerk", observe_ours());
  for (std::size_t i = 0; i < peers.size(); ++i)
    if (!speeds.peers[i].found.empty()) add_physics(rows, speeds.peers[i].code, observe(peers[i]));
  return rows;
}

}  // namespace

std::vector<Row> few() {
  try {
    return measure();
  } catch (const Interrupted& by) {
    std::raise(by.signal);  // nothing is left to tidy up
    return {};
  }
}

}  // namespace mahlwerk::bench
