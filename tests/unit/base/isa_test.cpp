// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/isa.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "isas.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/random.hpp"

namespace mahlwerk::isa_test {
namespace {

using tests::ChosenIsa;
using tests::supported_isas;

TEST(Isa, is_the_widest_supported_one_or_that_of_the_environment) {
  for (const Isa wanted : supported_isas()) {
    const ChosenIsa chosen(wanted);
    EXPECT_EQ(isa(), wanted);
  }
  setenv("MAHLWERK_SIMD", "", 1);
  EXPECT_EQ(isa(), supported_isas().front());
  unsetenv("MAHLWERK_SIMD");
  EXPECT_EQ(isa(), supported_isas().front());
}

TEST(Isa, that_is_unknown_or_unsupported_is_refused_with_those_that_work) {
  std::vector<std::string> wrong{"foo", "AVX2", "avx", "sse"};
  for (const Isa one : all_isas)
    if (!is_supported(one)) wrong.emplace_back(word_of(one));
  for (const std::string& word : wrong) {
    setenv("MAHLWERK_SIMD", word.c_str(), 1);
    try {
      isa();
      ADD_FAILURE() << word << " was taken";
    } catch (const InputError& e) {
      EXPECT_NE(e.faults().at(0).what.find(word), std::string::npos);
      for (const Isa one : supported_isas())
        EXPECT_NE(e.faults().at(0).remedy.find(word_of(one)), std::string::npos);
    }
  }
  unsetenv("MAHLWERK_SIMD");
}

/// Numbers of all magnitudes, with zeros of both signs and infinities.
std::vector<double> numbers() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> all{0.0, -0.0, 1.0, -1.0, infinite, -infinite, 5e-324, 1e300};
  Random random(3, 0);
  while (all.size() < 800)
    all.push_back(std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform(-300, 300))));
  return all;
}

/// What the vector layer makes of pairs of numbers, lane by lane.
using Results = std::vector<double>;
struct EveryOperation {
  template <int width>
  [[gnu::always_inline]] static void run(const std::vector<double>& a, Results& out) {
    using V = Register<width>;
    for (std::size_t i = 0; i + 2 * width <= a.size(); i += width) {
      V x{}, y{};
      for (int l = 0; l < width; ++l) {
        const std::size_t k = i + static_cast<std::size_t>(l);
        x[l] = a[k], y[l] = a[(k + 8) % a.size()];
      }
      const MaskOf<V> mask = less<V>(x, y);
      for (const V& r : {sqrt<V>(abs<V>(x)), max<V>(x, y), min<V>(x, y), select<V>(mask, x, y),
                         where<V>(mask, x), where<V>(mask_of<width>(bits(mask)), y)})
        for (int l = 0; l < width; ++l) out.push_back(r[l]);
    }
  }
};

/// The scalar operations, in the order in which EveryOperation gives them with `width` lanes.
Results scalar(const std::vector<double>& a, std::size_t width) {
  Results out;
  for (std::size_t i = 0; i + 2 * width <= a.size(); i += width)
    for (int operation = 0; operation < 6; ++operation)
      for (std::size_t l = 0; l < width; ++l) {
        const double x = a[i + l], y = a[(i + l + 8) % a.size()];
        const double all[] = {std::sqrt(x < 0 ? -x : x),
                              x > y ? x : y,
                              x < y ? x : y,
                              x < y ? x : y,
                              x < y ? x : 0,
                              x < y ? y : 0};
        out.push_back(all[operation]);
      }
  return out;
}

TEST(Lanes, every_instruction_set_computes_the_bits_of_scalar_code) {
  const std::vector<double> all = numbers();
  for (const Isa one : supported_isas()) {
    SCOPED_TRACE(name_of(one));
    const ChosenIsa chosen(one);
    Results found;
    Multiversioned<EveryOperation, void (*)(const std::vector<double>&, Results&)>::best()(all,
                                                                                           found);
    const Results expected = scalar(all, static_cast<std::size_t>(register_width(one)));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i], expected[i]) << i;
      EXPECT_EQ(std::signbit(found[i]), std::signbit(expected[i])) << i;
    }
  }
}

}  // namespace
}  // namespace mahlwerk::isa_test
