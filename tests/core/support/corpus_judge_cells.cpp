// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <set>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

namespace {

bool less(const Vec3& a, const Vec3& b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

/// The pairs of cells that meet in a face.
template <class Visit>
void for_each_inner_face(const Judgement& j, Visit visit) {
  for (std::size_t i = 1; i < j.cell_faces.size(); ++i)
    if (j.cell_faces[i - 1].key.sorted == j.cell_faces[i].key.sorted) visit(j.cell_faces[i - 1], j.cell_faces[i]);
}

VertexIndex vertex_off(const Tetrahedron& t, const Triangle& face) {
  for (VertexIndex v : t)
    if (v != face[0] && v != face[1] && v != face[2]) return v;
  return no_vertex;
}

class Classes {
 public:
  explicit Classes(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) { parent_[find(a)] = find(b); }

 private:
  std::vector<Index> parent_;
};

}  // namespace

void judge_points(Judgement& j) {
  const auto& mesh = j.mesh;
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (VertexIndex v : t) used[v] = 1;
  std::vector<Vec3> sorted = mesh.points;
  std::sort(sorted.begin(), sorted.end(), less);
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) j.fault("points", "two are equal");
  std::array<std::size_t, 5> counts{};
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    const std::string name = "point " + std::to_string(v);
    if (!used[v]) j.fault("points", name + " is in no cell");
    const VertexIndex row = mesh.input_vertex[v];
    ++counts[static_cast<std::size_t>(mesh.origin[v])];
    if ((row == no_vertex) != (mesh.origin[v] != VertexOrigin::input))
      j.fault("points", name + ": origin and input row disagree");
    if (row == no_vertex) continue;
    if (row >= j.plc.points.size() || !(j.plc.points[row] == mesh.points[v])) j.fault("points", name + " has moved");
    if (v > 0 && (mesh.input_vertex[v - 1] == no_vertex || mesh.input_vertex[v - 1] >= row))
      j.fault("points", name + " is out of order");
  }
  const auto count = [&](VertexOrigin o) { return counts[static_cast<std::size_t>(o)]; };
  const auto& s = mesh.recovery;
  if (count(VertexOrigin::on_segment) != s.steiner_on_segments ||
      count(VertexOrigin::on_facet) != s.steiner_on_facets || count(VertexOrigin::inside) != s.steiner_inside ||
      mesh.tetrahedra.size() != s.tetrahedra_final)
    j.fault("points", "the statistics disagree with the mesh");
  if (j.options.recover.preserve_boundary && (count(VertexOrigin::on_segment) > 0 || count(VertexOrigin::on_facet) > 0))
    j.fault("preserve_boundary", std::to_string(count(VertexOrigin::on_segment)) + " points on segments, " +
                                     std::to_string(count(VertexOrigin::on_facet)) + " on facets");
  const std::set<VertexIndex> isolated(j.plc.isolated_points.begin(), j.plc.isolated_points.end());
  const std::set<VertexIndex> listed(mesh.isolated_points.begin(), mesh.isolated_points.end());
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if ((!j.is_added(v) && isolated.count(mesh.input_vertex[v]) > 0) != (listed.count(v) > 0))
      j.fault("isolated points", "point " + std::to_string(v) + " is listed wrongly");
}

void judge_cells(Judgement& j) {
  for (Index c = 0; c < j.mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = j.mesh.tetrahedra[c];
    if (exact_orientation(j.point(t[0]), j.point(t[1]), j.point(t[2]), j.point(t[3])) <= 0)
      j.fault("cells", std::to_string(c) + " is not positive");
  }
  for (std::size_t i = 0; i < j.cell_faces.size();) {
    std::size_t end = i + 1;
    while (end < j.cell_faces.size() && j.cell_faces[end].key.sorted == j.cell_faces[i].key.sorted) ++end;
    const std::string name = "a face of cell " + std::to_string(j.cell_faces[i].cell);
    if (end - i > 2) j.fault("cells", name + " is shared by " + std::to_string(end - i));
    if (end - i == 2 && j.cell_faces[i].key.even == j.cell_faces[i + 1].key.even)
      j.fault("cells", name + " is shared from the same side");
    if (end - i == 1 && j.facet_of(j.cell_faces[i].key.sorted) == no_index)
      j.fault("cells", name + " bounds the mesh and is in no facet");
    i = end;
  }
}

void judge_components(Judgement& j) {
  const auto& component = j.mesh.component;
  const std::size_t n = j.mesh.n_components;
  for (Index c : component)
    if (c >= n) return j.fault("components", "number out of range");
  if (j.mesh.component_seed.size() != n) j.fault("components", "one seed a component is wanted");
  Classes classes(component.size());
  for_each_inner_face(j, [&](const Judgement::CellFace& a, const Judgement::CellFace& b) {
    if (j.facet_of(a.key.sorted) != no_index) return;
    classes.join(a.cell, b.cell);
    if (component[a.cell] != component[b.cell])
      j.fault("components", "two meet without a facet, at cell " + std::to_string(a.cell));
  });
  std::vector<Index> representative(n, no_index);
  for (Index c = 0; c < component.size(); ++c) {
    Index& r = representative[component[c]];
    if (r == no_index) r = classes.find(c);
    if (r != classes.find(c)) j.fault("components", std::to_string(component[c]) + " is parted by facets");
  }
  std::vector<std::uint64_t> first(n, ~std::uint64_t{0});
  for (const auto& f : j.mesh.faces)
    for (std::uint64_t above = 0; above < 2; ++above) {
      const Index cell = above ? f.tetrahedron_above : f.tetrahedron_below;
      if (cell < component.size())
        first[component[cell]] = std::min(first[component[cell]], 2 * std::uint64_t{f.facet} + above);
    }
  for (std::size_t c = 0; c < n; ++c) {
    if (representative[c] == no_index) j.fault("components", std::to_string(c) + " has no cell");
    if (c > 0 && first[c - 1] > first[c]) j.fault("components", std::to_string(c) + " is numbered out of order");
  }
}

void judge_delaunay(Judgement& j) {
  if (!j.mesh.delaunay) return;
  const std::set<Index> given_up(j.mesh.recovery.facets_not_recovered.begin(),
                                 j.mesh.recovery.facets_not_recovered.end());
  for_each_inner_face(j, [&](const Judgement::CellFace& a, const Judgement::CellFace& b) {
    const Index facet = j.facet_of(a.key.sorted);
    if (facet != no_index && given_up.count(facet) > 0) return;
    const Tetrahedron& t = j.mesh.tetrahedra[a.cell];
    const VertexIndex opposite = vertex_off(j.mesh.tetrahedra[b.cell], a.key.sorted);
    if (opposite != no_vertex &&
        exactly_inside_sphere({j.point(t[0]), j.point(t[1]), j.point(t[2]), j.point(t[3])}, j.point(opposite)))
      j.fault("delaunay",
              "point " + std::to_string(opposite) + " is inside the sphere of cell " + std::to_string(a.cell));
  });
}

}  // namespace geomesh::test
