// SPDX-License-Identifier: MIT
#include "classify/classify.hpp"

#include <algorithm>

#include "common/flood.hpp"
#include "recover/model/presence.hpp"

namespace geomesh::classify {

namespace {

using recover::ConstrainedMesh;
using recover::DeclaredModel;
using recover::Subfacet;
using recover::Subsegment;

constexpr Index unvisited = no_index, outside = no_index - 1, dropped = no_index - 2;

class Classifier {
 public:
  Classifier(ConstrainedMesh& mesh, DeclaredModel& model, const PiecewiseLinearComplex& plc, const RunContext& context)
      : mesh_(mesh), model_(model), plc_(plc), context_(context), label_(mesh.cells().n_slots(), unvisited) {}

  ConstrainedTetrahedralization run() {
    flood_outside();
    for (const auto& seed : plc_.hole_seeds) flood_hole(seed);
    order_subfacets();
    number_components();
    if (out_.n_components == 0)
      throw Error(ErrorKind::cannot_mesh,
                  "the facets enclose no space, so there is nothing to mesh: close the surfaces, add a box, or keep "
                  "the convex hull");
    mark_regions();
    emit_points();
    emit_cells();
    emit_faces();
    emit_edges();
    return std::move(out_);
  }

 private:
  const TetMesh& cells() const { return mesh_.cells(); }

  void flood(CellIndex start, Index label) {
    flood_cells(cells(), start, label_, unvisited, label, [&](FaceRef f) { return !mesh_.is_locked(f); });
  }
  void flood_outside() {
    for (std::size_t k = 0; k < 8; ++k) {
      const CellIndex c = mesh_.cell_of(static_cast<VertexIndex>(mesh_.n_input() + k));
      if (label_[c] == unvisited) flood(c, outside);
    }
  }
  void flood_hole(const PiecewiseLinearComplex::Seed& seed) {
    const CellIndex c = mesh_.locate(seed.point, mesh_.cell_of(0));
    if (c == no_cell || label_[c] == outside) {
      context_.note(LogLevel::warning, "a hole seed lies outside the model");
    } else if (label_[c] == unvisited) {
      flood(c, dropped);
    }
  }

  /// Live subfacets by facet, so that numbers and output do not depend on the course of recovery.
  void order_subfacets() {
    for (Index f = 0; f < model_.constraints.subfacets.size(); ++f)
      if (model_.constraints.subfacets[f].live) subfacets_.push_back(f);
    std::stable_sort(subfacets_.begin(), subfacets_.end(), [&](Index a, Index b) {
      return model_.constraints.subfacets[a].facet < model_.constraints.subfacets[b].facet;
    });
    for (Index f : subfacets_) above_.push_back(recover::face_of_subfacet(mesh_, model_.constraints, f));
  }
  void number_components() {
    Index next = 0;
    for (const FaceRef above : above_)
      for (const CellIndex c : {cells().mirror(above).cell(), above.cell()})
        if (label_[c] == unvisited) flood(c, next++);
    out_.n_components = next;
  }
  void mark_regions() {
    out_.component_seed.assign(out_.n_components, no_index);
    for (const auto& seed : plc_.region_seeds) {
      const CellIndex c = mesh_.locate(seed.point, mesh_.cell_of(0));
      if (c == no_cell || label_[c] >= out_.n_components) {
        context_.note(LogLevel::warning, "a region seed lies outside every region");
        continue;
      }
      Index& slot = out_.component_seed[label_[c]];
      if (slot == no_index) {
        slot = seed.id;
      } else if (slot != seed.id) {
        context_.note(LogLevel::warning, "two region seeds lie in one region; the first one names it");
      }
    }
  }

  bool kept(CellIndex c) const { return label_[c] < out_.n_components; }

  void emit_points() {
    point_.assign(mesh_.points().size(), no_vertex);
    std::vector<std::uint8_t> used(mesh_.points().size(), 0);
    for (CellIndex c = 0; c < cells().n_slots(); ++c)
      if (cells().is_live(c) && kept(c))
        for (VertexIndex v : cells().vertices(c)) used[v] = 1;
    for (VertexIndex v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      point_[v] = static_cast<VertexIndex>(out_.points.size());
      out_.points.push_back(mesh_.point(v));
      out_.input_vertex.push_back(v < mesh_.n_input() ? model_.input_vertex[v] : no_vertex);
      out_.origin.push_back(model_.constraints.vertices[v].origin);
    }
    for (VertexIndex v : model_.isolated_points)
      if (point_[v] != no_vertex) out_.isolated_points.push_back(point_[v]);
  }
  void emit_cells() {
    tetrahedron_.assign(cells().n_slots(), no_index);
    for (CellIndex c = 0; c < cells().n_slots(); ++c) {
      if (!cells().is_live(c) || !kept(c)) continue;
      tetrahedron_[c] = static_cast<Index>(out_.tetrahedra.size());
      const auto& v = cells().vertices(c);
      out_.tetrahedra.push_back({point_[v[0]], point_[v[1]], point_[v[2]], point_[v[3]]});
      out_.component.push_back(label_[c]);
    }
    out_.recovery.tetrahedra_final = out_.tetrahedra.size();
  }
  void emit_faces() {
    for (std::size_t i = 0; i < subfacets_.size(); ++i) {
      const CellIndex above = above_[i].cell(), below = cells().mirror(above_[i]).cell();
      if (!kept(above) && !kept(below)) continue;
      const Subfacet& f = model_.constraints.subfacets[subfacets_[i]];
      out_.faces.push_back({{point_[f.vertices[0]], point_[f.vertices[1]], point_[f.vertices[2]]},
                            f.facet,
                            tetrahedron_[below],
                            tetrahedron_[above]});
    }
  }
  void emit_edges() {
    if (model_.segment_of_row.empty()) return;
    const auto& constraints = model_.constraints;
    std::vector<std::vector<Index>> parts(constraints.segments.size());
    for (Index i = 0; i < constraints.subsegments.size(); ++i) {
      const Subsegment& s = constraints.subsegments[i];
      if (s.live && s.segment != no_index && constraints.segments[s.segment].row != no_index)
        parts[s.segment].push_back(i);
    }
    for (Index row = 0; row < model_.segment_of_row.size(); ++row)
      for (const Index i : parts[model_.segment_of_row[row]]) {
        const Subsegment& s = constraints.subsegments[i];
        if (point_[s.a] != no_vertex && point_[s.b] != no_vertex && is_kept_edge(i))
          out_.edges.push_back({point_[s.a], point_[s.b], row});
      }
  }
  /// Some cell about the edge is kept; both ends may be though none is.
  bool is_kept_edge(Index subsegment) const {
    const Subsegment& s = model_.constraints.subsegments[subsegment];
    recover::EdgeRing ring;
    mesh_.ring(recover::cell_of_subsegment(mesh_, model_.constraints, subsegment), s.a, s.b, ring);
    return std::any_of(ring.cells.begin(), ring.cells.end(), [&](CellIndex c) { return kept(c); });
  }

  ConstrainedMesh& mesh_;
  DeclaredModel& model_;
  const PiecewiseLinearComplex& plc_;
  const RunContext& context_;
  std::vector<Index> label_;
  std::vector<Index> subfacets_;
  std::vector<FaceRef> above_;
  std::vector<VertexIndex> point_;
  std::vector<Index> tetrahedron_;
  ConstrainedTetrahedralization out_;
};

}  // namespace

ConstrainedTetrahedralization classify(ConstrainedMesh& mesh, DeclaredModel& model, const PiecewiseLinearComplex& plc,
                                       const RunContext& context) {
  return Classifier(mesh, model, plc, context).run();
}

}  // namespace geomesh::classify
