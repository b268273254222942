// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the face set against the faces of the mesh, declared in `check/mesh/checked_mesh.hpp`.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "check/exact/exact.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

bool less(const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

std::int32_t region_of(const CheckedMesh& mesh, Index cell) { return cell == no_index ? 0 : mesh.file.region[cell]; }

/// Checks that each triangle of the face set is a mesh face and occurs once. Returns these faces, nullptr for none.
std::vector<const FacePair*> check_triangles(const CheckedMesh& mesh, const FacesFile& faces,
                                             const std::vector<Triangle>& triangles, CheckResult& result) {
  FaultCollector unknown_point("face_points_not_in_mesh"), no_face("faces_not_in_mesh"), repeated("repeated_faces");
  std::vector<const FacePair*> found(triangles.size(), nullptr);
  std::vector<std::pair<Triangle, std::size_t>> keys;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    const Vec3& place = faces.points[faces.triangles[f][0]];
    if (std::find(t.begin(), t.end(), no_vertex) != t.end()) {
      unknown_point.add(f, place);
      continue;
    }
    found[f] = find_face(mesh, t);
    if (!found[f]) no_face.add(f, place);
    keys.emplace_back(sorted(t), f);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first)
      repeated.add(keys[i].second, faces.points[faces.triangles[keys[i].second][0]]);
  unknown_point.report(result, "triangles of the face set have a point that the mesh does not have");
  no_face.report(result, "triangles of the face set are no face of the mesh");
  repeated.report(result, "triangles are in the face set more than once");
  return found;
}

/// Checks that region_minus and region_plus are the regions at the face, and that its normal points from minus to plus.
void check_sides(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<Triangle>& triangles,
                 const std::vector<const FacePair*>& found, CheckResult& result) {
  FaultCollector wrong("wrong_face_regions"), inward("boundary_faces_turned");
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!found[f]) continue;
    const bool odd = is_odd(triangles[f]);
    const std::int32_t minus = region_of(mesh, odd ? found[f]->odd : found[f]->even);
    const std::int32_t plus = region_of(mesh, odd ? found[f]->even : found[f]->odd);
    if (minus == 0) inward.add(f, centroid(mesh, triangles[f]));
    if (faces.region_minus[f] != minus || faces.region_plus[f] != plus) wrong.add(f, centroid(mesh, triangles[f]));
  }
  wrong.report(result, "faces do not have the regions that lie at them (normal from region_minus to region_plus)");
  inward.report(result, "boundary faces have their normal pointing inwards");
}

/// Returns whether the region is the hull that `--hull` adds around the model. Its outer border belongs to no surface.
bool is_hull(const CheckedMesh& mesh, std::int32_t region) {
  const auto name = mesh.file.region_names.find(region);
  return name != mesh.file.region_names.end() && (name->second == "hull" || name->second.starts_with("hull__"));
}

/// Checks that every mesh face between two regions, or between a region and the outside, is in the face set.
void check_all_listed(const CheckedMesh& mesh, const std::vector<const FacePair*>& found, CheckResult& result) {
  std::vector<bool> listed(mesh.faces.size(), false);
  for (const FacePair* face : found)
    if (face) listed[static_cast<std::size_t>(face - mesh.faces.data())] = true;
  FaultCollector missing("unlisted_region_faces");
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const std::int32_t a = region_of(mesh, mesh.faces[i].even), b = region_of(mesh, mesh.faces[i].odd);
    if (listed[i] || a == b || (is_boundary(mesh.faces[i]) && is_hull(mesh, a + b))) continue;
    missing.add(i, centroid(mesh, mesh.faces[i].key));
  }
  missing.report(result,
                 "mesh faces lie between two regions, or outside and a region, and are in no surface of the face set");
}

/// Checks that the listed faces around each region form a closed surface that encloses exactly its volume.
void check_regions_closed(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<Triangle>& triangles,
                          const std::vector<const FacePair*>& found, CheckResult& result) {
  struct RegionEdge {
    std::int32_t region;
    VertexIndex a, b;
    int direction;
  };
  std::vector<RegionEdge> sides;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!found[f] || faces.region_minus[f] == faces.region_plus[f]) continue;
    for (int i = 0; i < 3; ++i) {
      const VertexIndex a = triangles[f][i], b = triangles[f][(i + 1) % 3];
      const int direction = a < b ? 1 : -1;
      if (faces.region_minus[f] != 0 && !is_hull(mesh, faces.region_minus[f]))
        sides.push_back({faces.region_minus[f], std::min(a, b), std::max(a, b), direction});
      if (faces.region_plus[f] != 0 && !is_hull(mesh, faces.region_plus[f]))
        sides.push_back({faces.region_plus[f], std::min(a, b), std::max(a, b), -direction});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const RegionEdge& x, const RegionEdge& y) {
    return std::tie(x.region, x.a, x.b, x.direction) < std::tie(y.region, y.a, y.b, y.direction);
  });
  FaultCollector open("open_regions");
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    int sum = 0;
    for (j = i; j < sides.size() &&
                std::tie(sides[j].region, sides[j].a, sides[j].b) == std::tie(sides[i].region, sides[i].a, sides[i].b);
         ++j)
      sum += sides[j].direction;
    if (sum != 0) open.add(sides[i].a, mesh.point(sides[i].a));
  }
  open.report(result, "edges where the faces about a region do not close");
}

void check_names(const CheckedMesh& mesh, const FacesFile& faces, CheckResult& result) {
  FaultCollector unnamed("unnamed_surfaces"), shared_id("shared_ids"), wrong_set("wrong_surface_sets"),
      wrong_patch("wrong_patches");
  std::set<std::int32_t> region_ids(mesh.file.region.begin(), mesh.file.region.end()), seen;
  for (std::size_t f = 0; f < faces.triangles.size(); ++f) {
    const Vec3& place = faces.points[faces.triangles[f][0]];
    const std::int32_t id = faces.surface[f];
    if (seen.insert(id).second) {
      if (!faces.surface_names.contains(id)) unnamed.add(f, place);
      if (region_ids.contains(id)) shared_id.add(f, place);
    }
    const auto set = static_cast<std::size_t>(faces.surface_set[f]);
    const bool right = faces.surface_set[f] >= 0 && set < faces.surface_sets.size() &&
                       !faces.surface_sets[set].empty() && faces.surface_sets[set].front() == id;
    if (!right) wrong_set.add(f, place);
    if (faces.patch[f] < 1) wrong_patch.add(f, place);
  }
  unnamed.report(result, "surface ids have no name");
  shared_id.report(result, "surface ids are region ids too");
  wrong_set.report(result, "faces have a surface_set that is not there or does not begin with their surface");
  wrong_patch.report(result, "faces have a patch less than 1");
}

}  // namespace

std::vector<VertexIndex> match_points(const CheckedMesh& mesh, const std::vector<Vec3>& points) {
  std::vector<VertexIndex> order(mesh.n_points()), rows;
  std::iota(order.begin(), order.end(), VertexIndex{0});
  std::sort(order.begin(), order.end(), [&](VertexIndex a, VertexIndex b) {
    return mesh.point(a) == mesh.point(b) ? a < b : less(mesh.point(a), mesh.point(b));
  });
  for (const Vec3& p : points) {
    const auto it = std::lower_bound(order.begin(), order.end(), p,
                                     [&](VertexIndex v, const Vec3& q) { return less(mesh.point(v), q); });
    rows.push_back(it != order.end() && mesh.point(*it) == p ? *it : no_vertex);
  }
  return rows;
}

std::vector<Triangle> check_face_set(const CheckedMesh& mesh, const FacesFile& faces, CheckResult& result) {
  const std::vector<VertexIndex> rows = match_points(mesh, faces.points);
  std::vector<Triangle> triangles;
  for (const Triangle& t : faces.triangles) triangles.push_back({rows[t[0]], rows[t[1]], rows[t[2]]});
  const auto found = check_triangles(mesh, faces, triangles, result);
  result.checks_done.push_back("the face set: " + std::to_string(triangles.size()) +
                               " triangles, each a mesh face, once");
  if (!faces.missing_arrays.empty()) {
    std::string names;
    for (const std::string& name : faces.missing_arrays) names += (names.empty() ? "" : ", ") + name;
    result.faults.push_back(
        {"missing_face_arrays",
         std::to_string(faces.missing_arrays.size()) + " cell arrays are missing in the face set: " + names,
         faces.missing_arrays.size(),
         {},
         {}});
    return triangles;
  }
  check_names(mesh, faces, result);
  if (!mesh.file.region.empty()) {
    check_sides(mesh, faces, triangles, found, result);
    check_all_listed(mesh, found, result);
    check_regions_closed(mesh, faces, triangles, found, result);
    result.checks_done.emplace_back(
        "normals point from region_minus to region_plus; every face at a region's border is listed; the faces about "
        "each region "
        "close");
  }
  return triangles;
}

}  // namespace geomesh::geomodel::checking
