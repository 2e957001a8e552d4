// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace mahlwerk::python {

/// Work that runs in a thread of its own without the interpreter's lock (GIL), while the calling
/// thread reports progress to Python and watches for Ctrl-C.
class Job {
 public:
  /// `stop` is set when the work must end: after Ctrl-C, or after an exception in Python.
  explicit Job(std::atomic<bool>& stop) : stop_(&stop) {}

  /// Tells the newest progress: `share` done, from 0 to 1 (NaN: not known), and a line of text. Any
  /// thread may call it.
  void progress(double share, std::string line);
  /// Keeps the first exception that Python code raised in a thread of the work, and ends the work.
  /// The caller holds the GIL.
  void fail(std::exception_ptr raised);

  /// Runs `work` and waits. `show(share, line)` is called with progress, unless it is None. The
  /// caller holds the GIL. Rethrows an exception of `work`, or the first one that Python code
  /// raised. Returns whether Ctrl-C stopped the work.
  bool run(const std::function<void()>& work, const pybind11::object& show);

  /// Whether Python code raised an exception.
  bool failed();
  void stop() { stop_->store(true); }

 private:
  void wait_for(std::thread& worker, const pybind11::object& show);
  void tell(const pybind11::object& show);
  void check_signals();
  void end(pybind11::error_already_set& raised);  // Ctrl-C, or an exception

  std::atomic<bool>* stop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false, interrupted_ = false;
  bool fresh_ = false;  // progress that has not been shown
  double share_ = 0;
  std::string line_;
  std::exception_ptr raised_;
};

/// Ends the work of all jobs and waits for it, for the end of the interpreter: a thread that waits
/// for a lock of an interpreter that has ended would end the process. The caller holds the GIL.
void stop_all_jobs();

}  // namespace mahlwerk::python
