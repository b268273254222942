// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that mesh faces cover the input surfaces. A mesh face represents a part of an input triangle if all its
// corners lie within the tolerance of the triangle's plane. Mesh faces of a sound mesh never overlap. So a triangle is
// covered if the areas that such faces share with it add up to the required area: all of it, or its part inside the
// box. Any missing area must be inside a body that cuts: there the faces' open edges must run along that body (or the
// box or the triangle's sides). Whether uncovered points lie in the body is decided exactly.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "check/exact/crossing.hpp"
#include "check/exact/deviation.hpp"
#include "check/exact/plane_triangle.hpp"
#include "check/mesh/checked_faces.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"
#include "check/pieces/pieces_without_faces.hpp"
#include "check/pieces/uncovered_places.hpp"
#include "check/specification/taken_by_rules.hpp"

namespace geomesh::geomodel::checking {
namespace {

std::pair<VertexIndex, VertexIndex> edge(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

/// Returns the ends of the border edges of a surface, which have only one triangle.
std::vector<std::array<Vec3, 2>> border_edges(const TriangulatedSurface& surface) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> uses;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[edge(t[i], t[(i + 1) % 3])];
  std::vector<std::array<Vec3, 2>> borders;
  for (const auto& [e, n] : uses)
    if (n == 1) borders.push_back({surface.points[e.first], surface.points[e.second]});
  return borders;
}

class CoverageChecker : public CheckedFaces {
 public:
  CoverageChecker(const CheckedMesh& mesh, const Specification& specification, const FacesFile* faces,
                  const std::vector<Triangle>& set_faces, double tolerance)
      : CheckedFaces(mesh, specification, faces, set_faces),
        tolerance_(tolerance),
        rules_(specification, 2 * tolerance),
        tree_(tree_over(mesh.file.points, candidates_)) {
    if (faces_) collect_clip_edges();
    for (const TriangulatedSurface& s : specification.surfaces) borders_.push_back(border_edges(s));
  }

  void check_sources(CheckResult& result);
  void check_bodies(CheckResult& result);
  void check_triangles(CheckResult& result);

 private:
  void collect_clip_edges();
  bool spreads_from(const PlaneTriangle& named, Index surface, const Triangle& face);
  std::vector<Index> faces_on(const PlaneTriangle& triangle, Index surface) const;
  bool may_be_cut_by_horizons(Index surface) const {
    return specification_.may_be_trimmed(surface) &&
           !(specification_.trims[surface].above.empty() && specification_.trims[surface].below.empty());
  }
  bool runs_along_border(Index surface, const Vec3& a, const Vec3& b, double tolerance) const;
  double height_of(const Triangle& t) const;
  bool open_edges_run_along_clips(const PlaneTriangle& triangle, Index surface, const std::vector<Index>& pieces) const;
  /// An input triangle: the index of its surface, and its index within that surface.
  struct Source {
    Index surface, triangle;
  };
  bool uncovered_is_removed(const PlaneTriangle& triangle, Source source, const std::vector<Index>& pieces,
                            Vec3& place) const;
  bool may_be_removed(const PlaneTriangle& triangle, Source source, const std::vector<Index>& pieces,
                      Vec3& place) const;
  std::function<bool(VertexIndex, VertexIndex)> runs_along_clip_or_border(Index surface) const;

  double tolerance_;
  TakenByRules rules_;
  BoxTree tree_;
  std::map<Index, BoxTree> surface_trees_;
  std::vector<std::vector<std::array<Vec3, 2>>> borders_;
  std::vector<std::pair<VertexIndex, VertexIndex>>
      clip_edges_;  ///< edges of mesh faces that lie on box sides or on bodies that cut other surfaces, sorted
};

void CoverageChecker::collect_clip_edges() {
  std::set<std::int32_t> clipping;
  for (const auto& [id, name] : faces_->surface_names) {
    const Index row = surface_of(id);
    if (row != no_index ? specification_.surfaces[row].cuts_all : is_box_side(id)) clipping.insert(id);
  }
  for (Index f = 0; f < candidates_.size(); ++f) {
    const auto& set = set_of(f);
    if (std::none_of(set.begin(), set.end(), [&](std::int32_t id) { return clipping.contains(id); })) continue;
    for (int i = 0; i < 3; ++i) clip_edges_.push_back(edge(candidates_[f][i], candidates_[f][(i + 1) % 3]));
  }
  std::sort(clip_edges_.begin(), clip_edges_.end());
}

/// Checks that each mesh face lies on the input triangle that it names as its source.
void CoverageChecker::check_sources(CheckResult& result) {
  FaultCollector no_source("wrong_source_triangles"), off("faces_off_their_triangle");
  double largest = 0;
  for (Index f = 0; f < candidates_.size(); ++f) {
    const Triangle& t = candidates_[f];
    const Index row = surface_of(faces_->surface[f]);
    if (row == no_index) continue;
    const TriangulatedSurface& surface = specification_.surfaces[row];
    const auto source = static_cast<std::size_t>(faces_->source_triangle[f]);
    if (faces_->source_triangle[f] < 0 || source >= surface.triangles.size()) {
      no_source.add(f, centroid(mesh_, t));
      continue;
    }
    const Triangle& s = surface.triangles[source];
    const PlaneTriangle triangle(surface.points[s[0]], surface.points[s[1]], surface.points[s[2]]);
    if (triangle.degenerate()) continue;
    double distance = 0;
    for (int i = 0; i < 3; ++i)
      distance = std::max({distance, triangle.distance(corner(t, i)), triangle.outside(corner(t, i))});
    if (distance > tolerance_ && spreads_from(triangle, row, t)) continue;
    largest = std::max(largest, distance);
    if (distance > tolerance_) off.add(f, centroid(mesh_, t));
  }
  char text[160];
  std::snprintf(text, sizeof text,
                "faces lie farther off the input triangle that they name than %.3g (the largest: %.3g)", tolerance_,
                largest);
  no_source.report(result, "faces name a source_triangle that their surface does not have");
  off.report(result, text);
  std::snprintf(text, sizeof text,
                "each face lies on the input triangle that it names, within %.3g (largest distance seen: %.3g)",
                tolerance_, largest);
  result.checks_done.emplace_back(text);
}

/// Returns whether the face's centroid is in the input triangle that the face names, and the rest of the face lies on
/// coplanar neighbours of that triangle: coplanar triangles of one surface may be meshed as one polygon. Corners and
/// midpoints of edges are tested.
bool CoverageChecker::spreads_from(const PlaneTriangle& named, Index surface, const Triangle& face) {
  if (named.outside(centroid(mesh_, face)) > tolerance_) return false;
  const TriangulatedSurface& s = specification_.surfaces[surface];
  auto at = surface_trees_.find(surface);
  if (at == surface_trees_.end()) at = surface_trees_.emplace(surface, tree_over(s.points, s.triangles)).first;
  const auto is_on_plane_part = [&](const Vec3& p) {
    if (named.distance(p) > tolerance_) return false;
    bool found = false;
    at->second.query(inflated(box_of(p, p, p), tolerance_), [&](Index i) {
      const Triangle& t = s.triangles[i];
      const Corners corners{s.points[t[0]], s.points[t[1]], s.points[t[2]]};
      const Vec3 off = nearest_on_triangle(p, corners) - p;
      const bool is_in_plane =
          std::ranges::all_of(corners, [&](const Vec3& q) { return named.distance(q) <= tolerance_; });
      found = found || (is_in_plane && dot(off, off) <= tolerance_ * tolerance_);
    });
    return found;
  };
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = corner(face, i), &b = corner(face, (i + 1) % 3);
    if (!is_on_plane_part(a) || !is_on_plane_part(0.5 * (a + b))) return false;
  }
  return true;
}

/// Checks that no face of a horizon or fault lies inside a body that cuts.
void CoverageChecker::check_bodies(CheckResult& result) {
  if (bodies_.empty()) return;
  FaultCollector inside("faces_inside_bodies");
  for (Index f = 0; f < candidates_.size(); ++f) {
    bool is_cut = false, bounds_body = false;
    for (const std::int32_t id : set_of(f)) {
      const Index row = surface_of(id);
      if (row == no_index) continue;
      is_cut = is_cut || is_cut_kind(row);
      bounds_body = bounds_body || specification_.surfaces[row].kind == SurfaceKind::body;
    }
    if (!is_cut || bounds_body || may_be_scarp(f)) continue;
    const Triangle& t = candidates_[f];
    for (const Body& body : bodies_) {
      if (!body.surface->cuts_all) continue;
      const auto winding = winding_about_centroid(body.surface->points, body.surface->triangles, body.tree,
                                                  corner(t, 0), corner(t, 1), corner(t, 2));
      if (winding && *winding != 0 &&
          // If the face's centroid is that near the body's surface, rounding may have put it inside.
          !is_near(body, centroid(mesh_, t), tolerance_)) {
        inside.add(f, centroid(mesh_, t));
        break;
      }
    }
  }
  inside.report(result, "faces of horizons and faults lie inside a body that cuts them");
  result.checks_done.emplace_back(
      "no face of a horizon or fault lies inside a body that cuts (exact, but for faces within rounding of it)");
}

std::vector<Index> CoverageChecker::faces_on(const PlaneTriangle& triangle, Index surface) const {
  std::vector<Index> found;
  const auto& c = triangle.corners();
  tree_.query(inflated(box_of(c[0], c[1], c[2]), tolerance_), [&](Index f) {
    if (!carries(f, surface)) return;
    for (int i = 0; i < 3; ++i)
      if (triangle.distance(corner(candidates_[f], i)) > tolerance_) return;
    found.push_back(f);
  });
  std::sort(found.begin(), found.end());
  return found;
}

/// Returns whether a and b lie on one border edge of the input surface, where the surface ends anyway. Such a border
/// may lie inside an input triangle if parts of the surface overlap by rounding.
bool CoverageChecker::runs_along_border(Index surface, const Vec3& a, const Vec3& b, double tolerance) const {
  return std::ranges::any_of(borders_[surface], [&](const std::array<Vec3, 2>& border) {
    const Corners line{border[0], border[1], border[1]};
    const Vec3 da = nearest_on_triangle(a, line) - a, db = nearest_on_triangle(b, line) - b;
    return std::max(dot(da, da), dot(db, db)) <= tolerance * tolerance;
  });
}

/// Height of a very thin triangle, as four areas over the perimeter. For a regular triangle, two thirds of its height.
double CoverageChecker::height_of(const Triangle& t) const {
  const PlaneTriangle triangle(corner(t, 0), corner(t, 1), corner(t, 2));
  return 4 * triangle.area() / triangle.perimeter();
}

/// Returns whether the mesh faces on an input triangle end only along box sides, bodies that cut, or the surface's
/// border. A needle between two such borders that are a rounding error apart may have its ends on either of them.
bool CoverageChecker::open_edges_run_along_clips(const PlaneTriangle& triangle, Index surface,
                                                 const std::vector<Index>& pieces) const {
  constexpr double thin = 2;  // tolerances
  struct Uses {
    int n = 0;
    Index piece = no_index;
  };
  std::map<std::pair<VertexIndex, VertexIndex>, Uses> uses;
  for (const Index f : pieces) {
    const Triangle& t = candidates_[f];
    if (triangle.outside(centroid(mesh_, t)) > tolerance_) continue;
    for (int i = 0; i < 3; ++i) {
      Uses& at = uses[edge(t[i], t[(i + 1) % 3])];
      at = {at.n + 1, f};
    }
  }
  for (const auto& [e, at] : uses) {
    const Vec3 &a = mesh_.point(e.first), &b = mesh_.point(e.second);
    if (at.n != 1 || triangle.are_beyond_a_side(a, b, tolerance_)) continue;
    const double height = height_of(candidates_[at.piece]);
    const double near = height <= thin * tolerance_ ? tolerance_ + height : tolerance_;
    if (!std::binary_search(clip_edges_.begin(), clip_edges_.end(), e) && !runs_along_border(surface, a, b, near))
      return false;
  }
  return true;
}

/// Tests a lattice of points of the input triangle: points in the box without a mesh face must be removed by a rule.
bool CoverageChecker::uncovered_is_removed(const PlaneTriangle& triangle, Source source,
                                           const std::vector<Index>& pieces, Vec3& place) const {
  bool removed = true;
  for_each_uncovered(triangle, flat_faces(*this, pieces), tolerance_, [&](const Vec3& p) {
    removed = rules_.may_be_away(source.surface, source.triangle, p) ||
              is_removed(source.surface, p, (4 * tolerance_) * triangle.normal());
    if (!removed) place = p;
    return removed;
  });
  return removed;
}

std::function<bool(VertexIndex, VertexIndex)> CoverageChecker::runs_along_clip_or_border(Index surface) const {
  return [this, surface](VertexIndex a, VertexIndex b) {
    return std::binary_search(clip_edges_.begin(), clip_edges_.end(), edge(a, b)) ||
           runs_along_border(surface, mesh_.point(a), mesh_.point(b), tolerance_);
  };
}

/// Returns whether rules may have removed the part of an input triangle that no mesh face covers. If not, sets `place`
/// to a point of that part which they keep.
bool CoverageChecker::may_be_removed(const PlaneTriangle& triangle, Source source, const std::vector<Index>& pieces,
                                     Vec3& place) const {
  if (specification_.may_be_trimmed(source.surface) || (specification_.volume && !specification_.volume->box))
    return uncovered_is_removed(triangle, source, pieces, place);
  const bool is_cut = is_cut_kind(source.surface);
  if (bodies_.empty() || !(is_cut || specification_.surfaces[source.surface].kind == SurfaceKind::body)) return false;
  if (is_cut && faces_ && !open_edges_run_along_clips(triangle, source.surface, pieces)) return false;
  return uncovered_is_removed(triangle, source, pieces, place);
}

void CoverageChecker::check_triangles(CheckResult& result) {
  FaultCollector missing("uncovered_triangles");
  std::size_t n_triangles = 0, n_clipped = 0, n_degenerate = 0, first_of_surface = 0;
  std::set<std::string> short_of;
  for (Index s = 0; s < specification_.surfaces.size(); ++s) {
    const TriangulatedSurface& surface = specification_.surfaces[s];
    // Triangles of this surface that mesh faces do not cover completely, if rules may remove connected pieces of it as
    // a whole.
    std::optional<PiecesWithoutFaces> uncovered;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const Triangle& t = surface.triangles[i];
      const PlaneTriangle triangle(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
      ++n_triangles;
      if (triangle.degenerate()) {
        ++n_degenerate;
        continue;
      }
      const std::vector<Index> pieces = faces_on(triangle, s);
      double covered = 0;  // of the triangle
      for (const Index f : pieces)
        covered +=
            triangle.common_area(corner(candidates_[f], 0), corner(candidates_[f], 1), corner(candidates_[f], 2));
      const double due = specification_.box() ? triangle.area_inside(*specification_.box()) : triangle.area();
      const double slack = 4 * tolerance_ * triangle.perimeter() + 1e-12 * triangle.area();
      if (due < triangle.area() - slack) ++n_clipped;
      if (covered >= due - slack) continue;
      if (may_be_cut_by_horizons(s)) {
        if (!uncovered) uncovered.emplace(*this, s, rules_, tolerance_, runs_along_clip_or_border(s));
        uncovered->add(triangle, static_cast<Index>(i), pieces);
        continue;
      }
      Vec3 place = (1.0 / 3) * (triangle.corners()[0] + triangle.corners()[1] + triangle.corners()[2]);
      if (may_be_removed(triangle, {s, static_cast<Index>(i)}, pieces, place)) {
        ++n_clipped;
        continue;
      }
      missing.add(first_of_surface + i, place);
      short_of.insert(surface.name);
    }
    if (uncovered) {
      const std::vector<UncoveredTriangle> not_taken = uncovered->not_taken();
      n_clipped += uncovered->size() - not_taken.size();
      for (const UncoveredTriangle& u : not_taken) {
        missing.add(first_of_surface + u.triangle, u.place);
        short_of.insert(surface.name);
      }
    }
    first_of_surface += surface.triangles.size();
  }
  std::string names;
  for (const std::string& name : short_of) names += (names.empty() ? "" : ", ") + name;
  missing.report(result, "input triangles are not covered by mesh faces (surfaces: " + names + ")");
  char text[240];
  std::snprintf(
      text, sizeof text,
      "%zu input triangles are covered by mesh faces within %.3g; %zu of them are clipped by the box or a body; %zu of "
      "zero area passed over",
      n_triangles, tolerance_, n_clipped, n_degenerate);
  result.checks_done.emplace_back(missing.count() == 0 ? text : "coverage of the input triangles was checked");
}

}  // namespace

void check_coverage(const CheckedMesh& mesh, const Specification& specification, const FacesFile* faces,
                    const std::vector<Triangle>& set_faces, double tolerance, CheckResult& result) {
  CoverageChecker checker(mesh, specification, faces, set_faces, tolerance);
  if (faces && specification.named) checker.check_sources(result);
  if (faces && specification.named) checker.check_box_sides(result);
  if (faces && specification.named) checker.check_bodies(result);
  checker.check_triangles(result);
}

}  // namespace geomesh::geomodel::checking
