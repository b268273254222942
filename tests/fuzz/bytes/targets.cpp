// SPDX-License-Identifier: GPL-3.0-or-later
#include "targets.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace fuzz_bytes {
namespace {

/// A file of this process alone, in memory where the system has such a folder; gone at the end.
class ScratchFile {
 public:
  ScratchFile(const std::string& extension, const std::uint8_t* data, std::size_t size) {
    const std::filesystem::path memory = "/dev/shm";
    const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path_ = folder / ("geomesh_fuzz_" + std::to_string(getpid()) + extension);
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void hand_over(std::string_view target, const std::filesystem::path& file) {
  using namespace geomesh::geomodel;
  if (target == "project") {
    read_project(file);
  } else if (target == "surfaces") {
    const auto extension = file.extension();
    if (extension == ".poly" || extension == ".smesh") {
      read_plc_file(file);
    } else {
      read_surface_file(file);
    }
  } else if (target == "meshes") {
    CheckRequest request;
    request.mesh = file;
    check_mesh(request);
  } else {
    throw std::invalid_argument("no target is named " + std::string(target));
  }
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"project", {".yaml"}},
                                       {"surfaces",
                                        {".ts", ".pl", ".ml", ".off", ".obj", ".stl", ".ply", ".vtp", ".poly", ".smesh",
                                         ".dxf", ".asc", ".grd", ".xyz", ".csv"}},
                                       {"meshes", {".vtu", ".vtk", ".msh", ".inp"}}};
  return all;
}

Verdict run(std::string_view target, const std::string& extension, const std::uint8_t* data, std::size_t size) {
  const ScratchFile file(extension, data, size);
  try {
    hand_over(target, file.path());
    return Verdict::taken;
  } catch (const geomesh::Error&) {
    return Verdict::refused;
  }
}

}  // namespace fuzz_bytes
