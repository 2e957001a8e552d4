// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "records.hpp"

#include <cstdint>
#include <memory>
#include <utility>

#include "mahlwerk/results/files/collision_columns.hpp"

namespace mahlwerk::python {

namespace py = pybind11;
using scene::Collision;

void bind_records(py::module_& m) {
  py::class_<RecordBuffer>(m, "RecordBuffer", py::buffer_protocol(), "Collision records as bytes.")
      .def_buffer([](RecordBuffer& b) {
        return py::buffer_info(reinterpret_cast<std::uint8_t*>(b.records.data()),
                               static_cast<py::ssize_t>(b.records.size() * sizeof(Collision)),
                               true);
      });
  m.def("record_columns", [] {
    py::list columns;  // name, unit, meaning, offset, whether it is an integer
    for (const results::CollisionColumn& c : results::collision_columns())
      columns.append(py::make_tuple(c.name, c.unit, c.about, c.offset, c.whole));
    return columns;
  });
  m.attr("record_size") = sizeof(Collision);
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
    observe_(RecordBuffer{std::exchange(buffer_, {})}, replicate_);
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
