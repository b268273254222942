// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes files safely: a file is composed under a temporary name and then renamed, so that it is either complete or
/// absent. The writers of mesh formats are in formats.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geomesh::geomodel {

/// Names under which an output file is composed and finally stored.
struct OutputTarget {
  /// The file that will hold the content; for a symbolic link, the file to which it points.
  std::filesystem::path file;
  std::filesystem::path
      temporary;  ///< name of the file while it is written, unique to this process; `file` itself for devices and pipes
  bool is_direct() const { return temporary == file; }
};

/// Returns the names under which a file is composed and finally stored. Throws Error{usage} if it is a folder.
OutputTarget output_target(const std::filesystem::path& file);

/// Throws Error{usage} if a file cannot be written because its name is that of a folder, or because its folder (or the
/// nearest existing parent, as missing folders are created) is not writable. Removes temporary files (NAME.PID.part)
/// that killed runs left beside it.
void require_writable(const std::filesystem::path& file);

/// Registers a file that is being written for the lifetime of this object, so that remove_files_being_written can
/// remove it. At most 64 files are registered at once. Files beyond these are removed by the next run, which recognises
/// them by name (require_writable).
class FileBeingWritten {
 public:
  explicit FileBeingWritten(const std::filesystem::path& temporary);
  ~FileBeingWritten();
  FileBeingWritten(const FileBeingWritten&) = delete;
  FileBeingWritten& operator=(const FileBeingWritten&) = delete;

 private:
  void* place_ = nullptr;
};

/// Removes the registered temporary files. Signal handlers may call this function: it neither allocates nor locks.
void remove_files_being_written() noexcept;

/// Calls `write` with a temporary path and then renames the temporary file to `file`; removes it if `write` throws.
/// Devices and pipes (/dev/stdout) are written directly.
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

/// Throws Error{usage} that explains why a file cannot be written.
[[noreturn]] void refuse_to_write(const std::filesystem::path& file);

/// Writes a text file, which is then either complete or absent. Throws Error{usage} if it cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view content);

}  // namespace geomesh::geomodel
