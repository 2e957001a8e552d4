// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/points/designs.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::campaign {
namespace {

/// First streams of random numbers, one stream for each key or trajectory; engines use streams near
/// 0.
constexpr std::uint32_t hypercube_stream = 0x10000000, trajectory_stream = 0x20000000,
                        shift_stream = 0x30000000;

std::size_t below(std::size_t count, Random& random) {
  return std::min(count - 1,
                  static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
}

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[below(i, random)]);
  return order;
}

Random stream(std::uint64_t seed, std::uint32_t first, std::size_t which) {
  return {seed, first + static_cast<std::uint32_t>(which)};
}

/// Sobol' sequence as integers in units of 2^-64.
class Sobol {
 public:
  explicit Sobol(std::size_t dimensions) : dimensions_(dimensions), engine_(engine(dimensions)) {}

  std::vector<std::uint64_t> next() {
    std::vector<std::uint64_t> row(dimensions_);
    for (std::uint64_t& digits : row) digits = engine_();
    return row;
  }

 private:
  static boost::random::sobol engine(std::size_t dimensions) {
    constexpr std::size_t most = boost::random::default_sobol_table::max_dimension;
    if (dimensions == 0 || dimensions > most)
      throw std::invalid_argument("Sobol's sequence has 1 to 3667 dimensions");
    return boost::random::sobol(dimensions);
  }

  std::size_t dimensions_;
  boost::random::sobol engine_;
};

double unit_interval(std::uint64_t digits) {
  return static_cast<double>(digits >> 11U) * 0x1p-53;
}

}  // namespace

DesignMatrix latin_hypercube(std::size_t keys, std::size_t samples, std::uint64_t seed) {
  DesignMatrix rows(samples, std::vector<double>(keys));
  for (std::size_t key = 0; key < keys; ++key) {
    Random random = stream(seed, hypercube_stream, key);
    const std::vector<std::size_t> parts = shuffled(samples, random);
    for (std::size_t i = 0; i < samples; ++i)
      rows[i][key] =
          (static_cast<double>(parts[i]) + random.uniform()) / static_cast<double>(samples);
  }
  return rows;
}

DesignMatrix sobol_points(std::size_t keys, std::size_t samples) {
  Sobol sequence(keys);  // without the corner, as in Boost
  DesignMatrix rows(samples);
  for (std::vector<double>& row : rows)
    for (const std::uint64_t digits : sequence.next()) row.push_back(unit_interval(digits));
  return rows;
}

DesignMatrix one_at_a_time_design(std::size_t keys, double base) {
  DesignMatrix rows(2 * keys + 1, std::vector<double>(keys, base));
  for (std::size_t key = 0; key < keys; ++key) {
    rows[2 * key + 1][key] = 0;
    rows[2 * key + 2][key] = 1;
  }
  return rows;
}

DesignMatrix morris_design(std::size_t keys, std::size_t trajectories, std::uint64_t seed) {
  constexpr int levels = 4, step = levels / 2;  // (sen.1)
  const auto level = [](int number) { return static_cast<double>(number) / (levels - 1); };
  DesignMatrix rows;
  rows.reserve(trajectories * (keys + 1));
  for (std::size_t trajectory = 0; trajectory < trajectories; ++trajectory) {
    Random random = stream(seed, trajectory_stream, trajectory);
    std::vector<int> at(keys);
    for (int& number : at) number = static_cast<int>(below(levels, random));
    const auto add = [&] {
      std::vector<double>& row = rows.emplace_back();
      for (const int number : at) row.push_back(level(number));
    };
    add();
    for (const std::size_t key : shuffled(keys, random)) {
      at[key] += at[key] < step ? step : -step;  // only one of the two stays in the range
      add();
    }
  }
  return rows;
}

DesignMatrix saltelli_design(std::size_t keys, std::size_t base, std::uint64_t seed) {
  Sobol sequence(2 * keys);
  // The first rows of the plain sequence have nearly equal halves, which give no information.
  std::vector<std::uint64_t> shift(2 * keys);
  for (std::size_t i = 0; i < shift.size(); ++i) {
    Random random = stream(seed, shift_stream, i);
    shift[i] = static_cast<std::uint64_t>(random.uniform() * 0x1p53) << 11U;
  }
  DesignMatrix rows;
  rows.reserve(base * (keys + 2));
  for (std::size_t group = 0; group < base; ++group) {
    // The corner is added: with it 2^m rows are a digital net.
    const std::vector<std::uint64_t> digits =
        group == 0 ? std::vector<std::uint64_t>(2 * keys) : sequence.next();
    std::vector<double> a, b;
    for (std::size_t i = 0; i < keys; ++i) {
      a.push_back(unit_interval(digits[i] ^ shift[i]));
      b.push_back(unit_interval(digits[keys + i] ^ shift[keys + i]));
    }
    rows.push_back(a);
    for (std::size_t i = 0; i < keys; ++i) {
      rows.push_back(a);
      rows.back()[i] = b[i];
    }
    rows.push_back(std::move(b));
  }
  return rows;
}

}  // namespace mahlwerk::campaign
