// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <vector>

#include "job.hpp"
#include "mahlwerk/scene/collision.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::python {

/// Collision records that Python reads as bytes, without a copy. numpy makes an array of them
/// (mahlwerk/records.py). This module has no interface to numpy: its initialisation, which imports
/// numpy, would block threads that hold the interpreter's lock.
struct RecordBuffer {
  std::vector<scene::Collision> records;
};

void bind_records(pybind11::module_& m);

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
  /// `observe(buffer, replicate)`; `replicate` counts from 1.
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
