// SPDX-License-Identifier: MIT
#include "classify/classify.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "common/flood.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "recover/model/presence.hpp"

namespace geomesh::classify {

namespace {

using recover::ConstrainedMesh;
using recover::DeclaredModel;
using recover::Subfacet;
using recover::Subsegment;

constexpr Index unvisited = no_index, outside = no_index - 1, dropped = no_index - 2;

/// Assigns each cell to a component. A component is a maximal set of cells that are connected through faces without a
/// lock. Components are numbered in the order of the facets around them.
class Components {
 public:
  Components(ConstrainedMesh& mesh, DeclaredModel& model, const PiecewiseLinearComplex& plc, const RunContext& context)
      : mesh_(mesh), plc_(plc), context_(context), label_(mesh.cells().n_slots(), unvisited) {
    flood_outside();
    for (const auto& seed : plc_.hole_seeds) flood_hole(seed);
    order_subfacets(model.constraints);
    number_components();
  }

  Index size() const { return n_; }
  Index of(CellIndex c) const { return label_[c]; }
  bool kept(CellIndex c) const { return label_[c] < n_; }
  /// Returns the live subfacets ordered by facet, so that the numbers of components and the output do not depend on the
  /// order in which recovery created subfacets.
  const std::vector<Index>& subfacets() const { return subfacets_; }
  /// Returns for each of subfacets() its face in the mesh, as a face of the cell above it.
  const std::vector<FaceRef>& faces_above() const { return above_; }

  /// Returns for each component of the mesh the row of the region seed inside it, or no_index.
  std::vector<Index> seeds() const {
    std::vector<Index> out(n_, no_index);
    for (const auto& seed : plc_.region_seeds) {
      const CellIndex c = locate(seed, "region");
      if (c == no_cell || !kept(c)) {
        context_.note(LogLevel::warning, "a region seed lies outside every region");
        continue;
      }
      Index& slot = out[label_[c]];
      if (slot == no_index) {
        slot = seed.id;
      } else if (slot != seed.id) {
        context_.note(LogLevel::warning, "two region seeds lie in one region; the first one names it");
      }
    }
    return out;
  }

 private:
  /// Returns a cell that contains the seed, or no_cell if it is outside the box. Throws Error{invalid_input} if the
  /// seed lies on a facet, because it would then be in the components on both sides.
  CellIndex locate(const PiecewiseLinearComplex::Seed& seed, const char* kind) const {
    const CellIndex first = mesh_.locate(seed.point, mesh_.cell_of(0));
    if (first == no_cell) return no_cell;
    std::vector<CellIndex> around{first};  // cells that contain the region seed
    for (std::size_t k = 0; k < around.size(); ++k) {
      if (mesh_.cells().is_ghost(around[k])) continue;
      const Tetrahedron v = mesh_.cells().vertices(around[k]);
      for (unsigned i = 0; i < 4; ++i) {
        const auto& corners = face_vertices[i];
        const Vec3 &p = mesh_.point(v[corners[0]]), &q = mesh_.point(v[corners[1]]), &r = mesh_.point(v[corners[2]]);
        if (orient3d(p, q, r, seed.point) != Sign::zero) continue;
        const FaceRef face(around[k], i);
        if (mesh_.is_locked(face)) throw_seed_on_facet(seed, kind);
        const CellIndex beyond = mesh_.cells().mirror(face).cell();
        if (std::find(around.begin(), around.end(), beyond) == around.end()) around.push_back(beyond);
      }
    }
    return first;
  }
  [[noreturn]] static void throw_seed_on_facet(const PiecewiseLinearComplex::Seed& seed, const char* kind) {
    ErrorContext context;
    context.places.push_back(seed.point);
    throw Error(ErrorKind::invalid_input,
                std::string("a ") + kind + " seed lies on a facet, so it is on both sides of it; move it into a region",
                std::move(context));
  }
  void flood(CellIndex start, Index label) {
    flood_cells(mesh_.cells(), start, label_, unvisited, label, [&](FaceRef f) { return !mesh_.is_locked(f); });
  }
  void flood_outside() {
    for (std::size_t k = 0; k < 8; ++k) {
      const CellIndex c = mesh_.cell_of(static_cast<VertexIndex>(mesh_.n_input() + k));
      if (label_[c] == unvisited) flood(c, outside);
    }
  }
  void flood_hole(const PiecewiseLinearComplex::Seed& seed) {
    const CellIndex c = locate(seed, "hole");
    if (c == no_cell || label_[c] == outside) {
      context_.note(LogLevel::warning, "a hole seed lies outside the model");
    } else if (label_[c] == unvisited) {
      flood(c, dropped);
    }
  }
  void order_subfacets(recover::Constraints& constraints) {
    for (Index f = 0; f < constraints.subfacets.size(); ++f)
      if (constraints.subfacets[f].live) subfacets_.push_back(f);
    std::stable_sort(subfacets_.begin(), subfacets_.end(),
                     [&](Index a, Index b) { return constraints.subfacets[a].facet < constraints.subfacets[b].facet; });
    for (Index f : subfacets_) above_.push_back(recover::face_of_subfacet(mesh_, constraints, f));
  }
  void number_components() {
    for (const FaceRef above : above_)
      for (const CellIndex c : {mesh_.cells().mirror(above).cell(), above.cell()})
        if (label_[c] == unvisited) flood(c, n_++);
  }

  ConstrainedMesh& mesh_;
  const PiecewiseLinearComplex& plc_;
  const RunContext& context_;
  std::vector<Index> label_;
  std::vector<Index> subfacets_;
  std::vector<FaceRef> above_;
  Index n_ = 0;
};

/// Copies the kept components of the mesh into plain arrays, in the order of the mesh.
class Arrays {
 public:
  Arrays(ConstrainedMesh& mesh, DeclaredModel& model, const Components& components, ConstrainedTetrahedralization& out)
      : mesh_(mesh), cells_(mesh.cells()), model_(model), components_(components), out_(out) {
    add_points();
    add_cells();
    add_faces();
    add_edges();
    tell_points_off_constraints();
  }

 private:
  void add_points() {
    point_.assign(mesh_.points().size(), no_vertex);
    std::vector<std::uint8_t> used(mesh_.points().size(), 0);
    for (CellIndex c = 0; c < cells_.n_slots(); ++c)
      if (cells_.is_live(c) && components_.kept(c))
        for (VertexIndex v : cells_.vertices(c)) used[v] = 1;
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
  void add_cells() {
    tetrahedron_.assign(cells_.n_slots(), no_index);
    for (CellIndex c = 0; c < cells_.n_slots(); ++c) {
      if (!cells_.is_live(c) || !components_.kept(c)) continue;
      tetrahedron_[c] = static_cast<Index>(out_.tetrahedra.size());
      const auto& v = cells_.vertices(c);
      out_.tetrahedra.push_back({point_[v[0]], point_[v[1]], point_[v[2]], point_[v[3]]});
      out_.component.push_back(components_.of(c));
    }
    out_.recovery.tetrahedra_final = out_.tetrahedra.size();
  }
  void add_faces() {
    const std::vector<Index>& subfacets = components_.subfacets();
    for (std::size_t i = 0; i < subfacets.size(); ++i) {
      const FaceRef face = components_.faces_above()[i];
      const CellIndex above = face.cell(), below = cells_.mirror(face).cell();
      if (!components_.kept(above) && !components_.kept(below)) continue;
      const Subfacet& f = model_.constraints.subfacets[subfacets[i]];
      out_.faces.push_back({{point_[f.vertices[0]], point_[f.vertices[1]], point_[f.vertices[2]]},
                            f.facet,
                            tetrahedron_[below],
                            tetrahedron_[above]});
    }
  }
  void add_edges() {
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
  /// Marks added points that are on no face or edge of the output as inner points. If two facets are separated only by
  /// rounding, a point that was added on one of them may end up beside it.
  void tell_points_off_constraints() {
    std::vector<bool> is_on(out_.points.size(), false);
    for (const auto& face : out_.faces)
      for (const VertexIndex v : face.vertices) is_on[v] = true;
    for (const auto& edge : out_.edges) is_on[edge.a] = is_on[edge.b] = true;
    for (VertexIndex v = 0; v < is_on.size(); ++v)
      if (!is_on[v] && out_.origin[v] != VertexOrigin::input) out_.origin[v] = VertexOrigin::inside;
  }
  /// Returns whether the output contains at least one cell around the subsegment.
  bool is_kept_edge(Index subsegment) const {
    const Subsegment& s = model_.constraints.subsegments[subsegment];
    recover::EdgeRing ring;
    mesh_.ring(recover::cell_of_subsegment(mesh_, model_.constraints, subsegment), s.a, s.b, ring);
    return std::any_of(ring.cells.begin(), ring.cells.end(), [&](CellIndex c) { return components_.kept(c); });
  }

  ConstrainedMesh& mesh_;
  const TetMesh& cells_;
  DeclaredModel& model_;
  const Components& components_;
  ConstrainedTetrahedralization& out_;
  std::vector<VertexIndex> point_;  ///< by vertex of the recovered mesh: its row in the points of the output
  std::vector<Index> tetrahedron_;  ///< by cell of the recovered mesh: its row in the tetrahedra of the output
};

}  // namespace

ConstrainedTetrahedralization classify(ConstrainedMesh& mesh, DeclaredModel& model, const PiecewiseLinearComplex& plc,
                                       const RunContext& context) {
  const Components components(mesh, model, plc, context);
  if (components.size() == 0)
    throw Error(ErrorKind::cannot_mesh,
                "the facets enclose no space, so there is nothing to mesh: close the surfaces, add a box, or keep "
                "the convex hull");
  ConstrainedTetrahedralization out;
  out.n_components = components.size();
  out.component_seed = components.seeds();
  Arrays(mesh, model, components, out);
  return out;
}

}  // namespace geomesh::classify
