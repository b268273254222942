// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tests ask here what this machine has: modules built beside the test program, and programs that read its files back.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#ifndef _WIN32
#include <sys/wait.h>
#endif

namespace geomesh::geomodel::testing {

/// `name`: gdal, proj ...
inline bool has_module(const std::string& name) {
  std::error_code error;
  return std::filesystem::exists(
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / ("geomesh-" + name + ".so"), error);
}

/// Exit codes: of a shell that does not find a program, and of read_back.py if its reader is not installed.
constexpr int no_program = 127, no_reader = 77;

/// Runs the command in a shell of POSIX; returns its exit code, or -1 if a signal ended it.
inline int exit_code_of([[maybe_unused]] const std::string& command) {
#ifdef _WIN32
  return no_program;
#else
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
#endif
}

}  // namespace geomesh::geomodel::testing
