// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/fault_sides.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace geomesh::geomodel {

namespace {

/// An edge of a fault's face, and whether the face traverses it from the lower vertex to the higher.
struct EdgeUse {
  std::int32_t fault;
  VertexIndex a, b;
  bool forward;
  std::size_t face;
  auto key() const { return std::tuple(fault, a, b); }
};

std::vector<EdgeUse> edges_of_faults(const ModelMesh& mesh, const std::vector<std::int32_t>& fault_of) {
  std::vector<EdgeUse> uses;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (fault_of[f] != 0)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex p = mesh.faces[f].vertices[i], q = mesh.faces[f].vertices[(i + 1) % 3];
        uses.push_back({fault_of[f], std::min(p, q), std::max(p, q), p < q, f});
      }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& p, const EdgeUse& q) {
    return std::tuple(p.key(), p.face) < std::tuple(q.key(), q.face);
  });
  return uses;
}

struct Neighbour {
  std::size_t face;
  bool same;  ///< whether two neighbouring faces have their normals on the same side of the fault
};

/// A connected part of a fault, whose faces have been oriented consistently.
struct Sheet {
  std::int32_t fault;
  std::vector<std::size_t> faces;
  bool two_sided = true;
  Vec3 area{0, 0, 0};  ///< sum of the area vectors of the faces after orienting them
  double size = 0;     ///< size of this connected part of the fault: the sum of the lengths of its faces' area vectors
};

class SheetTurner {
 public:
  SheetTurner(const ModelMesh& mesh, const std::vector<std::int32_t>& fault_of)
      : mesh_(mesh), fault_of_(fault_of), turned_(mesh.faces.size(), false), seen_(mesh.faces.size(), false) {
    const std::vector<EdgeUse> uses = edges_of_faults(mesh, fault_of);
    for (std::size_t k = 0, end = 0; k < uses.size(); k = end) {
      for (end = k + 1; end < uses.size() && uses[end].key() == uses[k].key();) ++end;
      if (end - k != 2) continue;
      const bool same = uses[k].forward != uses[k + 1].forward;
      at_[uses[k].face].push_back({uses[k + 1].face, same});
      at_[uses[k + 1].face].push_back({uses[k].face, same});
    }
  }

  std::vector<bool> turned() {
    std::map<std::int32_t, std::vector<Sheet>> of_fault;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      if (fault_of_[f] != 0 && !seen_[f]) of_fault[fault_of_[f]].push_back(flood(f));
    for (auto& [fault, sheets] : of_fault) {
      const auto largest = std::max_element(sheets.begin(), sheets.end(),
                                            [](const Sheet& p, const Sheet& q) { return p.size < q.size; });
      if (kept_area(*largest) < 0) turn(*largest);
      for (Sheet& sheet : sheets)
        if (&sheet != &*largest && dot(sheet.area, largest->area) < 0) turn(sheet);
    }
    return std::move(turned_);
  }

 private:
  Vec3 area_of(std::size_t f) const {
    const Triangle& t = mesh_.faces[f].vertices;
    const Vec3 area = 0.5 * cross(mesh_.points[t[1]] - mesh_.points[t[0]], mesh_.points[t[2]] - mesh_.points[t[0]]);
    return turned_[f] ? -1.0 * area : area;
  }
  Sheet flood(std::size_t first) {
    Sheet sheet{fault_of_[first], {first}};
    seen_[first] = true;
    for (std::size_t k = 0; k < sheet.faces.size(); ++k) {
      const std::size_t f = sheet.faces[k];
      for (const Neighbour& n : at_[f]) {
        if (!seen_[n.face]) {
          seen_[n.face] = true;
          turned_[n.face] = n.same ? turned_[f] : !turned_[f];
          sheet.faces.push_back(n.face);
        } else if (turned_[n.face] != (n.same ? turned_[f] : !turned_[f])) {
          sheet.two_sided = false;
        }
      }
    }
    if (!sheet.two_sided)
      for (const std::size_t f : sheet.faces) turned_[f] = false;
    for (const std::size_t f : sheet.faces) {
      const Vec3 area = area_of(f);
      sheet.area = sheet.area + area;
      sheet.size += std::sqrt(dot(area, area));
    }
    return sheet;
  }
  /// Returns a number that is positive if most of the area of a connected part of a fault keeps its orientation.
  double kept_area(const Sheet& sheet) const {
    double kept = 0;
    for (const std::size_t f : sheet.faces) kept += (turned_[f] ? -1 : 1) * std::sqrt(dot(area_of(f), area_of(f)));
    return kept;
  }
  void turn(Sheet& sheet) {
    if (!sheet.two_sided) return;
    for (const std::size_t f : sheet.faces) turned_[f] = !turned_[f];
    sheet.area = -1.0 * sheet.area;
  }

  const ModelMesh& mesh_;
  const std::vector<std::int32_t>& fault_of_;
  std::vector<bool> turned_, seen_;
  std::map<std::size_t, std::vector<Neighbour>> at_;  // by face
};

}  // namespace

std::vector<bool> turned_faces(const ModelMesh& mesh, const std::vector<std::int32_t>& fault_of) {
  return SheetTurner(mesh, fault_of).turned();
}

}  // namespace geomesh::geomodel
