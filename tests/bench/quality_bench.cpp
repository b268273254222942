// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the tables of the Refinement section of docs/performance.md to standard output:
///     quality_bench [--section peers|levels|growth]...
/// peers: beside `tetgen -pq1.414` and `gmsh -3 -optimize_netgen` (command-line programs, 60 seconds each) on the same surfaces
/// and, within a tenth, the same number of tetrahedra. levels: fast, default and best, surfaces kept and within 0.2 % of a
/// grain's size. growth: to a million tetrahedra, by stage.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "quality_models.hpp"

using namespace geomesh;
using namespace geomesh::bench;

namespace {

struct Row {
  std::string tool;
  ShapeStatistics shapes;
  double cpu_s = 0;
};

double children_cpu() {
  rusage u{};
  getrusage(RUSAGE_CHILDREN, &u);
  return static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}
double own_cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void print_header() {
  std::printf(
      "| model | tool | tetrahedra | least angle | largest | first percentile | mean of least | below 10 %% | above 24.85 %% | "
      "CPU s |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
}
void print(const std::string& model, const Row& r) {
  const ShapeStatistics& s = r.shapes;
  std::printf("| %s | %s | %zu | %.2f | %.2f | %.2f | %.2f | %.3f | %.3f | %.2f |\n", model.c_str(), r.tool.c_str(),
              s.n_tetrahedra, s.min_dihedral.min, s.max_dihedral.max, s.min_dihedral.first_percentile, s.min_dihedral.mean,
              100 * s.share_below_10, 100 * s.share_above_24_85, r.cpu_s);
  std::fflush(stdout);
}

ShapeStatistics measure_oriented(const std::vector<Vec3>& points, std::vector<Tetrahedron> cells) {
  for (Tetrahedron& t : cells)
    if (dot(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]), points[t[3]] - points[t[0]]) < 0)
      std::swap(t[2], t[3]);
  return measure_shapes(points, cells);
}

ShapeStatistics read_tetgen(const std::string& stem) {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> cells;
  std::size_t n = 0;
  long skip = 0, attributes = 0, markers = 0;
  std::ifstream nodes(stem + ".1.node"), elements(stem + ".1.ele");
  for (nodes >> n >> skip >> attributes >> markers; n > 0 && points.size() < n;) {
    Vec3 p;
    nodes >> skip >> p.x >> p.y >> p.z;
    for (long k = 0; k < attributes + markers; ++k) nodes >> skip;
    points.push_back(p);
  }
  n = 0;
  for (elements >> n >> skip >> attributes; n > 0 && cells.size() < n;) {
    Tetrahedron t{};
    elements >> skip >> t[0] >> t[1] >> t[2] >> t[3];
    for (long k = 0; k < attributes; ++k) elements >> skip;
    cells.push_back(t);
  }
  return measure_oriented(points, std::move(cells));
}

ShapeStatistics read_gmsh(const std::string& path) {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> cells;
  std::map<long, VertexIndex> row;
  std::ifstream in(path);
  std::string word;
  std::size_t n = 0;
  while (in >> word) {
    if (word == "$Nodes")
      for (in >> n; n > 0; --n) {
        long id = 0;
        Vec3 p;
        in >> id >> p.x >> p.y >> p.z;
        row[id] = static_cast<VertexIndex>(points.size());
        points.push_back(p);
      }
    if (word == "$Elements")
      for (in >> n; n > 0; --n) {
        long id = 0, type = 0, tags = 0;
        for (in >> id >> type >> tags; tags > 0; --tags) in >> id;
        const std::size_t corners = type == 4 ? 4 : type == 2 ? 3 : type == 1 ? 2 : 1;
        Tetrahedron t{};
        for (std::size_t k = 0; k < corners; ++k) in >> id, t[k] = row[id];
        if (type == 4) cells.push_back(t);
      }
  }
  return measure_oriented(points, std::move(cells));
}

Row run_peer(const std::string& tool, const std::string& command, const std::function<ShapeStatistics()>& read) {
  const double before = children_cpu();
  const int status = std::system(("timeout 60 " + command + " > /dev/null 2>&1").c_str());
  Row r{tool, {}, children_cpu() - before};
  if (status != 0) r.tool += " (status " + std::to_string(status >> 8) + ")";
  r.shapes = read();
  return r;
}

Row run_geomesh(const QualityModel& model, const RefineOptions& options, const std::string& label) {
  const double before = own_cpu();
  const RefineResult r = refine_and_improve(model.plc, tetrahedralize(model.plc), options);
  return {label, measure_shapes(r.mesh.points, r.mesh.tetrahedra), own_cpu() - before};
}

/// The gradation and, above what that gives, the size are chosen so that the count is that of the peer within a tenth.
Row run_matched(const QualityModel& model, std::size_t wanted, const std::string& label) {
  double low = 0.02, high = 0.9, length = 0;
  for (const Vec3& p : model.plc.points)
    length = std::max(length, std::sqrt(dot(p - model.plc.points[0], p - model.plc.points[0])));
  Row row;
  for (int trial = 0; trial < 6; ++trial) {
    // Above 0.1 a gradation; below, a global size that shrinks with it.
    const double knob = std::sqrt(low * high);
    RefineOptions options;
    options.size.gradation = std::max(knob, 0.1);
    if (knob < 0.1) options.size.global = length / 20 * knob / 0.1;
    row = run_geomesh(model, options, label);
    const double ratio = static_cast<double>(row.shapes.n_tetrahedra) / static_cast<double>(wanted);
    if (std::abs(ratio - 1) < 0.1) return row;
    (ratio > 1 ? low : high) = knob;
  }
  row.tool += " (count not matched)";
  return row;
}

std::vector<QualityModel> models() {
  std::vector<QualityModel> m{grains(0, 1), grains(0.25, 1)};
  for (const char* file : {"sphere1.obj", "cube_minus_sphere.obj", "sphere2.obj", "soccerball.obj", "bunny25k.obj"}) {
    m.push_back(solid(file));
    if (m.back().plc.points.empty()) {
      std::fprintf(stderr, "skipped: %s is absent\n", file);
      m.pop_back();
    }
  }
  return m;
}

void compare_peers() {
  print_header();
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "geomesh_quality_bench";
  std::filesystem::create_directories(folder);
  const std::string stem = (folder / "model").string();
  for (const QualityModel& model : models()) {
    write_poly(model.plc, stem + ".poly");
    write_gmsh(model, stem);
    const std::array<Row, 2> peers{
        run_peer("tetgen -pq1.414", "tetgen -pq1.414Q " + stem + ".poly", [&] { return read_tetgen(stem); }),
        run_peer("gmsh", "gmsh -3 -optimize_netgen -format msh2 " + stem + ".geo -o " + stem + ".msh",
                 [&] { return read_gmsh(stem + ".msh"); })};
    for (const Row& peer : peers) {
      print(model.name, peer);
      if (peer.shapes.n_tetrahedra > 0) print(model.name, run_matched(model, peer.shapes.n_tetrahedra, "geomesh, as many"));
    }
  }
  std::filesystem::remove_all(folder);
}

void compare_levels() {
  print_header();
  for (const double roughness : {0.0, 0.25}) {
    const QualityModel model = grains(roughness, 1);
    for (const double tolerance : {0.0, 0.002 * 2 * 3.435})
      for (const auto& [name, level] : {std::pair{"fast", QualityLevel::fast}, std::pair{"default", QualityLevel::standard},
                                        std::pair{"best", QualityLevel::best}}) {
        RefineOptions options;
        options.quality = level;
        options.size.gradation = 0.5;
        if (tolerance > 0) options.honour = Honour::tolerance, options.tolerance = tolerance;
        print(model.name,
              run_geomesh(model, options, std::string(name) + (tolerance > 0 ? ", within 0.2 %" : ", surfaces kept")));
      }
  }
}

void measure_growth() {
  std::printf(
      "| tetrahedra | Delaunay and recovery s | refine s | improve s | whole s (CPU) | tetrahedra a CPU second "
      "|\n|---|---|---|---|---|---|\n");
  const QualityModel model = grains(0, 1);
  for (const double size : {0.85, 0.55, 0.375}) {
    std::map<std::string, double> spent;
    RunContext context;
    context.stage = [&](std::string_view name, bool begins) { spent[std::string(name)] += begins ? -own_cpu() : own_cpu(); };
    RefineOptions options;
    options.size.global = size;
    const double before = own_cpu();
    auto mesh = tetrahedralize(model.plc);
    const double engine = own_cpu() - before;
    const RefineResult r = refine_and_improve(model.plc, std::move(mesh), options, context);
    const double whole = own_cpu() - before;
    std::printf("| %zu | %.2f | %.2f | %.2f | %.2f | %.0f |\n", r.mesh.tetrahedra.size(), engine, spent["refine"],
                spent["improve"], whole, static_cast<double>(r.mesh.tetrahedra.size()) / whole);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::set<std::string> sections;
  for (int i = 1; i + 1 < argc; i += 2)
    if (std::string(argv[i]) == "--section") sections.insert(argv[i + 1]);
  const auto wants = [&](const char* s) { return sections.empty() || sections.contains(s); };
  if (wants("peers")) compare_peers();
  if (wants("levels")) compare_levels();
  if (wants("growth")) measure_growth();
}
