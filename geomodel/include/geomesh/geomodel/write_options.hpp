// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a mesh file should hold, and how: the choices of `output:` in a project and of `geomesh convert`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Which groups of faces and curves a solver file has.
enum class GroupChoice {
  whole,   ///< one for each surface and curve
  pieces,  ///< one for each part between two regions; no two of them share a face or an edge
  both
};

/// Of VTK files.
enum class Compression {
  none,
  fast,  ///< zlib, level 1
  small  ///< zlib, level 6
};

inline constexpr unsigned most_partitions = 100000;

enum class ElementOrder { first = 1, second = 2 };

/// A property from a file onto the mesh. The file is in the mesh's coordinates before an origin is subtracted.
struct FieldSpec {
  std::string name;
  std::filesystem::path file;  ///< a grid over the map, or values at points in space
  enum class Place { cells, points } place = Place::cells;
  std::string unit;  ///< told in the files; empty: not known
};

/// Volume elements between the two sides of a fault.
struct FaultZone {
  std::string fault;     ///< a surface with faces inside the mesh
  double thickness = 0;  ///< between the two walls, in the mesh's unit
  unsigned layers = 1;   ///< of elements across
};
inline constexpr unsigned most_zone_layers = 100;

struct WriteOptions {
  GroupChoice groups = GroupChoice::whole;
  bool inner_faces = true;  ///< faces with regions on both sides (horizons, faults)
  bool curves = true;       ///< curves and named points
  ElementOrder order = ElementOrder::first;
  std::string region_array = "region";  ///< VTU: name of the first cell array
  bool single_grid = false;             ///< VTU: faces and curves as 2D and 1D cells of the one grid
  bool node_arrays = false;             ///< VTU: each surface and curve as a point array of 0 and 1
  Compression compression = Compression::fast;
  std::vector<std::string> split;  ///< faults along which nodes are doubled
  bool cohesive = false;           ///< prisms without thickness between the two sides of split faults
  std::vector<FaultZone> fault_zones;
  unsigned partitions = 1;  ///< parts by METIS: a file for each
  bool starter = false;     ///< a starter input of the solver beside its mesh
  std::vector<FieldSpec> fields;
  bool fractures_only = false;  ///< triangles of faults and fractures without the tetrahedra
};

}  // namespace geomesh::geomodel
