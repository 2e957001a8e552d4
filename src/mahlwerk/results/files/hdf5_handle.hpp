// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "mahlwerk/base/error.hpp"

// Helpers of the HDF5 writers, for their .cpp files only. Identifiers of the library are plain
// integers here, so that this header does not include the library's.
namespace mahlwerk::results {

constexpr unsigned deflation = 4;  ///< of 9: most of the compression at little cost

/// Owns an identifier of the library, with the function that closes it.
class Handle {
 public:
  using Id = std::int64_t;
  Handle() = default;
  Handle(Id id, int (*give_back)(Id)) : id_(id), close_(give_back) {}
  Handle(Handle&& o) noexcept : id_(std::exchange(o.id_, -1)), close_(o.close_) {}
  Handle& operator=(Handle&& o) noexcept {
    std::swap(id_, o.id_);
    std::swap(close_, o.close_);
    return *this;
  }
  ~Handle() { close(); }
  operator Id() const { return id_; }
  bool valid() const { return id_ >= 0; }
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  Id id_ = -1;
  int (*close_)(Id) = nullptr;
};

/// Locks the HDF5 library, which is not thread-safe even for different files. Hold the lock during
/// calls. Disables the library's error messages on the terminal.
std::unique_lock<std::mutex> hdf5_library();

/// Adds a UTF-8 text attribute; returns false on failure.
bool write_attribute(Handle::Id object, const std::string& name, std::string_view text);

/// The error that the library could not do `doing` to `file`, with the reason in errno, if any.
InputError hdf5_failure(const std::filesystem::path& file, const char* doing,
                        const std::string& remedy);

}  // namespace mahlwerk::results
