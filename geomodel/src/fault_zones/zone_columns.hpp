// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The nodes across a fault zone: a column for each pair of nodes that face each other.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "solver_mesh/split_faults.hpp"

namespace geomesh::geomodel {

/// A pair of nodes on the two sides of a fault; one node where the fault ends.
struct ZoneColumn {
  VertexIndex minus, plus;
  std::size_t zone;  ///< row of the first zone that contains it
  /// From minus to plus, one more than there are layers; only the minus node if both are the same.
  std::vector<VertexIndex> nodes;
  bool is_closed() const { return minus == plus; }
};

/// A face of the fault with its three columns; the normal of the columns' minus nodes points to the plus side.
struct ZonePrism {
  std::array<std::size_t, 3> columns;
  std::size_t zone;
};

struct ZoneColumns {
  std::vector<ZoneColumn> columns;
  std::vector<ZonePrism> prisms;
  std::map<Triangle, std::size_t> zone_of_wall;  ///< the zone of each wall face, by the face's nodes in ascending order
};

/// Finds columns from the prisms of a mesh split along the zones' faults. Throws Error{cannot_mesh} if more than two
/// sides meet in a node, if zones of different thickness or layers share a node, or if a fault has one side alone.
ZoneColumns columns_of(const SplitMesh& split, const std::vector<FaultZone>& zones);

/// Adds the nodes between the sides of each column, evenly on the straight line. Call it once the sides have moved.
void fill_columns(ModelMesh& mesh, ZoneColumns& zone, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
