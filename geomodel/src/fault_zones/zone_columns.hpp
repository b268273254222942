// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The nodes across a fault zone, in columns: one column for each pair of nodes on the two sides of the fault.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "solver_mesh/split_faults.hpp"

namespace geomesh::geomodel {

/// A column of nodes across a fault zone, between two nodes on the sides of the fault; one node where the fault ends.
struct ZoneColumn {
  VertexIndex minus, plus;
  std::size_t zone;  ///< row of the first fault zone that contains the column of nodes
  /// Nodes of the column across the fault zone, from the minus to the plus side: one more than the zone has layers, or
  /// a single one if both sides share it.
  std::vector<VertexIndex> nodes;
  bool is_closed() const { return minus == plus; }
};

/// A prism of a fault zone: one face of the fault, with a column of nodes at each corner. The normal of the face on the
/// minus side points to the plus side.
struct ZonePrism {
  std::array<std::size_t, 3> columns;
  std::size_t zone;
};

struct ZoneColumns {
  std::vector<ZoneColumn> columns;
  std::vector<ZonePrism> prisms;
  /// Row of the fault zone of each mesh face on one of its walls, by the nodes of the face in ascending order.
  std::map<Triangle, std::size_t> zone_of_wall;
};

/// Finds the columns of nodes across fault zones in a mesh that was split along the faults. Throws Error{cannot_mesh}
/// if more than two sides meet in a node, if zones that share a node differ in thickness or layers, or if a fault is
/// one-sided.
ZoneColumns columns_of(const SplitMesh& split, const std::vector<FaultZone>& zones);

/// Adds the nodes across a fault zone between the two ends of each column of nodes, evenly on a straight line.
/// Precondition: the ends were moved to the walls before.
void fill_columns(ModelMesh& mesh, ZoneColumns& zone, const std::vector<FaultZone>& zones);

}  // namespace geomesh::geomodel
