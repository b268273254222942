// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Triangulated surfaces and polylines as they are read, which model building and the arrangement take as input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// The geological meaning of a surface.
enum class SurfaceKind {
  surface,  ///< no meaning known (files given to `geomesh mesh`)
  horizon,
  fault,
  body,  ///< closed body: salt, an intrusion, a grain
  box,   ///< a side of the model volume
};
const char* to_string(SurfaceKind kind);

/// Triangles as read: equal coordinates are not merged yet, any defect may be there (the arrangement and `geomesh info`
/// report them). Rows of `triangles` are the `source_triangle` of the output.
struct TriangulatedSurface {
  std::string name;
  SurfaceKind kind = SurfaceKind::surface;
  bool cuts_all = false;    ///< for bodies: whether parts of horizons and faults inside are removed
  bool ends_model = false;  ///< for a topography or base: no body removes parts of it
  std::string file;         ///< file from which it was read, as the user wrote it; empty if a rule made it
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// A polyline: a well path or a fault trace.
struct Polyline {
  std::string name;
  std::string file;
  std::vector<Vec3> points;  ///< points in order; consecutive ones are connected
};

struct NamedPoint {
  std::string name;
  Vec3 point;
};

/// A region described by a closed list of oriented patches of triangles (GOCAD Model3d). Only its name is used; its
/// volume is found by a point inside.
struct RegionHint {
  std::string name;
  /// Oriented boundary as (surface row, triangle row, orientation as stored (true) or reversed); the region lies on the
  /// side that the normal points away from (outward normals).
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
  std::string unit;         ///< unit as written ("m", "ft", ...); empty if the file names none
  std::string z_unit;       ///< where it differs
  bool depth = false;       ///< z counted downwards
  bool z_named = false;     ///< whether the file says in which direction z counts
  std::string crs;          ///< coordinate system, projection or datum as written; empty if the file names none
  bool geographic = false;  ///< whether x and y are longitude and latitude in degrees
};

/// Description of a grid that was converted to a surface.
struct GridSummary {
  std::string surface;                                 ///< its name
  std::size_t n_columns = 0, n_rows = 0, n_blank = 0;  ///< numbers of columns and rows, and of nodes without a value
  Vec2 origin;                                         ///< the first node
  Vec2 spacing;                                        ///< spacing of the grid; zero if nodes are not regular
  double rotation = 0;                                 ///< degrees counter-clockwise
  bool cell_centred = false;
};

/// The contents of one file.
struct FileContents {
  std::string format;  ///< name of the format: "GOCAD TSurf", "OFF", ...
  SourceFrame frame;   ///< frame of the first object, if objects differ (a warning then says so)
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> polylines;
  std::vector<NamedPoint> points;
  std::vector<PointSet> point_sets;
  std::vector<RegionHint> regions;
  std::vector<GridSummary> grids;   ///< descriptions of the surfaces that were grids
  std::vector<std::string> arrays;  ///< names of properties of points or triangles in the file, which are ignored
  /// Notes on how the file was interpreted (z negated because it is depth, unit ft, ...).
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< warnings for the user
};

}  // namespace geomesh::geomodel
