// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The contents of a project file (docs/project-file.md). Reading collects all mistakes and reports them together.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/palette.hpp"
#include "geomesh/geomodel/read_options.hpp"
#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/scalar_field.hpp"
#include "geomesh/geomodel/section.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "geomesh/geomodel/tops.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

/// How the coordinates of one input are to be interpreted (docs/coordinates.md).
struct SourceSpec {
  /// Name of the object to read from the file. If empty: the only object, or the one named like the surface or well.
  std::string object;
  /// Coordinate system of the input. If empty: that of the file, if it names a known one, else the project's.
  std::string crs;
  std::string unit;           ///< unit of x, y and z in the input; if empty: that of the file, else the project's
  std::string z_unit;         ///< unit of z in the input; if empty: the same as that of x and y
  std::optional<bool> depth;  ///< whether z of the input is depth; if empty: as the file says, else as the project says
  double z_datum = 0;   ///< elevation of the input's zero level in the project's height system, in the project's unit
  ReadOptions reading;  ///< `columns` and `no_data`
};

/// The key `fault_polygons` of a horizon.
struct FaultPolygonsSpec {
  std::filesystem::path file;  ///< empty: none
  std::string file_as_written;
  SourceSpec source;
};

struct SurfaceSpec {
  std::string name;
  SurfaceKind kind = SurfaceKind::horizon;
  std::filesystem::path file;  ///< absolute path of the file of fault polygons, resolved against the project's folder
  std::string file_as_written;
  /// Input in memory (given.hpp) that replaces the input file; null: the file is read.
  std::shared_ptr<const FileContents> given;
  /// One or several scalar fields, each with its own domain, of which the surface is a level set; used instead of a
  /// file.
  std::vector<LevelSetSpec> level_sets;
  /// Whether the surface cuts all other surfaces inside it (`cuts: all`); true by default for bodies.
  bool cuts_all = false;
  SourceSpec source;
  GriddingSpec gridding;  ///< how a surface is interpolated from points
  double resample = 0;    ///< edge length with which the surface is remeshed; 0: its triangulation is used as it is
  int smooth = 0;         ///< passes of smoothing
  FaultPolygonsSpec fault_polygons;
  /// Name of the horizon from which this one is computed, by subtracting `thickness` or the thicknesses in the file.
  std::string below;
  /// Value of the key `thickness` if it is a number; if empty, the file holds the thicknesses.
  std::optional<double> below_by;
  ExtrudeSpec extrude;
  SurfaceRules rules;  ///< rules in the keys `extend`, `fill_holes`, `extent` and `base` of a surface
  int line = 0;        ///< line in the project file at which the surface or well begins, from 1

  /// Returns false if the surface is known to be of another kind than `wanted`. A surface whose kind was not recognised
  /// may be of any kind, so that one mistake causes only one message.
  bool may_be(SurfaceKind wanted) const { return kind == wanted || kind == SurfaceKind::surface; }
};

struct WellSpec {
  std::string name;
  std::filesystem::path file;
  std::string file_as_written;
  std::shared_ptr<const FileContents> given;  ///< as of surfaces
  SourceSpec source;
  /// Point of the well at which measured depth is zero, in the coordinates of the well's file.
  std::optional<Vec3> head;
  int line = 0;
};

struct CrsSpec {
  std::string horizontal = "local";  ///< horizontal coordinate system: local, geographic, utm [ZONE], epsg:CODE
  /// Whether z in the project file and its inputs is depth, counted downwards. In the mesh z is always elevation.
  bool depth = false;
  std::string unit = "m";  ///< unit of the mesh and of all lengths in the project file
  std::string z_datum;     ///< name of the height system, which is only repeated in the report
  /// Factor by which z is multiplied during meshing and divided afterwards. It is a power of two, which avoids
  /// rounding.
  double z_scale = 1;
};

struct MeshSpec {
  TetrahedralizeOptions options;
  RefinementSettings refinement;
};

struct OutputSpec {
  std::filesystem::path directory;  ///< absolute
  std::vector<std::string> formats{"vtu"};
  Vec3 origin{0, 0, 0};
  WriteOptions options;
};

struct Project {
  std::filesystem::path file;
  std::string name;
  CrsSpec crs;
  std::optional<VolumeSpec> box;
  std::vector<SurfaceSpec> surfaces;
  std::vector<WellSpec> wells;
  TopsSpec tops;
  std::vector<NamedPoint> points;
  /// Stratigraphic column: alternating units and horizons (unit, horizon, ..., unit), youngest first. May be empty.
  std::vector<std::string> column;
  /// The values of the keys `on_crossing` and `trim_overshoot` of the project's key `rules`.
  ModelRules rules;
  NamingRules
      /// The keys that name regions: `regions`, `groups`, `attributes`, and `topography`, `fault_blocks`, `min_volume`,
      /// `small_regions` of `rules`.
      naming;
  GivenColours colours;     ///< colours of units and surfaces in pictures
  double merge_within = 0;  ///< distance within which points, edges and facets are merged
  MeshSpec mesh;
  std::vector<std::string> notes;  ///< notes on keys of the project that are written with a former name
  OutputSpec output;
};

/// Reads a project file. Throws Error{usage} whose message lists every problem found, each as "file:line:column: what
/// is wrong; what was expected": unknown key (with the nearest known one), wrong type, missing file, duplicate key,
/// column naming an unknown surface ...
Project read_project(const std::filesystem::path& file);

}  // namespace geomesh::geomodel
