// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Feeds the parsers with mutated inputs, for machines without libFuzzer and for CI. The same seed
// gives the same inputs.
//     fuzz_parsers COUNT [SEED [FIRST]]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "parsers.hpp"

namespace {

namespace fs = std::filesystem;
using mahlwerk::Random;
using mahlwerk::fuzz::Reader;

std::size_t below(Random& random, std::size_t n) {
  return std::min(static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(n)), n - 1);
}

std::string with(Reader reader, const std::string& bytes) {
  return static_cast<char>(reader) + bytes;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const char* const tetrahedron =
    "solid t\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid t\n";

const char* const surrogate =
    R"({"surrogate":1,"mahlwerk":"0.1.0","title":"t","digest":"0","settings":3,"failed":0,)"
    R"("engines":["event"],"keys":[{"key":"mill.speed","from":"200 rpm","to":"800 rpm",)"
    R"("logarithm":false}],"following":[],"notices":[],"quantities":{"d":{"unit":"W","about":"",)"
    R"("hold_out_error":0.1,"widening":1.0,"hold_out_coverage":1.0,"logarithm":false,"centre":2.0,)"
    R"("scale":1.0,"noise":0.01,"amplitude":1.0,"constant":0.1,"length_scales":[0.5],)"
    R"("points":[[0.0],[0.5],[1.0]],"values":[-1.0,0.0,1.0],"variances":[0.01,0.01,0.01]}}})";

std::vector<std::string> corpus() {
  std::vector<fs::path> files;
  for (const char* folder : {"/examples", "/papers", "/catalogue"})
    for (const auto& entry : fs::recursive_directory_iterator(std::string(MAHLWERK_HOME) + folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> all;
  for (const fs::path& file : files) all.push_back(with(Reader::case_file, contents(file)));
  const std::size_t others = all.size() / 10 + 1;  // so that they are chosen now and then
  for (std::size_t i = 0; i < others; ++i) {
    all.push_back(with(Reader::mesh, tetrahedron));
    all.push_back(with(Reader::mesh,
                       std::string(80, 's') + std::string("\1\0\0\0", 4) + std::string(50, '\1')));
    all.push_back(with(Reader::motion, "t [s],x [mm],y [mm],z [mm]\n0,0,0,0\n1,1,0,0\n2,0,0,0\n"));
    all.push_back(with(Reader::measurements, "time [min],D50 [um]\n10,40\n20,30\n60,12\n"));
    all.push_back(with(Reader::checkpoint, "mahlwerk checkpoint 6\n"));
    all.push_back(with(Reader::state, mahlwerk::fuzz::state_of_a_run()));
    all.push_back(with(Reader::surrogate, surrogate));
  }
  return all;
}

/// Keywords of the parsers, and numbers that are hard to parse.
const std::vector<std::string>& words() {
  static const std::vector<std::string> list{"[",
                                             "]",
                                             "[[",
                                             "]]",
                                             "=",
                                             "\"",
                                             "'",
                                             "\n",
                                             ".",
                                             ",",
                                             "{",
                                             "}",
                                             "-",
                                             "+",
                                             "e",
                                             "nan",
                                             "inf",
                                             "-inf",
                                             "1e308",
                                             "1e-308",
                                             "-0",
                                             "0",
                                             "1",
                                             "2",
                                             "99999999999999999999",
                                             "0x7fffffffffffffff",
                                             "mm",
                                             "rpm",
                                             "Hz",
                                             "%",
                                             "kg/m3",
                                             "1:-2",
                                             "until",
                                             "true",
                                             "false",
                                             "\xff",
                                             std::string(1, '\0'),
                                             "\xe2\x82\xac",
                                             "mill",
                                             "jar",
                                             "balls",
                                             "contact",
                                             "run",
                                             "sweep",
                                             "fit",
                                             "optimise",
                                             "over",
                                             "from",
                                             "to",
                                             "steps",
                                             "model",
                                             "kind",
                                             "#",
                                             "\\u0000",
                                             "= ",
                                             "()",
                                             "(",
                                             ")",
                                             "^",
                                             "/"};
  return list;
}

void mutate(std::string& input, Random& random, const std::vector<std::string>& seeds) {
  const auto at = [&](std::size_t extra) { return 1 + below(random, input.size() + extra); };
  switch (below(random, 7)) {
    case 0: {  // replace a byte
      if (input.size() < 3) return;
      input[at(0) % input.size()] = static_cast<char>(below(random, 256));
      break;
    }
    case 1: {  // delete a piece
      const std::size_t from = std::min(at(0), input.size());
      input.erase(from, below(random, 64));
      break;
    }
    case 2: {  // insert a word
      input.insert(std::min(at(0), input.size()), words()[below(random, words().size())]);
      break;
    }
    case 3: {  // repeat a piece
      const std::size_t from = std::min(at(0), input.size());
      const std::string piece = input.substr(from, below(random, 200));
      input.insert(std::min(at(0), input.size()), piece);
      break;
    }
    case 4: {  // insert a piece of another input
      const std::string& other = seeds[below(random, seeds.size())];
      const std::size_t from = below(random, other.size());
      input.insert(std::min(at(0), input.size()), other.substr(from, below(random, 200)));
      break;
    }
    case 5: {  // replace a number
      const std::size_t digit = input.find_first_of("0123456789", std::min(at(0), input.size()));
      if (digit == std::string::npos) return;
      const std::size_t end = std::min(input.find_first_not_of("0123456789.", digit), input.size());
      input.replace(digit, end - digit, words()[15 + below(random, 9)]);
      break;
    }
    default:
      input.resize(std::max<std::size_t>(2, below(random, input.size()) + 1));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 1000;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atol(argv[2]) : 1);
  const std::vector<std::string> seeds = corpus();
  constexpr double patience = 5;  // [s] for one input
  const long first = argc > 3 ? std::atol(argv[3]) : 0;
  for (long i = first; i < first + count; ++i) {
    if (i % 1000 == 0) {  // locates an input that ends the program
      fmt::print("from {}\n", i);
      std::fflush(stdout);
    }
    Random random(seed, static_cast<std::uint32_t>(i));
    std::string input = seeds[below(random, seeds.size())];
    for (std::size_t n = 1 + below(random, 8); n > 0; --n) mutate(input, random, seeds);
    const std::string name = fmt::format("fuzz-{}-{}.bin", seed, i);
    const auto began = std::chrono::steady_clock::now();
    const auto keep = [&] {
      std::ofstream(name, std::ios::binary) << input;
      fmt::print("kept as {}\n", name);
    };
    try {
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    } catch (const std::exception& e) {
      fmt::print("input {} of seed {}: {}\n", i, seed, e.what());
      keep();
      return 1;
    }
    if (std::chrono::steady_clock::now() - began > std::chrono::duration<double>(patience)) {
      fmt::print("input {} of seed {} took more than {} s\n", i, seed, patience);
      keep();
      return 1;
    }
  }
  fmt::print("{} inputs, seed {}: every one was read or refused\n", count, seed);
  return 0;
}
