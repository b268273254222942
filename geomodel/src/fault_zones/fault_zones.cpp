// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_zones/fault_zones.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "fault_zones/relabel.hpp"
#include "fault_zones/zone_columns.hpp"
#include "fault_zones/zone_walls.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "solver_mesh/split_faults.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

template <std::size_t N>
bool has_repeats(std::array<VertexIndex, N> v) {
  std::sort(v.begin(), v.end());
  return std::adjacent_find(v.begin(), v.end()) != v.end();
}

Triangle in_order(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

class ZoneOpener {
 public:
  ZoneOpener(const ModelMesh& mesh, const std::vector<FaultZone>& zones) : zones_(zones) {
    std::vector<std::string> faults;
    for (const FaultZone& zone : zones) {
      if (std::find(faults.begin(), faults.end(), zone.fault) != faults.end())
        throw Error(ErrorKind::usage, "fault_zone: " + zone.fault + " is named twice");
      faults.push_back(zone.fault);
    }
    SplitMesh split = split_with_origins(mesh, faults, true);
    columns_ = columns_of(split, zones);
    mesh_ = std::move(split.mesh);
    mesh_.prisms.clear();
    mesh_.cohesive_layers.clear();
    mesh_.before_zones = mesh_.points;
    if (!mesh.before_zones.empty())  // keeps positions from before fault zones that an earlier call opened
      for (std::size_t v = 0; v < mesh_.points.size(); ++v)
        mesh_.before_zones[v] = mesh.before_zones[split.original[v]];
    for (std::size_t v = mesh.points.size(); v < mesh_.points.size(); ++v) mesh_.point_kind[v] = 3;
  }

  ModelMesh open() {
    join_closed_faces();
    add_regions();
    const std::vector<Vec3> before = mesh_.points;
    move_walls(mesh_, columns_, zones_);
    move_curved_edges(before);
    fill_columns(mesh_, columns_, zones_);
    add_elements();
    require_positive();
    add_side_faces();
    close_walls();
    carry_wells_across();
    name_intersections(mesh_, edges_);
    renumber_ids(mesh_);
    number_patches(mesh_);
    measure_again(mesh_);
    return std::move(mesh_);
  }

 private:
  /// Moves the midpoints of curved edges with the walls of fault zones. Edges with both ends on walls become straight,
  /// like those of the elements between the walls. Midpoints of others move by the mean of their ends' moves.
  void move_curved_edges(const std::vector<Vec3>& before) {
    const auto way = [&](VertexIndex v) { return mesh_.points[v] - before[v]; };
    std::erase_if(mesh_.curved_edges, [&](const CurvedEdge& edge) {
      return !(way(edge.a) == Vec3{0, 0, 0}) && !(way(edge.b) == Vec3{0, 0, 0});
    });
    for (CurvedEdge& edge : mesh_.curved_edges) edge.middle = edge.middle + 0.5 * (way(edge.a) + way(edge.b));
  }
  /// Joins faces that were split but have the same three nodes on both sides, as at an end of the fault. There is no
  /// fault zone between them, and the face exists once.
  void join_closed_faces() {
    std::map<Triangle, std::size_t> first;
    std::set<std::size_t> second;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      if (mesh_.faces[f].region_plus != 0 || is_wall(mesh_.faces[f])) continue;
      const auto [entry, is_new] = first.try_emplace(in_order(mesh_.faces[f].vertices), f);
      if (is_new) continue;
      ModelMesh::Face& kept = mesh_.faces[entry->second];
      kept.region_plus = mesh_.faces[f].region_minus;
      if (kept.region_plus < kept.region_minus) {
        std::swap(kept.region_minus, kept.region_plus);
        std::swap(kept.vertices[1], kept.vertices[2]);
      }
      second.insert(f);
    }
    std::size_t row = 0;
    std::erase_if(mesh_.faces, [&](const ModelMesh::Face&) { return second.contains(row++); });
  }
  /// Adds a region for each fault zone. The ids of surfaces, curves and points are shifted to make room for its id;
  /// renumber_ids() follows.
  void add_regions() {
    const auto n = static_cast<std::int32_t>(zones_.size());
    for (NamedSurface& s : mesh_.surfaces) s.id += n;
    for (NamedCurve& c : mesh_.curves) c.id += n;
    for (auto& p : mesh_.marked_points) p.id += n;
    for (NodeSet& s : mesh_.node_sets) s.id += n;
    for (auto& set : mesh_.surface_sets)
      for (std::int32_t& id : set) id += n;
    for (auto& face : mesh_.faces) face.surface += n;
    for (auto& e : mesh_.curve_edges) e.curve += n;
    for (const FaultZone& zone : zones_) {
      const std::string name = zone_name(zone.fault);
      for (const Region& region : mesh_.regions)
        if (region.name == name)
          throw Error(ErrorKind::usage, "fault_zone " + zone.fault + ": a region is named " + name + " already");
      Region region{static_cast<std::int32_t>(mesh_.regions.size() + 1), name, {}};
      region.unit = name;
      mesh_.regions.push_back(std::move(region));
    }
    for (RegionAttribute& a : mesh_.attributes) a.by_region.resize(mesh_.regions.size(), not_known);
  }
  std::int32_t region_of(std::size_t zone) const {
    return static_cast<std::int32_t>(mesh_.regions.size() - zones_.size() + zone + 1);
  }

  VertexIndex node(std::size_t column, unsigned level) const {
    const ZoneColumn& c = columns_.columns[column];
    return c.is_closed() ? c.minus : c.nodes[level];
  }
  void add(const Tetrahedron& t, std::size_t zone) {
    if (has_repeats(t)) return;
    mesh_.tetrahedra.push_back(t);
    mesh_.tet_region.push_back(region_of(zone));
  }
  /// Divides the prisms of fault zones into tetrahedra. Each side of a prism is cut along the diagonal from the lower
  /// end of its column of nodes with the smaller row, so that neighbouring prisms agree.
  void add_elements() {
    for (const ZonePrism& prism : columns_.prisms) {
      std::array<std::size_t, 3> c = prism.columns;
      bool even = true;
      for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}})
        if (c[i] > c[j]) {
          std::swap(c[i], c[j]);
          even = !even;
        }
      for (unsigned k = 0; k < zones_[prism.zone].layers; ++k) {
        const VertexIndex l0 = node(c[0], k), l1 = node(c[1], k), l2 = node(c[2], k);
        const VertexIndex u0 = node(c[0], k + 1), u1 = node(c[1], k + 1), u2 = node(c[2], k + 1);
        add(even ? Tetrahedron{l0, l1, l2, u2} : Tetrahedron{l0, l1, u2, l2}, prism.zone);
        add(even ? Tetrahedron{l0, l1, u2, u1} : Tetrahedron{l0, l1, u1, u2}, prism.zone);
        add(even ? Tetrahedron{l0, u0, u1, u2} : Tetrahedron{l0, u0, u2, u1}, prism.zone);
      }
    }
    for (CellArray& array : mesh_.cell_arrays) array.values.resize(mesh_.tetrahedra.size(), not_known);
  }

  void require_positive() const {
    std::size_t n = 0, first = 0;
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
      const Tetrahedron& v = mesh_.tetrahedra[t];
      if (orient3d(mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]], mesh_.points[v[3]]) != Sign::positive &&
          n++ == 0)
        first = t;
    }
    if (n == 0) return;
    std::string faults;
    for (const FaultZone& zone : zones_) faults += (faults.empty() ? "" : ", ") + zone.fault;
    const Vec3& p = mesh_.points[mesh_.tetrahedra[first][0]];
    throw Error(ErrorKind::cannot_mesh,
                "fault_zone " + faults + ": " + std::to_string(n) +
                    " elements would be turned over, the first in region " +
                    mesh_.regions[static_cast<std::size_t>(mesh_.tet_region[first] - 1)].name + " at (" +
                    std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
                    "). The zone is too thick for the elements beside the fault: give less thickness, or larger sizes "
                    "there",
                {{}, {}, {}, {p}});
  }

  /// Adds the faces that fault zones have on sides of the model at which their faults end.
  void add_side_faces() {
    struct ColumnEdge {
      std::size_t a, b;  ///< rows of the node columns across the fault zone at the edge's ends, in the prism's order
      std::size_t zone;
      unsigned uses = 0;
    };
    std::map<std::pair<std::size_t, std::size_t>, ColumnEdge> sides;
    for (const ZonePrism& prism : columns_.prisms)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = prism.columns[i], b = prism.columns[(i + 1) % 3];
        if (columns_.columns[a].is_closed() && columns_.columns[b].is_closed()) continue;
        ++sides.try_emplace({std::min(a, b), std::max(a, b)}, ColumnEdge{a, b, prism.zone}).first->second.uses;
      }
    // For each border edge of a fault: a face at the edge on the model's boundary.
    std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> outer;
    for (const auto& [key, side] : sides)
      if (side.uses == 1) outer[ends(columns_.columns[side.a].minus, columns_.columns[side.b].minus)] = no_face;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      if (mesh_.faces[f].region_plus == 0 && !is_wall(mesh_.faces[f]))
        for (std::size_t i = 0; i < 3; ++i) {
          const Triangle& t = mesh_.faces[f].vertices;
          const auto at = outer.find(ends(t[i], t[(i + 1) % 3]));
          if (at != outer.end()) at->second = f;
        }
    for (const auto& [key, side] : sides) {
      if (side.uses != 1) continue;
      const std::size_t f = outer[ends(columns_.columns[side.a].minus, columns_.columns[side.b].minus)];
      // Each such border edge of a fault zone has a face on the model's boundary: otherwise all tetrahedra around the
      // edge would be connected, and its nodes would not have been duplicated.
      GEOMESH_CHECK(f != no_face);
      for (unsigned k = 0; k < zones_[side.zone].layers; ++k) add_side(side.a, side.b, k, side.zone, mesh_.faces[f]);
    }
  }
  void add_side(std::size_t a, std::size_t b, unsigned k, std::size_t zone, const ModelMesh::Face& like) {
    const VertexIndex la = node(a, k), lb = node(b, k), ua = node(a, k + 1), ub = node(b, k + 1);
    const std::array<Triangle, 2> halves = a < b ? std::array<Triangle, 2>{Triangle{la, lb, ub}, Triangle{la, ub, ua}}
                                                 : std::array<Triangle, 2>{Triangle{la, lb, ua}, Triangle{lb, ub, ua}};
    for (const Triangle& half : halves) {
      if (has_repeats(half)) continue;
      ModelMesh::Face face = like;
      face.vertices = half;
      face.region_minus = region_of(zone);
      face.region_plus = 0;
      added_.push_back(face);
      for (std::size_t i = 0; i < 3; ++i) edges_.insert(ends(half[i], half[(i + 1) % 3]));
    }
  }

  /// Sets the regions of faces on walls of fault zones. Normals point into a zone: it has the highest region id.
  void close_walls() {
    for (auto& face : mesh_.faces) {
      if (!is_wall(face)) continue;
      for (std::size_t i = 0; i < 3; ++i) edges_.insert(ends(face.vertices[i], face.vertices[(i + 1) % 3]));
      face.region_plus = region_of(columns_.zone_of_wall.at(in_order(face.vertices)));
    }
    mesh_.faces.insert(mesh_.faces.end(), added_.begin(), added_.end());
  }
  bool is_wall(const ModelMesh::Face& face) const { return columns_.zone_of_wall.contains(in_order(face.vertices)); }

  /// Continues wells across fault zones: a well that meets the fault in a node follows the new nodes across the zone.
  void carry_wells_across() {
    std::map<VertexIndex, std::set<std::int32_t>> wells_at;
    for (const NamedCurve& curve : mesh_.curves)
      if (curve.kind == "well")
        for (const auto& e : mesh_.curve_edges)
          if (e.curve == curve.id)
            for (const VertexIndex v : {e.a, e.b}) wells_at[v].insert(curve.id);
    for (const ZoneColumn& column : columns_.columns) {
      const auto a = wells_at.find(column.minus), b = wells_at.find(column.plus);
      if (column.is_closed() || a == wells_at.end() || b == wells_at.end()) continue;
      for (const std::int32_t well : a->second)
        if (b->second.contains(well))
          for (std::size_t k = 0; k + 1 < column.nodes.size(); ++k)
            mesh_.curve_edges.push_back({column.nodes[k], column.nodes[k + 1], well});
    }
  }

  static std::pair<VertexIndex, VertexIndex> ends(VertexIndex a, VertexIndex b) {
    return {std::min(a, b), std::max(a, b)};
  }
  static constexpr std::size_t no_face = std::numeric_limits<std::size_t>::max();

  const std::vector<FaultZone>& zones_;
  ModelMesh mesh_;
  ZoneColumns columns_;
  std::vector<ModelMesh::Face> added_;
  EdgeSet edges_;  // edges of the faces on walls of fault zones, and of the zones' faces on sides of the model
};

}  // namespace

ModelMesh open_fault_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones) {
  return ZoneOpener(mesh, zones).open();
}

}  // namespace geomesh::geomodel
