// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Fuzzer entry point for all parsers of input from users or from disk. The first byte selects the
// parser, the rest is its input. Every outcome is right except a crash, a hang, or an exception
// that is not one of ours.
#include "parsers.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/campaign/run/checkpoint.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "mahlwerk/cases/file/stl.hpp"
#include "mahlwerk/cases/read.hpp"

namespace {

using namespace mahlwerk;

const cases::Catalogue& catalogue() {
  static const cases::Catalogue one(MAHLWERK_HOME "/catalogue");
  return one;
}

const char* const motion_case = R"(title = "t"
[mill]
kind = "tabulated"
file = "motion.csv"
[jar]
kind = "sphere"
diameter = "20 mm"
[[balls]]
count = 1
diameter = "5 mm"
density = "7850 kg/m3"
[run]
time = "1 s"
)";

const char* const small_case = R"(title = "t"
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
engine = "event"
time = "0.01 s"
[power_meter]
[microphone]
[accelerometer]
)";

/// A folder of this process for parsers that only read files.
const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    std::string name = (std::filesystem::temp_directory_path() / "mahlwerk-fuzz-XXXXXX").string();
    return std::filesystem::path(mkdtemp(name.data()));
  }();
  return made;
}

void read_motion(const std::string& bytes) {
  std::ofstream(folder() / "motion.csv", std::ios::binary) << bytes;
  cases::read_text(motion_case, folder() / "case.toml", catalogue());
}

void read_checkpoint(const std::string& bytes) {
  const std::filesystem::path file = folder() / "case.checkpoint";
  std::ofstream(file, std::ios::binary) << bytes;
  campaign::Checkpoint(file, "case", 1, 60).load();
}

void read_state(const std::string& bytes) {
  static const cases::Case mill_case = cases::read_text(small_case, "case.toml", catalogue());
  campaign::ReplicateRun replica(mill_case, 0);
  Archive archive(bytes);
  replica.serialize(archive);
  archive.finish();
}

void read_surrogate(const std::string& bytes) {
  const std::filesystem::path file = folder() / "mill.json";
  std::ofstream(file, std::ios::binary) << bytes;
  const campaign::CampaignSurrogate read = campaign::read_surrogate(file);
  if (read.quantities.empty()) return;
  campaign::predict(read.quantities.front(), read.point({{"mill.speed", "300 rpm"}}));
}

}  // namespace

namespace mahlwerk::fuzz {

std::string state_of_a_run() {
  const cases::Case mill_case = cases::read_text(small_case, "case.toml", catalogue());
  campaign::ReplicateRun replica(mill_case, 0);
  replica.run_slice();
  Archive archive;
  replica.serialize(archive);
  return archive.bytes();
}

}  // namespace mahlwerk::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    switch (static_cast<fuzz::Reader>(data[0] % fuzz::readers)) {
      case fuzz::Reader::case_file:
        cases::read_text(bytes, "case.toml", catalogue());
        break;
      case fuzz::Reader::mesh:
        cases::read_stl(bytes, 1e-3);
        break;
      case fuzz::Reader::motion:
        read_motion(bytes);
        break;
      case fuzz::Reader::measurements:
        campaign::read_measurements_text(bytes, "data.csv");
        break;
      case fuzz::Reader::checkpoint:
        read_checkpoint(bytes);
        break;
      case fuzz::Reader::state:
        read_state(bytes);
        break;
      case fuzz::Reader::surrogate:
        read_surrogate(bytes);
        break;
    }
  } catch (const InputError&) {  // expected for bad input
  } catch (const RunError&) {    // expected for a damaged state
  } catch (const cases::StlError&) {
  }
  return 0;
}
