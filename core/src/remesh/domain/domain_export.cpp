// SPDX-License-Identifier: MIT
// Converts the mesh that refinement works on, or a part of it, to the caller's format. Declared in
// remesh/domain/domain_io.hpp.
#include <algorithm>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "common/sort_unique.hpp"
#include "remesh/domain/domain_io.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;
using Face = ConstrainedTetrahedralization::Face;

class Exporter {
 public:
  Exporter(const DomainMesh& domain, const ConstrainedTetrahedralization& before, ExportScratch& scratch,
           unsigned threads = 1)
      : domain_(domain),
        before_(before),
        marks_(scratch.marks),
        row_(scratch.vertex_row),
        cell_row_(scratch.cell_row),
        threads_(threads) {
    row_.resize(std::max(row_.size(), domain.n_vertices()), no_vertex);
    cell_row_.resize(std::max<std::size_t>(cell_row_.size(), domain.n_slots()), no_index);
  }

  ConstrainedTetrahedralization whole() {
    for (VertexIndex v = 0; v < domain_.n_vertices(); ++v)
      if (domain_.kind(v) != VertexKind::dead) add_vertex(v);
    cells_.reserve(domain_.n_cells());
    for (const CellIndex c : domain_.live_cells()) {
      cell_row_[c] = static_cast<Index>(cells_.size());
      cells_.push_back(c);
    }
    out_.n_components = before_.n_components;
    out_.component_seed = before_.component_seed;
    out_.recovery = before_.recovery;
    out_.recovery.tetrahedra_final = domain_.n_cells();
    out_.delaunay_statistics = before_.delaunay_statistics;
    fill(domain_.curve_edges());
    for (const VertexIndex v : before_.isolated_points)
      if (row_[v] != no_vertex) out_.isolated_points.push_back(row_[v]);
    return std::move(out_);
  }

  /// Exports a part of the mesh: the given cells first, then the cells around them ring by ring.
  ConstrainedTetrahedralization about(std::span<const CellIndex> seeds, unsigned rings) {
    for (const CellIndex c : seeds) add_cell(c);
    std::vector<CellIndex> star;
    for (std::size_t ring = 0, k = 0; ring < rings; ++ring)
      for (const std::size_t n = vertices_.size(); k < n; ++k) {
        domain_.star(vertices_[k], marks_, star);
        for (const CellIndex c : star)
          if (cell_row_[c] == no_index) add_cell(c);
      }
    fill(curves_of_cells());
    for (const CellIndex c : cells_) cell_row_[c] = no_index;
    for (const VertexIndex v : vertices_) row_[v] = no_vertex;
    return std::move(out_);
  }

 private:
  void add_cell(CellIndex c) {
    cell_row_[c] = static_cast<Index>(cells_.size());
    cells_.push_back(c);
    for (const VertexIndex v : domain_.vertices(c)) add_vertex(v);
  }
  void add_vertex(VertexIndex v) {
    if (row_[v] != no_vertex) return;
    row_[v] = 0;  // marks v as part of the export; its number there is set later
    vertices_.push_back(v);
  }
  VertexIndex input_of(VertexIndex v) const { return input_vertex(domain_, before_, v); }

  /// Returns the origin of a vertex. Input vertices that moved get the origin of their kind (curve, surface or inside).
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

  void fill(const std::vector<Edge>& curves) {
    std::sort(vertices_.begin(), vertices_.end());
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [&](VertexIndex a, VertexIndex b) { return input_of(a) < input_of(b); });
    out_.points.reserve(vertices_.size());
    out_.input_vertex.reserve(vertices_.size());
    out_.origin.reserve(vertices_.size());
    for (const VertexIndex v : vertices_) {
      row_[v] = static_cast<VertexIndex>(out_.points.size());
      out_.points.push_back(domain_.point(v));
      out_.input_vertex.push_back(input_of(v));
      out_.origin.push_back(origin_of(v));
    }
    fill_cells();
    std::stable_sort(out_.faces.begin(), out_.faces.end(),
                     [](const auto& a, const auto& b) { return a.facet < b.facet; });
    for (const auto& [a, b] : curves)
      for (const Index s : domain_.curve_class(domain_.curve_of(a, b)).segments)
        out_.edges.push_back({row_[a], row_[b], s});
    std::stable_sort(out_.edges.begin(), out_.edges.end(),
                     [](const auto& a, const auto& b) { return a.segment < b.segment; });
  }

  /// Writes the cells to the export, then the constrained faces in the cells' order. All vertices must be numbered.
  void fill_cells() {
    constexpr std::size_t chunk = 16384;
    out_.tetrahedra.resize(cells_.size());
    out_.component.resize(cells_.size());
    std::vector<std::vector<Face>> faces((cells_.size() + chunk - 1) / chunk);
    for_each_task(faces.size(), threads_, [&](std::size_t task) {
      for (std::size_t k = task * chunk; k < std::min(cells_.size(), (task + 1) * chunk); ++k) {
        const CellIndex c = cells_[k];
        Tetrahedron t = domain_.vertices(c);
        for (VertexIndex& v : t) v = row_[v];
        out_.tetrahedra[k] = t;
        out_.component[k] = domain_.component(c);
        for (unsigned i = 0; i < 4; ++i) add_face(FaceRef(c, i), faces[task]);
      }
    });
    for (const std::vector<Face>& of_task : faces) out_.faces.insert(out_.faces.end(), of_task.begin(), of_task.end());
  }

  /// Writes a constrained face once: from the cell above it, or from the cell below if the one above is not exported.
  void add_face(FaceRef face, std::vector<Face>& faces) const {
    const FaceTag tag = domain_.tag(face);
    if (!tag.constrained() || tag.facet() == hull_facet) return;
    const FaceRef other = domain_.cells().mirror(face);
    const Index here = cell_row_[face.cell()], there = other.valid() ? cell_row_[other.cell()] : no_index;
    if (!tag.above() && there != no_index) return;
    Triangle t = domain_.facet_face(face);
    for (VertexIndex& v : t) v = row_[v];
    Face f;
    f.vertices = t;
    f.facet = tag.facet();
    f.tetrahedron_above = tag.above() ? here : no_index;
    f.tetrahedron_below = tag.above() ? there : here;
    faces.push_back(f);
  }

  std::vector<Edge> curves_of_cells() const {
    std::vector<Edge> curves;
    for (const CellIndex c : cells_)
      for (const auto& e : edge_vertices) {
        const Tetrahedron& t = domain_.vertices(c);
        if (domain_.curve_of(t[e[0]], t[e[1]]) != no_index) curves.push_back(sorted(Edge{t[e[0]], t[e[1]]}));
      }
    sort_unique(curves);
    return curves;
  }

  const DomainMesh& domain_;
  const ConstrainedTetrahedralization& before_;
  EpochMarks& marks_;
  std::vector<VertexIndex>& row_;
  std::vector<Index>& cell_row_;
  unsigned threads_;
  std::vector<CellIndex> cells_;
  std::vector<VertexIndex> vertices_;
  ConstrainedTetrahedralization out_;
};

}  // namespace

VertexIndex input_vertex(const DomainMesh& domain, const ConstrainedTetrahedralization& before, VertexIndex v) {
  if (v >= before.input_vertex.size() || before.input_vertex[v] == no_vertex) return no_vertex;
  return domain.point(v) == before.points[v] ? before.input_vertex[v] : no_vertex;
}

ConstrainedTetrahedralization export_domain(const DomainMesh& domain, const ConstrainedTetrahedralization& before,
                                            unsigned threads) {
  ExportScratch scratch;
  return Exporter(domain, before, scratch, thread_count(threads)).whole();
}

ConstrainedTetrahedralization export_about(const DomainMesh& domain, std::span<const CellIndex> cells, unsigned rings,
                                           const ConstrainedTetrahedralization& before, ExportScratch& scratch) {
  return Exporter(domain, before, scratch).about(cells, rings);
}

}  // namespace geomesh::remesh
