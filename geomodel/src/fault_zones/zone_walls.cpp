// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_zones/zone_walls.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "geomesh/core/error.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

/// Largest movement of a node as a multiple of half of the fault zone's thickness: along other surfaces, which the node
/// leaves if it would move farther, and along sides of the model, where a longer movement is an error.
constexpr double longest_along_surfaces = 2, longest_along_sides = 4;
/// Limit on the bend of a fault at a node: the factor by which a node may move farther than the planes of its faces.
/// With 2, faces may be inclined by 60 degrees to their mean plane.
constexpr double longest_miter = 2;
/// Sine of the largest angle between planes that count as parallel.
constexpr double nearly_parallel = 0.1;

Vec3 area_vector(const ModelMesh& mesh, const Triangle& t) {
  return 0.5 * cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
}

double angle_at(const ModelMesh& mesh, const Triangle& t, std::size_t i) {
  const Vec3& p = mesh.points[t[i]];
  const Vec3 u = mesh.points[t[(i + 1) % 3]] - p, v = mesh.points[t[(i + 2) % 3]] - p;
  return std::atan2(norm(cross(u, v)), dot(u, v));
}

/// Returns the unit vector of v; exact if v is along an axis.
Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return {v.x / length, v.y / length, v.z / length};
}

/// The mean normal of a fault at a node, weighted by angles. `weight` divided by `cosine` is how much farther than the
/// planes of the faces the node moves.
struct WallNormal {
  Vec3 sum{0, 0, 0}, direction{0, 0, 0};
  double cosine = 0, weight = 0;
};

/// A surface other than the fault on which a node of the fault lies.
struct Guide {
  Vec3 area{0, 0, 0};
  bool is_side = false;
};

class WallMover {
 public:
  WallMover(ModelMesh& mesh, const ZoneColumns& zone, const std::vector<FaultZone>& zones)
      : mesh_(mesh), zone_(zone), zones_(zones) {
    for (const NamedSurface& surface : mesh.surfaces) is_side_[surface.id] = surface.kind == SurfaceKind::box;
    find_normals();
    find_guides();
  }

  void move() {
    std::vector<std::pair<VertexIndex, Vec3>> moved;
    for (std::size_t c = 0; c < zone_.columns.size(); ++c) {
      const ZoneColumn& column = zone_.columns[c];
      if (column.is_closed()) continue;
      moved.emplace_back(column.minus, place(column, normals_[c], column.minus, -1));
      moved.emplace_back(column.plus, place(column, normals_[c], column.plus, 1));
    }
    for (const auto& [v, p] : moved) mesh_.points[v] = p;
  }

 private:
  Triangle minus_face(const ZonePrism& prism) const {
    return {zone_.columns[prism.columns[0]].minus, zone_.columns[prism.columns[1]].minus,
            zone_.columns[prism.columns[2]].minus};
  }
  [[noreturn]] void refuse(const ZoneColumn& column, const std::string& why) const {
    const Vec3& p = mesh_.points[column.minus];
    throw Error(ErrorKind::cannot_mesh,
                "fault_zone " + zones_[column.zone].fault + ": " + why + ", at (" + std::to_string(p.x) + ", " +
                    std::to_string(p.y) + ", " + std::to_string(p.z) + ")",
                {{}, {}, {}, {p}});
  }

  void find_normals() {
    normals_.resize(zone_.columns.size());
    for (const bool is_first : {true, false})
      for (const ZonePrism& prism : zone_.prisms) {
        const Triangle face = minus_face(prism);
        const Vec3 area = area_vector(mesh_, face);
        const double size = norm(area);
        if (!(size > 0)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          WallNormal& normal = normals_[prism.columns[i]];
          const double angle = angle_at(mesh_, face, i);
          if (is_first) {
            normal.sum = normal.sum + (angle / size) * area;
            normal.weight += angle;
          } else {
            normal.cosine += angle / size * dot(area, normal.sum) / norm(normal.sum);
          }
        }
      }
    for (std::size_t c = 0; c < normals_.size(); ++c) {
      WallNormal& normal = normals_[c];
      if (zone_.columns[c].is_closed()) continue;
      if (!(longest_miter * normal.cosine >= normal.weight))
        refuse(zone_.columns[c],
               "the fault bends too sharply for walls at a constant distance (smooth or resample it)");
      normal.direction = unit(normal.sum);
    }
  }

  /// Finds the other surfaces on which nodes of faults lie, with the sums of their faces' area vectors at these nodes.
  void find_guides() {
    for (const ZoneColumn& column : zone_.columns)
      if (!column.is_closed()) guides_[column.minus], guides_[column.plus];
    for (const ModelMesh::Face& face : mesh_.faces) {
      const auto set = static_cast<std::size_t>(face.surface_set);
      Triangle nodes = face.vertices;
      std::sort(nodes.begin(), nodes.end());
      if (zone_.zone_of_wall.contains(nodes)) continue;
      const Vec3 area = area_vector(mesh_, face.vertices);
      for (const VertexIndex v : face.vertices) {
        const auto at = guides_.find(v);
        if (at == guides_.end()) continue;
        Guide& guide = at->second[{!is_side(set), face.surface_set}];
        guide.is_side = is_side(set);
        guide.area = guide.area + (dot(area, guide.area) < 0 ? -1.0 : 1.0) * area;
      }
    }
  }
  bool is_side(std::size_t set) const {
    const auto& ids = mesh_.surface_sets[set];
    return std::any_of(ids.begin(), ids.end(), [&](std::int32_t id) { return is_side_.at(id); });
  }

  Vec3 place(const ZoneColumn& column, const WallNormal& normal, VertexIndex v, double sign) const {
    const double half = zones_[column.zone].thickness / 2 * normal.weight / normal.cosine;
    Vec3 along = normal.direction;  // the fault's normal, projected onto the other surfaces on which the node remains
    std::vector<Vec3> across;       // orthonormal
    for (const auto& [key, guide] : guides_.at(v)) {
      if (!(norm(guide.area) > 0)) continue;
      Vec3 n = unit(guide.area);
      for (const Vec3& a : across) n = n - dot(n, a) * a;
      if (norm(n) < nearly_parallel) continue;
      n = unit(n);
      const Vec3 tried = along - dot(along, n) * n;
      const double cosine = norm(tried);
      if (guide.is_side && cosine * longest_along_sides < 1)
        refuse(column, "the fault lies nearly in a side of the model there (leave the zone out, or move the side)");
      if (!guide.is_side && (cosine * longest_along_surfaces < 1 || across.size() >= 2)) continue;
      along = tried;
      across.push_back(n);
    }
    // Scales the movement `along` so that its component along the fault's normal is half of the zone's thickness.
    return mesh_.points[v] + (sign * half / dot(along, normal.direction)) * along;
  }

  ModelMesh& mesh_;
  const ZoneColumns& zone_;
  const std::vector<FaultZone>& zones_;
  std::map<std::int32_t, bool> is_side_;
  std::vector<WallNormal> normals_;  // by column
  std::map<VertexIndex, std::map<std::pair<bool, std::int32_t>, Guide>> guides_;
};

}  // namespace

void move_walls(ModelMesh& mesh, const ZoneColumns& zone, const std::vector<FaultZone>& zones) {
  WallMover(mesh, zone, zones).move();
}

}  // namespace geomesh::geomodel
