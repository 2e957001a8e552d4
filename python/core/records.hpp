// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "job.hpp"
#include "mahlwerk/scene/collision.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::python {

/// The structured type of a collision record, with the memory layout of scene::Collision.
pybind11::dtype record_type();

/// An array of records that owns them; they are not copied.
pybind11::array as_array(std::vector<scene::Collision> records);

/// Collects all records of a replicate.
class RecordList final : public scene::Observer {
 public:
  explicit RecordList(std::vector<scene::Collision>& list) : list_(&list) {}
  void collisions(std::span<const scene::Collision> finished) override;

 private:
  std::vector<scene::Collision>* list_;
};

/// Passes the records of a replicate to a Python function, in chunks. An exception there ends the
/// job.
class PythonObserver final : public scene::Observer {
 public:
  /// `observe(records, replicate)`; `replicate` counts from 1.
  PythonObserver(pybind11::handle observe, int replicate, Job& job);
  ~PythonObserver() override;  ///< passes the last records
  void collisions(std::span<const scene::Collision> finished) override;

 private:
  void flush();

  pybind11::handle observe_;
  int replicate_;
  Job* job_;
  std::vector<scene::Collision> buffer_;
};

/// Passes every record to several observers.
class ObserverList final : public scene::Observer {
 public:
  void add(std::unique_ptr<scene::Observer> one);
  /// The only observer, or this list; null if there is none. The list is used up.
  std::unique_ptr<scene::Observer> combined() &&;
  void collisions(std::span<const scene::Collision> finished) override;

 private:
  std::vector<std::unique_ptr<scene::Observer>> all_;
};

}  // namespace mahlwerk::python
