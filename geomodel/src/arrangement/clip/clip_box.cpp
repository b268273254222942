// SPDX-License-Identifier: GPL-3.0-or-later
// Removes everything outside the box, declared in arrangement/clip/clip.hpp.
#include <algorithm>

#include "arrangement/clip/clip.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Returns whether a vertex is exactly outside the closed box. Its nearest doubles decide unless on a box plane.
bool is_outside(const ExactVertices& vertices, Index v, const Box3& box) {
  const Vec3& p = vertices.rounded(v);
  for (std::size_t i = 0; i < 3; ++i) {
    if (p[i] < box.min[i] || p[i] > box.max[i]) return true;
    if (!vertices.is_made(v)) continue;
    const ExactFrame& frame = vertices.frame();
    if (p[i] == box.min[i] && compare_coordinate(*vertices.made(v), frame.to_exact(box.min), i) == Sign::negative)
      return true;
    if (p[i] == box.max[i] && compare_coordinate(*vertices.made(v), frame.to_exact(box.max), i) == Sign::positive)
      return true;
  }
  return false;
}

void clip_wells(ClipContext& context, const Box3& box, const std::vector<Polyline>& polylines) {
  const Arranged& arranged = context.arranged;
  std::vector<std::uint8_t> outside;
  for (const auto& s : arranged.segments)
    outside.push_back(is_outside(arranged.vertices, s.a, box) || is_outside(arranged.vertices, s.b, box));
  remove_segments(context, outside, polylines);
}

}  // namespace

void remove_segments(ClipContext context, const std::vector<std::uint8_t>& outside,
                     const std::vector<Polyline>& polylines) {
  Arranged& arranged = context.arranged;
  std::vector<double> length_outside(polylines.size(), 0);
  std::vector<Vec3> place(polylines.size());
  std::vector<PolygonSoup::Segment> kept;
  for (std::size_t i = 0; i < arranged.segments.size(); ++i) {
    const auto& s = arranged.segments[i];
    if (!outside[i]) {
      kept.push_back(s);
      continue;
    }
    length_outside[s.polyline] += length(arranged.vertices.rounded(s.a) - arranged.vertices.rounded(s.b));
    place[s.polyline] = arranged.vertices.rounded(s.a);
  }
  arranged.segments = std::move(kept);
  for (std::size_t l = 0; l < polylines.size(); ++l)
    if (length_outside[l] > 0)
      context.result.spots.push_back(
          {"clipped polyline", static_cast<Index>(l), no_index, 1, length_outside[l], place[l]});
}

void remove_outside(ClipContext context, std::vector<std::uint8_t>& outside) {
  Arranged& arranged = context.arranged;
  for (std::size_t f = 0; f < arranged.facets.size(); ++f) {
    if (!outside[f]) continue;
    for (const Origin& o : arranged.origins.of(f))
      context.result.area_clipped_by_box[o.surface] += facet_area(arranged, f);
  }
  remove_origins(arranged, outside, [](Index, const Origin&) { return true; });
}

double facet_area(const Arranged& arranged, std::size_t f) {
  const Triangle& t = arranged.facets[f];
  return area(arranged.vertices.rounded(t[0]), arranged.vertices.rounded(t[1]), arranged.vertices.rounded(t[2]));
}

void clip_to_box(ClipContext context, const Box3& box, const std::vector<Polyline>& polylines) {
  Arranged& arranged = context.arranged;
  std::vector<std::uint8_t> outside_vertex(arranged.vertices.size(), 0), outside(arranged.facets.size(), 0);
  for (Index v = 0; v < arranged.vertices.size(); ++v) outside_vertex[v] = is_outside(arranged.vertices, v, box);
  for (std::size_t f = 0; f < arranged.facets.size(); ++f)
    for (const VertexIndex v : arranged.facets[f]) outside[f] |= outside_vertex[v];
  remove_outside(context, outside);
  clip_wells(context, box, polylines);
}

}  // namespace geomesh::geomodel::arrangement
