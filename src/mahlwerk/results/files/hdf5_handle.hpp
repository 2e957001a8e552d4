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

// What the writers of HDF5 share; for their .cpp files alone. The library's identifiers are plain
// integers here, so that its header need not be known.
namespace mahlwerk::results {

constexpr unsigned deflation = 4;  ///< of 9: most of the gain at little time

/// An identifier of the library and the function that gives it back.
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

/// The library, to be held while it is called: it is not safe to call from two threads, whichever
/// file they write. It is quiet from here on.
std::unique_lock<std::mutex> hdf5_library();

/// Adds an attribute, a text in UTF-8; false if that failed.
bool write_attribute(Handle::Id object, const std::string& name, std::string_view text);

/// That the library could not do something to `file`, with the reason in errno, if there is one.
InputError hdf5_failure(const std::filesystem::path& file, const char* doing,
                        const std::string& remedy);

}  // namespace mahlwerk::results
