// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The few services of the operating system that differ between POSIX and Windows. Nothing else in geomodel/ calls the
/// system directly. (The engine calls it once, for huge pages: core/src/common/pod_array.cpp.)
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace geomesh::geomodel {

/// Memory of the machine, or of the container around this process where that is less. 0: the system does not say.
std::size_t memory_of_machine();

struct ProcessUse {
  double cpu_seconds = 0;  ///< of all threads, in the program and in the system
  std::size_t peak_bytes = 0;
};
ProcessUse use_of_this_process();

long id_of_this_process();
/// False only where the system says that there is no such process.
bool may_be_running(long process);

/// Empty where files can be made in the folder, else the system's reason.
std::string why_not_writable(const std::filesystem::path& folder);

/// Makes a file of that many bytes whose room on the disk is taken. False where there is no room or no access.
bool make_file_of(const std::filesystem::path& file, std::size_t bytes);

/// Removes a file, if it is there, by a call that a handler of signals may make.
void remove_in_handler(const char* file) noexcept;

/// A library loaded by its file: null, with the system's reason, where that fails.
void* open_library(const std::filesystem::path& file, std::string& reason);
/// Null where the library has no function of that name.
void* function_of_library(void* library, const char* name, std::string& reason);
void close_library(void* library);
/// The program or library that holds this code, as the system names it; empty where it does not say.
std::filesystem::path file_of_code(void (*code)());

}  // namespace geomesh::geomodel
