// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/module.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/operating_system.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

namespace fs = std::filesystem;

void anchor() {}

/// Returns the folder of the program, or of the shared library, that contains this code.
fs::path own_folder() { return file_of_code(&anchor).parent_path(); }

#ifdef _WIN32
constexpr char between_folders = ';';  // separates folders in GEOMESH_PLUGINS; on Windows paths contain colons
#else
constexpr char between_folders = ':';
#endif

std::vector<fs::path> plugin_folders() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("GEOMESH_PLUGINS")) {
    std::string_view rest = given;
    while (!rest.empty()) {
      const std::size_t end = rest.find(between_folders);
      if (end != 0) folders.emplace_back(rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  const fs::path own = own_folder();
  if (!own.empty()) {
    folders.push_back(own);
    folders.push_back(own / ".." / GEOMESH_PLUGIN_FOLDER_FROM_BIN);
    folders.push_back(own / "../../../.." /
                      GEOMESH_PLUGIN_FOLDER_FROM_BIN);  // PREFIX/lib/python3/dist-packages/geomesh
  }
  folders.emplace_back(GEOMESH_PLUGIN_FOLDER);
  return folders;
}

std::string listed(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) text += (text.empty() ? "" : ", ") + folder.lexically_normal().string();
  return text;
}

/// Loads a module from a file and returns its table, or null and the reason.
const void* load(const fs::path& file, const ModuleName& module, bool (*fits)(const void* table), std::string& reason) {
  reason = "no reason given";
  void* const library = open_library(file, reason);
  if (!library) return nullptr;
  using Function = const void* (*)();
  const auto function = reinterpret_cast<Function>(function_of_library(library, module.function, reason));
  if (function && fits(function())) return function();
  if (function) reason = "it is of another version of geomesh";
  close_library(library);
  return nullptr;
}

}  // namespace

const char* module_version() { return GEOMESH_MODULE_VERSION; }

const void* module_table(const ModuleName& module, bool (*fits)(const void* table)) {
  const std::vector<fs::path> folders = plugin_folders();
  std::string reasons;
  for (const fs::path& folder : folders) {
    const fs::path file = folder / module.file;
    std::error_code error;
    if (!fs::exists(file, error)) continue;
    std::string reason;
    if (const void* const table = load(file, module, fits, reason)) return table;
    reasons += "; " + file.lexically_normal().string() + " cannot be used: " + reason;
  }
  throw Error(ErrorKind::usage,
              std::string(module.purpose) + " a module of its own, " + module.file + ", in the package " +
                  module.package + " (apt install " + module.package + "; built from source: apt install " +
                  module.headers +
                  ", or all by ./scripts/install-packages build full, and build again). It was looked for in " +
                  listed(folders) + "; GEOMESH_PLUGINS names other folders" + reasons);
}

}  // namespace geomesh::geomodel
