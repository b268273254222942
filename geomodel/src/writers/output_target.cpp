// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether a file can be written, before hours are spent on its contents.
#include <charconv>
#include <string_view>

#include "common/operating_system.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(ErrorKind::usage, "cannot write " + file.string() + ": " + why);
}

/// Returns the folder if it exists, else the nearest existing folder above it, in which the folder would be created.
fs::path nearest_existing(fs::path folder) {
  std::error_code ec;
  while (!fs::exists(folder, ec) && folder.has_parent_path() && folder.parent_path() != folder)
    folder = folder.parent_path();
  return fs::exists(folder, ec) ? folder : fs::path(".");
}

constexpr std::string_view part_end = ".part";

/// Returns the id of the process that wrote a temporary file with a name such as "dome.vtu.1234.part"; 0 if the name
/// has another form.
long writer_of(std::string_view name) {
  if (!name.ends_with(part_end)) return 0;
  name.remove_suffix(part_end.size());
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return 0;
  const char *const first = name.data() + dot + 1, *const last = name.data() + name.size();
  long pid = 0;
  const auto [end, status] = std::from_chars(first, last, pid);
  return status == std::errc() && end == last && pid > 0 ? pid : 0;
}

/// Removes temporary files that killed runs left while they were writing a file with the same stem. Those of running
/// processes are kept.
void remove_left_parts(const fs::path& file) {
  std::error_code ec;
  const std::string start = file.stem().string() + ".";
  for (fs::directory_iterator entry(file.parent_path(), ec), end; !ec && entry != end; entry.increment(ec)) {
    const std::string name = entry->path().filename().string();
    const long writer = name.starts_with(start) ? writer_of(name) : 0;
    if (writer > 0 && !may_be_running(writer)) {
      std::error_code ignored;
      fs::remove_all(entry->path(), ignored);
    }
  }
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
  return {real, real.string() + "." + std::to_string(id_of_this_process()) + std::string(part_end)};
}

void require_writable(const fs::path& file) {
  const OutputTarget target = output_target(file);
  if (target.is_direct()) return;
  const fs::path folder = nearest_existing(fs::absolute(target.file).parent_path());
  if (!fs::is_directory(folder)) refuse(file, folder.string() + " is a file, not a folder");
  if (const std::string reason = why_not_writable(folder); !reason.empty())
    refuse(file, "the folder " + folder.string() + ": " + reason + "; choose another with -o");
  remove_left_parts(fs::absolute(target.file));
}

}  // namespace geomesh::geomodel
