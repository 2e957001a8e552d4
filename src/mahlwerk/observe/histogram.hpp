// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numbers>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/observe/packed_array.hpp"

namespace mahlwerk::observe {

/// Histogram of counts and sums in logarithmic bins, four per octave, with edges 2^(k/4), in fixed
/// memory. Sums are in fixed point, in units of the last place of the bin's octave, so that they do
/// not depend on the order of values: merging is exact.
class LogHistogram {
 public:
  static constexpr int per_octave = 4;
  static constexpr int lowest_octave = -80, highest_octave = 40;
  static constexpr int bins = (highest_octave - lowest_octave) * per_octave;

  /// 2^(k/4), k = 0 ... 3.
  static constexpr std::array<double, per_octave> edges{1, 1.189207115002721, std::numbers::sqrt2,
                                                        1.681792830507429};
  /// Values beyond these go into the first or last bin.
  static constexpr double least = 0x1p-80, most = 0x1.fffffffffffffp39;

  LogHistogram() : inner_(std::size_t{bins}) {}

  /// Adds a value. Values beyond the ends go into the first or last bin. Values <= 0 (losses made
  /// negative by rounding or by a contact law that gains energy) go into the first bin.
  void add(double value) { add(value, bin_of(value)); }
  /// Adds a value whose bin is known.
  void add(double value, std::int64_t at) {
    if (at > 0 && at < bins - 1)
      inner_[static_cast<std::size_t>(at)] += one | Whole(mantissa_of(value) | implicit_bit);
    else
      add_to_end(value, at);
  }
  void merge(const LogHistogram& other);
  void pack() { inner_.pack(); }  ///< nothing is added from then on (PackedArray)
  void let_go() {                 ///< the values are forgotten (PackedArray)
    inner_.let_go();
    ends_ = {};
  }
  void serialize(Archive& archive) {
    inner_.serialize(archive);
    archive(ends_);
  }

  /// The bin of `value`. Without a logarithm: the octave is the exponent of the double, the quarter
  /// follows from comparing its mantissa with the three edges inside an octave.
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

  static double lower(int bin);  ///< lower edge, in the unit of the values (obs.2)
  std::int64_t count(int bin) const;
  double sum(int bin) const;   ///< sum of the bin's values
  std::int64_t total() const;  ///< sum of all counts
  double sum() const;          ///< sum of all values
  /// First and one past the last non-empty bin; {0, 0} if all are empty.
  std::array<int, 2> occupied_range() const;

 private:
  __extension__ using Whole = unsigned __int128;
  __extension__ using Signed = __int128;
  /// An inner bin is one 128-bit number, for speed: the count in its upper 38 bits, the sum below
  /// in units of the last place of the bin's octave. It holds up to 1e11 values.
  static constexpr int count_place = 90;
  static constexpr Whole one = Whole{1} << count_place;
  /// First or last bin, where octaves are mixed and values may be negative.
  struct End {
    std::int64_t count = 0;
    Signed sum = 0;  // each value rounded to a unit and clamped
  };
  void add_to_end(double value, std::int64_t at);
  const End& end(int bin) const { return ends_[bin == 0 ? 0 : 1]; }
  static bool inside(int bin) { return bin > 0 && bin < bins - 1; }
  static double unit(std::int64_t bin);
  static constexpr int mantissa_bits = 52, exponent_bias = 1023;
  static constexpr std::int64_t implicit_bit = std::int64_t{1} << mantissa_bits;
  static constexpr std::int64_t mantissa_mask = implicit_bit - 1;
  static constexpr std::int64_t mantissa_of(double value) {
    return std::bit_cast<std::int64_t>(value) & mantissa_mask;
  }

  PackedArray<Whole> inner_;
  std::array<End, 2> ends_{};
};

}  // namespace mahlwerk::observe
