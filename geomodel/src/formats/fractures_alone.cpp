// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fractures_alone.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

constexpr VertexIndex left_out = std::numeric_limits<VertexIndex>::max();

class FractureMesh {
 public:
  explicit FractureMesh(const ModelMesh& whole) : whole_(whole), row_of_(whole.points.size(), left_out) {
    made_.name = whole.name;
    made_.origin = whole.origin;
    made_.unit = whole.unit;
  }

  ModelMesh make() {
    take_surfaces();
    take_faces();
    take_nodes();
    take_curves();
    for (ModelMesh::Face& face : made_.faces)
      for (VertexIndex& v : face.vertices) v = row_of_[v];
    for (const ModelMesh::MarkedPoint& point : whole_.marked_points)
      if (row_of_[point.v] != left_out) made_.marked_points.push_back({row_of_[point.v], point.id, point.name});
    return std::move(made_);
  }

 private:
  void take_surfaces() {
    for (const NamedSurface& surface : whole_.surfaces)
      if (surface.kind == SurfaceKind::fault) faults_.insert(surface.id);
    for (std::vector<std::int32_t> set : whole_.surface_sets) {
      std::erase_if(set, [&](std::int32_t id) { return !faults_.contains(id); });
      made_.surface_sets.push_back(std::move(set));
    }
  }
  /// Copies the faces on faults to the mesh of fractures alone, without the regions on their sides.
  void take_faces() {
    for (ModelMesh::Face face : whole_.faces) {
      const std::vector<std::int32_t>& set = made_.surface_sets[static_cast<std::size_t>(face.surface_set)];
      if (set.empty()) continue;
      // A face on a fault and on a side of the box has the side's surface id. A mesh of faults alone needs the fault's.
      if (std::find(set.begin(), set.end(), face.surface) == set.end()) {
        face.surface = set.front();
        face.source_triangle = -1;
      }
      face.region_minus = face.region_plus = 0;
      for (std::size_t i = 0; i < 3; ++i) edges_.insert(std::minmax(face.vertices[i], face.vertices[(i + 1) % 3]));
      made_.faces.push_back(face);
    }
    std::set<std::int32_t> kept;
    for (const ModelMesh::Face& face : made_.faces) {
      const std::vector<std::int32_t>& set = made_.surface_sets[static_cast<std::size_t>(face.surface_set)];
      kept.insert(set.begin(), set.end());
    }
    for (const NamedSurface& surface : whole_.surfaces)
      if (kept.contains(surface.id)) made_.surfaces.push_back(surface);
    if (made_.faces.empty())
      throw Error(ErrorKind::usage,
                  "fractures_only: no face of the mesh is on a fault or a fracture; leave out this option");
  }
  void take_nodes() {
    for (const ModelMesh::Face& face : made_.faces)
      for (const VertexIndex v : face.vertices) row_of_[v] = 0;
    made_.point_arrays = whole_.point_arrays;
    for (PointArray& array : made_.point_arrays) array.values.clear();
    for (VertexIndex v = 0; v < row_of_.size(); ++v) {
      if (row_of_[v] == left_out) continue;
      row_of_[v] = static_cast<VertexIndex>(made_.points.size());
      made_.points.push_back(whole_.points[v]);
      made_.point_kind.push_back(whole_.point_kind[v]);
      made_.input_vertex.push_back(whole_.input_vertex[v]);
      for (std::size_t k = 0; k < made_.point_arrays.size(); ++k)
        made_.point_arrays[k].values.push_back(whole_.point_arrays[k].values[v]);
    }
  }
  void take_curves() {
    std::set<std::int32_t> kept;
    for (const ModelMesh::CurveEdge& edge : whole_.curve_edges) {
      if (!edges_.contains(std::minmax(edge.a, edge.b))) continue;
      made_.curve_edges.push_back({row_of_[edge.a], row_of_[edge.b], edge.curve});
      kept.insert(edge.curve);
    }
    for (const NamedCurve& curve : whole_.curves)
      if (kept.contains(curve.id)) made_.curves.push_back(curve);
  }

  const ModelMesh& whole_;
  ModelMesh made_;
  std::set<std::int32_t> faults_;
  std::set<std::pair<VertexIndex, VertexIndex>> edges_;  ///< of the faces
  std::vector<VertexIndex> row_of_;
};

}  // namespace

ModelMesh fractures_alone(const ModelMesh& mesh) { return FractureMesh(mesh).make(); }

std::string against_fractures_alone(const Format& format, const WriteOptions& options) {
  if (!format.holds.triangles_alone) {
    std::string holding;
    for (const Format& other : formats())
      if (other.holds.triangles_alone) holding += (holding.empty() ? "" : ", ") + other.name;
    return "the format " + format.name + " holds no fractures alone; those that do are " + holding +
           "; leave out fractures_only";
  }
  const std::pair<bool, const char*> others[] = {{options.order == ElementOrder::second, "order: 2"},
                                                 {!options.split.empty(), "split"},
                                                 {!options.fault_zones.empty(), "fault_zone"},
                                                 {options.partitions > 1, "partitions"},
                                                 {options.starter, "starter"}};
  for (const auto& [is_asked, name] : others)
    if (is_asked)
      return std::string("fractures_only leaves out the tetrahedra, which ") + name + " needs; give one of the two";
  return {};
}

}  // namespace geomesh::geomodel
