// SPDX-License-Identifier: GPL-3.0-or-later
// Where a file may be written, found out before hours are spent on what goes into it.
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(ErrorKind::usage, "cannot write " + file.string() + ": " + why);
}

/// The folder itself, or the nearest one above it that is there: where missing folders would be made.
fs::path nearest_existing(fs::path folder) {
  std::error_code ec;
  while (!fs::exists(folder, ec) && folder.has_parent_path() && folder.parent_path() != folder)
    folder = folder.parent_path();
  return fs::exists(folder, ec) ? folder : fs::path(".");
}

}  // namespace

OutputTarget output_target(const fs::path& file) {
  std::error_code ec, ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) refuse(file, "it is a folder; give the name of a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) return {file, file};
  fs::path real = file;
  if (fs::is_symlink(fs::symlink_status(file, ignored))) real = fs::weakly_canonical(file, ec);
  if (ec) refuse(file, ec.message());
  return {real, real.string() + "." + std::to_string(getpid()) + ".part"};
}

void require_writable(const fs::path& file) {
  const OutputTarget target = output_target(file);
  if (target.is_direct()) return;
  const fs::path folder = nearest_existing(fs::absolute(target.file).parent_path());
  if (!fs::is_directory(folder)) refuse(file, folder.string() + " is a file, not a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse(file, "the folder " + folder.string() + ": " + std::strerror(errno) + "; choose another with -o");
}

}  // namespace geomesh::geomodel
