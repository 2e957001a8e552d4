// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mahlwerk::contact {

/// A value for each pair of ball kinds, and for each kind with each face of the jar. Symmetric in
/// the two kinds.
template <class T>
class PairwiseTable {
 public:
  PairwiseTable(int kinds, int faces, const T& all)
      : kinds_(static_cast<std::size_t>(kinds)),
        row_(kinds_ + static_cast<std::size_t>(faces)),
        all_(kinds_ * row_, all) {}

  const T& balls(int a, int b) const { return all_[index(a, b)]; }
  const T& wall(int kind, int face) const { return all_[index(kind, face) + kinds_]; }

  void set_balls(int a, int b, const T& value) { all_[index(a, b)] = all_[index(b, a)] = value; }
  void set_wall(int kind, int face, const T& value) { all_[index(kind, face) + kinds_] = value; }

  std::span<const T> all() const { return all_; }
  int kinds() const { return static_cast<int>(kinds_); }
  int faces() const { return static_cast<int>(row_ - kinds_); }
  bool operator==(const PairwiseTable&) const = default;

 private:
  /// Layout: a row for each kind, with a column for every kind and then for every face.
  std::size_t index(int kind, int other) const {
    return static_cast<std::size_t>(kind) * row_ + static_cast<std::size_t>(other);
  }

  std::size_t kinds_, row_;
  std::vector<T> all_;
};

}  // namespace mahlwerk::contact
