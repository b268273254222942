// SPDX-License-Identifier: GPL-3.0-or-later
// Removes everything outside a model volume, declared in arrangement/clip/clip.hpp.
#include "arrangement/clip/clip.hpp"
#include "arrangement/clip/facet_components.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// The closed volume that the sides enclose, with exact queries.
class Volume {
 public:
  Volume(const ClipContext& context, const Complex& complex, const Ingested& ingested)
      : vertices_(context.arranged.vertices),
        points_(complex.points),
        triangles_(triangles_of(context.surfaces, ingested)),
        winding_(complex.points, triangles_) {}

  /// Returns whether the point q is outside the volume. Unless `closed` is set, q must not lie on a side.
  bool is_outside(const ExactPoint& q, bool closed) const {
    if (winding_(vertices_.frame(), q, vertices_.frame().to_nearest(q), {}) != 0) return false;
    return !closed ||
           std::none_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) { return is_on(t, q); });
  }

 private:
  static std::vector<Triangle> triangles_of(const SurfaceList& surfaces, const Ingested& ingested) {
    std::vector<Triangle> triangles;
    for (std::size_t s = surfaces.given.size(); s < surfaces.size(); ++s)
      for (const Triangle& t : surfaces[s].triangles) {
        const auto& vertex = ingested.vertex_of_point[s];
        triangles.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
      }
    return triangles;
  }
  bool is_on(const Triangle& t, const ExactPoint& q) const {
    const ExactFrame& frame = vertices_.frame();
    const std::array<ExactPoint, 3> p{frame.to_exact(points_[t[0]]), frame.to_exact(points_[t[1]]),
                                      frame.to_exact(points_[t[2]])};
    if (exact_orient3d(p[0], p[1], p[2], q) != Sign::zero) return false;
    const Projection along = projection_of(points_[t[0]], points_[t[1]], points_[t[2]]);
    for (std::size_t k = 0; k < 3; ++k)
      if (exact_orient2d(p[k], p[(k + 1) % 3], q, along.i, along.j) == -along.sign) return false;
    return true;
  }

  const ExactVertices& vertices_;
  const std::vector<Vec3>& points_;
  std::vector<Triangle> triangles_;
  WindingNumber winding_;
};

void clip_facets(ClipContext& context, const Volume& volume) {
  const Arranged& arranged = context.arranged;
  const std::size_t n = arranged.facets.size();
  std::vector<std::uint8_t> chosen(n, 0), barrier(n, 0), outside(n, 0), is_outside;
  for (std::size_t f = 0; f < n; ++f) {
    for (const Origin& o : arranged.origins.of(f)) barrier[f] |= o.surface >= context.surfaces.given.size();
    chosen[f] = !barrier[f];
  }
  const auto component = components(arranged, chosen, barrier, [&](auto edge) {
    return std::none_of(edge.begin(), edge.end(), [&](const FacetEdge& e) { return barrier[e.facet] != 0; });
  });
  for (std::size_t f = 0; f < n; ++f) {
    if (!chosen[f]) continue;
    if (component[f] == is_outside.size())
      is_outside.push_back(volume.is_outside(facet_centroid(arranged, arranged.facets[f]), false));
    outside[f] = is_outside[component[f]];
  }
  remove_outside(context, outside);
}

void clip_segments(ClipContext& context, const Volume& volume, const std::vector<Polyline>& polylines) {
  const ExactVertices& vertices = context.arranged.vertices;
  std::vector<std::uint8_t> outside;
  for (const auto& s : context.arranged.segments) {
    const ExactPoint b = vertices.exact(s.b);
    outside.push_back(volume.is_outside(centroid(vertices.exact(s.a), b, b), true));
  }
  remove_segments(context, outside, polylines);
}

}  // namespace

void clip_to_volume(ClipContext context, const Complex& complex, const Ingested& ingested,
                    const std::vector<Polyline>& polylines, const std::vector<NamedPoint>& points) {
  const Volume volume(context, complex, ingested);
  clip_facets(context, volume);
  clip_segments(context, volume, polylines);
  std::erase_if(context.arranged.isolated_points, [&](const PolygonSoup::IsolatedPoint& p) {
    if (!volume.is_outside(context.arranged.vertices.exact(p.v), true)) return false;
    context.result.warnings.push_back("point " + points[p.point].name + " lies outside the model volume near " +
                                      to_text(context.arranged.vertices.rounded(p.v)) + " and is left out");
    return true;
  });
}

}  // namespace geomesh::geomodel::arrangement
