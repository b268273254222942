// SPDX-License-Identifier: GPL-3.0-or-later
#include "voronoi/control_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "geomesh/core/dual_faces.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

namespace {

/// Smallest area of a face of the Voronoi dual, as a share of the squared length of its edge. A smaller area is due to
/// rounding at cospherical points.
constexpr double rounding = 1e-12;

double length_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

[[noreturn]] void refuse(const std::string& why, const Vec3& place) {
  throw Error(ErrorKind::cannot_mesh,
              "a finite-volume grid needs a Delaunay mesh: " + why + ", the first at (" + std::to_string(place.x) +
                  ", " + std::to_string(place.y) + ", " + std::to_string(place.z) +
                  "). Mesh with mode: conforming and a size; where small angles between surfaces forbid it, write the "
                  "tetrahedra themselves (pflotran)",
              {{}, {}, {}, {place}});
}

/// Throws if a vertex lies strictly inside the circumsphere of the tetrahedron across a face from it.
void require_delaunay(const ModelMesh& mesh) {
  const auto across = tetrahedra_across(mesh.tetrahedra);
  std::size_t n = 0;
  Vec3 first{};
  for (std::size_t t = 0; t < across.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t other = across[t][i];
      if (across[t][i] == no_neighbour || other < t) continue;
      const Tetrahedron& o = mesh.tetrahedra[other];
      const auto apex =
          std::find_if(o.begin(), o.end(), [&](VertexIndex w) { return std::find(v.begin(), v.end(), w) == v.end(); });
      if (apex == o.end() || in_sphere(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]],
                                       mesh.points[*apex]) != Sign::positive)
        continue;
      if (n++ == 0) first = mesh.points[*apex];
    }
  }
  if (n > 0) refuse(std::to_string(n) + " faces are not Delaunay", first);
}

/// Returns for each point the region with the largest share of its Voronoi cell; the first one if shares are equal.
std::vector<std::int32_t> largest_regions(const ModelMesh& mesh) {
  constexpr std::int32_t none = 0, several = -1;
  std::vector<std::int32_t> largest(mesh.points.size(), none);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (const VertexIndex v : mesh.tetrahedra[t]) {
      if (largest[v] == none) largest[v] = mesh.tet_region[t];
      if (largest[v] != mesh.tet_region[t]) largest[v] = several;
    }
  // For each region: the rows of its tetrahedra at points that belong to several regions.
  std::map<std::int32_t, std::vector<std::uint32_t>> rows_of;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (const Tetrahedron& v = mesh.tetrahedra[t];
        std::any_of(v.begin(), v.end(), [&](VertexIndex a) { return largest[a] == several; }))
      rows_of[mesh.tet_region[t]].push_back(static_cast<std::uint32_t>(t));
  std::vector<double> most(mesh.points.size(), 0);
  for (std::size_t v = 0; v < largest.size(); ++v)
    if (largest[v] != several) most[v] = std::numeric_limits<double>::infinity();
  for (const auto& [region, rows] : rows_of) {
    std::vector<Tetrahedron> tetrahedra;
    tetrahedra.reserve(rows.size());
    for (const std::uint32_t t : rows) tetrahedra.push_back(mesh.tetrahedra[t]);
    std::vector<double> own(mesh.points.size(), 0);
    for_each_dual_face(mesh.points, tetrahedra, [&](const DualFace& face) {
      const double share = face.area * length_of(mesh.points[face.b] - mesh.points[face.a]) / 6;
      own[face.a] += share;
      own[face.b] += share;
    });
    for (std::size_t v = 0; v < own.size(); ++v)
      if (own[v] > most[v]) {
        most[v] = own[v];
        largest[v] = region;
      }
  }
  return largest;
}

}  // namespace

ControlVolumes control_volumes(const ModelMesh& mesh) {
  require_delaunay(mesh);
  ControlVolumes result;
  result.volume.assign(mesh.points.size(), 0);
  result.region = largest_regions(mesh);
  for_each_dual_face(mesh.points, mesh.tetrahedra, [&](const DualFace& face) {
    const Vec3 along = mesh.points[face.b] - mesh.points[face.a];
    if (face.area < -rounding * dot(along, along)) ++result.n_negative_areas;
    const double share = face.area * length_of(along) / 6;
    result.volume[face.a] += share;
    result.volume[face.b] += share;
    if (face.area > rounding * dot(along, along)) result.connections.push_back({face.a, face.b, face.area});
  });
  const auto least = std::min_element(result.volume.begin(), result.volume.end());
  if (!(*least > 0))
    refuse("circumcentres lie so far beyond the boundary that a cell has no volume",
           mesh.points[static_cast<std::size_t>(least - result.volume.begin())]);
  return result;
}

std::vector<BoundaryShare> boundary_shares(const ModelMesh& mesh, std::int32_t surface) {
  std::map<VertexIndex, double> area;
  for (const ModelMesh::Face& face : mesh.faces) {
    const auto& set = mesh.surface_sets[static_cast<std::size_t>(face.surface_set)];
    if (face.region_plus != 0 || std::find(set.begin(), set.end(), surface) == set.end()) continue;
    const Vec3 &a = mesh.points[face.vertices[0]], &b = mesh.points[face.vertices[1]],
               &c = mesh.points[face.vertices[2]];
    const double third = length_of(cross(b - a, c - a)) / 6;
    for (const VertexIndex v : face.vertices) area[v] += third;
  }
  std::vector<BoundaryShare> shares;
  for (const auto& [point, own] : area) shares.push_back({point, own});
  return shares;
}

}  // namespace geomesh::geomodel
