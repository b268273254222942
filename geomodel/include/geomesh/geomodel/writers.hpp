// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How files are written: beside the target and renamed, so that a file is complete or absent. Formats of meshes:
/// formats.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geomesh::geomodel {

/// Where an output file is composed before it gets its name.
struct OutputTarget {
  std::filesystem::path file;  ///< what will hold the content: where `file` is a symbolic link, what it points to
  std::filesystem::path
      temporary;  ///< beside `file`, of this process alone; `file` itself where that is a device or a pipe
  bool is_direct() const { return temporary == file; }
};

/// Throws Error{usage} where the name is a folder's.
OutputTarget output_target(const std::filesystem::path& file);

/// Throws Error{usage} where the file could not be written: its name is a folder's, or its folder (the nearest that is
/// there, as missing ones are made) may not be written to. Removes what killed runs left beside it (NAME.PID.part).
void require_writable(const std::filesystem::path& file);

/// Makes a file that is being written known to remove_files_being_written, as long as this object lives. At most 64
/// are known at once; others are left to the next run, which removes them by their names (require_writable).
class FileBeingWritten {
 public:
  explicit FileBeingWritten(const std::filesystem::path& temporary);
  ~FileBeingWritten();
  FileBeingWritten(const FileBeingWritten&) = delete;
  FileBeingWritten& operator=(const FileBeingWritten&) = delete;

 private:
  void* place_ = nullptr;
};

/// For a handler of signals that ends the process afterwards: it neither allocates nor locks.
void remove_files_being_written() noexcept;

/// Calls `write(temporary path)` and renames the temporary to `file`; removes it where `write` throws. Devices and
/// pipes (/dev/stdout) are written to as they are.
template <class F>
void write_complete_or_absent(const std::filesystem::path& file, F&& write) {
  const OutputTarget target = output_target(file);
  if (target.is_direct()) return write(target.file);
  const FileBeingWritten watched(target.temporary);
  try {
    write(target.temporary);
    std::filesystem::rename(target.temporary, target.file);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(target.temporary, ignored);
    throw;
  }
}

/// Throws Error{usage}: the file cannot be written.
[[noreturn]] void refuse_to_write(const std::filesystem::path& file);

/// A text file, complete or absent. Throws Error{usage} where it cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view content);

}  // namespace geomesh::geomodel
