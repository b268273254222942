// SPDX-License-Identifier: MIT
// What lies about some places, for messages, declared in remesh/domain/domain_io.hpp.
#include <algorithm>

#include "common/epoch_marks.hpp"
#include "common/sort_unique.hpp"
#include "remesh/domain/domain_io.hpp"

namespace geomesh::remesh {

namespace {

class LocalExporter {
 public:
  LocalExporter(const DomainMesh& domain, const ConstrainedTetrahedralization& before, EpochMarks& marks)
      : domain_(domain), before_(before), marks_(marks) {}

  ConstrainedTetrahedralization run(std::span<const CellIndex> seeds, unsigned rings) {
    collect_cells(seeds, rings);
    number_points();
    for (const CellIndex c : cells_) {
      Tetrahedron t = domain_.vertices(c);
      for (VertexIndex& v : t) v = row_of(v);
      out_.tetrahedra.push_back(t);
      out_.component.push_back(domain_.component(c));
      add_faces(c);
      add_edges(c);
    }
    sort_edges();
    return std::move(out_);
  }

 private:
  /// The seeds first, then ring by ring.
  void collect_cells(std::span<const CellIndex> seeds, unsigned rings) {
    cells_.assign(seeds.begin(), seeds.end());
    sorted_ = cells_;
    std::sort(sorted_.begin(), sorted_.end());
    std::vector<VertexIndex> done;
    std::vector<CellIndex> star, found;
    for (unsigned k = 0; k < rings; ++k) {
      const std::vector<VertexIndex> all = vertices_of_cells();
      found.clear();
      for (const VertexIndex v : all) {
        if (std::binary_search(done.begin(), done.end(), v)) continue;
        domain_.star(v, marks_, star);
        found.insert(found.end(), star.begin(), star.end());
      }
      sort_unique(found);
      for (const CellIndex c : found)
        if (!std::binary_search(sorted_.begin(), sorted_.end(), c)) cells_.push_back(c);
      sorted_ = cells_;
      std::sort(sorted_.begin(), sorted_.end());
      done = all;
    }
  }
  std::vector<VertexIndex> vertices_of_cells() const {
    std::vector<VertexIndex> all;
    for (const CellIndex c : cells_) all.insert(all.end(), domain_.vertices(c).begin(), domain_.vertices(c).end());
    sort_unique(all);
    return all;
  }

  void number_points() {
    vertices_ = vertices_of_cells();
    for (const VertexIndex v : vertices_) {
      out_.points.push_back(domain_.point(v));
      out_.input_vertex.push_back(input_vertex(domain_, before_, v));
    }
  }
  VertexIndex row_of(VertexIndex v) const {
    return static_cast<VertexIndex>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  }
  bool is_here(CellIndex c) const { return std::binary_search(sorted_.begin(), sorted_.end(), c); }

  /// Once: from above, or where that cell is not here.
  void add_faces(CellIndex c) {
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag tag = domain_.tag(c, i);
      if (!tag.constrained() || tag.facet() == hull_facet) continue;
      const bool is_shared = domain_.has_neighbor(c, i) && is_here(domain_.topology().neighbor_cell(c, i));
      if (is_shared && !tag.above()) continue;
      const Tetrahedron& t = domain_.vertices(c);
      ConstrainedTetrahedralization::Face f;
      for (unsigned k = 0; k < 3; ++k) f.vertices[k] = row_of(t[face_vertices[i][k]]);
      f.facet = tag.facet();
      out_.faces.push_back(f);
    }
  }
  void add_edges(CellIndex c) {
    const Tetrahedron& t = domain_.vertices(c);
    for (const auto& e : edge_vertices) {
      const Index curve = domain_.curve_of(t[e[0]], t[e[1]]);
      if (curve == no_index) continue;
      const VertexIndex a = row_of(t[e[0]]), b = row_of(t[e[1]]);
      for (const Index s : domain_.curve_class(curve).segments)
        out_.edges.push_back({std::min(a, b), std::max(a, b), s});
    }
  }
  /// Each once.
  void sort_edges() {
    const auto key = [](const auto& e) { return std::array{e.a, e.b, e.segment}; };
    std::sort(out_.edges.begin(), out_.edges.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
    out_.edges.erase(std::unique(out_.edges.begin(), out_.edges.end(),
                                 [&](const auto& x, const auto& y) { return key(x) == key(y); }),
                     out_.edges.end());
  }

  const DomainMesh& domain_;
  const ConstrainedTetrahedralization& before_;
  EpochMarks& marks_;
  ConstrainedTetrahedralization out_;
  std::vector<CellIndex> cells_, sorted_;
  std::vector<VertexIndex> vertices_;  // by row
};

}  // namespace

ConstrainedTetrahedralization export_about(const DomainMesh& domain, std::span<const CellIndex> cells, unsigned rings,
                                           const ConstrainedTetrahedralization& before, EpochMarks& marks) {
  return LocalExporter(domain, before, marks).run(cells, rings);
}

}  // namespace geomesh::remesh
