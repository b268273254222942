// SPDX-License-Identifier: MIT
// A part of a mesh is refined on its own: what is to stay does, and two parts fit together after.
#include <algorithm>
#include <catch2/catch.hpp>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/refine_part.hpp"
#include "refine_models.hpp"

using namespace geomesh;
using namespace refine_models;

namespace {

using Face = std::array<std::array<double, 3>, 3>;

Face placed(const std::vector<Vec3>& points, const Tetrahedron& t, unsigned i) {
  Face f;
  for (unsigned k = 0; k < 3; ++k) {
    const Vec3& p = points[t[face_vertices[i][k]]];
    f[k] = {p.x, p.y, p.z};
  }
  std::sort(f.begin(), f.end());
  return f;
}

/// Faces that one tetrahedron has, by places.
std::vector<Face> border_of(const TetrahedraPart& part) {
  std::vector<Face> all, border;
  for (const Tetrahedron& t : part.tetrahedra)
    for (unsigned i = 0; i < 4; ++i) all.push_back(placed(part.points, t, i));
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i - 1] != all[i]) && (i + 1 == all.size() || all[i + 1] != all[i])) border.push_back(all[i]);
  return border;
}

std::ptrdiff_t n_kept(const TetrahedraPart& part) { return std::ranges::count(part.is_kept, 1); }

double volume_of(const TetrahedraPart& part) {
  double sum = 0;
  for (const Tetrahedron& t : part.tetrahedra) {
    const Vec3& o = part.points[t[0]];
    sum += dot(cross(part.points[t[1]] - o, part.points[t[2]] - o), part.points[t[3]] - o) / 6;
  }
  return sum;
}

/// Those with their middle on one side of a plane y = const.
TetrahedraPart half_of(const ConstrainedTetrahedralization& mesh, double y, bool is_low) {
  TetrahedraPart part;
  part.points = mesh.points;
  part.is_kept.assign(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    double sum = 0;
    for (const VertexIndex v : mesh.tetrahedra[t]) sum += mesh.points[v].y;
    if ((sum < 4 * y) != is_low) continue;
    part.tetrahedra.push_back(mesh.tetrahedra[t]);
    part.component.push_back(mesh.component[t]);
  }
  std::vector<VertexIndex> row(mesh.points.size(), no_vertex);
  part.points.clear();
  for (Tetrahedron& t : part.tetrahedra)
    for (VertexIndex& v : t) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(part.points.size());
        part.points.push_back(mesh.points[v]);
      }
      v = row[v];
    }
  part.is_kept.assign(part.points.size(), 0);
  for (const auto& f : mesh.faces) {
    const auto is_here = [&](Index t) {
      if (t == no_index) return false;
      double sum = 0;
      for (const VertexIndex v : mesh.tetrahedra[t]) sum += mesh.points[v].y;
      return (sum < 4 * y) == is_low;
    };
    if (is_here(f.tetrahedron_above) && is_here(f.tetrahedron_below))
      part.kept_faces.push_back({row[f.vertices[0]], row[f.vertices[1]], row[f.vertices[2]]});
  }
  return part;
}

}  // namespace

TEST_CASE("Parts refined on their own keep their borders and the faces told", "[refine_part]") {
  Model model = two_boxes(3);
  RefineOptions options;
  options.size.global = 0.2;
  const RefineResult start = refine_and_improve(model.plc, model.mesh, options);
  double least = 1e300, greatest = -1e300;
  for (const Vec3& p : start.mesh.points) least = std::min(least, p.y), greatest = std::max(greatest, p.y);
  const SizeField size = start.size_field.times(0.25);
  for (const bool is_low : {true, false}) {
    TetrahedraPart part = half_of(start.mesh, 0.5 * (least + greatest), is_low);
    const std::vector<Face> border = border_of(part);
    const double volume = volume_of(part);
    const std::size_t n = part.tetrahedra.size(), n_faces = part.kept_faces.size();
    REQUIRE(n > 0);
    REQUIRE(n_faces > 0);
    refine_part(part, size, options);
    CHECK(part.tetrahedra.size() > 4 * n);
    CHECK(border_of(part) == border);
    CHECK(part.kept_faces.size() == n_faces);
    CHECK(volume_of(part) == Approx(volume).epsilon(1e-12));
    for (const Tetrahedron& t : part.tetrahedra)
      REQUIRE(orient3d(part.points[t[0]], part.points[t[1]], part.points[t[2]], part.points[t[3]]) == Sign::positive);
    std::vector<Face> faces;
    for (const Tetrahedron& t : part.tetrahedra)
      for (unsigned i = 0; i < 4; ++i) faces.push_back(placed(part.points, t, i));
    std::sort(faces.begin(), faces.end());
    for (const Triangle& f : part.kept_faces) {
      Face kept;
      for (unsigned k = 0; k < 3; ++k) kept[k] = {part.points[f[k]].x, part.points[f[k]].y, part.points[f[k]].z};
      std::sort(kept.begin(), kept.end());
      CHECK(std::binary_search(faces.begin(), faces.end(), kept));
    }
  }
}

TEST_CASE("Points of settled tetrahedra stay through refinement, and no others inside", "[refine_part]") {
  Model model = two_boxes(3);
  RefineOptions options;
  options.size.global = 0.1;
  const RefineResult start = refine_and_improve(model.plc, model.mesh, options);
  const TetrahedraPart part = half_of(start.mesh, 1e300, true);
  const auto share_in_place = [&](const TetrahedraPart& result) {
    std::vector<std::array<double, 3>> places;
    for (const Vec3& p : result.points) places.push_back({p.x, p.y, p.z});
    std::sort(places.begin(), places.end());
    const auto n = std::ranges::count_if(part.points, [&](const Vec3& p) {
      return std::binary_search(places.begin(), places.end(), std::array{p.x, p.y, p.z});
    });
    return static_cast<double>(n) / static_cast<double>(part.points.size());
  };
  TetrahedraPart settled = part, loose = part;
  settled.is_settled.assign(part.tetrahedra.size(), 1);
  refine_part(settled, start.size_field, options);
  refine_part(loose, start.size_field, options);
  CHECK(share_in_place(settled) > 0.6);
  CHECK(share_in_place(loose) < 0.5);
  for (const TetrahedraPart& result : {settled, loose}) {
    CHECK(n_kept(result) == n_kept(loose));
    CHECK(result.kept_faces.size() == part.kept_faces.size());
    CHECK(result.is_settled.empty());
    CHECK(border_of(result) == border_of(part));
    CHECK(volume_of(result) == Approx(volume_of(part)).epsilon(1e-12));
  }
}

TEST_CASE("A face that is to stay and is not there is told", "[refine_part]") {
  const Model model = two_boxes(2);
  TetrahedraPart part = half_of(model.mesh, 1e300, true);
  part.kept_faces.push_back({0, 0, 0});
  SizeField::Limits limits;
  limits.global = 1;
  CHECK_THROWS_AS(refine_part(part, SizeField({}, limits), {}), InternalError);
}

TEST_CASE("A sparse inside leaves surfaces as fine as asked, with fewer cells", "[refine_part]") {
  const Model model = two_boxes(2);
  RefineOptions options;
  options.size.global = 0.05;
  const RefineResult full = refine_and_improve(model.plc, model.mesh, options);
  options.sparse_growth = 0.7;
  const RefineResult sparse = refine_and_improve(model.plc, model.mesh, options);
  CHECK(2 * sparse.mesh.tetrahedra.size() < full.mesh.tetrahedra.size());
  CHECK(static_cast<double>(sparse.mesh.faces.size()) > 0.9 * static_cast<double>(full.mesh.faces.size()));
  options.sparse_surfaces = 2;
  const RefineResult coarse = refine_and_improve(model.plc, model.mesh, options);
  CHECK(3 * coarse.mesh.faces.size() < sparse.mesh.faces.size());
  options.sparse_ratio = 0.5;
  CHECK_THROWS_AS(refine_and_improve(model.plc, model.mesh, options), Error);
}
