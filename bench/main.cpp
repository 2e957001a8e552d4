// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "benchmarks.hpp"
#include "child.hpp"
#include "crowd_run.hpp"
#include "mahlwerk/base/isa.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::bench {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

namespace {

int help() {
  std::ifstream file(MAHLWERK_HOME "/bench/help.txt");
  fmt::print("{}", std::string(std::istreambuf_iterator<char>(file), {}));
  return 0;
}

int usage(const std::string& wrong) {
  fmt::print(stderr, "bench: {}; ./mahlwerk bench --help lists the benchmarks\n", wrong);
  return 2;
}

/// Name of the processor, from /proc/cpuinfo.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name : ") || line.starts_with("model name\t: "))
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

void print(const std::vector<Row>& rows) {
  fmt::print("{}, {} cores, {}, {:%F}\n", processor(), std::thread::hardware_concurrency(),
             name_of(isa()), fmt::localtime(std::time(nullptr)));
  fmt::print("{:<10} {:<48} {:<22} {:<34} {:>10}\n", "benchmark", "case", "code", "metric",
             "value");
  for (const Row& r : rows) {
    fmt::print("{:<10} {:<48} {:<22} {:<34} {:>10.4g}", r.benchmark, r.what, r.code, r.metric,
               r.value);
    if (std::isfinite(r.least)) fmt::print("  ({:.4g} to {:.4g})", r.least, r.most);
    fmt::print("\n");
  }
}

int perform(int argc, char** argv) {
  std::string name;
  bool json = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h") return help();
    if (word == "--json")
      json = true;
    else if (name.empty() && word[0] != '-')
      name = word;
    else
      return usage("unknown argument '" + word + "'");
  }
  std::vector<Row> rows;
  bool found = name.empty();
  for (const Benchmark& one : benchmarks) {
    if (name.empty() ? one.only_by_name : name != one.name) continue;
    found = true;
    const std::vector<Row> more = one.run();
    rows.insert(rows.end(), more.begin(), more.end());
  }
  if (!found) return usage("unknown benchmark '" + name + "'");
  if (json) {
    using results::Json;
    Json list = Json::array();
    for (const Row& r : rows) {
      list.push_back(Json::object({{"benchmark", r.benchmark},
                                   {"case", r.what},
                                   {"code", r.code},
                                   {"metric", r.metric},
                                   {"value", r.value}}));
      if (!std::isfinite(r.least)) continue;
      list.back()["least"] = r.least;
      list.back()["most"] = r.most;
    }
    fmt::print("{}\n", list.text(2));
    return 0;
  }
  print(rows);
  return 0;
}

}  // namespace
}  // namespace mahlwerk::bench

int main(int argc, char** argv) {
  using namespace mahlwerk::bench;
  try {
    if (argc > 1 && argv[1] == crowd_run_option) return perform_crowd_run({argv + 2, argv + argc});
    return perform(argc, argv);
  } catch (const Interrupted& by) {
    std::raise(by.signal);
    return 1;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "bench: {}\n", fault.what());
    return 1;
  }
}
