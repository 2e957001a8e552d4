// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A library to preload (LD_PRELOAD) that makes the n-th call of a kind fail, or raises a signal at
// it. glibc on Linux.
//
//   MAHLWERK_FAULT=write:17:28        the 17th call fails with errno 28, once
//   MAHLWERK_FAULT=write:17:28:stays  so do all later ones: a disk that stays full
//   MAHLWERK_FAULT=open:3:signal:15   the signal 15 is raised before the third call
//   MAHLWERK_FAULT_LOG=FILE           gets the failed call, and at the end the number of all calls
//   MAHLWERK_FAULT_TRACE=1            prints the functions that made the failed call
//   MAHLWERK_FAULT_WAIT=1             calls count from mahlwerk_fault_begin() on, not from main()
//
// Kinds: open, write, sync, rename, make (a folder), mmap, malloc, thread. What is written to
// standard error is not counted: the messages of the program are what a test reads. Of the
// allocations those count that the program makes itself, or through the C++ library, SQLite or the
// other libraries below: HDF5 1.10 crashes without memory, and the directory iterators of libstdc++
// end the program, so that the next allocation fails instead.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "chosen_fault.hpp"

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

using namespace faults;

template <class Function>
Function* real(const char* name) {
  void* const found = dlsym(RTLD_NEXT, name);
  Function* function = nullptr;
  std::memcpy(&function, &found, sizeof function);
  return function;
}

bool is_message(std::FILE* stream) {
  return stream == stderr || fileno(stream) == STDERR_FILENO;
}

/// Sets the error of a stream, as a failed write does; glibc has no function for it.
void set_error(std::FILE* stream) {
  constexpr int io_err_seen = 0x20;
  stream->_flags |= io_err_seen;
}

using Main = int(int, char**, char**);
Main* program = nullptr;

int main_of_program(int argc, char** argv, char** environment) {
  if (std::getenv("MAHLWERK_FAULT_WAIT") == nullptr) begin_to_count();
  return program(argc, argv, environment);
}

struct Report {
  Report() {
    read_environment();
    unsetenv("LD_PRELOAD");  // a program that is started is none under test
  }
  ~Report() {
    end_counting();
    log_calls();
  }
} report;

}  // namespace

#define EXPORT __attribute__((visibility("default")))

extern "C" {

EXPORT void mahlwerk_fault_begin() {
  begin_to_count();
}
EXPORT void mahlwerk_fault_end() {
  end_counting();
}

EXPORT int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(),
                             void (*rtld_fini)(), void* stack_end) {
  using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
  program = main;
  return real<Start>("__libc_start_main")(main_of_program, argc, argv, init, fini, rtld_fini,
                                          stack_end);
}

// --- open

static int open_at(int folder, const char* path, int flags, std::va_list rest) {
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  if (fails(file_open, path)) return -1;
  return static_cast<int>(syscall(SYS_openat, folder, path, flags | O_LARGEFILE, mode));
}
#define OPEN(name)                                         \
  EXPORT int name(const char* path, int flags, ...) {      \
    std::va_list rest;                                     \
    va_start(rest, flags);                                 \
    const int file = open_at(AT_FDCWD, path, flags, rest); \
    va_end(rest);                                          \
    return file;                                           \
  }
OPEN(open)
OPEN(open64)
#define OPENAT(name)                                              \
  EXPORT int name(int folder, const char* path, int flags, ...) { \
    std::va_list rest;                                            \
    va_start(rest, flags);                                        \
    const int file = open_at(folder, path, flags, rest);          \
    va_end(rest);                                                 \
    return file;                                                  \
  }
OPENAT(openat)
OPENAT(openat64)

EXPORT std::FILE* fopen(const char* path, const char* mode) {
  static auto* const next = real<std::FILE*(const char*, const char*)>("fopen");
  return fails(file_open, path) ? nullptr : next(path, mode);
}
EXPORT std::FILE* fopen64(const char* path, const char* mode) {
  static auto* const next = real<std::FILE*(const char*, const char*)>("fopen64");
  return fails(file_open, path) ? nullptr : next(path, mode);
}
EXPORT DIR* opendir(const char* path) {
  static auto* const next = real<DIR*(const char*)>("opendir");
  return fails(file_open, path) ? nullptr : next(path);
}

// --- write

static const char* name_of(int file) {
  static thread_local std::array<char, 300> name;
  std::array<char, 40> link{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  const long length = syscall(SYS_readlinkat, AT_FDCWD, link.data(), name.data(), name.size() - 1);
  name[length > 0 ? static_cast<unsigned long>(length) : 0] = '\0';
  return name.data();
}
/// The name is found only for the call that fails.
static bool write_fails(int file) {
  return file != STDERR_FILENO && fails(file_write, is_next(file_write) ? name_of(file) : "");
}

EXPORT ssize_t write(int file, const void* bytes, std::size_t count) {
  if (write_fails(file)) return -1;
  return syscall(SYS_write, file, bytes, count);
}
EXPORT ssize_t writev(int file, const iovec* parts, int count) {
  if (write_fails(file)) return -1;
  return syscall(SYS_writev, file, parts, count);
}
EXPORT ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t at) {
  if (write_fails(file)) return -1;
  return syscall(SYS_pwrite64, file, bytes, count, at);
}
EXPORT ssize_t pwrite64(int file, const void* bytes, std::size_t count, off64_t at) {
  if (write_fails(file)) return -1;
  return syscall(SYS_pwrite64, file, bytes, count, at);
}
EXPORT int ftruncate64(int file, off64_t size) {
  if (write_fails(file)) return -1;
  return static_cast<int>(syscall(SYS_ftruncate, file, size));
}
EXPORT int ftruncate(int file, off_t size) {
  return ftruncate64(file, size);
}
EXPORT int fallocate64(int file, int mode, off64_t at, off64_t size) {
  if (write_fails(file)) return -1;
  return static_cast<int>(syscall(SYS_fallocate, file, mode, at, size));
}
EXPORT int fallocate(int file, int mode, off_t at, off_t size) {
  return fallocate64(file, mode, at, size);
}
EXPORT std::size_t fwrite(const void* bytes, std::size_t size, std::size_t count,
                          std::FILE* stream) {
  static auto* const next =
      real<std::size_t(const void*, std::size_t, std::size_t, std::FILE*)>("fwrite");
  if (is_message(stream) || !write_fails(fileno(stream))) return next(bytes, size, count, stream);
  set_error(stream);
  return 0;
}
EXPORT int fflush(std::FILE* stream) {
  static auto* const next = real<int(std::FILE*)>("fflush");
  if (stream == nullptr || is_message(stream) || !write_fails(fileno(stream))) return next(stream);
  set_error(stream);
  return EOF;
}

// --- sync, rename, folders

EXPORT int fsync(int file) {
  return fails(file_sync, "") ? -1 : static_cast<int>(syscall(SYS_fsync, file));
}
EXPORT int fdatasync(int file) {
  return fails(file_sync, "") ? -1 : static_cast<int>(syscall(SYS_fdatasync, file));
}
EXPORT int rename(const char* from, const char* to) noexcept {
  if (fails(file_rename, to)) return -1;
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
EXPORT int mkdir(const char* path, mode_t mode) noexcept {
  return fails(folder_make, path) ? -1
                                  : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

// --- memory and threads

static bool memory_fails(const void* caller) {
  return is_counted(caller) && fails(memory);
}

EXPORT void* mmap64(void* at, std::size_t size, int rights, int flags, int file,
                    off64_t offset) noexcept {
  if (fails(map)) return MAP_FAILED;
  const long made = syscall(SYS_mmap, at, size, rights, flags, file, offset);
  void* address = nullptr;
  std::memcpy(&address, &made, sizeof address);
  return address;
}
EXPORT void* mmap(void* at, std::size_t size, int rights, int flags, int file,
                  off_t offset) noexcept {
  return mmap64(at, size, rights, flags, file, offset);
}
EXPORT void* malloc(std::size_t size) {
  return memory_fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}
EXPORT void* calloc(std::size_t count, std::size_t size) {
  return memory_fails(__builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}
EXPORT void* realloc(void* old, std::size_t size) {
  return memory_fails(__builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}
EXPORT void* aligned_alloc(std::size_t align, std::size_t size) {
  return memory_fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(align, size);
}
EXPORT int posix_memalign(void** place, std::size_t align, std::size_t size) {
  if (memory_fails(__builtin_return_address(0))) return ENOMEM;
  *place = __libc_memalign(align, size);
  return *place == nullptr ? ENOMEM : 0;
}
EXPORT int pthread_create(pthread_t* made, const pthread_attr_t* attributes, void* (*begin)(void*),
                          void* argument) {
  using Create = int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static auto* const next = real<Create>("pthread_create");
  return fails(thread) ? errno : next(made, attributes, begin, argument);
}

}  // extern "C"
