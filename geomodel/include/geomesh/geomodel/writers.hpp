// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes files safely: they are composed under a temporary name and then renamed, so that a file is complete or
/// absent. Mesh formats are in formats.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geomesh::geomodel {

/// Names under which an output file is composed and finally stored.
struct OutputTarget {
  std::filesystem::path file;  ///< the file that will hold the content: the target, if the name is a symbolic link
  std::filesystem::path
      temporary;  ///< name used while writing, unique to this process; `file` itself if that is a device or a pipe
  bool is_direct() const { return temporary == file; }
};

/// Throws Error{usage} if the name is that of a folder.
OutputTarget output_target(const std::filesystem::path& file);

/// Throws Error{usage} if the file cannot be written: its name is that of a folder, or its folder (the nearest existing
/// one, since missing ones are created) is not writable. Removes temporary files that killed runs left beside it
/// (NAME.PID.part).
void require_writable(const std::filesystem::path& file);

/// Registers a file that is being written, as long as this object lives, so that remove_files_being_written can remove
/// it. At most 64 files are registered at once; others are removed by the next run, which recognises them by name
/// (require_writable).
class FileBeingWritten {
 public:
  explicit FileBeingWritten(const std::filesystem::path& temporary);
  ~FileBeingWritten();
  FileBeingWritten(const FileBeingWritten&) = delete;
  FileBeingWritten& operator=(const FileBeingWritten&) = delete;

 private:
  void* place_ = nullptr;
};

/// Called by a signal handler before the process ends, so it neither allocates nor locks.
void remove_files_being_written() noexcept;

/// Calls `write(temporary path)` and renames the temporary to `file`; removes it if `write` throws. Devices and pipes
/// (/dev/stdout) are written directly.
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

/// Throws Error{usage} because the file cannot be written.
[[noreturn]] void refuse_to_write(const std::filesystem::path& file);

/// Writes a text file, which is complete or absent. Throws Error{usage} if it cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view content);

}  // namespace geomesh::geomodel
