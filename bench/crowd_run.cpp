// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "crowd_run.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <chrono>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "benchmarks.hpp"
#include "crowd_cases.hpp"

namespace mahlwerk::bench {
namespace {

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

static_assert(std::is_trivially_copyable_v<scene::Ball>);

void write_balls(const std::filesystem::path& file, const std::vector<scene::Ball>& balls) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(balls.data()),
            static_cast<std::streamsize>(balls.size() * sizeof(scene::Ball)));
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

CrowdRun parse_run(const std::vector<std::string>& words) {
  if (words.size() != 7) throw std::runtime_error("expected seven arguments");
  return {words[0],
          std::stoi(words[1]),
          std::stoi(words[2]),
          std::stoi(words[3]),
          std::stod(words[4]),
          words[5],
          words[6]};
}

void perform(const CrowdRun& run) {
  using Clock = std::chrono::steady_clock;
  const CrowdCase c = crowd_case(run.name);
  std::size_t count = 0;
  const auto engine_of_run = [&] {  // frees the initial balls after its return
    const std::vector<scene::Ball> balls = run.from == "-" ? c.fill() : read_balls(run.from);
    count = balls.size();
    return engine(c, balls, run.threads, run.start);
  }();
  NullObserver observer;
  engine_of_run->advance(run.lead * c.step, observer);
  const Clock::time_point began = Clock::now();
  const double worked = cpu_seconds();
  engine_of_run->advance((run.lead + run.steps) * c.step, observer);
  const double taken = std::chrono::duration<double>(Clock::now() - began).count();
  const double work = cpu_seconds() - worked;
  fmt::output_file("log.txt").print(
      "{} {:.9g} 0\nLoop time of {:.6f} on {} procs for {} steps with {} atoms\nCPU time of "
      "{:.6f}\n",
      run.lead + run.steps, engine_of_run->energy_balance().kinetic, taken, run.threads, run.steps,
      count, work);
  if (run.to != "-") write_balls(run.to, engine_of_run->balls());
}

}  // namespace

std::vector<scene::Ball> read_balls(const std::filesystem::path& file) {
  std::vector<scene::Ball> balls(std::filesystem::file_size(file) / sizeof(scene::Ball));
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(balls.data()),
               static_cast<std::streamsize>(balls.size() * sizeof(scene::Ball))))
    throw std::runtime_error("cannot read " + file.string());
  return balls;
}

std::vector<std::string> arguments_for(const CrowdRun& run) {
  return {std::string(crowd_run_option),
          run.name,
          fmt::format("{}", run.threads),
          fmt::format("{}", run.lead),
          fmt::format("{}", run.steps),
          fmt::format("{}", run.start),
          run.from,
          run.to};
}

int perform_crowd_run(const std::vector<std::string>& words) {
  try {
    perform(parse_run(words));
    return 0;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "Error: {}\n", fault.what());
    return 1;
  }
}

}  // namespace mahlwerk::bench
