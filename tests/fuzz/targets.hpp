// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"

// Everything that reads what a user or a disk gives, for fuzzers: a target takes any bytes. Every
// outcome is right except a crash, a hang, or an exception that is none of ours.
namespace mahlwerk::fuzz {

struct Target {
  std::string_view name;                ///< also that of its folder in tests/fuzz/corpus
  void (*read)(const std::string&);     ///< throws one of our errors for input that is refused
  std::vector<std::string> (*seeds)();  ///< input that is read, made by the program of today
};

/// All targets; those of a file are defined there.
std::span<const Target> targets();
Target case_target(), sieves_target();                                  // cases.cpp
Target mesh_target(), motion_target(), measurements_target();           // files.cpp
Target store_target(), surrogate_target();                              // campaigns.cpp
Target event_state_target(), soft_state_target(), checkpoint_target();  // states.cpp
Target folder_target();                                                 // folders.cpp

/// Why the input is refused; empty if it is read. Throws what is none of our errors.
std::string refusal(const Target& target, const std::string& bytes);

const cases::Catalogue& catalogue();
std::filesystem::path home();  ///< of the sources
/// A folder of this process for what is read from files; in memory, where the system has such.
const std::filesystem::path& scratch();
void write_file(const std::filesystem::path& file, const std::string& bytes);
std::string contents(const std::filesystem::path& file);

/// A case of three balls in a sphere that runs 10 ms by this engine.
std::string small_case(std::string_view engine);

}  // namespace mahlwerk::fuzz
