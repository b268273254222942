// SPDX-License-Identifier: MIT
#include "tetrahedralize/roofed_parts.hpp"

#include <algorithm>

#include "plc/convex_parts.hpp"
#include "plc/coplanar_patches.hpp"
#include "plc/roof.hpp"
#include "recover/start/level_frame.hpp"
#include "tetrahedralize/roof_filling.hpp"

namespace geomesh {

namespace {

using Mesh = ConstrainedTetrahedralization;

Triangle corners_of(const PiecewiseLinearComplex& plc, Index facet) {
  const auto loop = plc.outer_loop(facet);
  return {loop[0], loop[1], loop[2]};
}

Vec3 extents_of_segments(const PiecewiseLinearComplex& plc) {
  Box3 box;
  for (const VertexIndex v : plc.loop_vertices) box.add(plc.points[v]);
  for (const auto& s : plc.segments)
    for (const VertexIndex v : {s.a, s.b}) box.add(plc.points[v]);
  return box.max - box.min;
}

RoofedPart in_rows(RoofedPart part, const std::vector<VertexIndex>& row) {
  for (std::vector<Triangle>* triangles : {&part.as_given, &part.triangles, &part.roof})
    for (Triangle& t : *triangles)
      for (VertexIndex& v : t) v = row[v];
  for (VertexIndex& v : part.inner) v = row[v];
  return part;
}

}  // namespace

std::optional<RoofedParts> RoofedParts::of(const PiecewiseLinearComplex& plc, std::span<const Index> provenance) {
  RoofedParts out(plc);
  out.find_parts(provenance);
  if (out.parts_.empty()) return std::nullopt;
  out.write_facets();
  return out;
}

void RoofedParts::find_parts(std::span<const Index> provenance) {
  const AxisChoice axis_for = [extents = extents_of_segments(given_)](const std::array<Vec3, 3>& corners) {
    return recover::level_axis(corners, extents);
  };
  for (const CoplanarPatch& patch : patches_far_from_delaunay(given_, provenance, most_crossings_of_kept_edge)) {
    if (patch.facets.size() == 1) continue;
    const std::optional<FlatPatch> flat = flat_patch_of(given_, patch.facets);
    if (!flat) continue;
    for (const ConvexPart& part : convex_parts(*flat, patch.segments)) {
      std::vector<Vec3> corners;
      for (const VertexIndex v : part.border) corners.push_back(given_.points[v]);
      const std::optional<Roof> roof = roof_over(corners, axis_for);
      // The two lifted triangulations of a part must need fewer points than the part has inner edges.
      if (!roof || 2 * (roof->inner.size() + 1) >= part.left_out.size()) continue;
      RoofedPart& out = parts_.emplace_back();
      for (const Index t : part.triangles) {
        out.facets.push_back(patch.facets[t]);
        out.as_given.push_back(corners_of(given_, patch.facets[t]));
        out.triangles.push_back(flat->triangle(t));
        out.is_turned.push_back(flat->is_turned(t));
      }
      out.rise = roof->rise;
      std::vector<VertexIndex> row = part.border;
      for (const Vec3& p : roof->inner) {
        row.push_back(static_cast<VertexIndex>(plc_.points.size()));
        out.inner.push_back(row.back());
        plc_.points.push_back(p);
      }
      for (const Triangle& t : roof->triangles) out.roof.push_back({row[t[0]], row[t[1]], row[t[2]]});
    }
  }
}

void RoofedParts::write_facets() {
  std::vector<bool> is_in_part(given_.n_facets(), false);
  for (const RoofedPart& part : parts_)
    for (const Index f : part.facets) is_in_part[f] = true;
  plc_.loop_vertices.clear();
  plc_.loop_offsets.assign(1, 0);
  plc_.facet_loops.assign(1, 0);
  plc_.facet_provenance.clear();
  std::vector<Index> new_row(given_.n_facets(), no_index);
  for (Index f = 0; f < given_.n_facets(); ++f) {
    if (is_in_part[f]) continue;
    std::vector<std::vector<VertexIndex>> loops;
    for (Index l = given_.facet_loops[f]; l < given_.facet_loops[f + 1]; ++l)
      loops.emplace_back(given_.loop(l).begin(), given_.loop(l).end());
    new_row[f] = plc_.add_polygon(loops);
    facet_.push_back(f);
  }
  for (auto& s : plc_.facet_segments) s.facet = new_row[s.facet];
  for (auto& p : plc_.facet_points) p.facet = new_row[p.facet];
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (const Triangle& t : parts_[k].roof) {
      plc_.add_triangle(t);
      facet_.push_back(static_cast<Index>(given_.n_facets() + k));
    }
}

bool RoofedParts::fill(Mesh& mesh) const {
  std::vector<VertexIndex> row(plc_.points.size(), no_vertex);
  std::vector<Index> part_of(mesh.points.size(), no_index);  // by mesh point: the part that it lies inside
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (mesh.input_vertex[v] != no_vertex) row[mesh.input_vertex[v]] = v;
  for (Index k = 0; k < parts_.size(); ++k)
    for (const VertexIndex v : parts_[k].inner) {
      if (row[v] == no_vertex) continue;
      part_of[row[v]] = k;
      mesh.input_vertex[row[v]] = no_vertex;
      mesh.origin[row[v]] = VertexOrigin::inside;
    }
  std::vector<std::vector<Index>> stars(parts_.size());
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t)
    for (const VertexIndex v : mesh.tetrahedra[t])
      if (const Index k = part_of[v]; k != no_index && (stars[k].empty() || stars[k].back() != t))
        stars[k].push_back(t);
  std::vector<std::vector<Mesh::Face>> roofs(parts_.size());
  std::vector<Mesh::Face> faces;
  for (Mesh::Face& face : mesh.faces) {
    face.facet = facet_[face.facet];
    (face.facet < given_.n_facets() ? faces : roofs[face.facet - given_.n_facets()]).push_back(face);
  }
  for (std::size_t k = 0; k < parts_.size(); ++k)
    if (!roofs[k].empty() && !fill_under_roof(mesh, in_rows(parts_[k], row), roofs[k], stars[k], faces)) return false;
  std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.facet < b.facet; });
  mesh.faces = std::move(faces);
  mesh.recovery.facets_total = given_.n_facets();
  mesh.recovery.tetrahedra_final = mesh.tetrahedra.size();
  mesh.recovery.steiner_inside =
      static_cast<std::size_t>(std::count(mesh.origin.begin(), mesh.origin.end(), VertexOrigin::inside));
  return true;
}

}  // namespace geomesh
