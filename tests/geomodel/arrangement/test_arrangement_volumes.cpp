// SPDX-License-Identifier: GPL-3.0-or-later
// Unions, differences and overlaps of solids, meshed, beside CGAL's corefinement in exact arithmetic.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>

#include "arrangement_inputs.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
namespace Processing = CGAL::Polygon_mesh_processing;

const std::filesystem::path data = GEOMESH_SHARED_DATA;

/// Volumes of the parts of two solids.
struct Parts {
  double only_a = 0, only_b = 0, both = 0;
};

/// A folder that goes with the test.
struct Scratch {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("geomesh_volumes_" + std::to_string(std::random_device{}()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
};

void write_off(const TriangulatedSurface& s, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << std::setprecision(17) << "OFF\n" << s.points.size() << " " << s.triangles.size() << " 0\n";
  for (const Vec3& p : s.points) out << p.x << " " << p.y << " " << p.z << "\n";
  for (const auto& [a, b, c] : s.triangles) out << "3 " << a << " " << b << " " << c << "\n";
}

/// Meshes both together; a region belongs to the part that its `inside` says.
Parts meshed_parts(const TriangulatedSurface& a, const TriangulatedSurface& b) {
  const Scratch folder;
  write_off(a, folder.path / "a.off");
  write_off(b, folder.path / "b.off");
  MeshRequest request;
  request.inputs = {folder.path / "a.off", folder.path / "b.off"};
  request.output = folder.path / "out.vtu";
  run_mesh(request, RunContext{});
  std::ifstream in(folder.path / "out.report.json");
  Parts parts;
  const nlohmann::json report = nlohmann::json::parse(in);
  for (const auto& region : report["regions"]) {
    const auto inside = region["inside"].get<std::set<std::string>>();
    const double volume = region["volume"];
    if (inside == std::set<std::string>{"a", "b"}) parts.both += volume;
    if (inside == std::set<std::string>{"a"}) parts.only_a += volume;
    if (inside == std::set<std::string>{"b"}) parts.only_b += volume;
    CHECK_FALSE(inside.empty());
  }
  return parts;
}

Mesh to_mesh(const TriangulatedSurface& s) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> row;
  for (const Vec3& p : s.points) row.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& [a, b, c] : s.triangles) REQUIRE(mesh.add_face(row[a], row[b], row[c]) != Mesh::null_face());
  return mesh;
}

/// Exact, rounded once.
Parts exact_parts(const TriangulatedSurface& a, const TriangulatedSurface& b) {
  Mesh ma = to_mesh(a), mb = to_mesh(b), both;
  const auto volume_a = Processing::volume(ma), volume_b = Processing::volume(mb);
  REQUIRE(Processing::corefine_and_compute_intersection(ma, mb, both));
  const auto overlap = Processing::volume(both);
  return {CGAL::to_double(volume_a - overlap), CGAL::to_double(volume_b - overlap), CGAL::to_double(overlap)};
}

/// Two ulps of the largest coordinate times the area, and 1e-12 of the volume.
void compare(const TriangulatedSurface& a, const TriangulatedSurface& b) {
  const Parts ours = meshed_parts(a, b), exact = exact_parts(a, b);
  double largest = 0;
  for (const TriangulatedSurface* s : {&a, &b})
    for (const Vec3& p : s->points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double ulp = std::ldexp(1.0, std::ilogb(largest) - 52), area = area_of(a) + area_of(b);
  const auto near = [&](double x, double y) {
    CAPTURE(x, y);
    CHECK(std::fabs(x - y) <= 2 * ulp * area + 1e-12 * std::fabs(y));
  };
  near(ours.both, exact.both);
  near(ours.only_a, exact.only_a);
  near(ours.only_b, exact.only_b);
  near(ours.only_a + ours.only_b + ours.both, exact.only_a + exact.only_b + exact.both);
}

/// The connected pieces of a surface.
std::vector<TriangulatedSurface> pieces(const TriangulatedSurface& s) {
  std::vector<VertexIndex> root(s.points.size());
  for (VertexIndex v = 0; v < root.size(); ++v) root[v] = v;
  const auto find = [&root](VertexIndex v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const Triangle& t : s.triangles)
    for (const VertexIndex v : t) root[find(v)] = find(t[0]);
  std::map<VertexIndex, TriangulatedSurface> by_root;
  for (const Triangle& t : s.triangles) {
    TriangulatedSurface& piece = by_root[find(t[0])];
    piece.points = s.points;
    piece.triangles.push_back(t);
  }
  std::vector<TriangulatedSurface> result;
  for (auto& [at, piece] : by_root) {
    TriangulatedSurface small;
    std::map<VertexIndex, VertexIndex> row;
    for (Triangle t : piece.triangles) {
      for (VertexIndex& v : t) {
        const auto [place, is_new] = row.try_emplace(v, static_cast<VertexIndex>(small.points.size()));
        if (is_new) small.points.push_back(s.points[v]);
        v = place->second;
      }
      small.triangles.push_back(t);
    }
    result.push_back(std::move(small));
  }
  return result;
}

TriangulatedSurface turned(TriangulatedSurface s, double angle, const Vec3& to) {
  const double c = std::cos(angle), d = std::sin(angle);
  for (Vec3& p : s.points) p = to + Vec3{c * p.x - d * p.y, d * p.x + c * p.y, p.z};
  return s;
}

}  // namespace

TEST_CASE("volumes: generated solids beside exact corefinement", "[arrangement]") {
  const auto a = ellipsoid("a", {0, 0, 0}, {1, 1.5, 1}, 3), b = ellipsoid("b", {0.7, 0.2, 0.1}, {1, 1, 1.3}, 3);
  compare(a, b);
  compare(ellipsoid("a", {0, 0, 0}, {2, 0.3, 0.3}, 3),
          turned(ellipsoid("b", {0, 0, 0}, {0.3, 2, 0.4}, 3), 0.4, {0.2, 0.1, 0.05}));
  SECTION("turned and moved to UTM") {
    compare(turned(a, 0.3, {549500, 7820100, -9000}), turned(b, 0.3, {549500, 7820100, -9000}));
  }
}

TEST_CASE("volumes: spheres from files beside exact corefinement", "[arrangement][data]") {
  if (!std::filesystem::exists(data / "solids")) {
    WARN("skipped: " << (data / "solids").string() << " is not there");
    return;
  }
  compare(load_obj(data / "solids/sphere1.obj"), load_obj(data / "solids/sphere2.obj"));
  const auto spheres = pieces(load_obj(data / "solids/two_spheres.obj"));
  REQUIRE(spheres.size() == 2);
  compare(spheres[0], spheres[1]);
}

TEST_CASE("volumes: bunny and cow beside exact corefinement", "[arrangement][data]") {
  if (!std::filesystem::exists(data / "solids")) {
    WARN("skipped: " << (data / "solids").string() << " is not there");
    return;
  }
  const auto bunny = load_obj(data / "solids/bunny25k.obj");
  auto cow = load_obj(data / "solids/cow25k.obj");
  const Box3 box = wide_box({bunny});
  for (Vec3& p : cow.points) {
    const double c = std::cos(0.7), s = std::sin(0.7), scale = 0.8 * (box.max.x - box.min.x);
    p = 0.5 * (box.min + box.max) + scale * Vec3{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  }
  compare(bunny, cow);
}
