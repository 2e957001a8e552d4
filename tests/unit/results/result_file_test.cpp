// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What is in result.h5 is read by the tests in tests/opening; here, how it is written.
#include "mahlwerk/results/result_file.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/tables.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results {
namespace {

class ResultFileTest : public ScratchTest {
 protected:
  std::string written(const std::string& name, const std::vector<Matrix>& matrices = {}) {
    const Outcome o = fake_outcome();
    write_result_file(scratch() / name,
                      {{"spectrum", "by energy", spectrum(o)},
                       {"nothing", "a table without rows", {{{"a", "m", "some length"}}, {}}}},
                      matrices, summarise(o), "title = \"x\"\n", "1.2.3");
    return read(scratch() / name);
  }
};

Matrix map() {
  return {.name = "wear",
          .unit = "J/m2",
          .about = "energy on the wall",
          .axes = {{"angle", "deg", "about the axis"}, {"height", "m", "from the middle"}},
          .edges = {{0, 180, 360}, {-1, 0, 1, 2}},
          .shape = {2, 3},
          .values = {1, 2, 3, 4, 5, 6}};
}

TEST_F(ResultFileTest, TheSameContentGivesTheSameBytes) {
  const std::string first = written("a.h5", {map()});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // clocks of files tick in seconds
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, written("b.h5", {map()}));
}

TEST_F(ResultFileTest, AMatrixFitsItsShape) {
  EXPECT_NO_THROW(written("a.h5", {map()}));
  Matrix m = map();
  m.values.pop_back();
  EXPECT_THROW(written("b.h5", {m}), std::invalid_argument);
  m = map();
  m.edges[1].pop_back();
  EXPECT_THROW(written("b.h5", {m}), std::invalid_argument);
  m = map();
  m.axes.pop_back();
  EXPECT_THROW(written("b.h5", {m}), std::invalid_argument);
}

TEST_F(ResultFileTest, OneThatCannotBeMadeIsAnError) {
  EXPECT_THROW(written("no/a.h5"), InputError);
}

}  // namespace
}  // namespace mahlwerk::results
