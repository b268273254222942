// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_zones/zone_columns.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

[[noreturn]] void refuse(const std::string& faults, const Vec3& p, const std::string& why) {
  throw Error(ErrorKind::cannot_mesh,
              "fault_zone " + faults + ": " + why + ", at (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
                  std::to_string(p.z) + ")",
              {{}, {}, {}, {p}});
}

class ColumnFinder {
 public:
  ColumnFinder(const SplitMesh& split, const std::vector<FaultZone>& zones) : split_(split), zones_(zones) {}

  ZoneColumns find() {
    for (const Prism& prism : split_.mesh.prisms) {
      const std::size_t zone = zone_of(prism.layer);
      ZonePrism found{{}, zone};
      for (std::size_t i = 0; i < 3; ++i) found.columns[i] = column(prism.vertices[i], prism.vertices[i + 3], zone);
      for (const std::size_t first : {0u, 3u}) {
        Triangle wall{prism.vertices[first], prism.vertices[first + 1], prism.vertices[first + 2]};
        std::sort(wall.begin(), wall.end());
        result_.zone_of_wall[wall] = zone;
      }
      result_.prisms.push_back(found);
    }
    return std::move(result_);
  }

 private:
  std::size_t zone_of(std::int32_t layer) const {
    const auto& layers = split_.mesh.cohesive_layers;
    const auto at = std::find_if(layers.begin(), layers.end(), [&](const CohesiveLayer& l) { return l.id == layer; });
    const auto zone =
        std::find_if(zones_.begin(), zones_.end(), [&](const FaultZone& z) { return z.fault + ".layer" == at->name; });
    return static_cast<std::size_t>(zone - zones_.begin());
  }
  std::string names(std::size_t a, std::size_t b) const {
    return zones_[a].fault + (a == b ? "" : " and " + zones_[b].fault);
  }
  const Vec3& place(VertexIndex v) const { return split_.mesh.points[v]; }

  std::size_t column(VertexIndex minus, VertexIndex plus, std::size_t zone) {
    const auto [entry, is_new] = of_pair_.try_emplace({minus, plus}, result_.columns.size());
    if (!is_new) {
      const std::size_t first = result_.columns[entry->second].zone;
      if (minus != plus &&
          (zones_[first].thickness != zones_[zone].thickness || zones_[first].layers != zones_[zone].layers))
        refuse(names(first, zone), place(minus),
               "the zones meet, so they must have one thickness and one number of layers");
      return entry->second;
    }
    if (minus != plus) {
      if (of_pair_.contains({plus, minus}))
        refuse(zones_[zone].fault, place(minus), "the fault has one side alone (it is twisted like a Moebius band)");
      const VertexIndex origin = split_.original[minus];
      const auto [other, is_first] = of_origin_.try_emplace(origin, result_.columns.size());
      if (!is_first)
        refuse(names(result_.columns[other->second].zone, zone), place(minus),
               "more than two sides of zones meet here. Open one of faults that meet to a zone, and leave the other a "
               "surface or split it");
    }
    result_.columns.push_back({minus, plus, zone, {}});
    return entry->second;
  }

  const SplitMesh& split_;
  const std::vector<FaultZone>& zones_;
  ZoneColumns result_;
  std::map<std::pair<VertexIndex, VertexIndex>, std::size_t> of_pair_;
  std::map<VertexIndex, std::size_t> of_origin_;  // open columns
};

}  // namespace

ZoneColumns columns_of(const SplitMesh& split, const std::vector<FaultZone>& zones) {
  return ColumnFinder(split, zones).find();
}

void fill_columns(ModelMesh& mesh, ZoneColumns& zone, const std::vector<FaultZone>& zones) {
  for (ZoneColumn& column : zone.columns) {
    column.nodes = {column.minus};
    if (column.is_closed()) continue;
    const unsigned layers = zones[column.zone].layers;
    const Vec3 from = mesh.points[column.minus], across = mesh.points[column.plus] - from;
    for (unsigned k = 1; k < layers; ++k) {
      const double share = double(k) / layers;
      column.nodes.push_back(static_cast<VertexIndex>(mesh.points.size()));
      mesh.points.push_back(from + share * across);
      mesh.point_kind.push_back(4);
      mesh.input_vertex.push_back(-1);
      mesh.before_zones.push_back(mesh.before_zones[column.minus]);
      for (PointArray& array : mesh.point_arrays)
        array.values.push_back((1 - share) * array.values[column.minus] + share * array.values[column.plus]);
    }
    column.nodes.push_back(column.plus);
  }
}

}  // namespace geomesh::geomodel
