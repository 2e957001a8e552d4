// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/body_hits.hpp"

namespace mahlwerk::observe {

void BodyHits::add(scene::BodyFeature feature, double energy, std::int64_t bin) {
  if (by_feature_.empty()) by_feature_.resize(scene::body_features.size());
  by_feature_[scene::index_of(feature)].add(energy, bin);
}

const LogHistogram& BodyHits::energies(scene::BodyFeature feature) const {
  static const LogHistogram none;
  return by_feature_.empty() ? none : by_feature_[scene::index_of(feature)];
}

std::int64_t BodyHits::count() const {
  std::int64_t sum = 0;
  for (const LogHistogram& one : by_feature_) sum += one.total();
  return sum;
}

double BodyHits::energy() const {
  double sum = 0;
  for (const LogHistogram& one : by_feature_) sum += one.sum();
  return sum;
}

void BodyHits::merge(const BodyHits& other) {
  if (other.by_feature_.empty()) return;
  if (by_feature_.empty()) by_feature_.resize(scene::body_features.size());
  for (std::size_t k = 0; k < by_feature_.size(); ++k) by_feature_[k].merge(other.by_feature_[k]);
}

void BodyHits::pack() {
  for (LogHistogram& one : by_feature_) one.pack();
}

void BodyHits::let_go() {
  for (LogHistogram& one : by_feature_) one.let_go();
}

void BodyHits::serialize(Archive& archive) {
  bool any = !by_feature_.empty();
  archive(any);
  by_feature_.resize(any ? scene::body_features.size() : 0);
  for (LogHistogram& one : by_feature_) one.serialize(archive);
}

}  // namespace mahlwerk::observe
