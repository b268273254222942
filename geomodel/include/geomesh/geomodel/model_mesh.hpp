// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The named mesh that writers write and the report describes (output contract of docs/output-files.md).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct Region {
  std::int32_t id;  ///< id from 1, the same in every run
  std::string name;
  std::vector<std::string> inside;  ///< names of the bodies in which the region lies
  std::size_t n_tetrahedra = 0;
  double volume = 0;           ///< volume in m3, summed without cancellation
  std::string unit{};          ///< the name without suffixes: a unit of the column, a body ...
  double volume_of_input = 0;  ///< volume before surfaces were moved within the tolerance; 0 if none was moved
};

/// A value that units assign to the mesh (porosity, density ...): a cell array of the VTU.
struct RegionAttribute {
  std::string name;
  std::vector<double> by_region;  ///< value by region id - 1; NaN if the unit has none
};

/// A value for each tetrahedron (target size, shape measures): a cell array of the VTU.
struct CellArray {
  std::string name;
  std::vector<double> values;  ///< value by row of ModelMesh::tetrahedra
  std::string unit{};          ///< empty: not known
};

/// A value for each point: a point array of the VTU.
struct PointArray {
  std::string name;
  std::vector<double> values;  ///< value by row of ModelMesh::points, followed by those of its midpoints if it has any
  std::string unit{};
};

/// A group of regions with a name of its own (for example an aquifer of three units).
struct RegionGroup {
  std::string name;
  std::vector<std::int32_t> regions;
};

struct NamedSurface {
  std::int32_t id;  ///< id of the surface, distinct from the ids of regions
  std::string name;
  SurfaceKind kind;
  double area = 0;  ///< area of the mesh faces on the surface
};

struct NamedCurve {
  std::int32_t id;  ///< id of the curve, distinct from the ids of regions and surfaces
  std::string name;
  std::string kind;  ///< kind of the curve: "intersection", "border", "fault_tip" or "well"
  double length = 0;
};

/// Nodes in the middle of edges, for elements of second order; empty where elements are of first order. Edges of a
/// tetrahedron in the order 01 12 20 03 13 23, of a face 01 12 20.
struct Midpoints {
  std::vector<Vec3> points;  ///< positions of the midpoints, whose rows follow those of ModelMesh::points
  std::vector<std::array<VertexIndex, 6>> of_tetrahedron;
  std::vector<std::array<VertexIndex, 3>> of_face;
  std::vector<VertexIndex> of_curve_edge;

  bool empty() const { return of_tetrahedron.empty(); }
};

/// An edge whose midpoint, in second-order elements, is not half-way between its ends, or has its own values in point
/// arrays.
struct CurvedEdge {
  VertexIndex a, b;  ///< a < b
  Vec3 middle;
  /// Values at the midpoint by row of ModelMesh::point_arrays; missing ones are the means of the ends.
  std::vector<double> values{};
};

/// Prism without thickness between the two sides of a split fault: vertices 0 1 2 on the minus side, 3 4 5 on the plus
/// side, 3 at the place of 0.
struct Prism {
  std::array<VertexIndex, 6> vertices;
  std::int32_t layer;  ///< id of the CohesiveLayer to which the prism belongs
};

struct CohesiveLayer {
  std::int32_t id;  ///< id that is distinct from all other ids
  std::string name;
};

/// Named nodes that are not the nodes of a surface or curve (from files of other tools).
struct NodeSet {
  std::int32_t id;
  std::string name;
  std::vector<VertexIndex> nodes;
};

/// Borders at which a horizon of the column ends inside one region, or its holes there.
struct OpenBorders {
  std::string horizon;
  std::string region;        ///< name of the region; empty if the border lies outside all regions
  bool joins_units = false;  ///< whether units on both sides of the horizon form one region because of the gap
  bool are_holes = false;
  std::size_t count = 0;
  double length = 0;  ///< of all, m
  Vec3 place;         ///< a point on the longest border, or the centre of the bounding box of the longest hole
};

/// Named mesh, plain data.
///
/// Invariants (validate_model_mesh): every tetrahedron positive and of a named region; no unused point; no two equal
/// points; no face listed twice; region_minus / region_plus agree with the tetrahedra at the face; ids disjoint.
struct ModelMesh {
  std::string name;
  std::vector<Vec3> points;  ///< coordinates in the frame in which they are written
  /// Origin of each point: 0 input, 1 intersection, 2 on a segment, 3 on a facet, 4 inside.
  std::vector<std::uint8_t> point_kind;
  /// Row in the concatenated vertices of the surfaces as read; -1 for added points.
  std::vector<std::int32_t> input_vertex;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::int32_t> tet_region;  ///< region id

  struct Face {
    Triangle vertices;         ///< vertices of the face, whose normal points from the minus to the plus side
    std::int32_t surface;      ///< id of the face's first surface in project order
    std::int32_t surface_set;  ///< row in surface_sets
    std::int32_t patch;        ///< from 1
    std::int32_t region_minus, region_plus;  ///< 0: outside
    std::int32_t source_triangle;  ///< row of the triangle in `surface` as read, from 0, of which the face is a part
  };
  std::vector<Face> faces;
  /// Lists of the ids of all surfaces on which a face lies, one or several; each face refers to one list.
  std::vector<std::vector<std::int32_t>> surface_sets;

  struct CurveEdge {
    VertexIndex a, b;
    std::int32_t curve;
  };
  std::vector<CurveEdge> curve_edges;
  struct MarkedPoint {
    VertexIndex v;
    std::int32_t id;
    std::string name;
  };
  std::vector<MarkedPoint> marked_points;

  std::vector<Region> regions;
  std::vector<OpenBorders> open_borders;
  std::vector<RegionAttribute> attributes;
  std::vector<CellArray> cell_arrays;
  std::vector<PointArray> point_arrays;
  std::vector<RegionGroup> groups;
  std::vector<NamedSurface> surfaces;
  std::vector<NamedCurve> curves;
  std::vector<NodeSet> node_sets;
  std::vector<Prism> prisms;  ///< elements without thickness, present only if faults were split for cohesive elements
  std::vector<CohesiveLayer> cohesive_layers;
  Midpoints midpoints;
  /// Edges with curved midpoints, ascending by their ends; used by add_midpoints().
  std::vector<CurvedEdge> curved_edges;
  /// Position of each point before fault zones were opened, when both walls of a zone lay on the fault. Empty if there
  /// are no zones.
  std::vector<Vec3> before_zones;
  Vec3 origin{0, 0, 0};    ///< vector that was subtracted from the project's coordinates
  std::string unit = "m";  ///< unit of all coordinates; volumes and areas are in its powers
};

}  // namespace geomesh::geomodel
