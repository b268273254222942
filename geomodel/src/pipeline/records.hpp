// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The records of a run. Each is the result of one stage; later stages read it and none changes it:
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

/// The request and the contents of the files, in the frame of the output (with its origin subtracted).
struct Inputs {
  std::string command, name;
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<FittedTop> tops;     ///< of wells
  std::optional<PlcFile> plc;      ///< for `geomesh mesh`, instead of surfaces: a PLC that the engine meshes unchanged
  bool closed_are_bodies = false;  ///< for `geomesh mesh`: closed surfaces name regions, although they cut nothing
  bool has_rules = false;          ///< for a project: stage build applies the rules
  NamingRules naming;
  ModelRules rules;
  ModelVolume volume;
  TetrahedralizeOptions options;
  RefinementSettings refinement;
  ArrangementOptions arrangement;
  Vec3 origin{0, 0, 0};
  std::string system = "local", unit = "m";  ///< coordinate system and unit of the mesh, for the report
  double z_scale = 1;                        ///< factor by which z is multiplied after `build` until the mesh is named
  bool curved_faces = false;         ///< set if the output has second order: corners of faces stay on the surfaces
  std::string description;           ///< description for the report, as the text of a JSON object
  std::vector<std::string> doubted;  ///< inputs that a warning already concerned, so that they are not warned of again
};

/// The surfaces after the rules of geology were applied, with z scaled; and the settings, with those that the stack
/// derives.
struct Built {
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  BuiltRows rows;      ///< which triangles of the surfaces were made by rules
  SettledStack stack;  ///< the stack as settled by this stage
  std::vector<ContinuedSurface> continued;
  ModelRules rules;
  ModelVolume volume;
  /// A settled stack has regions by unit and fault block, and thin units require sizes and a smaller tolerance.
  NamingRules naming;
  RefinementSettings refinement;
  ZScale z_scale{1};
};

/// The soup of polygons and the complex that is meshed.
struct Arranged {
  std::vector<TriangulatedSurface> surfaces;  ///< surfaces as built, followed by the sides of the volume
  ArrangementResult arrangement;
  ModelPlc plc;
  RefinementSettings refinement;  ///< settings, with the tolerance that merging used
};

/// The records that stages from meshing on read; they must outlive this object.
struct ModelRecords {
  const Inputs& inputs;
  const Built& built;
  const Arranged& arranged;
};

/// The mesh, in unscaled heights.
struct Meshed {
  RefineResult refined;
  RefinementSettings used;  ///< requested settings, with the derived sizes and the tolerance that remeshing used
  NamingRules naming;       ///< rules without topography and floor, since the parts beyond them were removed
  /// Volume of each component before surfaces moved within a tolerance; empty if none moved.
  std::vector<double> volumes_of_input;
};

}  // namespace geomesh::geomodel
