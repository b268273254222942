// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/isosurface.hpp"

#include <algorithm>
#include <utility>

#include "level_sets/mesh/adapt.hpp"
#include "level_sets/mesh/balancing_shift.hpp"
#include "level_sets/mesh/crossed_edges.hpp"
#include "level_sets/mesh/move_vertices.hpp"

namespace geomesh::geomodel {
namespace {

/// The corners of a cell, sorted so that those below the isovalue come first. If one or three are below, the order has
/// positive volume. If two are, each pair is ascending, so that the quadrangles of all isovalues are divided by the
/// same rule.
struct SortedCell {
  std::array<VertexIndex, 4> v;
  int n_below;
  bool is_positive;
};

SortedCell sorted(const BackgroundMesh::Cell& cell, double value, const MovedVertices& vertices) {
  SortedCell result{cell.v, 0, true};
  auto& v = result.v;
  const auto is_below = [&](VertexIndex i) { return vertices.values[i] < value; };
  const Vec3 &o = vertices.points[v[0]], &x = vertices.points[v[1]], &y = vertices.points[v[2]];
  result.is_positive = dot(cross(x - o, y - o), vertices.points[v[3]] - o) > 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (std::pair(!is_below(v[j]), v[j]) < std::pair(!is_below(v[i]), v[i])) {
        std::swap(v[i], v[j]);
        result.is_positive = !result.is_positive;
      }
  result.n_below = static_cast<int>(std::count_if(v.begin(), v.end(), is_below));
  if (result.is_positive || result.n_below == 2) return result;
  if (result.n_below == 1) std::swap(v[2], v[3]);
  if (result.n_below == 3) std::swap(v[0], v[1]);
  return result;
}

class Marcher {
 public:
  Marcher(const BackgroundMesh& mesh, const MovedVertices& vertices, const CrossedEdges& edges, double value,
          std::size_t row)
      : mesh_(mesh),
        vertices_(vertices),
        edges_(edges),
        value_(value),
        row_(row),
        of_edge_(edges.edges().size(), no_vertex),
        of_vertex_(mesh.n_points(), no_vertex) {}

  Isosurface march() {
    for (std::size_t c = 0; c < mesh_.cells().size(); ++c) march_cell(c);
    drop_duplicates();
    return std::move(surface_);
  }

 private:
  VertexIndex vertex(VertexIndex below, VertexIndex above) {
    const bool is_corner = vertices_.values[above] == value_;
    const std::size_t edge = is_corner ? 0 : edges_.row(below, above);
    VertexIndex& id = is_corner ? of_vertex_[above] : of_edge_[edge];
    if (id == no_vertex) {
      id = static_cast<VertexIndex>(surface_.points.size());
      surface_.points.push_back(is_corner ? vertices_.points[above] : edges_.root(row_, edge));
    }
    return id;
  }

  void add(const Triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    surface_.triangles.push_back(t);
    surface_.cell.push_back(cell_);
    surface_.gradient.push_back(gradient_);
  }

  void march_cell(std::size_t row) {
    const BackgroundMesh::Cell& cell = mesh_.cells()[row];
    const auto& f = vertices_.values;
    const auto [low, high] = std::minmax({f[cell.v[0]], f[cell.v[1]], f[cell.v[2]], f[cell.v[3]]});
    if (!(low < value_ && value_ <= high)) return;
    cell_ = row;
    const auto& p = vertices_.points;
    gradient_ = linear_in({p[cell.v[0]], p[cell.v[1]], p[cell.v[2]], p[cell.v[3]]},
                          {f[cell.v[0]], f[cell.v[1]], f[cell.v[2]], f[cell.v[3]]})
                    .gradient;
    const auto [v, n_below, is_positive] = sorted(cell, value_, vertices_);
    if (n_below == 1) {
      add({vertex(v[0], v[1]), vertex(v[0], v[2]), vertex(v[0], v[3])});
    } else if (n_below == 3) {
      add({vertex(v[0], v[3]), vertex(v[1], v[3]), vertex(v[2], v[3])});
    } else {
      const VertexIndex ac = vertex(v[0], v[2]), ad = vertex(v[0], v[3]);
      const VertexIndex bd = vertex(v[1], v[3]), bc = vertex(v[1], v[2]);
      add(is_positive ? Triangle{ac, ad, bd} : Triangle{ac, bd, ad});
      add(is_positive ? Triangle{ac, bd, bc} : Triangle{ac, bc, bd});
    }
  }

  /// Removes pairs of triangles with the same corners. They enclose no volume, as the field only touches the isovalue.
  void drop_duplicates() {
    std::vector<std::pair<Triangle, std::size_t>> sorted;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      Triangle corners = surface_.triangles[t];
      std::sort(corners.begin(), corners.end());
      sorted.emplace_back(corners, t);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<char> is_dropped(sorted.size(), 0);
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
      if (sorted[i].first == sorted[i + 1].first) {
        is_dropped[sorted[i].second] = is_dropped[sorted[i + 1].second] = 1;
        ++i;
      }
    std::size_t kept = 0;
    for (std::size_t t = 0; t < is_dropped.size(); ++t) {
      if (is_dropped[t]) continue;
      surface_.triangles[kept] = surface_.triangles[t];
      surface_.cell[kept] = surface_.cell[t];
      surface_.gradient[kept++] = surface_.gradient[t];
    }
    surface_.triangles.resize(kept);
    surface_.cell.resize(kept);
    surface_.gradient.resize(kept);
  }

  const BackgroundMesh& mesh_;
  const MovedVertices& vertices_;
  const CrossedEdges& edges_;
  double value_;
  std::size_t row_;
  std::vector<VertexIndex> of_edge_, of_vertex_;
  Isosurface surface_;
  std::size_t cell_ = 0;
  Vec3 gradient_;
};

std::vector<Isosurface> extract(const BackgroundMesh& mesh, const ScalarField* field, const std::vector<double>& values,
                                const std::vector<double>& shift) {
  MovedVertices vertices(mesh, shift);
  const CrossedEdges before(mesh, vertices, field, values, nullptr);
  if (field) move_vertices(mesh, before, values, vertices);
  const CrossedEdges edges(mesh, vertices, field, values, &before);
  std::vector<Isosurface> surfaces;
  for (std::size_t v = 0; v < values.size(); ++v)
    surfaces.push_back(Marcher(mesh, vertices, edges, values[v], v).march());
  return surfaces;
}

}  // namespace

std::vector<Isosurface> extract_isosurfaces(const BackgroundMesh& mesh, const ScalarField* field,
                                            const std::vector<double>& values) {
  const std::vector<double> none(mesh.n_points(), 0);
  const std::vector<Isosurface> surfaces = extract(mesh, field, values, none);
  return field ? extract(mesh, field, values, balancing_shift(mesh, *field, surfaces, values)) : surfaces;
}

}  // namespace geomesh::geomodel
