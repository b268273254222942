// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/module.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

namespace fs = std::filesystem;

void anchor() {}

/// The folder of the program, or of the shared library, that holds this code.
fs::path own_folder() {
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&anchor), &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  // The main program is named as it was called, which need not be a path.
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path named = fs::weakly_canonical(info.dli_fname, error);
  return (fs::exists(named, error) && named.has_parent_path() ? named : self).parent_path();
}

/// In the order of search.
std::vector<fs::path> plugin_folders() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("GEOMESH_PLUGINS")) {
    std::string_view rest = given;
    while (!rest.empty()) {
      const std::size_t colon = rest.find(':');
      if (colon != 0) folders.emplace_back(rest.substr(0, colon));
      rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
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

/// The table in the file, or null with the reason.
const void* load(const fs::path& file, const ModuleName& module, bool (*fits)(const void* table), std::string& reason) {
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  using Function = const void* (*)();
  const auto function = library ? reinterpret_cast<Function>(dlsym(library, module.function)) : nullptr;
  if (function && fits(function())) return function();
  const char* const error = function ? "it is of another version of geomesh" : dlerror();
  reason = error ? error : "no reason given";
  if (library) dlclose(library);
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
