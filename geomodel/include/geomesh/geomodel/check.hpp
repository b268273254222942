// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check`: exact verification of any tool's mesh. No code of the engine, the arrangement, the naming or the
/// writers is used here. The code shared with the mesher (readers, coordinates, rules that add to one surface) is
/// listed in docs/checking.md. Nothing that the checked run wrote is trusted.
///
/// Every decision is the sign of a number computed exactly from the doubles in the file (after a floating-point
/// filter). Only the coverage of input triangles is checked with a tolerance, because points added on a facet lie on it
/// only up to rounding: see CheckRequest::tolerance. docs/checking.md lists every check with the name of its fault.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/solver_verdict.hpp"

namespace geomesh::geomodel {

struct CheckRequest {
  /// File of the mesh to check: a .vtu file with NAME.faces.vtp beside it, or another format that can be read
  /// (docs/checking.md).
  std::filesystem::path mesh;
  std::filesystem::path project;  ///< empty: none
  /// Input surfaces; each of their triangles must be covered by faces of the mesh.
  std::vector<std::filesystem::path> surfaces;
  bool delaunay = false;
  /// Whether the mesh is also checked against the limits of solvers (solver_verdict.hpp), with the project's
  /// velocities.
  bool solver = false;
  /// Largest distance by which rounding may have moved a mesh face off its input triangle, in the mesh's unit.
  /// Negative: 1024 ulps of the largest coordinate (features closer than that are merged when crossings are rounded)
  /// plus twice the project's `merge_within`, or 8 ulps for coordinates in single precision.
  double tolerance = -1;
  /// Largest distance of remeshed surfaces from the input and of the input from them, beyond rounding. Negative: the
  /// project's `honour: tolerance`, else 0. If it is not 0, distances, topology and volumes are checked instead of
  /// coverage.
  double within = -1;
  /// Whether names, curves and arrays are compared with the project, if there are a project and a file of faces.
  enum class Contract { checked, passed_over } contract = Contract::checked;
};

struct CheckFault {
  std::string id;    ///< stable identifier as listed in docs/checking.md, for example "inverted_tetrahedra"
  std::string what;  ///< one sentence that describes the defect of the mesh, with counts
  std::size_t count = 0;
  std::vector<std::size_t> examples;  ///< rows of at most ten cells, faces or points with the defect
  Vec3 place;                         ///< place of the first example of the defect
};

struct CheckResult {
  std::size_t n_points = 0, n_tetrahedra = 0;
  double volume = 0;  ///< volume of the mesh, summed exactly and then rounded once
  struct RegionVolume {
    std::int32_t id;
    std::string name;
    std::size_t n_tetrahedra;
    double volume;
  };
  std::vector<RegionVolume> regions;
  std::optional<SolverVerdict> solver;   ///< result of the check for solvers, if it was requested
  std::vector<std::string> checks_done;  ///< descriptions of what was checked, and of what was not checked and why
  std::vector<CheckFault> faults;        ///< all defects of the mesh that were found; if empty, the mesh passes
};

/// Checks a mesh and collects every fault. Throws Error{usage} if a file cannot be opened, and Error{invalid_input} if
/// a file cannot be understood (it is truncated, a cell names a point that does not exist, ...). The time is nearly
/// linear in the number of cells, plus that of surface triangles.
CheckResult check_mesh(const CheckRequest& request);

/// Describes the result of a check for a person: counts, what was checked, one line for each defect, and the verdict.
std::string to_text(const CheckResult& result);
/// Returns the result of a check as JSON: the members of CheckResult under their own names, and "passes".
std::string to_json(const CheckResult& result);

}  // namespace geomesh::geomodel
