// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/within/within_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "check/exact/crossing.hpp"
#include "check/exact/plane_triangle.hpp"
#include "check/mesh/faults.hpp"
#include "check/specification/taken_by_rules.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Decides which mesh faces may represent a surface if the files give no names to faces.
class UnnamedFaces {
 public:
  explicit UnnamedFaces(const CheckedMesh& mesh) : mesh_(mesh) {
    for (const Triangle& t : mesh.file.triangles) listed_.push_back(sorted(t));
    std::sort(listed_.begin(), listed_.end());
  }
  /// Returns whether a mesh face may belong to a surface: it bounds the mesh, separates two regions, or is one of the
  /// triangles in the mesh's file. Without such a triangle, a fault inside one unit cannot be recognised.
  bool may_be_surface(const FacePair& face) const {
    if (is_boundary(face) || std::binary_search(listed_.begin(), listed_.end(), face.key)) return true;
    const std::vector<std::int32_t>& region = mesh_.file.region;
    return !region.empty() && is_inner(face) && region[face.even] != region[face.odd];
  }

 private:
  const CheckedMesh& mesh_;
  std::vector<Triangle> listed_;
};

/// Returns whether a mesh face without names is on one of the volume's own sides, up to rounding. If the model fills
/// the volume, only these sides bound the mesh.
bool is_side_of_volume(const CheckedFaces& checked, Index f, double rounding) {
  const Specification& specification = checked.specification();
  if (!specification.volume || !is_boundary(checked.mesh().faces[f])) return false;
  const Box3* const box = specification.box();
  if (!box) return !specification.ends_inside;
  const Corners corners = corners_of(checked, f);
  for (std::size_t k = 0; k < 3; ++k)
    for (const double side : {box->min[k], box->max[k]})
      if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) { return std::abs(p[k] - side) <= rounding; }))
        return true;
  return false;
}

/// Formats a measured deviation as in "proven within 0.5 for 99.8 % of the area, the rest sampled at most 0.1 apart;
/// largest distance sampled 0.34".
std::string words(const Deviation& d, double tolerance) {
  char text[240];
  const double share = d.area > 0 ? 100 * std::min(1.0, d.proven / (d.area - d.beyond)) : 100;
  std::snprintf(text, sizeof text, "proven within %.6g for %.4g %% of the area%s; largest distance sampled %.4g",
                tolerance, share, share < 100 && d.spacing > 0 ? ", the rest sampled at points at most " : "",
                d.largest);
  std::string all = text;
  if (share < 100 && d.spacing > 0) {
    std::snprintf(text, sizeof text, "%.3g apart", d.spacing);
    all.insert(all.find("; largest"), text);
  }
  return all;
}

class SurfacesWithin {
 public:
  SurfacesWithin(const CheckedFaces& checked, const Allowed& allowed)
      : checked_(checked), allowed_(allowed), rules_(checked.specification(), 2 * allowed.both()) {}

  void check(const SurfacePair& pair);
  void report(CheckResult& result);

 private:
  void check_faces(const SurfacePair& pair);
  void check_input(const SurfacePair& pair);
  /// Measures how far the part of an input triangle inside the box is from the mesh faces of its surface. Returns a
  /// point of it that is farther than allowed, if there is one.
  std::optional<Vec3> check_in_box(const DeviationChecker& checker, const PlaneTriangle& triangle, Deviation& sum);

  const CheckedFaces& checked_;
  Allowed allowed_;
  TakenByRules rules_;
  Deviation faces_, input_;
  double worst_face_ = 0, worst_input_ = 0;
  FaultCollector faces_off_{"faces_off_their_surface"}, input_off_{"input_off_the_mesh"};
  std::vector<std::string> face_names_, input_names_;
};

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (names.empty() || names.back() != name) names.push_back(name);
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

void SurfacesWithin::check_faces(const SurfacePair& pair) {
  std::vector<Corners> input;
  for (const Index row : pair.rows)
    for (const Corners& t : triangles_of(checked_.specification().surfaces[row])) input.push_back(t);
  const TriangleSet set(std::move(input));
  const DeviationChecker checker(set, allowed_.both());
  for (const Index f : pair.faces) {
    const auto witness = checker.check(corners_of(checked_, f), faces_);
    if (!witness) continue;
    worst_face_ = std::max(worst_face_, set.distance(*witness));
    faces_off_.add(f, *witness);
    add_name(face_names_, pair.name);
  }
}

std::optional<Vec3> SurfacesWithin::check_in_box(const DeviationChecker& checker, const PlaneTriangle& triangle,
                                                 Deviation& sum) {
  const Box3* box = checked_.specification().box();
  std::vector<Vec3> polygon(triangle.corners().begin(), triangle.corners().end());
  if (box) polygon = triangle.inside(*box);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (const auto witness = checker.check({polygon[0], polygon[i - 1], polygon[i]}, sum)) return witness;
  return std::nullopt;
}

void SurfacesWithin::check_input(const SurfacePair& pair) {
  std::vector<Corners> faces;
  for (const Index f : pair.faces) faces.push_back(corners_of(checked_, f));
  const TriangleSet set(std::move(faces));
  std::size_t first = 0;
  for (const Index row : pair.rows) {
    const std::vector<Corners> triangles = triangles_of(checked_.specification().surfaces[row]);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const PlaneTriangle triangle(triangles[i][0], triangles[i][1], triangles[i][2]);
      if (triangle.degenerate()) continue;
      const Vec3 off = (4 * allowed_.rounding) * triangle.normal();
      const DeviationChecker checker(set, allowed_.both(), [&](const Vec3& p) {
        return !rules_.may_be_away(row, static_cast<Index>(i), p) &&
               !(checked_.specification().named && checked_.is_removed(row, p, off));
      });
      const auto witness = check_in_box(checker, triangle, input_);
      if (!witness) continue;
      worst_input_ = std::max(worst_input_, set.distance(*witness));
      input_off_.add(first + i, *witness);
      add_name(input_names_, pair.name);
    }
    first += triangles.size();
  }
}

void SurfacesWithin::check(const SurfacePair& pair) {
  check_faces(pair);
  check_input(pair);
}

void SurfacesWithin::report(CheckResult& result) {
  char text[200];
  const bool pass = faces_off_.count() + input_off_.count() == 0;
  std::snprintf(
      text, sizeof text,
      "faces of surfaces have points farther from the input than %.6g (the largest distance seen: %.6g; surfaces: ",
      allowed_.both(), worst_face_);
  faces_off_.report(result, text + joined(face_names_) + ")");
  std::snprintf(text, sizeof text,
                "input triangles have points farther from the mesh's faces than %.6g (the largest distance seen: %.6g; "
                "surfaces: ",
                allowed_.both(), worst_input_);
  input_off_.report(result, text + joined(input_names_) + ")");
  if (!pass) {
    result.checks_done.emplace_back("distances between surfaces and input were checked, both ways");
    return;
  }
  result.checks_done.push_back("from mesh to input: " + words(faces_, allowed_.both()));
  result.checks_done.push_back("from input to mesh, less what the box and rules take: " +
                               words(input_, allowed_.both()));
}

/// Checks that mesh faces of horizons and faults reach into a body that cuts by at most the allowed distance, measured
/// at the centroids of the faces.
void check_bodies_within(const CheckedFaces& checked, const Allowed& allowed, const std::vector<Triangle>& candidates,
                         CheckResult& result) {
  FaultCollector inside("faces_inside_bodies");
  for (const Body& body : checked.bodies()) {
    if (!body.surface->cuts_all) continue;
    const TriangleSet set(triangles_of(*body.surface));
    for (Index f = 0; f < candidates.size(); ++f) {
      const auto& ids = checked.set_of(f);
      const auto is = [&](auto&& property) {
        return std::any_of(ids.begin(), ids.end(), [&](std::int32_t id) {
          const Index row = checked.surface_of(id);
          return row != no_index && property(row);
        });
      };
      if (checked.may_be_scarp(f) || !is([&](Index row) { return checked.is_cut_kind(row); }) ||
          is([&](Index row) { return checked.specification().surfaces[row].kind == SurfaceKind::body; }))
        continue;
      const Corners c = corners_of(checked, f);
      const auto winding =
          winding_about_centroid(body.surface->points, body.surface->triangles, body.tree, c[0], c[1], c[2]);
      if (!winding || *winding == 0) continue;
      const Vec3 centre = (1.0 / 3) * (c[0] + c[1] + c[2]);
      if (set.near(centre, allowed.both()).empty()) inside.add(f, centre);
    }
  }
  inside.report(result, "faces of horizons and faults lie inside a body that cuts them, deeper than the tolerance");
}

}  // namespace

Corners corners_of(const CheckedFaces& checked, Index face) {
  const Triangle& t = checked.candidates()[face];
  return {checked.corner(t, 0), checked.corner(t, 1), checked.corner(t, 2)};
}

std::vector<Corners> triangles_of(const TriangulatedSurface& surface) {
  std::vector<Corners> corners;
  for (const Triangle& t : surface.triangles)
    corners.push_back({surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]});
  return corners;
}

std::vector<SurfacePair> pair_surfaces(const CheckedFaces& checked, double rounding) {
  const Specification& specification = checked.specification();
  std::vector<SurfacePair> pairs;
  if (specification.named && checked.faces()) {
    for (Index s = 0; s < specification.surfaces.size(); ++s) {
      pairs.push_back({specification.surfaces[s].name, {s}, {}});
      for (Index f = 0; f < checked.candidates().size(); ++f)
        if (checked.carries(f, s)) pairs.back().faces.push_back(f);
    }
    return pairs;
  }
  const UnnamedFaces unnamed(checked.mesh());
  SurfacePair all{"the surfaces given", {}, {}};
  for (Index s = 0; s < specification.surfaces.size(); ++s) all.rows.push_back(s);
  for (Index f = 0; f < checked.candidates().size(); ++f)
    if (checked.faces() ? !checked.is_side_alone(f)
                        : unnamed.may_be_surface(checked.mesh().faces[f]) && !is_side_of_volume(checked, f, rounding))
      all.faces.push_back(f);
  pairs.push_back(std::move(all));
  return pairs;
}

void check_surfaces_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result) {
  SurfacesWithin within(checked, allowed);
  for (const SurfacePair& pair : pair_surfaces(checked, allowed.rounding)) within.check(pair);
  within.report(result);
  if (!checked.faces() || !checked.specification().named) return;
  check_bodies_within(checked, allowed, checked.candidates(), result);
  checked.check_box_sides(result);
}

}  // namespace geomesh::geomodel::checking
