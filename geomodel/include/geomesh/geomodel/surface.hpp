// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Triangulated surfaces and polylines as they are read, which model building and the arrangement take as input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Geological kind of a surface.
enum class SurfaceKind {
  surface,  ///< surface without a known geological meaning (files given to `geomesh mesh`)
  horizon,
  fault,
  body,  ///< closed body: salt, an intrusion, a grain
  box,   ///< a side of the model volume
};
const char* to_string(SurfaceKind kind);

/// Triangles as read: points with equal coordinates are not merged yet, and any defect may be present (the arrangement
/// and `geomesh info` report them). The `source_triangle` in output files is a row of `triangles`.
struct TriangulatedSurface {
  std::string name;
  SurfaceKind kind = SurfaceKind::surface;
  bool cuts_all = false;    ///< for bodies: whether parts of horizons and faults inside the body are removed
  bool ends_model = false;  ///< for a topography or base of the model: bodies remove no parts of it
  std::string file;         ///< input file of the surface, as the user wrote it; empty if a rule made the surface
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// A polyline: a well path or a fault trace.
struct Polyline {
  std::string name;
  std::string file;
  std::vector<Vec3> points;  ///< points of the polyline in order; consecutive ones are connected
};

struct NamedPoint {
  std::string name;
  Vec3 point;
};

/// A region described by closed lists of oriented triangles (GOCAD Model3d). Only its name is used; the region of the
/// mesh with this name is found by a point inside.
struct RegionHint {
  std::string name;
  /// One triangle of the region's boundary: its surface, its row in the surface, and whether it has the stored
  /// orientation or the reverse. The normals of the oriented triangles point out of the region.
  struct OrientedTriangle {
    Index surface, triangle;
    bool as_stored;
  };
  std::vector<OrientedTriangle> boundary;
};

/// Points that belong together without connections: interpreted picks or a point cloud.
struct PointSet {
  std::string name;
  std::string file;
  std::vector<Vec3> points;
};

/// A file's statements about its coordinates, before they were converted to metres with elevation up.
struct SourceFrame {
  std::string unit;      ///< unit of length as the file writes it ("m", "ft", ...); empty if the file names none
  std::string z_unit;    ///< where it differs
  bool depth = false;    ///< z counted downwards
  bool z_named = false;  ///< whether the file says if z counts upwards or downwards
  std::string crs;       ///< coordinate system, projection or datum as the file writes it; empty if the file names none
  bool geographic = false;  ///< whether x and y are longitude and latitude in degrees
};

/// Description of a grid that was converted to a surface by a reader.
struct GridSummary {
  std::string surface;                                 ///< its name
  std::size_t n_columns = 0, n_rows = 0, n_blank = 0;  ///< numbers of the grid's columns, rows, and nodes without value
  Vec2 origin;                                         ///< the first node
  Vec2 spacing;         ///< distances between columns and between rows; zero if the nodes are not regular
  double rotation = 0;  ///< degrees counter-clockwise
  bool cell_centred = false;
};

/// The contents of one input file.
struct FileContents {
  std::string format;  ///< name of the format: "GOCAD TSurf", "OFF", ...
  SourceFrame frame;   ///< unit and axes of the file's first object; a warning says so if its other objects differ
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> polylines;
  std::vector<NamedPoint> points;
  std::vector<PointSet> point_sets;
  std::vector<RegionHint> regions;
  std::vector<GridSummary> grids;  ///< descriptions of the grids of heights that were converted to surfaces
  /// Names of the properties of points or triangles that the file holds; they are ignored.
  std::vector<std::string> arrays;
  /// Notes on how the file was interpreted (z negated because it is depth, unit ft, ...).
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< warnings for the user about the contents of the file
};

}  // namespace geomesh::geomodel
