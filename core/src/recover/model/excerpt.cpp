// SPDX-License-Identifier: MIT
#include "recover/model/excerpt.hpp"

#include <algorithm>
#include <set>

#include "common/sort_unique.hpp"

namespace geomesh::recover {

namespace {

class ExcerptBuilder {
 public:
  explicit ExcerptBuilder(const Recovery& recovery) : mesh_(recovery.mesh), constraints_(recovery.constraints) {}

  MeshExcerpt build(std::span<const VertexIndex> vertices, std::size_t max_cells) {
    for (const VertexIndex v : vertices) out_.culprits.push_back(number(v));
    std::vector<VertexIndex> ring(vertices.begin(), vertices.end());
    for (int step = 0; step < 2; ++step) ring = add_stars(ring, max_cells);
    for (const Subsegment& s : constraints_.subsegments)
      if (s.live && is_in(s.a) && is_in(s.b)) out_.segments.push_back({rows_[s.a], rows_[s.b]});
    for (const Subfacet& f : constraints_.subfacets)
      if (f.live && f.piece == no_index &&
          std::all_of(f.vertices.begin(), f.vertices.end(), [&](VertexIndex v) { return is_in(v); })) {
        out_.triangles.push_back({rows_[f.vertices[0]], rows_[f.vertices[1]], rows_[f.vertices[2]]});
        out_.facet.push_back(f.facet);
      }
    return std::move(out_);
  }

 private:
  bool is_in(VertexIndex v) const { return v < rows_.size() && rows_[v] != no_vertex; }
  VertexIndex number(VertexIndex v) {
    if (v >= rows_.size()) rows_.resize(mesh_.points().size(), no_vertex);
    if (rows_[v] == no_vertex) {
      rows_[v] = static_cast<VertexIndex>(out_.points.size());
      out_.points.push_back(mesh_.point(v));
    }
    return rows_[v];
  }
  /// Adds the cells around the given vertices to the part of the mesh to be extracted, and returns their new vertices.
  std::vector<VertexIndex> add_stars(const std::vector<VertexIndex>& centres, std::size_t max_cells) {
    std::vector<VertexIndex> reached;
    std::vector<CellIndex> star;
    for (const VertexIndex centre : centres) {
      if (!mesh_.in_mesh(centre)) continue;
      mesh_.star(centre, star);
      for (const CellIndex c : star) {
        const Tetrahedron t = mesh_.cells().vertices(c);
        const bool is_shown = std::none_of(
            t.begin(), t.end(), [&](VertexIndex v) { return v == infinite_vertex || mesh_.is_box_vertex(v); });
        if (!is_shown || out_.tetrahedra.size() >= max_cells || !seen_.insert(c).second) continue;
        for (const VertexIndex v : t)
          if (!is_in(v)) reached.push_back(v);
        out_.tetrahedra.push_back({number(t[0]), number(t[1]), number(t[2]), number(t[3])});
      }
    }
    sort_unique(reached);
    return reached;
  }

  ConstrainedMesh& mesh_;
  const Constraints& constraints_;
  MeshExcerpt out_;
  std::vector<VertexIndex> rows_;  ///< by vertex of the mesh: its row in the excerpt, or no_vertex
  std::set<CellIndex> seen_;
};

}  // namespace

std::shared_ptr<const MeshExcerpt> excerpt_about(const Recovery& recovery, std::span<const VertexIndex> vertices,
                                                 std::size_t max_cells) {
  return std::make_shared<const MeshExcerpt>(ExcerptBuilder(recovery).build(vertices, max_cells));
}

}  // namespace geomesh::recover
