// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/bed_breakage/size_record.hpp"

namespace mahlwerk::parts::bed_breakage {

void SizeRecord::size_changes(std::span<const scene::SizeChange> changes) {
  for (const scene::SizeChange& change : changes) {
    now_.mass[static_cast<std::size_t>(change.size_class)] += change.mass;
    now_.broken += change.broken;
  }
}

void SizeRecord::take(const scene::EnergyBalance& now) {
  now_.time = now.time - begin_;
  samples_.push_back(now_);
}

void SizeRecord::serialize(Archive& archive) {
  now_.serialize(archive);
  auto count = static_cast<std::uint64_t>(samples_.size());
  archive(count);
  if (archive.reading()) {
    if (count > 1000000) throw Archive::broken();
    samples_.resize(count);
  }
  for (SizeSample& one : samples_) one.serialize(archive);
}

}  // namespace mahlwerk::parts::bed_breakage
