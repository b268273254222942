// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The named mesh: what writers write and what the report speaks of (output contract of docs/output-files.md).
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
  std::int32_t id;  ///< from 1, stable between runs
  std::string name;
  std::vector<std::string> inside;  ///< bodies it lies in
  std::size_t n_tetrahedra = 0;
  double volume = 0;           ///< m3, summed without cancellation
  std::string unit{};          ///< the name before suffixes: a unit of the column, a body ...
  double volume_of_input = 0;  ///< before surfaces were moved within a tolerance; 0: they were not
};

/// A number that units carry to the mesh (porosity, density ...): a cell array of the VTU.
struct RegionAttribute {
  std::string name;
  std::vector<double> by_region;  ///< by region id - 1; NaN where the unit has none
};

/// A number for each tetrahedron (asked size, shapes): a cell array of the VTU.
struct CellArray {
  std::string name;
  std::vector<double> values;  ///< by row of ModelMesh::tetrahedra
  std::string unit{};          ///< empty: not known
};

/// A number for each point: a point array of the VTU.
struct PointArray {
  std::string name;
  std::vector<double> values;  ///< by row of ModelMesh::points, then of its midpoints where it has those
  std::string unit{};
};

/// Regions under one more name (an aquifer of three units).
struct RegionGroup {
  std::string name;
  std::vector<std::int32_t> regions;
};

struct NamedSurface {
  std::int32_t id;  ///< disjoint from region ids
  std::string name;
  SurfaceKind kind;
  double area = 0;  ///< of the faces in the mesh that carry it
};

struct NamedCurve {
  std::int32_t id;  ///< disjoint from region and surface ids
  std::string name;
  std::string kind;  ///< "intersection", "border", "fault_tip", "well"
  double length = 0;
};

/// Nodes in the middle of edges, for elements of second order; empty where elements are of first order. Edges of a
/// tetrahedron in the order 01 12 20 03 13 23, of a face 01 12 20.
struct Midpoints {
  std::vector<Vec3> points;  ///< their rows follow those of ModelMesh::points
  std::vector<std::array<VertexIndex, 6>> of_tetrahedron;
  std::vector<std::array<VertexIndex, 3>> of_face;
  std::vector<VertexIndex> of_curve_edge;

  bool empty() const { return of_tetrahedron.empty(); }
};

/// An edge whose midpoint, in elements of second order, is not half-way between its ends, or has values of its own.
struct CurvedEdge {
  VertexIndex a, b;  ///< a < b
  Vec3 middle;
  std::vector<double> values{};  ///< by row of ModelMesh::point_arrays; of arrays beyond, the means of the ends
};

/// Prism without thickness between the two sides of a split fault: vertices 0 1 2 on the minus side, 3 4 5 on the plus
/// side, 3 at the place of 0.
struct Prism {
  std::array<VertexIndex, 6> vertices;
  std::int32_t layer;  ///< id of its CohesiveLayer
};

struct CohesiveLayer {
  std::int32_t id;  ///< disjoint from all other ids
  std::string name;
};

/// Nodes under a name that are not the nodes of a surface or curve (from files of other tools).
struct NodeSet {
  std::int32_t id;
  std::string name;
  std::vector<VertexIndex> nodes;
};

/// Borders at which a horizon of the column stops short inside one region, or its holes there.
struct OpenBorders {
  std::string horizon;
  std::string region;        ///< empty: outside of all regions
  bool joins_units = false;  ///< units on both sides of the horizon are one region there
  bool are_holes = false;
  std::size_t count = 0;
  double length = 0;  ///< of all, m
  Vec3 place;         ///< on the longest, or in the middle of the longest hole's box
};

/// Named mesh, plain data.
///
/// Invariants (validate_model_mesh): every tetrahedron positive and of a named region; no unused point; no two equal
/// points; a face once; region_minus / region_plus agree with the tetrahedra at the face; ids disjoint.
struct ModelMesh {
  std::string name;
  std::vector<Vec3> points;                ///< in the written frame
  std::vector<std::uint8_t> point_kind;    ///< 0 input, 1 intersection, 2 on a segment, 3 on a facet, 4 inside
  std::vector<std::int32_t> input_vertex;  ///< row in the concatenated vertices of the surfaces as read; -1 where added
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::int32_t> tet_region;  ///< region id

  struct Face {
    Triangle vertices;                       ///< normal from minus to plus
    std::int32_t surface;                    ///< id of the first surface in project order
    std::int32_t surface_set;                ///< row in surface_sets
    std::int32_t patch;                      ///< from 1
    std::int32_t region_minus, region_plus;  ///< 0: outside
    std::int32_t source_triangle;            ///< 0-based in `surface` as read
  };
  std::vector<Face> faces;
  std::vector<std::vector<std::int32_t>> surface_sets;  ///< lists of surface ids

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
  std::vector<Prism> prisms;  ///< only where faults were split for cohesive elements
  std::vector<CohesiveLayer> cohesive_layers;
  Midpoints midpoints;
  std::vector<CurvedEdge> curved_edges;  ///< by ends, ascending; for add_midpoints()
  /// Where each point was before fault zones were opened: both walls of a zone lie on the fault there. Empty where
  /// there are no zones.
  std::vector<Vec3> before_zones;
  Vec3 origin{0, 0, 0};    ///< was subtracted from the project's coordinates
  std::string unit = "m";  ///< of all coordinates; volumes and areas are in its powers
};

}  // namespace geomesh::geomodel
