// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/model/drawn_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace geomesh::geomodel::page {
namespace {

/// Returns the importance of each vertex for the model's outline: sides of the box count more than all other surfaces.
std::vector<std::uint8_t> weights_of(const ModelMesh& mesh) {
  constexpr std::size_t most = 4;  // largest number of different surfaces that are counted at one vertex
  constexpr std::uint8_t of_side = 5, of_other = 1;
  std::vector<std::array<std::int32_t, most>> met(mesh.points.size());
  std::vector<std::uint8_t> weight(mesh.points.size(), 0);
  std::unordered_map<std::int32_t, std::uint8_t> of_surface;
  for (const NamedSurface& s : mesh.surfaces) of_surface[s.id] = s.kind == SurfaceKind::box ? of_side : of_other;
  for (const ModelMesh::Face& face : mesh.faces)
    for (const VertexIndex v : face.vertices) {
      auto& known = met[v];
      const auto at =
          std::find_if(known.begin(), known.end(), [&](std::int32_t id) { return id == 0 || id == face.surface; });
      if (at == known.end() || *at == face.surface) continue;
      *at = face.surface;
      const auto own = of_surface.find(face.surface);
      weight[v] = static_cast<std::uint8_t>(weight[v] + (own == of_surface.end() ? of_other : own->second));
    }
  return weight;
}

/// Returns for each vertex the vertex that represents its cluster, in a grid with cells of the given width.
std::vector<VertexIndex> cluster(const ModelMesh& mesh, const std::vector<std::uint8_t>& weight, const Vec3& low,
                                 const Vec3& width) {
  struct Hash {
    std::size_t operator()(const std::array<std::int64_t, 3>& key) const {
      return static_cast<std::size_t>(key[0] * 73856093 ^ key[1] * 19349663 ^ key[2] * 83492791);
    }
  };
  std::unordered_map<std::array<std::int64_t, 3>, VertexIndex, Hash> first;
  std::vector<std::array<std::int64_t, 3>> key(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k)
      key[v][k] = static_cast<std::int64_t>(std::floor((mesh.points[v][k] - low[k]) / width[k]));
    const auto row = static_cast<VertexIndex>(v);
    const auto [at, is_new] = first.emplace(key[v], row);
    if (!is_new && weight[v] > weight[at->second]) at->second = row;
  }
  std::vector<VertexIndex> corner(mesh.points.size());
  for (std::size_t v = 0; v < corner.size(); ++v) corner[v] = first.at(key[v]);
  return corner;
}

template <class Rows>
std::vector<std::uint32_t> rows_with_all_corners(const Rows& rows, const std::vector<VertexIndex>& corner) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto corners = rows[i];
    for (VertexIndex& v : corners) v = corner[v];
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) == corners.end())
      kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

std::vector<Triangle> triangles_of(const ModelMesh& mesh) {
  std::vector<Triangle> all;
  all.reserve(mesh.faces.size());
  for (const ModelMesh::Face& face : mesh.faces) all.push_back(face.vertices);
  return all;
}

}  // namespace

DrawnMesh drawn_mesh(const ModelMesh& mesh, double stretch, const DrawingLimits& limits) {
  DrawnMesh drawn;
  drawn.corner.resize(mesh.points.size());
  std::iota(drawn.corner.begin(), drawn.corner.end(), VertexIndex{0});
  drawn.is_whole = mesh.faces.size() <= limits.faces && mesh.tetrahedra.size() <= limits.tetrahedra;
  const std::vector<Triangle> faces = triangles_of(mesh);
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  const Vec3 size = bounds.max - bounds.min;
  const double stretched_volume = size.x * size.y * size.z * stretch;
  // Ratio of width to height of the grid's cells. Units are wide and thin, so flat cells preserve thin units. The grid
  // has about six tetrahedra per cell.
  constexpr double flatness = 3;
  double width =
      std::cbrt(std::max(stretched_volume, 1e-300) * flatness * 6 / static_cast<double>(limits.tetrahedra)) / 2;
  const std::vector<std::uint8_t> weight = drawn.is_whole ? std::vector<std::uint8_t>{} : weights_of(mesh);
  for (constexpr double coarser = 1.2;; width *= coarser) {
    if (!drawn.is_whole) drawn.corner = cluster(mesh, weight, bounds.min, {width, width, width / flatness / stretch});
    drawn.faces = rows_with_all_corners(faces, drawn.corner);
    drawn.cells = rows_with_all_corners(mesh.tetrahedra, drawn.corner);
    if (drawn.is_whole || (drawn.faces.size() <= limits.faces && drawn.cells.size() <= limits.tetrahedra)) return drawn;
  }
}

Vec2 open_corner(const ModelMesh& mesh, const Box3& bounds) {
  const Vec2 middle{0.5 * (bounds.min.x + bounds.max.x), 0.5 * (bounds.min.y + bounds.max.y)};
  std::vector<bool> reaches_side(mesh.regions.size(), false);
  for (const ModelMesh::Face& face : mesh.faces)
    if (face.region_minus == 0 || face.region_plus == 0)
      reaches_side[static_cast<std::size_t>(std::max(face.region_minus, face.region_plus) - 1)] = true;
  std::vector<Box3> extents(mesh.regions.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto row = static_cast<std::size_t>(mesh.tet_region[t] - 1);
    if (!reaches_side[row])
      for (const VertexIndex v : mesh.tetrahedra[t]) extents[row].add(mesh.points[v]);
  }
  Vec2 corner = middle;
  double largest = 0;
  for (std::size_t r = 0; r < extents.size(); ++r) {
    if (reaches_side[r] || mesh.regions[r].n_tetrahedra == 0) continue;
    const Box3& e = extents[r];
    const bool first_wall = e.min.x < middle.x && e.max.x > middle.x && e.min.y < middle.y;
    const bool second_wall = e.min.y < middle.y && e.max.y > middle.y && e.min.x < middle.x;
    if (first_wall || second_wall) return middle;
    if (mesh.regions[r].volume <= largest) continue;
    largest = mesh.regions[r].volume;
    corner = {0.5 * (e.min.x + e.max.x), 0.5 * (e.min.y + e.max.y)};
  }
  return corner;
}

}  // namespace geomesh::geomodel::page
