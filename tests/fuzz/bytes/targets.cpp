// SPDX-License-Identifier: GPL-3.0-or-later
#include "targets.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "arrange_target.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace fuzz_bytes {
namespace {

/// A folder of this process alone, in memory where the system has such a place; gone at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto place = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path_ = place / ("geomesh_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Returns the file.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Beside it stands what the target `names` reads.
constexpr std::string_view tetrahedron =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"top\"\n3 1 \"rock\"\n$EndPhysicalNames\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 4 2 1 1 1 2 3 4\n"
    "$EndElements\n";

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
  } else if (target == "convert" || target == "names") {
    read_model_mesh(file);
  } else {
    throw std::invalid_argument("no target is named " + std::string(target));
  }
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"project", {".yaml"}},
                                       {"surfaces",
                                        {".ts", ".pl", ".ml", ".off", ".obj", ".stl", ".ply", ".vtp", ".vtu", ".vtk",
                                         ".poly", ".smesh", ".dxf", ".asc", ".grd", ".xyz", ".csv"}},
                                       {"meshes", {".vtu", ".vtk", ".msh", ".inp", ".mesh", ".pvtu", ".e"}},
                                       {"convert", {".msh", ".inp", ".vtu", ".mesh", ".pvtu"}},
                                       {"names", {".json"}},
                                       {"arrange", {".bin"}}};
  return all;
}

Verdict run(std::string_view target, const std::string& extension, const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (target == "arrange") {
      arrange_and_recover(data, size);
      return Verdict::taken;
    }
    const ScratchFolder folder;
    if (target == "names") {
      folder.write("fuzzed.msh.json", bytes);
      hand_over(target, folder.write("fuzzed.msh", tetrahedron));
    } else {
      hand_over(target, folder.write("fuzzed" + extension, bytes));
    }
    return Verdict::taken;
  } catch (const geomesh::Error&) {
    return Verdict::refused;
  }
}

}  // namespace fuzz_bytes
