// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/hdf5.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <cerrno>
#include <cstddef>
#include <exception>
#include <map>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/collision_columns.hpp"
#include "mahlwerk/results/files/hdf5_handle.hpp"

namespace mahlwerk::results {
namespace {

using scene::Collision;
constexpr hsize_t chunk = 4096;                 // records; 0.5 MB
constexpr std::size_t records_at_once = 16384;  // records per write

InputError failure(const std::filesystem::path& file, const char* doing) {
  return hdf5_failure(
      file, doing,
      "free some space or correct the permissions, choose another folder with --out, "
      "or leave out observe.collisions");
}

/// HDF5 compound type with the memory layout of Collision.
Handle record_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Collision)), H5Tclose);
  for (const CollisionColumn& p : collision_columns())
    H5Tinsert(type, p.name, p.offset, p.whole ? H5T_NATIVE_INT32 : H5T_NATIVE_DOUBLE);
  return type;
}

std::string group_name(int replicate) {
  return fmt::format("replicate_{}", replicate + 1);
}

}  // namespace

struct CollisionFile::Impl {
  std::filesystem::path path;
  Handle file, in_memory;
  std::map<int, Handle> sets;
  std::exception_ptr pending_error;  ///< of a log's last write, rethrown by close()

  Handle& set(int replicate);
};

Handle& CollisionFile::Impl::set(int replicate) {
  Handle& found = sets[replicate];
  if (found.valid()) return found;
  const Handle group(
      H5Gcreate2(file, group_name(replicate).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Gclose);
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(how, 1, &chunk);
  H5Pset_shuffle(how);
  H5Pset_deflate(how, deflation);
  const Handle packed(H5Tcopy(in_memory), H5Tclose);
  H5Tpack(packed);
  found = Handle(H5Dcreate2(group, "collisions", packed, space, H5P_DEFAULT, how, H5P_DEFAULT),
                 H5Dclose);
  if (!found.valid()) throw failure(path, "make a data set in the file");
  bool good = write_attribute(found, "about", "every counted collision of a replicate, by time");
  for (const CollisionColumn& p : collision_columns()) {
    good = write_attribute(found, std::string("unit_") + p.name, p.unit) && good;
    good = write_attribute(found, std::string("about_") + p.name, p.about) && good;
  }
  if (!good) throw failure(path, "write the units into the file");
  return found;
}

CollisionFile::CollisionFile(const std::filesystem::path& file, std::string_view case_text,
                             std::string_view version)
    : impl_(std::make_unique<Impl>()) {
  const auto lock = hdf5_library();
  errno = 0;
  impl_->path = file;
  impl_->in_memory = record_type();
  impl_->file = Handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!impl_->file.valid()) throw failure(file, "create the file");
  if (!write_attribute(impl_->file, "mahlwerk", version) ||
      !write_attribute(impl_->file, "case", case_text))
    throw failure(file, "write the case into the file");
}

CollisionFile::~CollisionFile() {
  const auto lock = hdf5_library();
  impl_.reset();
}

void CollisionFile::append(int replicate, std::span<const Collision> records) {
  const auto lock = hdf5_library();
  errno = 0;
  Handle& set = impl_->set(replicate);
  hsize_t before = 0;
  {
    const Handle space(H5Dget_space(set), H5Sclose);
    H5Sget_simple_extent_dims(space, &before, nullptr);
  }
  const hsize_t more = records.size(), after = before + more;
  bool good = H5Dset_extent(set, &after) >= 0;
  const Handle target(H5Dget_space(set), H5Sclose);
  good = good && H5Sselect_hyperslab(target, H5S_SELECT_SET, &before, nullptr, &more, nullptr) >= 0;
  const Handle source(H5Screate_simple(1, &more, nullptr), H5Sclose);
  good = good && H5Dwrite(set, impl_->in_memory, source, target, H5P_DEFAULT, records.data()) >= 0;
  if (!good) throw failure(impl_->path, "write collisions into the file");
}

void CollisionFile::close() {
  const auto lock = hdf5_library();
  if (!impl_->file.valid()) return;
  errno = 0;
  bool good = H5Fflush(impl_->file, H5F_SCOPE_GLOBAL) >= 0;
  for (auto& [replicate, set] : impl_->sets) good = set.close() && good;
  good = impl_->file.close() && good;
  if (impl_->pending_error) std::rethrow_exception(impl_->pending_error);
  if (!good) throw failure(impl_->path, "finish the file");
}

CollisionLog::CollisionLog(CollisionFile& file, int replicate)
    : file_(file), replicate_(replicate) {
  file_.append(replicate_, {});  // a replicate without a collision has an empty data set
}

CollisionLog::~CollisionLog() {
  try {
    flush();
  } catch (...) {
    const auto lock = hdf5_library();
    if (!file_.impl_->pending_error) file_.impl_->pending_error = std::current_exception();
  }
}

void CollisionLog::collisions(std::span<const Collision> finished) {
  buffer_.insert(buffer_.end(), finished.begin(), finished.end());
  if (buffer_.size() >= records_at_once) flush();
}

void CollisionLog::flush() {
  const std::vector<Collision> now = std::exchange(buffer_, {});
  if (!now.empty()) file_.append(replicate_, now);
}

std::vector<Collision> read_collisions(const std::filesystem::path& file, int replicate) {
  const auto lock = hdf5_library();
  const auto missing = [&](const std::string& what) {
    return InputError(Fault{file.string(), what, "check the name of the file", "cannot-read"});
  };
  const Handle open(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!open.valid()) throw missing("cannot be read as HDF5");
  const std::string name = group_name(replicate) + "/collisions";
  const Handle set(H5Dopen2(open, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) throw missing("has no /" + name);
  const Handle space(H5Dget_space(set), H5Sclose);
  hsize_t count = 0;
  H5Sget_simple_extent_dims(space, &count, nullptr);
  std::vector<Collision> records(count);
  if (H5Dread(set, record_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, records.data()) < 0)
    throw missing("cannot be read to its end");
  return records;
}

}  // namespace mahlwerk::results
