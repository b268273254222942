// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What it costs to write a mesh: processor and wall time beside those of triangulating its points, and the largest
/// memory above the mesh. `writing_bench [POINTS [FORMAT [COMPRESSION]]]`, by default 500000 vtu fast; writes into the
/// current folder and removes what it wrote. `writing_bench --table PROJECT SIZE`: a Markdown table of all formats,
/// beside a whole run of the project at that size. Grids of Voronoi cells need a Delaunay mesh: they are written of
/// points near those of a lattice, with about as many tetrahedra.
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <random>
#include <string>

#include "delaunay_inputs.hpp"
#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/pipeline.hpp"

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

ModelMesh triangulated(const std::vector<Vec3>& points) { return mesh_of(points, delaunay_tetrahedralization(points)); }

struct Written {
  double cpu_s, wall_s, memory, file_bytes;
};
/// Memory is the largest above what is in use before: what was free is given back first.
Written write(const ModelMesh& mesh, const std::string& format, const WriteOptions& options) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // the largest memory is that of now
  const double before = memory("VmRSS");
  const Clock begin = now();
  const auto files = write_format(mesh, format, std::filesystem::current_path() / "writing_bench", options);
  const Clock end = now();
  Written written{end.cpu_s - begin.cpu_s, end.wall_s - begin.wall_s, memory("VmHWM") - before, 0};
  for (const auto& file : files) {
    written.file_bytes += static_cast<double>(std::filesystem::file_size(file));
    std::filesystem::remove(file);
  }
  return written;
}

/// Points of a lattice, those inside moved by up to a fifth of its width: no cell of theirs is beyond the boundary.
std::vector<Vec3> near_lattice(std::size_t n) {
  const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(n))));
  std::mt19937_64 random(seed);
  const double width = 1.0 / side;
  const auto place = [&](int i) {
    const bool is_inside = i > 0 && i + 1 < side;
    return width * (i + (is_inside ? 0.4 * (static_cast<double>(random() >> 11) / 9007199254740992.0 - 0.5) : 0.0));
  };
  std::vector<Vec3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) {
        const double x = place(i), y = place(j);
        points.push_back({x, y, place(k)});
      }
  return points;
}

bool is_dual(const std::string& format) { return format == "pflotran-explicit" || format == "tough"; }

void print_row(const std::string& format, const ModelMesh& mesh, const Written& written, double run_cpu_s) {
  const auto n = static_cast<double>(mesh.tetrahedra.size());
  std::printf("| `%s` | %.2f | %.1f | %.1f | %.3f |\n", format.c_str(), 1e6 * written.cpu_s / n, written.memory / n,
              written.file_bytes / n, written.cpu_s / n / run_cpu_s);
  std::fflush(stdout);
}

void print_table(const std::string& project, double size) {
  ProjectRequest request;
  request.project = read_project(project);
  request.project.mesh.refinement.refine = true;
  request.project.mesh.refinement.derive_size = false;
  request.project.mesh.refinement.size.base.global = size;
  request.outputs = ProjectRequest::Outputs::kept;
  const Clock start = now();
  const ModelMesh mesh = run_project(request, {}).mesh;
  const double run_cpu_s = (now().cpu_s - start.cpu_s) / static_cast<double>(mesh.tetrahedra.size());
  std::printf("%zu tetrahedra, a run takes %.1f CPU s a million\n\n", mesh.tetrahedra.size(), 1e6 * run_cpu_s);
  std::printf("| format | CPU s a million | bytes a tetrahedron above the mesh | bytes in files | part of a run |\n");
  std::printf("|---|---|---|---|---|\n");
  const std::size_t tetrahedra_a_point = 6;
  std::optional<ModelMesh> lattice;
  for (const std::string& format : mesh_formats()) {
    if (is_dual(format) && !lattice) lattice = triangulated(near_lattice(mesh.tetrahedra.size() / tetrahedra_a_point));
    const ModelMesh& written = is_dual(format) ? *lattice : mesh;
    print_row(format, written, write(written, format, {}), run_cpu_s);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--table") {
    print_table(argv[2], std::atof(argv[3]));
    return 0;
  }
  const std::size_t n = argc > 1 ? static_cast<std::size_t>(std::atol(argv[1])) : 500000;
  const std::string format = argc > 2 ? argv[2] : "vtu", compression = argc > 3 ? argv[3] : "fast";
  const std::map<std::string, Compression> choices{
      {"none", Compression::none}, {"fast", Compression::fast}, {"small", Compression::small}};
  WriteOptions options;
  options.compression = choices.at(compression);
  const Clock start = now();
  const ModelMesh mesh = triangulated(is_dual(format) ? near_lattice(n) : bench::make_points("uniform", n, seed));
  const Clock meshed = now();
  const Written written = write(mesh, format, options);
  const double per = static_cast<double>(mesh.tetrahedra.size());
  std::printf("%s, compression %s: %zu tetrahedra\n", format.c_str(), compression.c_str(), mesh.tetrahedra.size());
  std::printf("triangulated: %.2f s CPU, %.2f s\n", meshed.cpu_s - start.cpu_s, meshed.wall_s - start.wall_s);
  std::printf("written:      %.2f s CPU, %.2f s, %.2f of the CPU time of triangulating\n", written.cpu_s,
              written.wall_s, written.cpu_s / (meshed.cpu_s - start.cpu_s));
  std::printf("memory above the mesh: %.1f bytes a tetrahedron; files: %.1f\n", written.memory / per,
              written.file_bytes / per);
}
