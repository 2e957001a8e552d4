// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "records.hpp"

#include <memory>
#include <utility>

#include "mahlwerk/results/files/collision_columns.hpp"

namespace mahlwerk::python {

namespace py = pybind11;
using scene::Collision;

py::dtype record_type() {
  py::list names, formats, offsets;
  for (const results::CollisionColumn& column : results::collision_columns()) {
    names.append(column.name);
    formats.append(column.whole ? "i4" : "f8");
    offsets.append(column.offset);
  }
  return py::dtype(names, formats, offsets, sizeof(Collision));
}

py::array as_array(std::vector<Collision> records) {
  auto* owned = new std::vector<Collision>(std::move(records));
  const py::capsule owner(owned, [](void* p) { delete static_cast<std::vector<Collision>*>(p); });
  return py::array(record_type(), {owned->size()}, {sizeof(Collision)}, owned->data(), owner);
}

void RecordList::collisions(std::span<const Collision> finished) {
  list_->insert(list_->end(), finished.begin(), finished.end());
}

PythonObserver::PythonObserver(py::handle observe, int replicate, Job& job)
    : observe_(observe), replicate_(replicate), job_(&job) {}

PythonObserver::~PythonObserver() {
  flush();
}

void PythonObserver::collisions(std::span<const Collision> finished) {
  constexpr std::size_t chunk = 8192;  // 1.1 MB, which stays in the cache of a core
  buffer_.insert(buffer_.end(), finished.begin(), finished.end());
  if (buffer_.size() >= chunk) flush();
}

void PythonObserver::flush() {
  if (buffer_.empty()) return;
  const std::size_t used = buffer_.size();
  const py::gil_scoped_acquire held;
  try {
    observe_(as_array(std::exchange(buffer_, {})), replicate_);
  } catch (...) {
    job_->fail(std::current_exception());
  }
  buffer_.reserve(used);
}

void ObserverList::add(std::unique_ptr<scene::Observer> one) {
  if (one) all_.push_back(std::move(one));
}

std::unique_ptr<scene::Observer> ObserverList::combined() && {
  if (all_.empty()) return nullptr;
  if (all_.size() == 1) return std::move(all_.front());
  return std::make_unique<ObserverList>(std::move(*this));
}

void ObserverList::collisions(std::span<const Collision> finished) {
  for (const auto& one : all_) one->collisions(finished);
}

}  // namespace mahlwerk::python
