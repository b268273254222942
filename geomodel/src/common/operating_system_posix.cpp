// SPDX-License-Identifier: GPL-3.0-or-later
// Implements operating_system.hpp on Linux, macOS and other POSIX systems.
#ifndef _WIN32
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "common/operating_system.hpp"

namespace geomesh::geomodel {

namespace fs = std::filesystem;

std::size_t memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  std::size_t bytes = pages > 0 && page > 0 ? static_cast<std::size_t>(pages) * static_cast<std::size_t>(page) : 0;
  std::size_t of_container = 0;
  // without a memory limit, the container's file contains the text "max" instead of a number
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_container)
    bytes = bytes == 0 ? of_container : std::min(bytes, of_container);
  return bytes;
}

ProcessUse use_of_this_process() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;  // Linux counts kilobytes
#endif
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<std::size_t>(usage.ru_maxrss) * unit};
}

long id_of_this_process() { return getpid(); }

bool may_be_running(long process) { return kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH; }

void remove_in_handler(const char* file) noexcept { unlink(file); }

std::string why_not_writable(const fs::path& folder) {
  return access(folder.c_str(), W_OK | X_OK) == 0 ? std::string() : std::strerror(errno);
}

bool make_file_of(const fs::path& file, std::size_t bytes) {
  constexpr mode_t readable_by_all = 0666;  // read and write permissions for all, reduced by the user's umask
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable_by_all);
  if (descriptor < 0) return false;
#if defined(_POSIX_ADVISORY_INFO) && _POSIX_ADVISORY_INFO > 0
  const int status = posix_fallocate(descriptor, 0, static_cast<off_t>(bytes));
#else  // Without posix_fallocate, as on macOS, the length is set without reserving space.
  const int status = ftruncate(descriptor, static_cast<off_t>(bytes));
#endif
  return close(descriptor) == 0 && status == 0;
}

void* open_library(const fs::path& file, std::string& reason) {
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    if (const char* const error = dlerror()) reason = error;
  return library;
}

void* function_of_library(void* library, const char* name, std::string& reason) {
  void* const function = dlsym(library, name);
  if (!function)
    if (const char* const error = dlerror()) reason = error;
  return function;
}

void close_library(void* library) { dlclose(library); }

fs::path file_of_code(void (*code)()) {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(code), &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  const fs::path named = fs::weakly_canonical(info.dli_fname, error);
  if (fs::exists(named, error) && named.has_parent_path()) return named;
  // For the main program, dladdr returns the command that started it, which need not be a path.
  return fs::read_symlink("/proc/self/exe", error);
}

}  // namespace geomesh::geomodel
#endif
