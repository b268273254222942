// SPDX-License-Identifier: GPL-3.0-or-later
#include "halve.hpp"

#include <algorithm>
#include <array>

#include "corners.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::app {

namespace {

/// Appends the midpoints of a sorted list of edges to the points of a mesh, and finds the midpoint of an edge.
class Middles {
 public:
  Middles(std::vector<Vec3>& points, std::vector<Edge> edges) : first_(static_cast<VertexIndex>(points.size())) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges_ = std::move(edges);
    for (const Edge& e : edges_) points.push_back(0.5 * (points[e[0]] + points[e[1]]));
  }
  VertexIndex of(VertexIndex a, VertexIndex b) const {
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), sorted_edge(a, b));
    return first_ + static_cast<VertexIndex>(at - edges_.begin());
  }
  const std::vector<Edge>& edges() const { return edges_; }

 private:
  VertexIndex first_;
  std::vector<Edge> edges_;
};

/// The octahedron between the six midpoints of a tetrahedron's edges is divided around its shortest diagonal. Midpoints
/// are listed in the order in which `pairs` lists the edges.
constexpr std::array<std::array<unsigned, 2>, 6> pairs{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
/// A diagonal of the octahedron, between the midpoints of two opposite edges, and the ring of midpoints around it.
struct Diagonal {
  unsigned from, to;
  std::array<unsigned, 4> ring;
};
constexpr std::array<Diagonal, 3> diagonals{{{0, 5, {1, 2, 4, 3}}, {1, 4, {0, 3, 5, 2}}, {2, 3, {0, 1, 5, 4}}}};

double squared_length(const std::vector<Vec3>& points, VertexIndex a, VertexIndex b) {
  const Vec3 d = points[b] - points[a];
  return dot(d, d);
}

/// Returns the tetrahedron with positive orientation: two vertices are exchanged if it is negative. Throws
/// Error{cannot_mesh} if it is exactly flat.
Tetrahedron oriented(const std::vector<Vec3>& points, Tetrahedron t) {
  const Sign sign = orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  if (sign == Sign::negative) std::swap(t[0], t[1]);
  if (sign == Sign::zero)
    throw Error(ErrorKind::cannot_mesh, "a tetrahedron is too flat to be divided; request other sizes");
  return t;
}

}  // namespace

void halve_tetrahedra(std::vector<Vec3>& points, std::vector<Tetrahedron>& tetrahedra, std::vector<Index>& component) {
  std::vector<Edge> edges;
  edges.reserve(6 * tetrahedra.size());
  for (const Tetrahedron& t : tetrahedra)
    for (const auto& p : pairs) edges.push_back(sorted_edge(t[p[0]], t[p[1]]));
  const Middles middles(points, std::move(edges));
  std::vector<Tetrahedron> pieces;
  std::vector<Index> component_of_piece;
  pieces.reserve(8 * tetrahedra.size());
  component_of_piece.reserve(8 * tetrahedra.size());
  for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
    const Tetrahedron& t = tetrahedra[k];
    std::array<VertexIndex, 6> m;
    for (unsigned e = 0; e < 6; ++e) m[e] = middles.of(t[pairs[e][0]], t[pairs[e][1]]);
    for (unsigned i = 0; i < 4; ++i) {
      Tetrahedron corner = t;
      for (unsigned j = 0; j < 4; ++j)
        if (j != i) corner[j] = middles.of(t[i], t[j]);
      if (orient3d(points[corner[0]], points[corner[1]], points[corner[2]], points[corner[3]]) != Sign::positive)
        throw Error(ErrorKind::cannot_mesh, "a tetrahedron is too flat to be divided; request other sizes");
      pieces.push_back(corner);
    }
    const Diagonal* best = diagonals.data();
    for (const Diagonal& d : diagonals)
      if (squared_length(points, m[d.from], m[d.to]) < squared_length(points, m[best->from], m[best->to])) best = &d;
    for (unsigned i = 0; i < 4; ++i)
      pieces.push_back(oriented(points, {m[best->from], m[best->to], m[best->ring[i]], m[best->ring[(i + 1) % 4]]}));
    component_of_piece.insert(component_of_piece.end(), 8, component[k]);
  }
  tetrahedra = std::move(pieces);
  component = std::move(component_of_piece);
}

void halve_surfaces(geomodel::ModelMesh& mesh) {
  constexpr std::uint8_t on_segment = 2, on_facet = 3;
  std::vector<Edge> edges, curves;
  for (const auto& face : mesh.faces)
    for (unsigned i = 0; i < 3; ++i) edges.push_back(sorted_edge(face.vertices[i], face.vertices[(i + 1) % 3]));
  for (const auto& e : mesh.curve_edges) curves.push_back(sorted_edge(e.a, e.b));
  edges.insert(edges.end(), curves.begin(), curves.end());
  std::sort(curves.begin(), curves.end());
  const Middles middles(mesh.points, std::move(edges));
  for (const Edge& e : middles.edges()) {
    mesh.point_kind.push_back(std::binary_search(curves.begin(), curves.end(), e) ? on_segment : on_facet);
    mesh.input_vertex.push_back(-1);
  }
  std::vector<geomodel::ModelMesh::Face> faces;
  faces.reserve(4 * mesh.faces.size());
  for (const auto& face : mesh.faces) {
    const Triangle& t = face.vertices;
    const VertexIndex a = middles.of(t[1], t[2]), b = middles.of(t[2], t[0]), c = middles.of(t[0], t[1]);
    for (const Triangle& piece :
         {Triangle{t[0], c, b}, Triangle{c, t[1], a}, Triangle{b, a, t[2]}, Triangle{a, b, c}}) {
      faces.push_back(face);
      faces.back().vertices = piece;
    }
  }
  mesh.faces = std::move(faces);
  std::vector<geomodel::ModelMesh::CurveEdge> halves;
  for (const auto& e : mesh.curve_edges) {
    const VertexIndex m = middles.of(e.a, e.b);
    halves.push_back({e.a, m, e.curve});
    halves.push_back({m, e.b, e.curve});
  }
  mesh.curve_edges = std::move(halves);
}

}  // namespace geomesh::app
