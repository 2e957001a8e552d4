// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/evaluations.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr std::string_view magic = "mahlwerk evaluations 1\n";

/// Reads or writes one prediction.
void serialize(Archive& archive, FitEvaluations::Replicates& of, std::vector<double>& values,
               std::vector<double>& predicted) {
  std::uint64_t number = of ? *of + 1 : 0;  // 0: all replicates
  archive(number)(values)(predicted);
  of = number > 0 ? FitEvaluations::Replicates(number - 1) : std::nullopt;
}

}  // namespace

FitEvaluations::FitEvaluations(std::filesystem::path file, std::string what, double every,
                               std::function<void(const Fault&)> on_write_error)
    : file_(std::move(file)),
      what_(std::move(what)),
      every_(every),
      on_write_error_(std::move(on_write_error)) {
  load();
}

/// Leaves the list empty if the file is missing, damaged or of another fit.
void FitEvaluations::load() try {
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) return;
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  std::uint64_t seal = 0, count = 0;
  if (bytes.size() < sizeof seal) return;
  std::memcpy(&seal, bytes.data() + bytes.size() - sizeof seal, sizeof seal);
  bytes.resize(bytes.size() - sizeof seal);
  if (seal != fingerprint(bytes)) return;
  Archive archive(std::move(bytes));
  std::string title, what;
  archive(title)(what)(count);
  if (title != magic || what != what_) return;
  for (; count > 0; --count) {
    Replicates of;
    std::vector<double> values, predicted;
    serialize(archive, of, values, predicted);
    known_.emplace(std::pair(of, std::move(values)), std::move(predicted));
  }
  archive.finish();
} catch (const RunError&) {  // bytes are missing
  known_.clear();
}

const std::vector<double>* FitEvaluations::find(Replicates of,
                                                const std::vector<double>& values) const {
  const auto found = known_.find({of, values});
  return found == known_.end() ? nullptr : &found->second;
}

void FitEvaluations::keep(Replicates of, const std::vector<double>& values,
                          const std::vector<double>& predicted) {
  known_.insert_or_assign(std::pair(of, values), predicted);
  unwritten_ = true;
  if (std::chrono::steady_clock::now() - written_at_ > every_) write();
}

void FitEvaluations::flush() {
  if (unwritten_) write();
}

void FitEvaluations::note(const std::vector<double>& values, double sum) {
  if (std::isfinite(sum) && (!best_ || sum < best_->sum)) best_ = Best{values, sum};
}

void FitEvaluations::write() {
  Archive archive;
  std::string title(magic);
  auto count = static_cast<std::uint64_t>(known_.size());
  archive(title)(what_)(count);
  for (const auto& [key, prediction] : known_) {
    auto [of, values] = key;
    std::vector<double> predicted = prediction;
    serialize(archive, of, values, predicted);
  }
  std::uint64_t seal = fingerprint(archive.bytes());
  archive(seal);
  written_at_ = std::chrono::steady_clock::now();
  unwritten_ = false;
  try {
    results::write_whole(file_, archive.bytes());
  } catch (const InputError& e) {
    Fault fault = e.faults().front();
    fault.remedy = "the fit goes on; interrupted, it would start from the beginning";
    if (on_write_error_) on_write_error_(fault);
  }
}

}  // namespace mahlwerk::campaign
