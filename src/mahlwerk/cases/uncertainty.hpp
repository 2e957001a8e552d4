// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Values of a case that are known only within a scatter (docs/theory/calibration.md).
namespace mahlwerk::cases {

struct Case;

/// A key with the values that it may have, one for each draw from their common distribution.
struct UncertainKey {
  std::string key;                  ///< "contact.restitution", of [contact] or [mill]
  std::vector<std::string> values;  ///< as text, by draw
  bool operator==(const UncertainKey&) const = default;
};

struct DrawnSections;  ///< the sections of a case with the values of one draw

/// Draws of uncertain keys. Each replicate of a run has the values of one draw.
struct Uncertainty {
  std::string source;              ///< of the draws, in words
  std::vector<UncertainKey> keys;  ///< sorted by name; as many values of each
  std::int64_t first = 0;          ///< draw of the first replicate
  /// By draw; shared by the copies of a case. Null after a fault.
  std::shared_ptr<const std::vector<DrawnSections>> sections = {};

  std::size_t count() const { return keys.empty() ? 0 : keys.front().values.size(); }
  bool operator==(const Uncertainty& o) const {
    return source == o.source && keys == o.keys && first == o.first;
  }
};

/// Number of cases that differ from replicate to replicate; 1: all replicates have the same.
std::size_t distinct_replicates(const Case& c);

/// The case of a replicate, from 0: with the values of its draw and without [uncertainty], and in
/// its sense of rotation (reversal.hpp). Else the same case.
Case case_of_replicate(const Case& c, std::size_t replicate);

}  // namespace mahlwerk::cases
