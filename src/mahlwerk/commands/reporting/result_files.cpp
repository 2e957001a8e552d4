// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/result_files.hpp"

#include <filesystem>
#include <new>
#include <system_error>

#include "mahlwerk/commands/reporting/messages.hpp"

namespace mahlwerk::commands {

std::vector<Fault> faults_of_system(const std::exception_ptr& thrown) try {
  std::rethrow_exception(thrown);
} catch (const InputError& e) {
  return e.faults();
} catch (const std::filesystem::filesystem_error& e) {
  return {{e.path1().string(), e.code().message(),
           "check this place, the free disk space and your permissions, then start again",
           "system-error"}};
} catch (const std::system_error& e) {
  return {{"the operating system", e.what(),
           "check the limits of open files, processes and memory (ulimit -a), then start again",
           "system-error"}};
} catch (const std::bad_alloc&) {
  return {{"", "there is not enough memory for this case",
           "use fewer balls, or fewer replicates at a time (--threads)", "not-enough-memory"}};
}

std::vector<Fault> write_result(const std::function<void()>& write) try {
  write();
  return {};
} catch (...) {
  return faults_of_system(std::current_exception());
}

int print_result(const std::function<void()>& print, const std::vector<Fault>& unwritten,
                 int ended) {
  try {
    print();
  } catch (...) {
    if (!unwritten.empty()) report_end(bad_input, unwritten);
    throw;
  }
  return unwritten.empty() ? ended : report_end(bad_input, unwritten);
}

}  // namespace mahlwerk::commands
