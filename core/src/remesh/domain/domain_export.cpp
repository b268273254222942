// SPDX-License-Identifier: MIT
// From the domain to a mesh in the caller's terms, declared in remesh/domain/domain_io.hpp.
#include <algorithm>
#include <numeric>

#include "remesh/domain/domain_io.hpp"

namespace geomesh::remesh {

namespace {

class Exporter {
 public:
  Exporter(const DomainMesh& domain, const ConstrainedTetrahedralization& before) : domain_(domain), before_(before) {}

  ConstrainedTetrahedralization run() {
    out_.n_components = before_.n_components;
    out_.component_seed = before_.component_seed;
    out_.recovery = before_.recovery;
    out_.recovery.tetrahedra_final = domain_.n_cells();
    out_.delaunay_statistics = before_.delaunay_statistics;
    number_points();
    add_cells();
    add_faces();
    add_edges();
    for (const VertexIndex v : before_.isolated_points)
      if (row_[v] != no_vertex) out_.isolated_points.push_back(row_[v]);
    return std::move(out_);
  }

 private:
  VertexIndex input_of(VertexIndex v) const { return input_vertex(domain_, before_, v); }

  /// An input vertex that moved, or a curve's, is told by its kind now.
  VertexOrigin origin_of(VertexIndex v) const {
    if (input_of(v) != no_vertex) return VertexOrigin::input;
    switch (domain_.kind(v)) {
      case VertexKind::curve:
        return VertexOrigin::on_segment;
      case VertexKind::surface:
        return VertexOrigin::on_facet;
      case VertexKind::inside:
        return VertexOrigin::inside;
      default:
        return v < before_.origin.size() ? before_.origin[v] : VertexOrigin::on_segment;
    }
  }

  void number_points() {
    std::vector<VertexIndex> order;
    for (VertexIndex v = 0; v < domain_.n_vertices(); ++v)
      if (domain_.kind(v) != VertexKind::dead) order.push_back(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](VertexIndex a, VertexIndex b) { return input_of(a) < input_of(b); });
    row_.assign(domain_.n_vertices(), no_vertex);
    for (const VertexIndex v : order) {
      row_[v] = static_cast<VertexIndex>(out_.points.size());
      out_.points.push_back(domain_.point(v));
      out_.input_vertex.push_back(input_of(v));
      out_.origin.push_back(origin_of(v));
    }
  }

  void add_cells() {
    cell_row_.assign(domain_.n_slots(), no_index);
    for (CellIndex c = 0; c < domain_.n_slots(); ++c) {
      if (!domain_.is_live(c)) continue;
      cell_row_[c] = static_cast<Index>(out_.tetrahedra.size());
      Tetrahedron t = domain_.vertices(c);
      for (VertexIndex& v : t) v = row_[v];
      out_.tetrahedra.push_back(t);
      out_.component.push_back(domain_.component(c));
    }
  }

  void add_faces() {
    for (CellIndex c = 0; c < domain_.n_slots(); ++c) {
      if (!domain_.is_live(c)) continue;
      for (unsigned i = 0; i < 4; ++i) {
        const FaceTag t = domain_.tag(c, i);
        if (!t.constrained() || t.facet() == hull_facet || (!t.above() && domain_.has_neighbor(c, i))) continue;
        const Tetrahedron& v = domain_.vertices(c);
        ConstrainedTetrahedralization::Face f;
        for (unsigned k = 0; k < 3; ++k) f.vertices[k] = row_[v[face_vertices[i][k]]];
        f.facet = t.facet();
        if (t.above()) {
          f.tetrahedron_above = cell_row_[c];
          if (domain_.has_neighbor(c, i)) f.tetrahedron_below = cell_row_[domain_.topology().neighbor_cell(c, i)];
        } else {
          std::swap(f.vertices[1], f.vertices[2]);
          f.tetrahedron_below = cell_row_[c];
        }
        out_.faces.push_back(f);
      }
    }
    std::stable_sort(out_.faces.begin(), out_.faces.end(),
                     [](const auto& a, const auto& b) { return a.facet < b.facet; });
  }

  void add_edges() {
    for (const auto& [a, b] : domain_.curve_edges())
      for (const Index s : domain_.curve_class(domain_.curve_of(a, b)).segments)
        out_.edges.push_back({row_[a], row_[b], s});
    std::stable_sort(out_.edges.begin(), out_.edges.end(),
                     [](const auto& a, const auto& b) { return a.segment < b.segment; });
  }

  const DomainMesh& domain_;
  const ConstrainedTetrahedralization& before_;
  ConstrainedTetrahedralization out_;
  std::vector<VertexIndex> row_;
  std::vector<Index> cell_row_;
};

}  // namespace

VertexIndex input_vertex(const DomainMesh& domain, const ConstrainedTetrahedralization& before, VertexIndex v) {
  if (v >= before.input_vertex.size() || before.input_vertex[v] == no_vertex) return no_vertex;
  return domain.point(v) == before.points[v] ? before.input_vertex[v] : no_vertex;
}

ConstrainedTetrahedralization export_domain(const DomainMesh& domain, const ConstrainedTetrahedralization& before) {
  return Exporter(domain, before).run();
}

}  // namespace geomesh::remesh
