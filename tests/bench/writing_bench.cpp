// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What it costs to write a mesh: processor and wall time beside those of triangulating its points, and the largest
/// memory above the mesh. `writing_bench [POINTS [FORMAT [COMPRESSION]]]`, by default 500000 vtu fast; writes into the
/// current folder and removes what it wrote.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "delaunay_inputs.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/geomodel/formats.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

constexpr unsigned seed = 42;

struct Clock {
  double cpu_s, wall_s;
};
Clock now() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const double cpu = static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
                     1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
  return {cpu, std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

/// Bytes of a line of /proc/self/status: VmRSS, VmHWM.
double memory(const std::string& line) {
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;)
    if (word == line + ":") {
      double kilobytes = 0;
      in >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// Two regions, west and east of the middle; no surfaces.
ModelMesh mesh_of(const std::vector<Vec3>& points, const DelaunayTetrahedralization& made) {
  ModelMesh mesh;
  mesh.name = "bench";
  mesh.points = points;
  mesh.point_kind.assign(points.size(), 0);
  mesh.input_vertex.assign(points.size(), 0);
  for (CellIndex c = 0; c < made.mesh.n_slots(); ++c) {
    if (!made.mesh.is_live(c) || made.mesh.is_ghost(c)) continue;
    const auto& v = made.mesh.vertices(c);
    mesh.tetrahedra.push_back({v[0], v[1], v[2], v[3]});
    mesh.tet_region.push_back(points[v[0]].x < 0.5 ? 1 : 2);
  }
  mesh.regions = {{1, "west", {}}, {2, "east", {}}};
  return mesh;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t n = argc > 1 ? static_cast<std::size_t>(std::atol(argv[1])) : 500000;
  const std::string format = argc > 2 ? argv[2] : "vtu", compression = argc > 3 ? argv[3] : "fast";
  const std::map<std::string, Compression> choices{
      {"none", Compression::none}, {"fast", Compression::fast}, {"small", Compression::small}};
  WriteOptions options;
  options.compression = choices.at(compression);
  const std::vector<Vec3> points = bench::make_points("uniform", n, seed);
  const Clock start = now();
  std::optional<DelaunayTetrahedralization> made = delaunay_tetrahedralization(points);
  const Clock meshed = now();
  const ModelMesh mesh = mesh_of(points, *made);
  made.reset();
  std::ofstream("/proc/self/clear_refs") << 5;  // the largest memory is that of now
  const double before = memory("VmRSS");
  const Clock begin = now();
  const auto files = write_format(mesh, format, std::filesystem::current_path() / "writing_bench", options);
  const Clock end = now();
  std::uintmax_t bytes = 0;
  for (const auto& file : files) bytes += std::filesystem::file_size(file);
  const double per = static_cast<double>(mesh.tetrahedra.size());
  std::printf("%s, compression %s: %zu tetrahedra\n", format.c_str(), compression.c_str(), mesh.tetrahedra.size());
  std::printf("triangulated: %.2f s CPU, %.2f s\n", meshed.cpu_s - start.cpu_s, meshed.wall_s - start.wall_s);
  std::printf("written:      %.2f s CPU, %.2f s, %.2f of the CPU time of triangulating\n", end.cpu_s - begin.cpu_s,
              end.wall_s - begin.wall_s, (end.cpu_s - begin.cpu_s) / (meshed.cpu_s - start.cpu_s));
  std::printf("memory above the mesh: %.1f bytes a tetrahedron; files: %.1f\n", (memory("VmHWM") - before) / per,
              static_cast<double>(bytes) / per);
  for (const auto& file : files) std::filesystem::remove(file);
}
