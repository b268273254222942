// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/mesh/checked_faces.hpp"

#include <algorithm>

#include "check/exact/crossing.hpp"
#include "check/exact/deviation.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {

bool is_near(const Body& body, const Vec3& p, double reach) {
  bool found = false;
  body.tree.query(inflated(box_of(p, p, p), reach), [&](Index row) {
    const Triangle& t = body.surface->triangles[row];
    const auto& points = body.surface->points;
    const Vec3 way = nearest_on_triangle(p, {points[t[0]], points[t[1]], points[t[2]]}) - p;
    found = found || dot(way, way) <= reach * reach;
  });
  return found;
}

BoxTree tree_over(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  std::vector<Box3> boxes;
  for (const Triangle& t : triangles) boxes.push_back(box_of(points[t[0]], points[t[1]], points[t[2]]));
  return BoxTree(std::move(boxes));
}

CheckedFaces::CheckedFaces(const CheckedMesh& mesh, const Specification& specification, const FacesFile* faces,
                           const std::vector<Triangle>& set_faces)
    : mesh_(mesh), specification_(specification), faces_(faces) {
  if (faces_) {
    candidates_ = set_faces;  // also triangles that are no mesh faces, so that indices are those of the faces file
  } else {
    for (const FacePair& face : mesh_.faces) candidates_.push_back(face.key);
  }
  for (const TriangulatedSurface& s : specification.surfaces)
    if (s.kind == SurfaceKind::body || s.cuts_all) bodies_.push_back({&s, tree_over(s.points, s.triangles)});
  if (!faces_) return;
  for (Index i = 0; i < specification.surfaces.size(); ++i)
    for (const auto& [id, name] : faces_->surface_names)
      if (name == specification.surfaces[i].name) surface_of_id_[id] = i, id_of_surface_[i] = id;
}

bool CheckedFaces::carries(Index face, Index surface) const {
  if (!faces_ || !specification_.named) return true;
  const auto id = id_of_surface_.find(surface);
  if (id == id_of_surface_.end()) return false;
  const auto& set = set_of(face);
  return std::find(set.begin(), set.end(), id->second) != set.end();
}

const std::vector<std::int32_t>& CheckedFaces::set_of(Index face) const {
  static const std::vector<std::int32_t> none;
  const std::int32_t row = faces_->surface_set[face];
  return row >= 0 && static_cast<std::size_t>(row) < faces_->surface_sets.size() ? faces_->surface_sets[row] : none;
}

Index CheckedFaces::surface_of(std::int32_t id) const {
  const auto row = surface_of_id_.find(id);
  return row == surface_of_id_.end() ? no_index : row->second;
}

bool CheckedFaces::is_box_side(std::int32_t id) const {
  const auto name = faces_->surface_names.find(id);
  if (surface_of(id) != no_index || name == faces_->surface_names.end()) return false;
  if (specification_.volume && !specification_.volume->box)
    return std::ranges::any_of(specification_.volume->sides,
                               [&](const TriangulatedSurface& side) { return side.name == name->second; });
  return std::find(std::begin(box_side_names), std::end(box_side_names), name->second) != std::end(box_side_names);
}

bool CheckedFaces::is_side_alone(Index face) const {
  if (!faces_) return false;
  const auto& set = set_of(face);
  return !set.empty() && std::all_of(set.begin(), set.end(), [&](std::int32_t id) { return is_box_side(id); });
}

bool CheckedFaces::is_cut_kind(Index surface) const {
  const SurfaceKind kind = specification_.surfaces[surface].kind;
  return (kind == SurfaceKind::horizon || kind == SurfaceKind::fault) && !specification_.surfaces[surface].ends_model;
}

bool CheckedFaces::may_be_scarp(Index face) const {
  return faces_ && (faces_->region_minus[face] == 0 || faces_->region_plus[face] == 0) &&
         std::any_of(specification_.surfaces.begin(), specification_.surfaces.end(),
                     [](const TriangulatedSurface& s) { return s.ends_model; });
}

bool CheckedFaces::is_removed(Index surface, const Vec3& p, const Vec3& off, Index but) const {
  const TriangulatedSurface* passed_over = but == no_index ? nullptr : &specification_.surfaces[but];
  const auto in = [](const Body& body, const Vec3& q) {
    const auto winding = winding_about_centroid(body.surface->points, body.surface->triangles, body.tree, q, q, q);
    return !winding || *winding != 0;
  };
  if (is_cut_kind(surface))
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
      return body.surface->cuts_all && body.surface != passed_over && in(body, p);
    });
  return std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
    return body.surface == &specification_.surfaces[surface] && in(body, p + off) && in(body, p - off);
  });
}

void CheckedFaces::check_box_sides(CheckResult& result) const {
  if (!specification_.box()) return;
  FaultCollector off_side("faces_off_box_side");
  for (Index f = 0; f < candidates_.size(); ++f) {
    if (!is_box_side(faces_->surface[f])) continue;
    const std::string& name = faces_->surface_names.at(faces_->surface[f]);
    const auto side = static_cast<std::size_t>(std::find(std::begin(box_side_names), std::end(box_side_names), name) -
                                               std::begin(box_side_names));
    const double wanted = (side % 2 == 0 ? specification_.box()->min : specification_.box()->max)[side / 2];
    const auto is_off = [&](VertexIndex v) { return mesh_.point(v)[side / 2] != wanted; };
    const Triangle& t = candidates_[f];
    if (const auto v = std::find_if(t.begin(), t.end(), is_off); v != t.end()) off_side.add(f, mesh_.point(*v));
  }
  off_side.report(result, "faces of box sides do not lie on them exactly");
}

}  // namespace geomesh::geomodel::checking
