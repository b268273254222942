// SPDX-License-Identifier: MIT
#include "recover/start/hard_parts_first.hpp"

#include <algorithm>

#include "mesh/sorted_cells.hpp"
#include "mesh/spatial_order.hpp"
#include "recover/model/messages.hpp"
#include "recover/operations/star_insertion.hpp"

namespace geomesh::recover {

namespace {

/// Marks the vertices of segments and facets that were hard to recover, and of all facets around these segments.
class HardVertices {
 public:
  HardVertices(const Recovery& recovery, const DeclaredModel& model)
      : plc_(recovery.plc), local_(plc_.points.size(), no_vertex), is_hard_(model.input_vertex.size(), 0) {
    for (VertexIndex v = 0; v < model.input_vertex.size(); ++v) local_[model.input_vertex[v]] = v;
    EdgeMap hard_segments;
    for (const Index row : recovery.hard_segments) {
      const ModelSegment& s = recovery.constraints.segments[row];
      hard_segments.insert({s.a, s.b}, row);
      is_hard_[s.a] = is_hard_[s.b] = 1;
    }
    facet_is_hard_.assign(plc_.n_facets(), 0);
    for (const Index f : recovery.hard_facets) facet_is_hard_[f] = 1;
    for (Index f = 0; f < plc_.n_facets(); ++f)
      if (has_edge_of(f, hard_segments)) facet_is_hard_[f] = 1;
    mark_facets();
  }

  const std::vector<std::uint8_t>& marks() const { return is_hard_; }

 private:
  bool has_edge_of(Index f, const EdgeMap& edges) const {
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
      const auto loop = plc_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (edges.find({local_[loop[i]], local_[loop[(i + 1) % loop.size()]]}) != no_index) return true;
    }
    return false;
  }
  void mark_facets() {
    for (Index f = 0; f < plc_.n_facets(); ++f)
      for (Index l = plc_.facet_loops[f]; facet_is_hard_[f] && l < plc_.facet_loops[f + 1]; ++l)
        for (const VertexIndex v : plc_.loop(l)) is_hard_[local_[v]] = 1;
    for (const auto& s : plc_.facet_segments)
      if (facet_is_hard_[s.facet]) is_hard_[local_[s.a]] = is_hard_[local_[s.b]] = 1;
    for (const auto& p : plc_.facet_points)
      if (facet_is_hard_[p.facet]) is_hard_[local_[p.v]] = 1;
  }

  const PiecewiseLinearComplex& plc_;
  std::vector<VertexIndex> local_;
  std::vector<std::uint8_t> is_hard_, facet_is_hard_;
};

void insert_vertices(Recovery& recovery, const std::vector<VertexIndex>& vertices) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<Vec3> places;
  for (const VertexIndex v : vertices) places.push_back(mesh.point(v));
  CellIndex near = mesh.cell_of(static_cast<VertexIndex>(mesh.n_input()));  // a box vertex
  for (const VertexIndex i : spatial_order(places).order) {
    recovery.context.check_cancelled();
    const VertexIndex v = vertices[i];
    const CellIndex at = locate_vertex(mesh, v, near);
    if (at == no_cell || !insert_beside_constraints(mesh, recovery.constraints, v, cells_about_vertex(mesh, v, at)))
      return recovery.end(
          Error(ErrorKind::cannot_mesh,
                describe_vertex(recovery, v) + " lies where rounding has put an added point or a face with one"));
    near = mesh.cell_of(v);
  }
}

}  // namespace

void HardPartsFirst::learn(const Recovery& recovery, const DeclaredModel& model) {
  if (recovery.hard_segments.empty() && recovery.hard_facets.empty()) return;
  const HardVertices hard(recovery, model);
  stage_.resize(model.input_vertex.size(), 0);
  for (std::size_t v = 0; v < stage_.size(); ++v)
    stage_[v] = static_cast<std::uint8_t>(std::min(255, stage_[v] + hard.marks()[v]));
}

std::uint8_t HardPartsFirst::first_stage() const { return *std::max_element(stage_.begin(), stage_.end()); }

TetMesh HardPartsFirst::triangulate(const std::vector<Vec3>& points, const DelaunayOptions& options,
                                    const RunContext& context) const {
  std::vector<Vec3> some;
  std::vector<VertexIndex> row;
  for (VertexIndex v = 0; v < points.size(); ++v) {
    if (v < stage_.size() && stage_[v] < first_stage()) continue;
    some.push_back(points[v]);
    row.push_back(v);
  }
  TetMesh mesh = std::move(delaunay_tetrahedralization(some, options, context).mesh);
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    Tetrahedron vertices = mesh.vertices(c);
    for (VertexIndex& v : vertices)
      if (v != infinite_vertex) v = row[v];
    mesh.set_vertices(c, vertices);
  }
  return with_sorted_cells(mesh, static_cast<VertexIndex>(points.size()));
}

void HardPartsFirst::run(Recovery& recovery) const {
  for (std::uint8_t stage = first_stage(); stage-- > 0;) {
    std::vector<VertexIndex> next;
    for (VertexIndex v = 0; v < stage_.size(); ++v)
      if (stage_[v] == stage) next.push_back(v);
    if (next.empty()) continue;
    recover_segments(recovery);
    if (!recovery.has_ended()) recover_facets(recovery);
    if (!recovery.has_ended()) insert_vertices(recovery, next);
    if (recovery.has_ended()) return;
  }
}

}  // namespace geomesh::recover
