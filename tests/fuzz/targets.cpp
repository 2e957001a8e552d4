// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "targets.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::fuzz {

namespace fs = std::filesystem;

std::span<const Target> targets() {
  static const std::array all{case_target(),       sieves_target(),       mesh_target(),
                              motion_target(),     measurements_target(), store_target(),
                              surrogate_target(),  event_state_target(),  soft_state_target(),
                              checkpoint_target(), folder_target()};
  return all;
}

std::string refusal(const Target& target, const std::string& bytes) {
  try {
    target.read(bytes);
    return "";
  } catch (const InputError& e) {  // bad input
    return e.what();
  } catch (const RunError& e) {  // a damaged state
    return e.what();
  }
}

fs::path home() {
  return MAHLWERK_HOME;
}

const cases::Catalogue& catalogue() {
  static const cases::Catalogue one(home() / "catalogue");
  return one;
}

const fs::path& scratch() {
  struct Folder {
    fs::path path;
    Folder() {
      const fs::path memory = "/dev/shm";
      std::string name =
          ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "mahlwerk-fuzz-XXXXXX")
              .string();
      path = mkdtemp(name.data());
    }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };
  static const Folder one;
  return one.path;
}

void write_file(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string small_case(std::string_view engine) {
  return fmt::format(R"(title = "t"
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "5 mm"
[jar]
kind = "sphere"
diameter = "20 mm"
[[balls]]
count = 3
diameter = "5 mm"
density = "7850 kg/m3"
[run]
engine = "{}"
time = "0.01 s"
replicates = 1
[power_meter]
[microphone]
[accelerometer]
)",
                     engine);
}

}  // namespace mahlwerk::fuzz
