// SPDX-License-Identifier: MIT
// Refines a part of a mesh, in which constrained faces belong to no facet. Declared in geomesh/core/refine_part.hpp.
#include "geomesh/core/refine_part.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/geometry.hpp"
#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh {

namespace {

using remesh::DomainMesh;
using remesh::FaceTag;

using Corners = std::array<VertexIndex, 3>;

Corners sorted_corners(const Triangle& t) {
  Corners c{t[0], t[1], t[2]};
  std::sort(c.begin(), c.end());
  return c;
}

/// A face of a tetrahedron, identified by its sorted vertices. In a sorted list, the two sides of a face are adjacent.
struct FaceOfCell {
  Corners corners;
  Index cell;
  bool operator<(const FaceOfCell& o) const { return std::tie(corners, cell) < std::tie(o.corners, o.cell); }
};

std::vector<FaceOfCell> faces_of_cells(const TetrahedraPart& part) {
  std::vector<FaceOfCell> faces;
  faces.reserve(4 * part.tetrahedra.size());
  for (Index t = 0; t < part.tetrahedra.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) faces.push_back({sorted_corners(remesh::face_of(part.tetrahedra[t], i)), t});
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Marks the points of boundary faces, kept faces and kept edges as kept.
void keep_border(TetrahedraPart& part, const std::vector<FaceOfCell>& faces) {
  for (std::size_t i = 0, j; i < faces.size(); i = j) {
    for (j = i; j < faces.size() && faces[j].corners == faces[i].corners;) ++j;
    if (j - i > 2) throw InternalError("refine_part: a face of more than two tetrahedra");
    if (j - i > 1) continue;
    for (const VertexIndex v : faces[i].corners) part.is_kept[v] = 1;
  }
  for (const Triangle& f : part.kept_faces)
    for (const VertexIndex v : f) part.is_kept[v] = 1;
  for (const auto& e : part.kept_edges)
    for (const VertexIndex v : e) part.is_kept[v] = 1;
}

/// A part of a mesh in the form that import_domain takes: kept points and edges are points and segments of the PLC, and
/// kept faces belong to no facet.
struct Imported {
  PiecewiseLinearComplex plc;
  ConstrainedTetrahedralization mesh;
};

Imported in_terms_of_import(TetrahedraPart& part, const std::vector<FaceOfCell>& faces) {
  Imported in;
  in.mesh.points = std::move(part.points);
  in.mesh.tetrahedra = std::move(part.tetrahedra);
  in.mesh.component = std::move(part.component);
  for (VertexIndex v = 0; v < in.mesh.points.size(); ++v) {
    const bool is_kept = part.is_kept[v] != 0;
    in.mesh.input_vertex.push_back(is_kept ? static_cast<VertexIndex>(in.plc.points.size()) : no_vertex);
    in.mesh.origin.push_back(is_kept ? VertexOrigin::input : VertexOrigin::inside);
    if (is_kept) in.plc.points.push_back(in.mesh.points[v]);
  }
  const auto cells_at = [&](const Triangle& t) {
    const Corners corners = sorted_corners(t);
    const auto at = std::lower_bound(faces.begin(), faces.end(), FaceOfCell{corners, 0});
    if (at == faces.end() || at->corners != corners || at + 1 == faces.end() || (at + 1)->corners != corners)
      throw InternalError("refine_part: a face that is to stay is not between two tetrahedra");
    return std::pair(at->cell, (at + 1)->cell);
  };
  for (const Triangle& t : part.kept_faces) {
    const auto [below, above] = cells_at(t);
    in.mesh.faces.push_back({t, remesh::hull_facet, below, above});
  }
  for (Index k = 0; k < part.kept_edges.size(); ++k) {
    const auto& [a, b] = part.kept_edges[k];
    in.plc.segments.push_back({in.mesh.input_vertex[a], in.mesh.input_vertex[b], no_index});
    in.mesh.edges.push_back({a, b, k});
  }
  return in;
}

void export_part(const DomainMesh& mesh, const Imported& in, TetrahedraPart& part) {
  std::vector<VertexIndex> row(mesh.n_vertices(), no_vertex);
  part.points.clear();
  for (const bool kept : {true, false})
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) {
      const bool is_kept = v < in.mesh.input_vertex.size() && in.mesh.input_vertex[v] != no_vertex;
      if (is_kept != kept || mesh.kind(v) == remesh::VertexKind::dead) continue;
      row[v] = static_cast<VertexIndex>(part.points.size());
      part.points.push_back(mesh.point(v));
    }
  const std::size_t n_kept = in.plc.points.size();
  if (part.points.size() < n_kept || !std::equal(in.plc.points.begin(), in.plc.points.end(), part.points.begin()))
    throw InternalError("refine_part: a point that was to stay has not");
  part.is_kept.assign(part.points.size(), 0);
  std::fill_n(part.is_kept.begin(), n_kept, 1);
  part.tetrahedra.clear();
  part.component.clear();
  for (const CellIndex c : mesh.live_cells()) {
    Tetrahedron t = mesh.vertices(c);
    for (VertexIndex& v : t) v = row[v];
    part.tetrahedra.push_back(t);
    part.component.push_back(mesh.component(c));
  }
  for (Triangle& f : part.kept_faces)
    for (VertexIndex& v : f) v = row[v];
  for (auto& e : part.kept_edges)
    for (VertexIndex& v : e) v = row[v];
}

/// Keeps the faces and points of settled tetrahedra unchanged while the other tetrahedra are refined.
class Settled {
 public:
  explicit Settled(TetrahedraPart& part) : n_faces_(part.kept_faces.size()) {
    const std::vector<FaceOfCell> faces = faces_of_cells(part);
    keep_border(part, faces);
    const std::vector<std::uint8_t> was_kept = part.is_kept;
    std::vector<Corners> kept;
    for (const Triangle& f : part.kept_faces) kept.push_back(sorted_corners(f));
    std::sort(kept.begin(), kept.end());
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
      const FaceOfCell &a = faces[i], &b = faces[i + 1];
      if (a.corners != b.corners || !(part.is_settled[a.cell] || part.is_settled[b.cell])) continue;
      if (!std::binary_search(kept.begin(), kept.end(), a.corners))
        part.kept_faces.push_back({a.corners[0], a.corners[1], a.corners[2]});
      for (const VertexIndex v : a.corners) part.is_kept[v] = 1;
    }
    for (VertexIndex v = 0; v < was_kept.size(); ++v)
      if (part.is_kept[v]) is_free_later_.push_back(!was_kept[v]);
    part.is_settled.clear();
  }
  /// Permits changes of tetrahedra that were repaired before: only faces and points kept by the caller remain kept.
  void release(TetrahedraPart& part) const {
    for (std::size_t v = 0; v < is_free_later_.size(); ++v)
      if (is_free_later_[v]) part.is_kept[v] = 0;
    part.kept_faces.resize(n_faces_);
  }

 private:
  std::size_t n_faces_;
  std::vector<bool> is_free_later_;  // for each kept point, whether it is kept only until release() is called
};

/// The constraints of a mesh, each list in ascending order: constrained faces on the boundary, constrained faces
/// inside, and edges of curves.
struct Constrained {
  std::vector<Corners> border, faces;
  std::vector<std::array<VertexIndex, 2>> edges;
  bool operator==(const Constrained&) const = default;
};

Constrained constrained_of(const DomainMesh& mesh) {
  Constrained found;
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i) {
      if (!mesh.tag(c, i).constrained()) continue;
      (mesh.has_neighbor(c, i) ? found.faces : found.border).push_back(sorted_corners(mesh.face(c, i)));
    }
  std::sort(found.border.begin(), found.border.end());
  std::sort(found.faces.begin(), found.faces.end());
  for (const auto& edge : mesh.curve_edges())
    if (!mesh.curve_class(mesh.curve_of(edge[0], edge[1])).segments.empty()) found.edges.push_back(edge);
  return found;
}

/// Removes inner points that were made for larger sizes, because they obstruct points at the new sizes. Insertion then
/// starts at the border, as in a mesh without inner points.
void take_points_out(remesh::Toolbox& tools, const RunContext& context) {
  constexpr double far_larger = 4;  // factor of the sizes with which almost every inner point is superfluous
  constexpr unsigned rounds = 2;
  const SizeField loose = tools.lengths.field().times(far_larger);
  remesh::Toolbox apart(tools.mesh, tools.guard, loose, tools.statistics);
  apart.bad_cells_may_spread = true;
  for (unsigned round = 0; round < rounds; ++round) {
    remesh::collapse_short_edges(apart, remesh::ShortEdges::inside, context);
    remesh::flip_towards_delaunay(apart, context);
  }
}

/// Calls `work` on a mesh of the part, and checks afterwards that all constraints are unchanged.
template <class Work>
void run_on_part(TetrahedraPart& part, const SizeField& size, const RefineOptions& options,
                 RefineStatistics& statistics, const Work& work) {
  std::vector<FaceOfCell> faces = faces_of_cells(part);
  keep_border(part, faces);
  Imported in = in_terms_of_import(part, faces);
  faces = {};
  DomainMesh mesh = remesh::import_domain(in.plc, in.mesh, options, {});
  in.mesh.tetrahedra = {};
  in.mesh.faces = {};
  const Constrained before = constrained_of(mesh);
  const remesh::SurfaceGuard guard;
  remesh::Toolbox tools(mesh, guard, size, statistics);
  tools.borders_stay = true;
  work(tools);
  if (const std::string fault = mesh.validate(); !fault.empty()) throw InternalError("refine_part: " + fault);
  if (!(constrained_of(mesh) == before)) throw InternalError("refine_part: what was to stay has not");
  export_part(mesh, in, part);
}

}  // namespace

RefineStatistics refine_part(TetrahedraPart& part, const SizeField& size, const RefineOptions& asked,
                             const RunContext& context) {
  RefineStatistics statistics;
  RefineOptions options;
  options.quality = asked.quality;
  options.quality_measure = asked.quality_measure;
  options.time_budget = asked.time_budget;
  options.max_elements = asked.max_elements;
  statistics.quality_measure = options.quality_measure;
  const auto refine = [&](remesh::Toolbox& tools) {
    const StageScope stage(context, "refine");
    take_points_out(tools, context);
    options.size_surfaces = false;
    remesh::refine_to_size(tools, options, context);
  };
  const auto improve = [&](remesh::Toolbox& tools) {
    const StageScope stage(context, "improve");
    options.size_surfaces = true;  // if size_surfaces were false, improvement would add no inner points
    remesh::improve_mesh(tools, options, context);
  };
  const bool has_settled = std::ranges::any_of(part.is_settled, [](std::uint8_t s) { return s != 0; });
  if (asked.refine && has_settled) {
    const Settled settled(part);
    run_on_part(part, size, options, statistics, refine);
    settled.release(part);
  }
  part.is_settled.clear();
  run_on_part(part, size, options, statistics, [&](remesh::Toolbox& tools) {
    if (asked.refine && !has_settled) refine(tools);
    improve(tools);
  });
  return statistics;
}

}  // namespace geomesh
