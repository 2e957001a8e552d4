// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "job.hpp"

#include <chrono>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace mahlwerk::python {

namespace py = pybind11;

namespace {

std::mutex active_mutex;
std::condition_variable no_jobs;
std::set<Job*> active_jobs;

/// Enters a job in the list of active ones, as long as this object exists.
class ActiveJob {
 public:
  explicit ActiveJob(Job& job) : job_(&job) {
    const std::lock_guard lock(active_mutex);
    active_jobs.insert(job_);
  }
  ~ActiveJob() {
    const std::lock_guard lock(active_mutex);
    active_jobs.erase(job_);
    no_jobs.notify_all();
  }
  ActiveJob(const ActiveJob&) = delete;
  ActiveJob& operator=(const ActiveJob&) = delete;

 private:
  Job* job_;
};

}  // namespace

void Job::progress(double share, std::string line) {
  const std::lock_guard lock(mutex_);
  share_ = share;
  line_ = std::move(line);
  fresh_ = true;
}

void Job::fail(std::exception_ptr raised) {
  const std::lock_guard lock(mutex_);
  if (!raised_) raised_ = std::move(raised);
  stop_->store(true);
}

void Job::tell(const py::object& show) {
  std::string line;
  double share = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(fresh_, false) || show.is_none()) return;
    line = line_;
    share = share_;
  }
  try {
    show(share, line);
  } catch (py::error_already_set& raised) {
    end(raised);
  }
}

void Job::check_signals() {
  if (PyErr_CheckSignals() == 0) return;
  py::error_already_set raised;
  end(raised);
}

void Job::end(py::error_already_set& raised) {
  if (!raised.matches(PyExc_KeyboardInterrupt))
    return fail(std::make_exception_ptr(std::move(raised)));
  interrupted_ = true;
  stop_->store(true);
}

bool Job::failed() {
  const std::lock_guard lock(mutex_);
  return raised_ != nullptr;
}

void Job::wait_for(std::thread& worker, const py::object& show) {
  for (bool ended = false; !ended;) {
    {
      const py::gil_scoped_release free;
      std::unique_lock lock(mutex_);
      constexpr std::chrono::milliseconds between{50};
      ended = changed_.wait_for(lock, between, [&] { return ended_; });
    }
    check_signals();
    tell(show);
  }
  const py::gil_scoped_release free;
  worker.join();
}

bool Job::run(const std::function<void()>& work, const py::object& show) {
  const ActiveJob active(*this);
  std::exception_ptr thrown;
  const auto body = [&] {
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  };
  std::optional<std::thread> worker;
  try {
    worker.emplace(body);
  } catch (const std::system_error&) {  // the system has no more threads: this one works
    const py::gil_scoped_release free;
    body();
  }
  if (worker) wait_for(*worker, show);
  if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
  if (thrown) std::rethrow_exception(thrown);
  return interrupted_;
}

void stop_all_jobs() {
  const py::gil_scoped_release free;
  std::unique_lock lock(active_mutex);
  for (Job* job : active_jobs) job->stop();
  constexpr std::chrono::seconds patience{10};
  no_jobs.wait_for(lock, patience, [] { return active_jobs.empty(); });
}

}  // namespace mahlwerk::python
