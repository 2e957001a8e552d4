// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Saved states of a run, and the checkpoint file that holds them.
#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/campaign/run/checkpoint.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/read.hpp"
#include "targets.hpp"

namespace mahlwerk::fuzz {
namespace {

cases::Case case_of(const char* engine) {
  return cases::read_text(small_case(engine), scratch() / "case.toml", catalogue());
}
const cases::Case& event_case() {
  static const cases::Case one = case_of("event");
  return one;
}
const cases::Case& soft_case() {
  static const cases::Case one = case_of("soft");
  return one;
}

void read_state(const cases::Case& mill_case, const std::string& bytes) {
  campaign::ReplicateRun replica(mill_case, 0);
  Archive archive(bytes);
  replica.serialize(archive);
  archive.finish();
}

std::vector<std::string> states_of(const cases::Case& mill_case) {
  std::vector<std::string> states;
  campaign::ReplicateRun replica(mill_case, 0);
  for (int i = 0; i < 2; ++i) {
    Archive archive;
    replica.serialize(archive);
    states.push_back(archive.bytes());
    replica.run_slice();
  }
  return states;
}

constexpr std::size_t replicates = 2;

campaign::Checkpoint checkpoint_at(const std::filesystem::path& file) {
  return {file, "case", replicates, 60};
}

/// The fingerprint at the end of the file is made here: no mutation would find it.
void read_checkpoint(const std::string& bytes) {
  const std::filesystem::path file = scratch() / "case.checkpoint";
  const std::uint64_t seal = fingerprint(bytes);
  write_file(file, bytes + std::string(reinterpret_cast<const char*>(&seal), sizeof seal));
  campaign::Checkpoint checkpoint = checkpoint_at(file);
  checkpoint.load();
  for (std::size_t i = 0; i < replicates; ++i) {
    campaign::ReplicateRun replica(event_case(), static_cast<int>(i));
    checkpoint.restore(i, replica);
  }
}

std::vector<std::string> checkpoints() {
  const std::filesystem::path file = scratch() / "seed.checkpoint";
  std::vector<std::string> files;
  for (const bool begun : {false, true}) {
    campaign::Checkpoint checkpoint = checkpoint_at(file);
    for (std::size_t i = 0; i < (begun ? replicates : 1); ++i) {
      campaign::ReplicateRun replica(event_case(), static_cast<int>(i));
      replica.run_slice();
      checkpoint.save(i, replica);
    }
    checkpoint.flush();
    files.push_back(contents(file));
    files.back().resize(files.back().size() - sizeof(std::uint64_t));
  }
  return files;
}

}  // namespace

Target event_state_target() {
  return {"event-state", [](const std::string& bytes) { read_state(event_case(), bytes); },
          [] { return states_of(event_case()); }};
}
Target soft_state_target() {
  return {"soft-state", [](const std::string& bytes) { read_state(soft_case(), bytes); },
          [] { return states_of(soft_case()); }};
}
Target checkpoint_target() {
  return {"checkpoint", read_checkpoint, checkpoints};
}

}  // namespace mahlwerk::fuzz
