// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check`: exact verification of any tool's mesh. No code of the engine, the arrangement, the naming or the
/// writers is used here. What is shared with the mesher (readers, coordinates, rules that add to one surface) is listed
/// in docs/checking.md. Nothing that the checked run wrote is trusted.
///
/// What decides is a sign computed exactly from the doubles in the file (a floating-point filter first). The one
/// tolerance is that of coverage, since added points lie on their facet up to rounding only: see
/// CheckRequest::tolerance. docs/checking.md lists every check with the name of its fault.
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
  /// A .vtu file with NAME.faces.vtp beside it, or another format that can be read (docs/checking.md).
  std::filesystem::path mesh;
  std::filesystem::path project;  ///< empty: none
  /// Input surfaces; each of their triangles must be covered by faces of the mesh.
  std::vector<std::filesystem::path> surfaces;
  bool delaunay = false;
  /// Whether the mesh is also checked for what solvers need (solver_verdict.hpp), with the velocities of the project.
  bool solver = false;
  /// How far rounding may have moved a mesh face off the input triangle that it stands for, in the mesh's unit.
  /// Negative: 1024 ulps of the largest coordinate (features closer than that are merged when crossings are rounded),
  /// and twice the project's `tolerance`; 8 ulps for coordinates in single precision.
  double tolerance = -1;
  /// How far remeshed surfaces may be from the input, in both directions, beyond rounding. Negative: the value of the
  /// project (`honour: tolerance`), else 0. If it is not 0, distances, topology and volumes are checked instead of
  /// coverage.
  double within = -1;
  /// Whether names, curves and arrays are checked too, provided that there are a project and a set of faces.
  enum class Contract { checked, passed_over } contract = Contract::checked;
};

struct CheckFault {
  std::string id;    ///< stable identifier as listed in docs/checking.md, for example "inverted_tetrahedra"
  std::string what;  ///< one sentence that describes the fault, with counts
  std::size_t count = 0;
  std::vector<std::size_t> examples;  ///< at most ten rows of cells, faces or points that have the fault
  Vec3 place;                         ///< place of the first example of the fault
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
  std::vector<CheckFault> faults;        ///< all faults found; if empty, the mesh passes
};

/// Collects every fault; never stops at the first. Throws Error{usage} where a file cannot be opened. Throws
/// Error{invalid_input} where one cannot be understood (a cell that names a point which is not there, a truncated file
/// ...). Near-linear in the cells, plus the triangles of the surfaces.
CheckResult check_mesh(const CheckRequest& request);

/// Returns text for a person: counts, what was checked, one line for each fault, and the verdict.
std::string to_text(const CheckResult& result);
/// Returns JSON for programs: the members of CheckResult under their own names, and "passes".
std::string to_json(const CheckResult& result);

}  // namespace geomesh::geomodel
