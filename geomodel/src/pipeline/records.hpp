// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The records of a run. Each is what one stage returns; stages to come read it, and none changes it:
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

/// The request and the content of the files, in the frame of the output (its origin subtracted).
struct Inputs {
  std::string command, name;
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  std::vector<FittedTop> tops;     ///< of wells
  std::optional<PlcFile> plc;      ///< of `geomesh mesh`, instead of surfaces: the engine gets it as it is
  bool closed_are_bodies = false;  ///< of `geomesh mesh`: closed surfaces name regions, though they cut nothing
  bool has_rules = false;          ///< of a project: stage build applies them
  NamingRules naming;
  ModelRules rules;
  ModelVolume volume;
  TetrahedralizeOptions options;
  RefinementSettings refinement;
  ArrangementOptions arrangement;
  Vec3 origin{0, 0, 0};
  std::string system = "local", unit = "m";  ///< of the mesh, for the report
  double z_scale = 1;                        ///< by which z is multiplied from after `build` until the mesh is named
  bool curved_faces = false;                 ///< the output has second order: corners of faces stay on the surfaces
  std::string description;                   ///< for the report, a JSON object in text
  std::vector<std::string> doubted;          ///< inputs that a warning was about: not warned of for the same again
};

/// The surfaces once the rules of geology were applied, with z scaled; and the settings with what the stack derives.
struct Built {
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> wells;
  std::vector<NamedPoint> points;
  BuiltRows rows;      ///< which triangles of the surfaces rules made
  SettledStack stack;  ///< as the stage settled it
  std::vector<ContinuedSurface> continued;
  ModelRules rules;
  ModelVolume volume;
  /// A settled stack has regions by unit and fault block, and thin units ask for sizes and a smaller tolerance.
  NamingRules naming;
  RefinementSettings refinement;
  ZScale z_scale{1};
};

/// The soup and the complex that is meshed.
struct Arranged {
  std::vector<TriangulatedSurface> surfaces;  ///< as built, followed by the sides of the volume
  ArrangementResult arrangement;
  ModelPlc plc;
  RefinementSettings refinement;  ///< with what merging used of the tolerance
};

/// The records that stages from meshing on read. They outlive it.
struct ModelRecords {
  const Inputs& inputs;
  const Built& built;
  const Arranged& arranged;
};

/// The mesh, in true heights.
struct Meshed {
  RefineResult refined;
  RefinementSettings used;  ///< as asked, with the sizes that were derived and what remeshing used of the tolerance
  NamingRules naming;       ///< without topography and floor: what lies beyond is gone
  std::vector<double> volumes_of_input;  ///< by component, before surfaces moved within a tolerance; empty: none did
};

}  // namespace geomesh::geomodel
