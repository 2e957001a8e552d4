// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numbers>
#include <vector>

#include "mahlwerk/base/archive.hpp"

namespace mahlwerk::observe {

/// Counts in logarithmic bins, four per octave, edges 2^(k/4): fixed memory, exact merging.
class LogHistogram {
 public:
  static constexpr int per_octave = 4;
  static constexpr int lowest_octave = -80, highest_octave = 40;
  static constexpr int bins = (highest_octave - lowest_octave) * per_octave;

  LogHistogram() : bins_(bins) {}

  /// `value` >= 0; what lies beyond the ends goes into the first or last bin, and so does what
  /// rounding made a little less than 0.
  void add(double value) { add(value, bin_of(value)); }
  /// The same where its bin is known.
  void add(double value, int at) {
    Bin& bin = bins_[static_cast<std::size_t>(at)];
    ++bin.count;
    bin.sum += value;
  }
  void merge(const LogHistogram& other);
  void carry(Archive& archive) { archive(bins_); }

  /// The bin `value` goes into. No logarithm: the octave is the exponent of the double, the quarter
  /// is found by comparing its mantissa with the three edges inside an octave.
  static int bin_of(double value) {
    const auto bits =
        std::bit_cast<std::int64_t>(value);  // negative numbers: negative, so first bin
    const auto octave = static_cast<int>(bits >> mantissa_bits) - exponent_bias;
    const std::int64_t mantissa = bits & mantissa_mask;
    const int quarter = static_cast<int>(mantissa >= mantissa_of(edges[1])) +
                        static_cast<int>(mantissa >= mantissa_of(edges[2])) +
                        static_cast<int>(mantissa >= mantissa_of(edges[3]));
    return std::clamp((octave - lowest_octave) * per_octave + quarter, 0, bins - 1);
  }

  static double lower(int bin);  ///< edge, in the unit of the values; upper(bin) == lower(bin + 1)
  std::int64_t count(int bin) const { return bins_[static_cast<std::size_t>(bin)].count; }
  double sum(int bin) const { return bins_[static_cast<std::size_t>(bin)].sum; }  ///< of the values
  std::int64_t total() const;
  /// First and one past the last bin that is not empty; {0, 0} if all are.
  std::array<int, 2> filled() const;

 private:
  struct Bin {
    std::int64_t count = 0;
    double sum = 0;
  };
  static constexpr int mantissa_bits = 52, exponent_bias = 1023;
  static constexpr std::int64_t mantissa_mask = (std::int64_t{1} << mantissa_bits) - 1;
  /// 2^(k/4), k = 0 ... 3.
  static constexpr std::array<double, per_octave> edges{1, 1.189207115002721, std::numbers::sqrt2,
                                                        1.681792830507429};
  static constexpr std::int64_t mantissa_of(double value) {
    return std::bit_cast<std::int64_t>(value) & mantissa_mask;
  }

  std::vector<Bin> bins_;
};

}  // namespace mahlwerk::observe
