// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/spectra.hpp"

#include <cmath>

namespace mahlwerk::observe {
namespace {

constexpr std::array histograms{&Spectra::energy_normal, &Spectra::energy_contact_point,
                                &Spectra::energy_centre, &Spectra::energy_lost,
                                &Spectra::lost_normal,   &Spectra::lost_tangential,
                                &Spectra::approach,      &Spectra::duration,
                                &Spectra::flash};

}  // namespace

void JointHistogram::merge(const JointHistogram& other) {
  counts_.merge(other.counts_, [](std::int64_t& mine, std::int64_t more) { mine += more; });
}

double JointHistogram::lower(int bin) {
  return bin == 0 ? 0 : std::ldexp(1.0, bin + lowest_octave);
}

void Spectra::merge(const Spectra& other) {
  for (const auto one : histograms) (this->*one).merge(other.*one);
  normal_tangential.merge(other.normal_tangential);
  for (std::size_t i = 0; i < angle_bins; ++i) {
    angle_all[i] += other.angle_all[i];
    angle_above[i] += other.angle_above[i];
  }
}

void Spectra::pack() {
  for (const auto one : histograms) (this->*one).pack();
  normal_tangential.pack();
}

void Spectra::let_go() {
  for (const auto one : histograms) (this->*one).let_go();
  normal_tangential.let_go();
  angle_all = angle_above = {};
}

void Spectra::serialize(Archive& archive) {
  for (const auto one : histograms) (this->*one).serialize(archive);
  normal_tangential.serialize(archive);
  archive(angle_all)(angle_above);
}

}  // namespace mahlwerk::observe
