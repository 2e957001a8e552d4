// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The fuzzers, by libFuzzer:
//     fuzz --target=NAME [FOLDER] [FLAGS OF LIBFUZZER]
// The seeds of the target are written into the first folder, which libFuzzer reads.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "targets.hpp"

namespace {

const mahlwerk::fuzz::Target* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace mahlwerk::fuzz;
  constexpr std::string_view option = "--target=";
  std::string name, folder;
  for (int i = 1; i < *argc; ++i) {
    const std::string word = (*argv)[i];
    if (word.starts_with(option))
      name = word.substr(option.size());
    else if (!word.starts_with("-") && folder.empty() && std::filesystem::is_directory(word))
      folder = word;
  }
  for (const Target& target : targets())
    if (target.name == name) chosen = &target;
  if (chosen == nullptr) {
    std::fprintf(stderr, "give --target=NAME, one of:");
    for (const Target& target : targets())
      std::fprintf(stderr, " %s", std::string(target.name).c_str());
    std::fprintf(stderr, "\n");
    std::exit(2);
  }
  if (folder.empty()) return 0;
  int number = 0;
  for (const std::string& seed : chosen->seeds())
    write_file(std::filesystem::path(folder) / ("seed-" + std::to_string(++number)), seed);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mahlwerk::fuzz::refusal(*chosen, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
