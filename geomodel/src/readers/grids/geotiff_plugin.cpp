// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/grids/geotiff_plugin.hpp"

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

/// Where the module may lie, in the order of search: GEOMESH_PLUGINS (folders parted by colons), beside the program or
/// the Python module, in the libraries' folder of the same prefix; where it was to be installed.
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

const GeomeshRasterReader& load() {
  const std::vector<fs::path> folders = plugin_folders();
  std::string reasons;
  for (const fs::path& folder : folders) {
    const fs::path file = folder / geotiff_plugin_file;
    std::error_code error;
    if (!fs::exists(file, error)) continue;
    void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    using Function = const GeomeshRasterReader* (*)();
    const auto function = module ? reinterpret_cast<Function>(dlsym(module, geotiff_plugin_function)) : nullptr;
    if (function && function()->version == geomesh_raster_reader_version) return *function();
    const char* const reason = function ? "it is of another version of geomesh" : dlerror();
    reasons += "; " + file.lexically_normal().string() + " cannot be used: " + (reason ? reason : "no reason given");
    if (module) dlclose(module);
  }
  throw Error(ErrorKind::usage, std::string("GeoTIFF is read by a module of its own, ") + geotiff_plugin_file +
                                    ", in the package geomesh-gdal (apt install geomesh-gdal). It was looked for in " +
                                    listed(folders) + "; GEOMESH_PLUGINS names other folders" + reasons);
}

}  // namespace

const GeomeshRasterReader& geotiff_plugin() {
  static const GeomeshRasterReader& reader = load();  // after a throw the next call tries again
  return reader;
}

}  // namespace geomesh::geomodel
