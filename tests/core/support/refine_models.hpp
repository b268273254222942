// SPDX-License-Identifier: MIT
// Conforming meshes made without the engine, for tests of what works on meshes: grids of cubes cut in six, regions by
// cube.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include "geomesh/core/predicates.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace refine_models {

using namespace geomesh;

struct Model {
  PiecewiseLinearComplex plc;
  ConstrainedTetrahedralization mesh;
};

/// Options that remesh surfaces within a tolerance, with one size everywhere.
inline RefineOptions within(double tolerance, double size) {
  RefineOptions o;
  o.honour = Honour::tolerance;
  o.tolerance = tolerance;
  o.size.from_input_edges = false;
  o.size.global = size;
  o.size.gap_layers = 0;
  return o;
}

inline std::array<VertexIndex, 3> sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Facets of the PLC are the triangles between regions and on the outside; provenance: the caller's surface of a
/// triangle.
class GridModel {
 public:
  using Region = std::function<Index(const Vec3& centroid)>;  ///< no_index: the outside
  using Surface = std::function<Index(const Vec3& centroid)>;
  using Map = std::function<Vec3(const Vec3&)>;

  GridModel(
      unsigned n, Vec3 extent, const Region& region, const Surface& surface,
      const Map& map = [](const Vec3& p) { return p; }) {
    add_cells(n, extent, region);
    find_facets(surface);
    for (Vec3& p : points_) p = map(p);
  }

  /// Vertices on facets become the PLC's, the others are added points. Wells: pairs of grid vertices, which become
  /// input too.
  Model model(const std::vector<std::array<VertexIndex, 2>>& wells = {}) const {
    Model m;
    std::vector<VertexIndex> row(points_.size(), no_vertex);
    const auto use = [&](VertexIndex v) {
      if (row[v] != no_vertex) return;
      row[v] = static_cast<VertexIndex>(m.plc.points.size());
      m.plc.points.push_back(points_[v]);
    };
    for (const auto& f : facets_)
      for (const VertexIndex v : f.vertices) use(v);
    for (const auto& w : wells)
      for (const VertexIndex v : w) use(v);
    m.mesh.points = m.plc.points;
    for (VertexIndex v = 0; v < m.plc.points.size(); ++v) m.mesh.input_vertex.push_back(v);
    m.mesh.origin.assign(m.plc.points.size(), VertexOrigin::input);
    std::vector<bool> is_used(points_.size(), false);
    for (const Tetrahedron& t : cells_)
      for (const VertexIndex v : t) is_used[v] = true;
    for (VertexIndex v = 0; v < points_.size(); ++v)
      if (row[v] == no_vertex && is_used[v]) {
        row[v] = static_cast<VertexIndex>(m.mesh.points.size());
        m.mesh.points.push_back(points_[v]);
        m.mesh.input_vertex.push_back(no_vertex);
        m.mesh.origin.push_back(VertexOrigin::inside);
      }
    for (const Tetrahedron& t : cells_) m.mesh.tetrahedra.push_back({row[t[0]], row[t[1]], row[t[2]], row[t[3]]});
    m.mesh.component = component_;
    m.mesh.n_components = *std::max_element(component_.begin(), component_.end()) + std::size_t{1};
    m.mesh.component_seed.assign(m.mesh.n_components, no_index);
    for (const auto& f : facets_) {
      const Triangle t{row[f.vertices[0]], row[f.vertices[1]], row[f.vertices[2]]};
      m.mesh.faces.push_back({t, m.plc.add_triangle(t, f.surface), f.below, f.above});
    }
    for (const auto& w : wells) {
      m.plc.segments.push_back({row[w[0]], row[w[1]], 0});
      m.mesh.edges.push_back({row[w[0]], row[w[1]], static_cast<Index>(m.plc.segments.size() - 1)});
    }
    return m;
  }

 private:
  struct Facet {
    Triangle vertices;
    Index below, above, surface;
  };

  void add_cells(unsigned n, const Vec3& extent, const Region& region) {
    const unsigned m = n + 1;
    for (unsigned k = 0; k < m; ++k)
      for (unsigned j = 0; j < m; ++j)
        for (unsigned i = 0; i < m; ++i) points_.push_back({extent.x * i / n, extent.y * j / n, extent.z * k / n});
    const std::array<std::array<unsigned, 3>, 6> orders{
        {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}}};
    const auto at = [&](unsigned i, unsigned j, unsigned k, unsigned corner) {
      return (k + (corner >> 2)) * m * m + (j + ((corner >> 1) & 1u)) * m + i + (corner & 1u);
    };
    for (unsigned k = 0; k < n; ++k)
      for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i)
          for (const auto& o : orders) {  // Kuhn's six along the diagonal: conforming between cubes
            const Index component = region(0.5 * (points_[at(i, j, k, 0)] + points_[at(i, j, k, 7)]));
            if (component == no_index) continue;
            Tetrahedron t{at(i, j, k, 0), at(i, j, k, o[0]), at(i, j, k, o[0] | o[1]), at(i, j, k, 7)};
            if (orient3d(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]) != Sign::positive)
              std::swap(t[2], t[3]);
            cells_.push_back(t);
            component_.push_back(component);
          }
  }

  void find_facets(const Surface& surface) {
    std::map<Triangle, std::vector<std::pair<Index, Triangle>>>
        uses;  // by sorted face: tetrahedron, face seen from inside
    for (Index c = 0; c < cells_.size(); ++c)
      for (const auto& f : face_vertices) {
        const Triangle t{cells_[c][f[0]], cells_[c][f[1]], cells_[c][f[2]]};
        uses[sorted(t)].push_back({c, t});
      }
    for (const auto& [key, use] : uses) {
      if (use.size() == 2 && component_[use[0].first] == component_[use[1].first]) continue;
      const auto& [above, t] = use[0];
      const Vec3 centroid = (1.0 / 3) * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
      facets_.push_back({t, use.size() == 2 ? use[1].first : no_index, above, surface(centroid)});
    }
  }

  std::vector<Vec3> points_;
  std::vector<Tetrahedron> cells_;
  std::vector<Index> component_;
  std::vector<Facet> facets_;
};

/// Side of the unit cube a point lies on, else `inner`.
inline Index side_of_cube(const Vec3& p, Index inner) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (p[i] < 1e-9) return static_cast<Index>(2 * i);
    if (p[i] > 1 - 1e-9) return static_cast<Index>(2 * i + 1);
  }
  return inner;
}

/// The unit cube in two regions along x.
inline Model two_boxes(unsigned n) {
  return GridModel(
             2 * n, {1, 1, 1}, [](const Vec3& p) { return p.x < 0.5 ? 0u : 1u; },
             [](const Vec3& p) { return side_of_cube(p, 6); })
      .model();
}

/// Two quarters of the unit cube that meet along the line through its middle in z alone, the outside between them.
inline Model blocks_at_an_edge(unsigned n) {
  return GridModel(
             2 * n, {1, 1, 1}, [](const Vec3& p) { return (p.x < 0.5) == (p.y < 0.5) ? 0u : no_index; },
             [](const Vec3& p) { return side_of_cube(p, 6); })
      .model();
}

/// The unit cube with a vertical segment from (1/2, 1/2, 1/4) to (1/2, 1/2, 3/4). n: a multiple of four.
inline Model box_with_well(unsigned n) {
  const GridModel grid(
      n, {1, 1, 1}, [](const Vec3&) { return 0u; }, [](const Vec3& p) { return side_of_cube(p, 6); });
  std::vector<std::array<VertexIndex, 2>> wells;
  const unsigned m = n + 1;
  for (unsigned k = n / 4; k < 3 * n / 4; ++k)
    wells.push_back({k * m * m + (n / 2) * m + n / 2, (k + 1) * m * m + (n / 2) * m + n / 2});
  Model model = grid.model(wells);
  // One segment, not one a mesh edge.
  model.plc.segments = {{model.plc.segments.front().a, model.plc.segments.back().b, 0}};
  for (auto& e : model.mesh.edges) e.segment = 0;
  return model;
}

/// The cube [-2, 2]^3 with a ball of radius 1 inside: an inner cube of the grid, mapped radially. n cubes across the
/// ball.
inline Model ball_in_box(unsigned n) {
  const auto map = [](const Vec3& p) {
    const Vec3 q = 4.0 * p - Vec3{2, 2, 2};
    const double cube = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}), radius = std::sqrt(dot(q, q));
    if (cube == 0) return q;
    const double t = cube <= 1 ? 1 : 2 - cube;  // 1 on the ball, 0 on the box
    return (1 - t) * q + (t * cube / radius) * q;
  };
  const auto region = [](const Vec3& p) {
    return std::max({std::abs(p.x - 0.5), std::abs(p.y - 0.5), std::abs(p.z - 0.5)}) < 0.25 ? 0u : 1u;
  };
  return GridModel(
             2 * n, {1, 1, 1}, region, [](const Vec3& p) { return side_of_cube(p, 6); }, map)
      .model();
}

/// Moves inner vertices at random as far as every tetrahedron stays positive.
inline void disturb_inside(Model& model, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.12, 0.12);
  auto& mesh = model.mesh;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    if (mesh.input_vertex[v] != no_vertex) continue;
    const Vec3 old = mesh.points[v];
    mesh.points[v] = old + Vec3{shift(random), shift(random), shift(random)};
    for (const Tetrahedron& t : mesh.tetrahedra)
      if (std::find(t.begin(), t.end(), v) != t.end() &&
          orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) != Sign::positive)
        mesh.points[v] = old;
  }
}

/// What a ConstrainedTetrahedralization promises: positive cells, matched faces, components parted by facets.
inline void require_valid(const ConstrainedTetrahedralization& mesh) {
  std::map<Triangle, std::vector<Index>> cells_of;
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    REQUIRE(orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) == Sign::positive);
    for (const auto& f : face_vertices) cells_of[sorted({t[f[0]], t[f[1]], t[f[2]]})].push_back(c);
  }
  std::map<Triangle, const ConstrainedTetrahedralization::Face*> faces;
  for (const auto& f : mesh.faces) {
    REQUIRE(faces.emplace(sorted(f.vertices), &f).second);
    std::vector<Index> stated;
    for (const Index c : {f.tetrahedron_below, f.tetrahedron_above})
      if (c != no_index) stated.push_back(c);
    std::sort(stated.begin(), stated.end());
    REQUIRE(cells_of[sorted(f.vertices)] == stated);
    const auto& p = mesh.points;
    const auto apex = [&](Index c) {
      for (const VertexIndex v : mesh.tetrahedra[c])
        if (std::find(f.vertices.begin(), f.vertices.end(), v) == f.vertices.end()) return v;
      return no_vertex;
    };
    if (f.tetrahedron_above != no_index)
      REQUIRE(orient3d(p[f.vertices[0]], p[f.vertices[1]], p[f.vertices[2]], p[apex(f.tetrahedron_above)]) ==
              Sign::positive);
    if (f.tetrahedron_below != no_index)
      REQUIRE(orient3d(p[f.vertices[0]], p[f.vertices[1]], p[f.vertices[2]], p[apex(f.tetrahedron_below)]) ==
              Sign::negative);
  }
  for (const auto& [face, cells] : cells_of) {
    REQUIRE(cells.size() <= 2);
    if (cells.size() == 1 || mesh.component[cells[0]] != mesh.component[cells[1]]) REQUIRE(faces.count(face) == 1);
  }
}

inline std::vector<double> component_volumes(const ConstrainedTetrahedralization& mesh) {
  std::vector<double> volume(mesh.n_components, 0);
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    const Vec3 a = mesh.points[t[0]];
    volume[mesh.component[c]] += dot(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a), mesh.points[t[3]] - a) / 6;
  }
  return volume;
}

inline std::vector<double> facet_areas(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh) {
  std::vector<double> area(plc.n_facets(), 0);
  for (const auto& f : mesh.faces) {
    const Vec3 n = cross(mesh.points[f.vertices[1]] - mesh.points[f.vertices[0]],
                         mesh.points[f.vertices[2]] - mesh.points[f.vertices[0]]);
    area[f.facet] += std::sqrt(dot(n, n)) / 2;
  }
  return area;
}

/// A box of side 4 with a ridge along a diagonal of its top, from vertex 4 to 6, and one flat cell below it, which has
/// both faces of the ridge.
inline Model box_with_ridge(double height) {
  Model m;
  m.plc.points = {{0, 0, 0},          {4, 0, 0}, {4, 4, 0},          {0, 4, 0},
                  {0, 0, 4 + height}, {4, 0, 4}, {4, 4, 4 + height}, {0, 4, 4}};
  Index surface = 0;
  for (const std::array<VertexIndex, 4>& s :
       {std::array<VertexIndex, 4>{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    m.plc.add_triangle({s[0], s[1], s[2]}, surface);
    m.plc.add_triangle({s[0], s[2], s[3]}, surface++);
  }
  m.plc.add_triangle({4, 5, 6}, surface);
  m.plc.add_triangle({4, 6, 7}, surface);
  m.mesh = tetrahedralize(m.plc);
  return m;
}

}  // namespace refine_models
