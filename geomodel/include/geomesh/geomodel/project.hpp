// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The project file as understood (docs/project-file.md). Reading reports every mistake of one run together.
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

/// How the coordinates of one input are to be understood (docs/coordinates.md).
struct SourceSpec {
  std::string object;         ///< name of the object in the file; empty: the only one, or the one named as the entry
  std::string crs;            ///< empty: the file's own where it names one that is known, else the project's
  std::string unit;           ///< of x, y and z; empty: the file's own, else the project's
  std::string z_unit;         ///< of z alone; empty: as unit
  std::optional<bool> depth;  ///< empty: the file's own, else the project's
  double z_datum = 0;         ///< elevation of the input's zero in the project's height system, in the project's unit
  ReadOptions reading;        ///< `columns` and `no_data`
};

/// Key `fault_polygons` of a horizon.
struct FaultPolygonsSpec {
  std::filesystem::path file;  ///< empty: none
  std::string file_as_written;
  SourceSpec source;
};

struct SurfaceSpec {
  std::string name;
  SurfaceKind kind = SurfaceKind::horizon;
  std::filesystem::path file;  ///< absolute, resolved against the project file
  std::string file_as_written;
  std::shared_ptr<const FileContents> given;  ///< in place of the file (given.hpp); null: the file
  /// In place of a file: the surface is a level set of a field, or of several fields, each with a domain of its own.
  std::vector<LevelSetSpec> level_sets;
  bool cuts_all = false;  ///< `cuts: all`; default true for bodies
  SourceSpec source;
  GriddingSpec gridding;  ///< how points become a surface
  double resample = 0;    ///< length of the edges of the surface remade; 0: as it is
  int smooth = 0;         ///< passes of smoothing
  FaultPolygonsSpec fault_polygons;
  std::string below;               ///< a horizon: this one lies below it, by `thickness` or the heights of the file
  std::optional<double> below_by;  ///< `thickness` as a number; empty: the file holds thicknesses
  ExtrudeSpec extrude;
  SurfaceRules rules;  ///< `extend`, `fill_holes`, `extent`, `base`
  int line = 0;        ///< where it stands in the project file, from 1

  /// False where it is known to be another; a wrong word for the kind is one problem and no more.
  bool may_be(SurfaceKind wanted) const { return kind == wanted || kind == SurfaceKind::surface; }
};

struct WellSpec {
  std::string name;
  std::filesystem::path file;
  std::string file_as_written;
  std::shared_ptr<const FileContents> given;  ///< as of surfaces
  SourceSpec source;
  std::optional<Vec3> head;  ///< where measured depth is zero, in the coordinates of the entry
  int line = 0;
};

struct CrsSpec {
  std::string horizontal = "local";  ///< local, geographic, utm [ZONE], epsg:CODE
  bool depth = false;  ///< z: depth; what the project file and its inputs count downwards. The mesh has elevation up
  std::string unit = "m";  ///< of the mesh, and of all lengths in the project file
  std::string z_datum;     ///< name of the height system, for the report alone
  /// z is multiplied by this while meshing and divided in the mesh: a power of two, which is undone without rounding.
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
  /// unit, horizon, unit, horizon, ..., unit; youngest first. Empty where not given.
  std::vector<std::string> column;
  ModelRules rules;  ///< `rules: {on_crossing, trim_overshoot}`; its surfaces, box and column are filled from the rest
  NamingRules
      naming;  ///< `rules: {topography, fault_blocks, min_volume, small_regions}`, `regions`, `groups`, `attributes`
  GivenColours colours;     ///< of units and surfaces, for pictures
  double merge_within = 0;  ///< points, edges and facets nearer to each other than this merge
  MeshSpec mesh;
  std::vector<std::string> notes;  ///< of keys that are read under a former name
  OutputSpec output;
};

/// Throws Error{usage} whose message lists every problem found, each as "file:line:column: what is wrong; what was
/// expected": unknown key (with the nearest known one), wrong type, missing file, duplicate key, column naming an
/// unknown surface ...
Project read_project(const std::filesystem::path& file);

}  // namespace geomesh::geomodel
