// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gocad/gocad_model3d.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace geomesh::geomodel {
namespace {

/// The triangles of a GOCAD Model3d face, which is a part of a surface in the same file.
struct FoundFace {
  Index surface;      ///< row in contents.surfaces
  Index first, last;  ///< triangles
  bool as_stored;     ///< whether the surface's triangles have normals that point to the + side of the GOCAD face
};

/// Compares two triangles by their corners. Returns +1 if `corner` is a rotation of `key`, -1 if it is a rotation of
/// the reversed `key`, and 0 for different triangles.
int compare_triangles(const Vec3 (&key)[3], const Vec3 (&corner)[3]) {
  for (int r = 0; r < 3; ++r) {
    if (!(key[0] == corner[r])) continue;
    if (key[1] == corner[(r + 1) % 3] && key[2] == corner[(r + 2) % 3]) return 1;
    if (key[1] == corner[(r + 2) % 3] && key[2] == corner[(r + 1) % 3]) return -1;
  }
  return 0;
}

std::optional<FoundFace> find_face(const GocadKeyFace& face, const GocadObject& object, Index surface) {
  for (Index t = 0; t < object.triangles.size(); ++t) {
    const Triangle& v = object.triangles[t];
    const Vec3 corner[3] = {object.points[v[0]], object.points[v[1]], object.points[v[2]]};
    const int match = compare_triangles(face.key, corner);
    if (match == 0) continue;
    const auto next = std::upper_bound(object.part_first.begin(), object.part_first.end(), t);
    const Index last = next == object.part_first.end() ? static_cast<Index>(object.triangles.size()) : *next;
    return FoundFace{surface, *(next - 1), last, match > 0};
  }
  return std::nullopt;
}

SurfaceKind kind_of(const std::string& type) {
  const std::string t = to_lower(type);
  if (t.find("fault") != std::string::npos) return SurfaceKind::fault;
  for (const char* word : {"top", "horizon", "none_conformal", "unconformity", "intraformational", "bottom"})
    if (t.find(word) != std::string::npos) return SurfaceKind::horizon;
  return SurfaceKind::surface;
}

}  // namespace

void add_model3d_regions(const GocadObject& model, const std::vector<GocadObject>& objects, FileContents& contents) {
  std::map<std::string, const GocadObject*> object_of;
  for (const GocadObject& o : objects)
    if (o.kind == "TSurf") object_of.emplace(o.name, &o);
  std::map<std::int64_t, FoundFace> faces;
  for (const GocadKeyFace& face : model.key_faces) {
    const auto object = object_of.find(face.surface);
    const auto row = std::find_if(contents.surfaces.begin(), contents.surfaces.end(),
                                  [&](const TriangulatedSurface& s) { return s.name == face.surface; });
    std::optional<FoundFace> found;
    if (object != object_of.end() && row != contents.surfaces.end()) {
      row->kind = kind_of(face.type);
      found = find_face(face, *object->second, static_cast<Index>(row - contents.surfaces.begin()));
    }
    if (!found) {
      contents.warnings.push_back("face " + std::to_string(face.id) + " of the model (line " +
                                  std::to_string(face.line) + ") is not found in surface '" + face.surface +
                                  "': the model's regions are left out");
      return;
    }
    faces.emplace(face.id, *found);
  }
  for (const GocadRegion& region : model.regions) {
    if (region.name == "Universe") continue;
    RegionHint hint{region.name, {}};
    for (const std::int64_t id : region.signed_faces) {
      const auto face = faces.find(id < 0 ? -id : id);
      if (face == faces.end()) {
        contents.warnings.push_back("region " + region.name + " names face " + std::to_string(id) +
                                    ", which the model does not have: the model's regions are left out");
        contents.regions.clear();
        return;
      }
      const FoundFace& f = face->second;
      for (Index t = f.first; t < f.last; ++t) hint.boundary.push_back({f.surface, t, (id > 0) == f.as_stored});
    }
    contents.regions.push_back(std::move(hint));
  }
}

}  // namespace geomesh::geomodel
