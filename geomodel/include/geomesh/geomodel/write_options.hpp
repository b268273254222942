// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Options for writing a mesh file: the keys of `output:` in a project and the options of `geomesh convert`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Which groups of faces and curves a solver file contains.
enum class GroupChoice {
  whole,  ///< each surface is one group, and each curve is one group
  /// Surfaces and curves are divided where the regions beside them change. Each piece is a group, so that no face or
  /// edge is in two groups.
  pieces,
  both
};

/// Compression of VTK files.
enum class Compression {
  none,
  fast,  ///< zlib, level 1
  small  ///< zlib, level 6
};

inline constexpr unsigned most_partitions = 100000;

enum class ElementOrder { first = 1, second = 2 };

/// A property that is mapped from a file onto the mesh. Positions in the file are in the coordinates of the mesh before
/// an origin is subtracted.
struct FieldSpec {
  std::string name;
  std::filesystem::path file;  ///< file of the property: a grid on the map, or values at points in space
  enum class Place { cells, points } place = Place::cells;
  std::string unit;  ///< unit of the property that is written into mesh files; empty if not known
};

/// A fault that is opened to a zone of volume elements between two parallel walls.
struct FaultZone {
  std::string fault;     ///< name of the fault: any surface with faces inside the mesh
  double thickness = 0;  ///< distance between the two walls of the fault zone, in the mesh's unit
  unsigned layers = 1;   ///< of elements across
};
inline constexpr unsigned most_zone_layers = 100;

struct WriteOptions {
  GroupChoice groups = GroupChoice::whole;
  bool inner_faces = true;  ///< whether faces with regions on both sides (horizons, faults) are written
  bool curves = true;       ///< whether curves and named points are written
  ElementOrder order = ElementOrder::first;
  std::string region_array = "region";  ///< for VTU: name of the first cell array, which holds the region ids
  /// For VTU: whether faces and curves are 2D and 1D cells of the same grid as the tetrahedra.
  bool single_grid = false;
  bool node_arrays = false;  ///< for VTU: whether each surface and curve gets a point array of 0 and 1
  Compression compression = Compression::fast;
  std::vector<std::string> split;  ///< names of the faults along which nodes are doubled, which separates the two sides
  bool cohesive = false;           ///< whether prisms without thickness are added between the two sides of split faults
  std::vector<FaultZone> fault_zones;
  unsigned partitions = 1;  ///< number of parts into which METIS divides the mesh, with one file for each
  bool starter = false;     ///< whether a starter input of the solver is written beside its mesh
  std::vector<FieldSpec> fields;
  bool fractures_only = false;  ///< whether the triangles of faults and fractures are written without the tetrahedra
};

}  // namespace geomesh::geomodel
