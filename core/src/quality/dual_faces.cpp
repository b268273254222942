// SPDX-License-Identifier: MIT
#include "geomesh/core/dual_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/core/voronoi_dual.hpp"
#include "mesh/circumcentre.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

/// The part of an edge's dual face inside one tetrahedron, listed under the edge's vertex of lower index.
struct Part {
  VertexIndex second;
  double area;
};

/// Returns the signed area of the part of the dual face of edge a-b that is in a cell, next to face a,b,c. The part is
/// a right triangle between the edge's midpoint, the face's circumcentre and the cell's circumcentre. Each leg has a
/// sign: positive towards c in the face, and towards the apex off the face.
double dual_piece(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& apex, const Vec3& cell_centre) {
  const auto face_centre = circumcentre(a, b, c);
  const Vec3 u = b - a, n = cross(u, c - a);
  if (!face_centre || dot(n, n) == 0) return 0;
  const Vec3 middle = 0.5 * (a + b), in_face = cross(n, u);  // points towards c
  const double along = dot(*face_centre - middle, in_face) / length(in_face);
  const double up = dot(cell_centre - *face_centre, n) / length(n) * (dot(apex - a, n) > 0 ? 1 : -1);
  return 0.5 * along * up;
}

/// The vertices in [from, to), and the parts of dual faces of edges whose vertex of lower index is one of them.
struct Window {
  std::size_t from, to;
  std::vector<std::size_t>& end_of;  ///< for each vertex in [from, to): where the parts of its edges end in `parts`
  std::vector<Part>& parts;
  // If v is below `from`, the unsigned difference wraps around to a large number, so one comparison is enough.
  bool has(VertexIndex v) const { return v - from < to - from; }
};

/// Adds the part in tetrahedron t of the dual face of each edge of t whose lower vertex is in the window.
void add_parts(std::span<const Vec3> points, const Tetrahedron& t, Window& window) {
  // The tests of the four vertices are combined with |, so that there is one branch instead of four.
  if (!(window.has(t[0]) | window.has(t[1]) | window.has(t[2]) | window.has(t[3]))) return;
  const auto centre = circumcentre(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  if (!centre) return;
  for (const auto& e : edge_vertices) {
    if (!window.has(std::min(t[e[0]], t[e[1]]))) continue;
    std::array<unsigned, 2> rest{};
    unsigned n = 0;
    for (unsigned k = 0; k < 4; ++k)
      if (k != e[0] && k != e[1]) rest[n++] = k;
    const Vec3 &a = points[t[e[0]]], &b = points[t[e[1]]], &c = points[t[rest[0]]], &d = points[t[rest[1]]];
    const auto [first, second] = std::minmax(t[e[0]], t[e[1]]);
    window.parts[window.end_of[first - window.from]++] = {
        second, dual_piece(a, b, c, d, *centre) + dual_piece(a, b, d, c, *centre)};
  }
}

/// Returns the sorted edges of boundary faces, which are the faces of one tetrahedron only.
std::vector<std::array<VertexIndex, 2>> border_edges(std::span<const Tetrahedron> tetrahedra) {
  std::vector<Triangle> faces;
  for (const Tetrahedron& t : tetrahedra)
    for (const auto& l : face_vertices) {
      Triangle f{t[l[0]], t[l[1]], t[l[2]]};
      std::sort(f.begin(), f.end());
      faces.push_back(f);
    }
  std::sort(faces.begin(), faces.end());
  std::vector<std::array<VertexIndex, 2>> edges;
  for (std::size_t i = 0, j = 0; i < faces.size(); i = j) {
    for (j = i; j < faces.size() && faces[j] == faces[i];) ++j;
    if (j - i == 1)
      for (const auto& e : {std::array{faces[i][0], faces[i][1]}, std::array{faces[i][0], faces[i][2]},
                            std::array{faces[i][1], faces[i][2]}})
        edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

void for_each_dual_face(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                        const std::function<void(const DualFace&)>& use) {
  std::vector<std::uint32_t> n_parts_at(points.size(), 0);  // dual-face parts by the lower vertex of their edge
  for (const Tetrahedron& t : tetrahedra)
    for (const auto& e : edge_vertices) ++n_parts_at[std::min(t[e[0]], t[e[1]])];
  constexpr std::size_t n_windows = 16, least_at_once = 1 << 12;
  const std::size_t at_once = std::max(least_at_once, 6 * tetrahedra.size() / n_windows);
  // The list of parts is as long as the largest window of vertices needs, so that it is never reallocated.
  std::vector<Part> parts(
      points.empty()
          ? 0
          : std::min(6 * tetrahedra.size(),
                     std::max<std::size_t>(at_once, *std::max_element(n_parts_at.begin(), n_parts_at.end()))));
  std::vector<std::size_t> begin_of, end_of;
  for (std::size_t from = 0; from < points.size();) {
    std::size_t to = from, n = 0;
    do {
      n += n_parts_at[to++];
    } while (to < points.size() && n + n_parts_at[to] <= at_once);
    begin_of.assign(1, 0);
    for (std::size_t v = from; v < to; ++v) begin_of.push_back(begin_of.back() + n_parts_at[v]);
    end_of.assign(begin_of.begin(), begin_of.end() - 1);
    Window window{from, to, end_of, parts};
    for (const Tetrahedron& t : tetrahedra) add_parts(points, t, window);
    for (std::size_t v = from; v < to; ++v) {
      const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(begin_of[v - from]),
                 end = parts.begin() + static_cast<std::ptrdiff_t>(end_of[v - from]);
      std::stable_sort(begin, end, [](const Part& x, const Part& y) { return x.second < y.second; });
      for (auto i = begin, j = begin; i != end; i = j) {
        double area = 0;
        for (j = i; j != end && j->second == i->second; ++j) area += j->area;
        use({static_cast<VertexIndex>(v), i->second, area});
      }
    }
    from = to;
  }
}

VoronoiDual measure_voronoi_dual(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  VoronoiDual dual;
  const auto border = border_edges(tetrahedra);
  for_each_dual_face(points, tetrahedra, [&](const DualFace& face) {
    const double relative = face.area / squared_distance(points[face.a], points[face.b]);
    dual.least = dual.edges == 0 ? relative : std::min(dual.least, relative);
    ++dual.edges;
    if (relative >= -1e-12) return;
    ++dual.negative;
    dual.negative_on_border += std::binary_search(border.begin(), border.end(), std::array{face.a, face.b});
  });
  return dual;
}

}  // namespace geomesh
