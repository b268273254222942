// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The arrangement beside CGAL's corefine and experimental::autorefine on the same triangles.
///
///     arrangement_bench [--all] [--faults DIR...]
///
/// Two crossing grids of 20,000 and 200,000 triangles each (--all: also 1,000,000), then the .ts files of each folder together. Wall and
/// processor seconds, best of three for the small ones. Every soup is validated; volumes are compared with CGAL's where both are closed.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>

#include "../geomodel/arrangement_inputs.hpp"

namespace {

using namespace geomesh;
using namespace geomesh::geomodel;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Seconds {
  double wall = 0, cpu = 0;
};

Seconds timed(int repeats, const std::function<void()>& prepare, const std::function<void()>& run) {
  Seconds best{1e300, 1e300};
  for (int k = 0; k < repeats; ++k) {
    prepare();
    const auto wall = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    run();
    best.cpu = std::min(best.cpu, double(std::clock() - cpu) / CLOCKS_PER_SEC);
    best.wall = std::min(best.wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
  }
  return best;
}

Mesh to_mesh(const std::vector<TriangulatedSurface>& surfaces) {
  Mesh mesh;
  for (const TriangulatedSurface& s : surfaces) {
    std::vector<Mesh::Vertex_index> row;
    for (const Vec3& p : s.points) row.push_back(mesh.add_vertex({p.x, p.y, p.z}));
    for (const auto& [a, b, c] : s.triangles) mesh.add_face(row[a], row[b], row[c]);
  }
  return mesh;
}

std::vector<TriangulatedSurface> crossing_grids(unsigned cells) {
  return {testing::grid_surface("level", SurfaceKind::surface, cells, 0, 1000, 0, 1000,
                                [](double x, double y) { return 10 * std::sin(x * 0.01) * std::cos(y * 0.013); }),
          testing::grid_surface("ramp", SurfaceKind::surface, cells, 0.123, 1000.123, 0.0517, 1000.0517,
                                [](double x, double y) { return 0.3 * (x - 500) + 7 * std::sin(y * 0.02); })};
}

void print(const char* who, const Seconds& s) { std::printf(" | %s %.3f wall %.3f cpu", who, s.wall, s.cpu); }

template <typename Run>
void peer(const char* who, int repeats, const std::function<void()>& prepare, Run&& run) {
  try {
    print(who, timed(repeats, prepare, run));
  } catch (const std::exception&) {
    std::printf(" | %s refuses", who);
  }
  std::fflush(stdout);
}

void compare(const std::string& name, const std::vector<TriangulatedSurface>& surfaces, int repeats) {
  std::size_t n = 0;
  for (const auto& s : surfaces) n += s.triangles.size();
  std::printf("%s: %zu triangles", name.c_str(), n);
  ArrangementResult result;
  const Seconds ours = timed(repeats, [] {}, [&] { result = arrange(surfaces, {}, {}, {}); });
  std::printf(" -> %zu facets, %zu crossing pairs", result.soup.facets.size(), result.n_crossing_pairs);
  print("arrange", ours);
  Mesh a, b;
  const auto reload = [&] {
    a = to_mesh({surfaces[0]});
    b = to_mesh({surfaces.begin() + 1, surfaces.end()});
  };
  namespace Processing = CGAL::Polygon_mesh_processing;
  const auto refuse_self_crossing = CGAL::parameters::throw_on_self_intersection(false);
  if (surfaces.size() == 2) peer("corefine", repeats, reload, [&] { Processing::corefine(a, b, refuse_self_crossing); });
  peer("autorefine", repeats, [&] { a = to_mesh(surfaces); }, [&] { Processing::experimental::autorefine(a); });
  std::printf(" | soup %s\n", validate_soup(result.soup).empty() ? "sound" : "FAULTY");
}

std::vector<TriangulatedSurface> load_folder(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".ts") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<TriangulatedSurface> surfaces;
  for (const auto& file : files) surfaces.push_back(testing::load_ts(file));
  return surfaces;
}

}  // namespace

int main(int n, char** arguments) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_warning_behaviour(CGAL::CONTINUE);
  bool all = false;
  std::vector<std::string> folders;
  for (int k = 1; k < n; ++k) {
    const std::string word = arguments[k];
    if (word == "--all")
      all = true;
    else if (word != "--faults")
      folders.push_back(word);
  }
  compare("two grids of 20,000", crossing_grids(100), 3);
  for (const std::string& folder : folders) compare(std::filesystem::path(folder).filename().string(), load_folder(folder), 3);
  compare("two grids of 200,000", crossing_grids(316), 2);
  if (all) compare("two grids of 1,000,000", crossing_grids(707), 1);
}
