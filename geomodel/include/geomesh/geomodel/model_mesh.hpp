// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh with names for regions, surfaces and curves, which is written to files and described by the report
/// (docs/output-files.md).
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
  std::int32_t id;  ///< id of the region, from 1, the same in every run
  std::string name;
  std::vector<std::string> inside;  ///< names of the bodies in which the region lies
  std::size_t n_tetrahedra = 0;
  double volume = 0;   ///< volume of the region in m3, summed without cancellation
  std::string unit{};  ///< name of the region without suffixes: a stratigraphic unit, a body ...
  /// Volume of the region before surfaces were moved within the tolerance; 0 if none was moved.
  double volume_of_input = 0;
};

/// A value that units assign to the mesh (porosity, density ...): a cell array of the VTU.
struct RegionAttribute {
  std::string name;
  std::vector<double> by_region;  ///< attribute value at index region id - 1; NaN if the unit has none
};

/// A value for each tetrahedron (target size, shape measures): a cell array of the VTU.
struct CellArray {
  std::string name;
  std::vector<double> values;  ///< value for each tetrahedron, in the order of ModelMesh::tetrahedra
  std::string unit{};          ///< empty: not known
};

/// A value for each point: a point array of the VTU.
struct PointArray {
  std::string name;
  /// Value for each row of ModelMesh::points, followed by those of the midpoints if the mesh has any.
  std::vector<double> values;
  std::string unit{};
};

/// A group of regions that has its own name (for example an aquifer of three units).
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

/// Nodes in the middle of edges for elements of second order; empty if elements are of first order. A tetrahedron has
/// its midpoints on the edges 01 12 20 03 13 23, in this order, and a face on 01 12 20.
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
  /// Values at the midpoint for each of ModelMesh::point_arrays. A missing value is the mean of those at the edge's
  /// ends.
  std::vector<double> values{};
};

/// Prism without thickness between the two sides of a split fault. Vertices 0 1 2 lie on the minus side and 3 4 5 on
/// the plus side; 3 coincides with 0, 4 with 1, 5 with 2.
struct Prism {
  std::array<VertexIndex, 6> vertices;
  std::int32_t layer;  ///< id of the CohesiveLayer to which the prism belongs
};

struct CohesiveLayer {
  std::int32_t id;  ///< id of the cohesive layer, distinct from the ids of all regions, surfaces, curves and points
  std::string name;
};

/// Named nodes that are not the nodes of a surface or curve (from files of other tools).
struct NodeSet {
  std::int32_t id;
  std::string name;
  std::vector<VertexIndex> nodes;
};

/// Free borders, or holes, of a horizon inside one region.
struct OpenBorders {
  std::string horizon;
  std::string region;  ///< name of the region; empty if the border lies outside all regions
  /// Whether the gap beyond the border joins the units on both sides of the horizon to one region.
  bool joins_units = false;
  bool are_holes = false;
  std::size_t count = 0;
  double length = 0;  ///< of all, m
  Vec3 place;         ///< A point on the longest border, or the centre of the bounding box of the longest hole.
};

/// Mesh with named regions, surfaces and curves, as plain data.
///
/// Invariants (validate_model_mesh): every tetrahedron is positive and belongs to a named region; no unused point; no
/// two equal points; no duplicate face; region_minus / region_plus agree with the tetrahedra at the face; ids disjoint.
struct ModelMesh {
  std::string name;
  std::vector<Vec3> points;  ///< coordinates of the points as they are written to files
  /// Origin of each mesh point: 0 input, 1 intersection, 2 added on a segment, 3 added on a facet, 4 added inside.
  std::vector<std::uint8_t> point_kind;
  /// For each mesh point: its row among the vertices of all input surfaces one after the other; -1 for added points.
  std::vector<std::int32_t> input_vertex;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::int32_t> tet_region;  ///< region id

  struct Face {
    Triangle vertices;     ///< vertices of the face, whose normal points from the minus to the plus side
    std::int32_t surface;  ///< id of the surface to which the face belongs; if several, the first one in project order
    std::int32_t surface_set;                ///< row in surface_sets
    std::int32_t patch;                      ///< from 1
    std::int32_t region_minus, region_plus;  ///< 0: outside
    std::int32_t source_triangle;  ///< Row, from 0, of the input triangle of `surface` of which the face is a part.
  };
  std::vector<Face> faces;
  /// Lists of surface ids for faces that lie on one or several surfaces. Each face refers to one of these lists.
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
  std::vector<Prism> prisms;  ///< prisms without thickness, present only if faults were split for cohesive elements
  std::vector<CohesiveLayer> cohesive_layers;
  Midpoints midpoints;
  /// Edges with curved midpoints, sorted by end points, for add_midpoints().
  std::vector<CurvedEdge> curved_edges;
  /// Position of each point before fault zones were opened, when both walls of a zone lay on the fault. Empty if there
  /// are no zones.
  std::vector<Vec3> before_zones;
  Vec3 origin{0, 0, 0};    ///< vector that was subtracted from the project's coordinates
  std::string unit = "m";  ///< unit of coordinates and lengths; areas are in its square, volumes in its cube
};

}  // namespace geomesh::geomodel
