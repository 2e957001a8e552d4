// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "chosen_fault.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace faults {
namespace {

constexpr std::array<const char*, kinds> names{"open", "write", "sync",   "rename",
                                               "make", "mmap",  "malloc", "thread"};

std::array<std::atomic<long>, kinds> calls{};
std::atomic<bool> counts{false};
int chosen = kinds, error_number = 0, signal_number = 0;
long at_call = 0;
bool stays = false;

/// Writes to the log without any function of this file.
void log(const char* text) {
  const char* name = std::getenv("MAHLWERK_FAULT_LOG");
  if (name == nullptr) return;
  const long file = syscall(SYS_openat, AT_FDCWD, name, O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (file < 0) return;
  syscall(SYS_write, file, text, std::strlen(text));
  syscall(SYS_close, file);
}

void log_fault(int kind, long call, const char* what) {
  std::array<char, 600> line{};
  std::snprintf(line.data(), line.size(), "fault %s %ld %s\n", names[static_cast<unsigned>(kind)],
                call, what);
  log(line.data());
}

/// Code whose allocations count.
struct Range {
  std::uintptr_t begin = 0, end = 0;
};
std::array<Range, 16> counted{};

/// Notes the code of a loaded object, if its allocations count.
int note_code(dl_phdr_info* object, std::size_t, void* number) {
  constexpr std::array<const char*, 5> libraries{"libstdc++", "libsqlite3", "libfmt",
                                                 "libtomlplusplus", "/_core."};
  auto& made = *static_cast<unsigned*>(number);
  const char* name = object->dlpi_name;
  bool counts_here = name[0] == '\0' && std::getenv("MAHLWERK_FAULT_WAIT") == nullptr;
  for (const char* library : libraries)
    counts_here = counts_here || std::strstr(name, library) != nullptr;
  for (int k = 0; counts_here && k < object->dlpi_phnum && made < counted.size(); ++k)
    if (const auto& part = object->dlpi_phdr[k]; part.p_type == PT_LOAD && (part.p_flags & PF_X)) {
      const std::uintptr_t begin = object->dlpi_addr + part.p_vaddr;
      counted[made++] = {begin, begin + part.p_memsz};
    }
  return 0;
}

bool in_directory_iterator() {
  std::array<void*, 40> places{};
  counts = false;
  const int depth = backtrace(places.data(), places.size());
  bool found = false;
  for (int k = 0; k < depth; ++k) {
    Dl_info place{};
    found = found ||
            (dladdr(places[static_cast<unsigned>(k)], &place) != 0 && place.dli_sname != nullptr &&
             std::strstr(place.dli_sname, "directory_iterator") != nullptr);
  }
  counts = true;
  return found;
}

void print_trace() {
  std::array<void*, 60> places{};
  counts = false;
  std::array<char, 40> line{};
  const int length = std::snprintf(line.data(), line.size(), "code at %lx\n", counted[0].begin);
  syscall(SYS_write, STDERR_FILENO, line.data(), length);
  backtrace_symbols_fd(places.data(), backtrace(places.data(), places.size()), STDERR_FILENO);
  counts = true;
}

}  // namespace

void begin_to_count() {
  unsigned number = 0;
  dl_iterate_phdr(note_code, &number);
  counts = true;
}

bool is_counted(const void* caller) {
  if (!counts.load(std::memory_order_relaxed)) return false;
  const auto place = reinterpret_cast<std::uintptr_t>(caller);
  for (const Range& code : counted)
    if (place >= code.begin && place < code.end) return true;
  return false;
}

bool fails(Kind kind, const char* what) {
  if (!counts.load(std::memory_order_relaxed)) return false;
  const long call = ++calls[kind];
  if (kind != chosen || call < at_call || (call > at_call && !stays)) return false;
  if (kind == memory && call == at_call && in_directory_iterator()) {
    ++at_call;
    return false;
  }
  if (call == at_call) log_fault(kind, call, what);
  if (call == at_call && std::getenv("MAHLWERK_FAULT_TRACE") != nullptr) print_trace();
  if (signal_number != 0) {
    if (call == at_call) std::raise(signal_number);
    return false;
  }
  errno = error_number;
  return true;
}

void read_environment() {
  const char* text = std::getenv("MAHLWERK_FAULT");
  if (text == nullptr) return;
  std::array<char, 16> kind{}, rest{};
  if (std::sscanf(text, "%15[a-z]:%ld:signal:%d", kind.data(), &at_call, &signal_number) < 3) {
    signal_number = 0;
    if (std::sscanf(text, "%15[a-z]:%ld:%d:%15s", kind.data(), &at_call, &error_number,
                    rest.data()) < 3)
      return;
  }
  stays = std::strcmp(rest.data(), "stays") == 0;
  for (int k = 0; k < kinds; ++k)
    if (std::strcmp(kind.data(), names[static_cast<unsigned>(k)]) == 0) chosen = k;
}

void end_counting() {
  counts = false;
}

bool is_next(Kind kind) {
  return chosen == kind && calls[kind] + 1 == at_call;
}

void log_calls() {
  std::array<char, 400> text{};
  int length = 0;
  for (unsigned k = 0; k < kinds; ++k)
    length += std::snprintf(text.data() + length, text.size() - static_cast<unsigned>(length),
                            "%s %ld\n", names[k], calls[k].load());
  log(text.data());
}

}  // namespace faults
