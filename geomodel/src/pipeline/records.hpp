// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The records of a run. Each is the result of one stage; later stages read the record but do not change it:
///
///     Inputs --build--> Built --intersect--> Arranged --delaunay ... improve--> Meshed --verify--> ModelMesh
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/tops.hpp"
#include "pipeline/z_scale.hpp"

namespace geomesh::geomodel {

/// The user's request and the contents of the input files, in the frame of the output (with its origin subtracted).
struct Inputs {
  std::string command, name;
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<FittedTop> tops;  ///< of wells
  std::optional<PlcFile> plc;   ///< For `geomesh mesh`: a PLC that the engine meshes unchanged, in place of surfaces.
  bool closed_are_bodies = false;  ///< for `geomesh mesh`: closed surfaces name the regions inside, but cut no surface
  bool has_rules = false;          ///< whether the stage build applies rules of a project
  NamingRules naming;
  ModelRules rules;
  ModelVolume volume;
  TetrahedralizeOptions options;
  RefinementSettings refinement;
  ArrangementOptions arrangement;
  Vec3 origin{0, 0, 0};
  std::string system = "local", unit = "m";  ///< coordinate system and unit of the mesh, as the report names them
  double z_scale = 1;                        ///< factor by which z is multiplied after `build` until the mesh is named
  bool curved_faces = false;  ///< whether elements have second order; corners of mesh faces then stay on surfaces
  std::string description;    ///< description of the inputs for the report, as the text of a JSON object
  std::vector<std::string> doubted;  ///< names of inputs that a warning already concerns, so that no second one follows
};

/// The result of stage build: surfaces after the rules of geology were applied, with z scaled, and the settings,
/// including those that follow from putting the horizons in order.
struct Built {
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  BuiltRows rows;      ///< which triangles of the surfaces were made by rules
  SettledStack stack;  ///< horizons and units of the stratigraphic column after they were put in order in the map
  std::vector<ContinuedSurface> continued;
  ModelRules rules;
  ModelVolume volume;
  /// Naming rules. If horizons were put in order, the regions between them are named by unit and fault block.
  NamingRules naming;
  RefinementSettings refinement;
  ZScale z_scale{1};
};

/// The result of stage intersect: the polygon soup and the piecewise linear complex that is meshed.
struct Arranged {
  std::vector<TriangulatedSurface> surfaces;  ///< surfaces after stage build, followed by the sides of the volume
  ArrangementResult arrangement;
  ModelPlc plc;
  RefinementSettings refinement;  ///< mesh settings; the tolerance that merging used has been subtracted
};

/// The records that all stages after intersect read. The referenced records must outlive this object.
struct ModelRecords {
  const Inputs& inputs;
  const Built& built;
  const Arranged& arranged;
};

struct Meshed {
  RefineResult refined;
  RefinementSettings used;  ///< mesh settings as requested, with derived sizes and the tolerance that remeshing used
  NamingRules naming;       ///< naming rules without topography and floor, because parts beyond these were removed
  /// Volume of each component before surfaces were moved within a tolerance; empty if none was moved.
  std::vector<double> volumes_of_input;
};

}  // namespace geomesh::geomodel
