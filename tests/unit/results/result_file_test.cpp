// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The tests in tests/opening read the tables of result.h5. These tests are for its matrices, and
// for how it is written.
#include "mahlwerk/results/files/result_file.hpp"

#include <hdf5.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/hdf5_handle.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results::result_file_test {
namespace {

class ResultFileTest : public ScratchTest {
 protected:
  std::string written(const std::string& name, const std::vector<Matrix>& matrices = {}) {
    const Outcome o = fake_outcome();
    write_result_file(scratch() / name,
                      {{"spectrum", "by energy", spectrum(o)},
                       {"nothing", "a table without rows", {{{"a", "m", "some length"}}, {}}}},
                      matrices, summarise(o).quantities, "title = \"x\"\n", "1.2.3");
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

TEST_F(ResultFileTest, the_same_content_gives_the_same_bytes) {
  const std::string first = written("a.h5", {map()});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // file times have 1 s resolution
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, written("b.h5", {map()}));
}

std::vector<double> numbers(Handle::Id file, const std::string& name,
                            const std::vector<hsize_t>& wanted) {
  const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  EXPECT_EQ(shape, wanted) << name;
  hsize_t size = 1;
  for (const hsize_t n : shape) size *= n;
  std::vector<double> all(size);
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0) << name;
  return all;
}

std::string attribute(Handle::Id file, const std::string& set, const char* name) {
  const Handle found(H5Aopen_by_name(file, set.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(found), H5Tclose);
  char* text = nullptr;
  if (H5Aread(found, type, static_cast<void*>(&text)) < 0) return "none";
  const std::string copy = text;
  H5free_memory(text);
  return copy;
}

TEST_F(ResultFileTest, a_matrix_keeps_its_numbers_and_the_edges_of_its_cells) {
  written("a.h5", {map()});
  const Handle file(H5Fopen((scratch() / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file.valid());
  EXPECT_EQ(numbers(file, "wear", {2, 3}), map().values);
  EXPECT_EQ(attribute(file, "wear", "unit"), "J/m2");
  EXPECT_EQ(attribute(file, "wear", "about"), "energy on the wall");
  EXPECT_EQ(attribute(file, "wear", "axes"), "angle, height");
  EXPECT_EQ(numbers(file, "wear_edges/angle", {3}), map().edges[0]);
  EXPECT_EQ(numbers(file, "wear_edges/height", {4}), map().edges[1]);
  EXPECT_EQ(attribute(file, "wear_edges/height", "unit"), "m");
  EXPECT_EQ(attribute(file, "nothing", "unit_a"), "m");
}

TEST_F(ResultFileTest, a_matrix_fits_its_shape) {
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

TEST_F(ResultFileTest, one_that_cannot_be_made_is_an_error) {
  EXPECT_THROW(written("no/a.h5"), InputError);
}

}  // namespace
}  // namespace mahlwerk::results::result_file_test
