// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Services of the operating system that differ between POSIX and Windows. No other file of geomodel/ calls the system
/// directly. (The engine calls it once, for huge pages: core/src/common/pod_array.cpp.)
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace geomesh::geomodel {

/// Returns the memory in bytes of the machine, or of the container around this process if that is less; 0 if unknown.
std::size_t memory_of_machine();

struct ProcessUse {
  double cpu_seconds = 0;  ///< time of all threads of this process, in user and system mode
  std::size_t peak_bytes = 0;
};
ProcessUse use_of_this_process();

long id_of_this_process();
/// Returns false only if the system reports that no process has this id.
bool may_be_running(long process);

/// Returns an empty text if files can be created in the folder, else the system's reason for refusing.
std::string why_not_writable(const std::filesystem::path& folder);

/// Makes a file of the given size in bytes and reserves its disk space. Returns false without space or access.
bool make_file_of(const std::filesystem::path& file, std::size_t bytes);

/// Removes a file if it exists. Uses a call that is safe in a signal handler.
void remove_in_handler(const char* file) noexcept;

/// Loads a shared library from its file; returns null and sets `reason` on failure.
void* open_library(const std::filesystem::path& file, std::string& reason);
void* function_of_library(void* library, const char* name, std::string& reason);
void close_library(void* library);
/// Returns the path of the program or library that contains this code; empty if the system does not report it.
std::filesystem::path file_of_code(void (*code)());

}  // namespace geomesh::geomodel
