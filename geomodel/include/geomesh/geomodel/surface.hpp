// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Triangulated surfaces and polylines as read: what readers give and model building and the arrangement take.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// What a surface stands for in the rules of geology.
enum class SurfaceKind {
  surface,  ///< nothing known (files given to `geomesh mesh`)
  horizon,
  fault,
  body,  ///< closed: salt, an intrusion, a grain
  box,   ///< a side of the model volume
};
const char* to_string(SurfaceKind kind);

/// Triangles as read: equal coordinates are not merged yet, any defect may be there (the arrangement and `geomesh info`
/// speak of them). Rows of `triangles` are the `source_triangle` of the output.
struct TriangulatedSurface {
  std::string name;
  SurfaceKind kind = SurfaceKind::surface;
  bool cuts_all = false;    ///< bodies: remove the parts of horizons and faults inside
  bool ends_model = false;  ///< a topography or bottom: no body removes parts of it
  std::string file;         ///< where it came from, as the user wrote it; empty where made by rule
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// A polyline: well path, fault trace.
struct Polyline {
  std::string name;
  std::string file;
  std::vector<Vec3> points;  ///< in order; consecutive points are joined
};

struct NamedPoint {
  std::string name;
  Vec3 point;
};

/// A region told by a closed list of oriented triangles' patches (GOCAD Model3d): name only; the volume is found by a
/// point inside.
struct RegionHint {
  std::string name;
  /// Oriented boundary as (surface row, triangle row, orientation as stored (true) or reversed); the region lies on the
  /// side that the normal points away from (outward normals).
  struct Side {
    Index surface, triangle;
    bool as_stored;
  };
  std::vector<Side> boundary;
};

/// Points that belong together and are joined by nothing: interpreted picks, a cloud.
struct PointSet {
  std::string name;
  std::string file;
  std::vector<Vec3> points;
};

/// What a file says about its coordinates before they were brought to metres with elevation up.
struct SourceFrame {
  std::string unit;         ///< as written ("m", "ft", ...); empty where the file names none
  std::string z_unit;       ///< where it differs
  bool depth = false;       ///< z counted downwards
  bool z_named = false;     ///< the file says which way z counts
  std::string crs;          ///< name, projection, datum as written; empty where the file names none
  bool geographic = false;  ///< x, y are longitude and latitude in degrees
};

/// A grid that became a surface.
struct GridSummary {
  std::string surface;                                 ///< its name
  std::size_t n_columns = 0, n_rows = 0, n_blank = 0;  ///< nodes, and how many have no value
  Vec2 origin;                                         ///< the first node
  Vec2 spacing;                                        ///< zero where the nodes are not regular
  double rotation = 0;                                 ///< degrees counter-clockwise
  bool cell_centred = false;
};

/// What one file held.
struct FileContents {
  std::string format;  ///< "GOCAD TSurf", "OFF", ...
  SourceFrame frame;   ///< of the first object where several differ (a warning then says so)
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> polylines;
  std::vector<NamedPoint> points;
  std::vector<PointSet> point_sets;
  std::vector<RegionHint> regions;
  std::vector<GridSummary> grids;     ///< of the surfaces that were grids
  std::vector<std::string> arrays;    ///< properties of points or triangles in the file, which are passed over
  std::vector<std::string> notes;     ///< what was understood beyond the obvious (z negated: Depth, unit ft, ...)
  std::vector<std::string> warnings;  ///< in a user's words
};

}  // namespace geomesh::geomodel
