// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/hdf5_handle.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <cerrno>
#include <cstring>
#include <type_traits>

namespace mahlwerk::results {

static_assert(std::is_same_v<hid_t, Handle::Id> && std::is_same_v<herr_t, int>);

std::unique_lock<std::mutex> hdf5_library() {
  static std::mutex library;
  std::unique_lock held(library);
  // Disables the library's clean-up at exit, which retries without end on a full disk, and its
  // error trace on the terminal. A thread-safe library has a trace for each thread.
  static const int no_clean_up = H5dont_atexit();
  static_cast<void>(no_clean_up);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return held;
}

bool write_attribute(Handle::Id object, const std::string& name, std::string_view text) {
  const std::string copy(text);
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  const char* pointer = copy.c_str();
  return attribute.valid() && H5Awrite(attribute, type, static_cast<const void*>(&pointer)) >= 0;
}

InputError hdf5_failure(const std::filesystem::path& file, const char* doing,
                        const std::string& remedy) {
  const std::string why = errno != 0 ? fmt::format(" ({})", std::strerror(errno)) : "";
  return InputError(
      Fault{file.string(), fmt::format("cannot {}{}", doing, why), remedy, "cannot-write"});
}

}  // namespace mahlwerk::results
