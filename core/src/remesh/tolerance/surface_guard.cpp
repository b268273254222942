// SPDX-License-Identifier: MIT
#include "remesh/tolerance/surface_guard.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

#include "common/geometry.hpp"
#include "geomesh/core/predicates.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

std::array<Vec3, 13> triangle_samples(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto at = [&](double u, double v, double w) { return u * a + v * b + w * c; };
  constexpr double t = 1.0 / 3, s = 1.0 / 6, m = 2.0 / 3;
  return {a,           b,           c,           at(.5, .5, 0),    at(0, .5, .5),    at(.5, 0, .5),   at(t, t, t),
          at(m, s, s), at(s, m, s), at(s, s, m), at(.45, .45, .1), at(.1, .45, .45), at(.45, .1, .45)};
}

namespace {

/// Share of the tolerance within which faces must be; the rest allows for rounding in the computed distances.
constexpr double proven_share = 1 - 1e-6;
/// Limit for the distances of new faces, relative to the limit for samples of the original. New faces are examined as a
/// whole and not only at samples, so they may come closer to the tolerance.
constexpr double faces_over_samples = 1.15;
/// Cosine of the largest angle between normals of a reference surface and their mean at which no samples are needed.
constexpr double even_cosine = 0.9;
/// Distance by which rounding may move a point off its plane, relative to the largest coordinate.
constexpr double rounding_share = 64 * std::numeric_limits<double>::epsilon();
/// Number of places for which a thread stores the tolerance; more than the vertices on which it works in turn.
constexpr std::size_t n_recent_places = 16384;

/// Returns the coordinate that is equal for all points of the loop, or 3 if there is none.
std::uint8_t common_axis(const PiecewiseLinearComplex& plc, std::span<const VertexIndex> loop) {
  for (std::uint8_t axis = 0; axis < 3; ++axis)
    if (std::all_of(loop.begin(), loop.end(),
                    [&](VertexIndex v) { return plc.points[v][axis] == plc.points[loop[0]][axis]; }))
      return axis;
  return 3;
}

/// The faces of one patch, to which distances are computed.
class FaceSet {
 public:
  FaceSet(const std::vector<SurfaceFace>& faces, Index patch) {
    for (const SurfaceFace& f : faces)
      if (f.patch == patch) triangles_.emplace_back(f.corners);
  }
  bool is_near(const Vec3& p, double limit) const {
    return std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const auto& t) { return squared_distance(p, t.closest_to(p)) <= limit * limit; });
  }

 private:
  std::vector<search::PreparedTriangle> triangles_;
};

Box3 joined(Box3 a, const Box3& b) {
  a.add(b.min);
  a.add(b.max);
  return a;
}

bool contains(const Box3& box, const Vec3& p) {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < box.min[i] || p[i] > box.max[i]) return false;
  return true;
}

/// For each patch, whether its faces have consistent orientations: no two of them pass an edge in the same direction.
std::vector<bool> patches_oriented_alike(const DomainMesh& mesh) {
  struct DirectedEdge {
    Index patch;
    VertexIndex from, to;
    auto operator<=>(const DirectedEdge&) const = default;
  };
  std::vector<DirectedEdge> sides;
  mesh.for_each_facet_face([&](FaceRef f) {
    const Triangle t = mesh.facet_face(f);
    for (unsigned k = 0; k < 3; ++k) sides.push_back({mesh.patch_of(mesh.tag(f)), t[k], t[(k + 1) % 3]});
  });
  std::sort(sides.begin(), sides.end());
  std::vector<bool> alike(mesh.n_patches(), true);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i] == sides[i + 1]) alike[sides[i].patch] = false;
  return alike;
}

/// Visits the sample points of a triangle of the original that must be close to the mesh: the usual samples, and a
/// lattice with a spacing of a few tolerances if the triangle is large compared with the tolerance.
template <class Visit>
void for_each_reference_sample(const search::Corners& t, double tolerance, Visit visit) {
  constexpr double wide = 8;
  constexpr int most = 12;
  for (const Vec3& p : triangle_samples(t[0], t[1], t[2])) visit(p);
  const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  const int n = longest > wide * most * tolerance ? most : static_cast<int>(std::ceil(longest / (wide * tolerance)));
  for (int i = 0; n > 2 && i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      visit((1 - u - v) * t[0] + u * t[1] + v * t[2]);
    }
}

}  // namespace

SurfaceGuard::SurfaceGuard(const DomainMesh& given, const DomainMesh& mesh, const PiecewiseLinearComplex& plc,
                           Honour honour, LocalTolerance tolerance, const Hold& hold)
    : honour_(honour),
      tolerance_(hold.margin * tolerance.greatest()),
      zones_(hold.zones),
      recent_(search::RecentPlaces(n_recent_places)),
      allowed_(std::move(tolerance)),
      reach_(allowed_.greatest()) {
  for (const Vec3& p : plc.points)
    for (std::size_t i = 0; i < 3; ++i) rounding_ = std::max(rounding_, rounding_share * std::abs(p[i]));
  if (exact()) {
    find_planes(mesh, plc);
    return;
  }
  given_ = hold.surfaces;
  given_curves_ = curves_of(mesh);
  oriented_ = patches_oriented_alike(given);
  if (!given_) {
    std::vector<Vec3> normals;
    for (Index f = 0; f < plc.n_facets(); ++f) normals.push_back(unit(loop_normal(plc.points, plc.outer_loop(f))));
    const auto triangles = std::make_shared<search::TriangleSurfaces>(faces_of(given, std::move(normals)));
    flat_ = FlatPatches(*triangles, static_cast<Index>(given.n_patches()), rounding_);
    given_ = triangles;
  }
  std::vector<search::ClosestPointTrees::Item> boxes;
  for (const TightZone& zone : zones_)
    boxes.push_back({{zone.box.min, zone.box.max, zone.box.max}, 0, static_cast<Index>(boxes.size())});
  zone_boxes_ = search::ClosestPointTrees(std::move(boxes), zones_.empty() ? 0 : 1);
}

double SurfaceGuard::share_about(std::span<const Vec3> points) const {
  double least = allowed_.least_at(points, recent_.local());
  if (zones_.empty()) return least / reach_;
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  zone_boxes_.for_each_in(box, 0, [&](const auto& item) {
    const TightZone& zone = zones_[item.id];
    for (std::size_t i = 0; i < 3; ++i)
      if (zone.box.min[i] > box.max[i] || zone.box.max[i] < box.min[i]) return;
    least = std::min(least, zone.tolerance);
  });
  return least / reach_;
}

/// Finds the plane of each patch. For a patch with several facets it is their mean plane, weighted by area, so that no
/// point of the facets is off the plane by more than rounding.
void SurfaceGuard::find_planes(const DomainMesh& mesh, const PiecewiseLinearComplex& plc) {
  planes_.resize(mesh.n_patches());
  std::vector<Index> count(mesh.n_patches(), 0);
  std::vector<double> weight(mesh.n_patches(), 0);
  std::vector<Vec3> offset(mesh.n_patches());
  for (Index f = 0; f < plc.n_facets(); ++f) {
    const Index patch = mesh.patch_of_facet(f);
    const auto loop = plc.outer_loop(f);
    const Vec3 n = loop_normal(plc.points, loop);
    const double w = length(n);
    Plane& plane = planes_[patch];
    const std::uint8_t axis = common_axis(plc, loop);
    if (count[patch]++ == 0) {
      plane.point = plc.points[loop[0]];
      plane.axis = axis;
    } else if (axis != plane.axis || (axis < 3 && plc.points[loop[0]][axis] != plane.point[axis])) {
      plane.axis = 3;
    }
    plane.normal = plane.normal + n;
    weight[patch] += w;
    for (const VertexIndex v : loop)
      offset[patch] = offset[patch] + (w / static_cast<double>(loop.size())) * (plc.points[v] - plane.point);
  }
  for (Index p = 0; p < planes_.size(); ++p) {
    planes_[p].normal = unit(planes_[p].normal);
    if (count[p] > 1 && weight[p] > 0 && planes_[p].axis == 3)
      planes_[p].point = planes_[p].point + (1 / weight[p]) * offset[p];
  }
}

Index SurfaceGuard::nearest_facet(Index patch, const Vec3& p) const { return given_->closest(p, patch).item; }

Vec3 SurfaceGuard::normal(Index patch, const Vec3& p) const {
  if (!exact()) return given_->normal(nearest_facet(patch, p), p);
  return patch < planes_.size() ? planes_[patch].normal : Vec3{};
}

Vec3 SurfaceGuard::project_to_patch(Index patch, const Vec3& p) const {
  if (!exact()) return given_->closest(p, patch).point;
  const Plane& plane = planes_[patch];
  Vec3 q = p - dot(p - plane.point, plane.normal) * plane.normal;
  if (plane.axis < 3) q[plane.axis] = plane.point[plane.axis];
  return q;
}

Vec3 SurfaceGuard::project_to_curve(Index curve, const Vec3& p) const { return given_curves_.closest(p, curve).point; }

bool SurfaceGuard::reference_near(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                                  const std::vector<SurfaceFace>& around) const {
  std::vector<Index> patches;
  for (const SurfaceFace& f : before)
    if (std::find(patches.begin(), patches.end(), f.patch) == patches.end()) patches.push_back(f.patch);
  return std::all_of(patches.begin(), patches.end(), [&](Index patch) {
    Box3 box;
    for (const SurfaceFace& f : before)
      if (f.patch == patch) box = joined(box, search::box_about(f.corners, tolerance_));
    return given_->is_even(box, patch, even_cosine) || samples_near(patch, box, before, after, around);
  });
}

bool SurfaceGuard::samples_near(Index patch, const Box3& box, const std::vector<SurfaceFace>& before,
                                const std::vector<SurfaceFace>& after, const std::vector<SurfaceFace>& around) const {
  const FaceSet old_faces(before, patch), new_faces(after, patch), others(around, patch);
  bool near = true;
  given_->visit_pieces(box, patch, [&](const auto& item) {
    if (!near) return;
    for_each_reference_sample(item.corners, reach_, [&](const Vec3& p) {
      if (!near || !contains(box, p)) return;
      const double limit = share_about({&p, 1}) * tolerance_;
      if (new_faces.is_near(p, limit) || others.is_near(p, limit)) return;
      // a sample of the original surface near the removed faces must be near the new faces
      near = !old_faces.is_near(p, limit);
    });
  });
  return near;
}

bool SurfaceGuard::curves_near(const std::vector<CurvePiece>& before, const std::vector<CurvePiece>& after) const {
  for (const CurvePiece& c : after) {
    const double limit = share_about(std::array{c.a, c.b}) * tolerance_;
    for (const double t : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0})
      if (!(given_curves_.closest((1 - t) * c.a + t * c.b, c.curve, limit).distance <= limit)) return false;
  }
  // The removed curve edges must be within the tolerance of the new ones, which is tested at their ends and between.
  for (const CurvePiece& c : before)
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 p = given_curves_.closest((1 - t) * c.a + t * c.b, c.curve).point;
      double best = std::numeric_limits<double>::infinity();
      for (const CurvePiece& d : after)
        if (d.curve == c.curve) best = std::min(best, distance(p, search::closest_on_segment(p, d.a, d.b)));
      if (!(best <= share_about({&p, 1}) * tolerance_)) return false;
    }
  return true;
}

bool SurfaceGuard::is_proven_within(const SurfaceFace& f, double limit, Index& over) const {
  return given_->within(f.corners, f.patch, limit * share_about(f.corners), over);
}

bool SurfaceGuard::is_proven_near_reference(const SurfaceFace& f) const {
  Index over;
  return is_proven_within(f, proven_share * reach_, over);
}

bool SurfaceGuard::corners_on(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const {
  const auto is_on_one = [&](const Vec3& p) {
    return std::any_of(before.begin(), before.end(), [&](const SurfaceFace& f) {
      const auto& [a, b, c] = f.corners;
      return p == a || p == b || p == c ||
             squared_distance(p, search::closest_on_triangle(p, a, b, c)) <= rounding_ * rounding_;
    });
  };
  const Vec3* last = nullptr;  // first corner of the face examined before, found to be on a removed face
  return std::all_of(after.begin(), after.end(), [&](const SurfaceFace& f) {
    return std::all_of(f.corners.begin(), f.corners.end(), [&](const Vec3& p) {
      if (last && *last == p) return true;
      if (!is_on_one(p)) return false;
      if (&p == &f.corners[0]) last = &p;
      return true;
    });
  });
}

bool SurfaceGuard::keeps_sides(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const {
  const auto leans = [&](Index patch) { return patch < planes_.size() && planes_[patch].axis == 3; };
  const auto seen = [&](const SurfaceFace& f) { return seen_along(planes_[f.patch].normal, f.corners); };
  return std::all_of(after.begin(), after.end(), [&](const SurfaceFace& f) {
    if (!leans(f.patch)) return true;
    double sum = 0;
    bool was_flat = false;
    for (const SurfaceFace& g : before)
      if (g.patch == f.patch) {
        const auto t = seen(g);
        sum += signed_area(t);
        was_flat = was_flat || orient2d(t[0], t[1], t[2]) == Sign::zero;
      }
    const auto t = seen(f);
    const Sign side = orient2d(t[0], t[1], t[2]);
    return sum == 0 || side == (sum > 0 ? Sign::positive : Sign::negative) || (side == Sign::zero && was_flat);
  });
}

bool SurfaceGuard::admits(const SurfacePart& before, const SurfacePart& after,
                          const std::vector<SurfaceFace>& around) const {
  if (before.faces.empty() && before.curves.empty()) return true;
  if (exact()) return corners_on(before.faces, after.faces) && keeps_sides(before.faces, after.faces);
  if (flat_.cover_the_same(before, after)) return true;
  if (!curves_near(before.curves, after.curves)) return false;
  std::vector<Index> over(after.faces.size(), no_index);
  for (std::size_t k = 0; k < over.size(); ++k)
    if (!is_proven_within(after.faces[k], faces_over_samples * tolerance_, over[k])) return false;
  const bool curves_stay = before.curves.empty() && after.curves.empty();
  return keeps_direction(before.faces, after.faces, over, curves_stay) &&
         reference_near(before.faces, after.faces, around);
}

Deviations SurfaceGuard::deviations(const DomainMesh& mesh, unsigned threads, VerifiedSurfaces* before) const {
  if (!exact()) return verify_surfaces(mesh, {*given_, given_curves_}, allowed_, threads, before);
  Deviations d;
  mesh.for_each_facet_face([&](FaceRef f) {
    const Plane& plane = planes_[mesh.patch_of(mesh.tag(f))];
    for (const Vec3& p : mesh.places(mesh.face(f)))
      d.result_to_input = std::max(d.result_to_input, std::abs(dot(p - plane.point, plane.normal)));
  });
  d.input_to_result = d.result_to_input;
  return d;
}

}  // namespace geomesh::remesh
