// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check`: exact verification of any tool's mesh. No code of the engine, the arrangement, the naming or the
/// writers is used here. What is shared with the mesher (readers, coordinates, rules that add to one surface) is listed
/// in docs/checking.md. Nothing is believed that the run under judgement wrote.
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
  std::filesystem::path mesh;     ///< .vtu with NAME.faces.vtp beside it, or a format that is read (docs/checking.md)
  std::filesystem::path project;  ///< empty: none
  std::vector<std::filesystem::path> surfaces;  ///< each triangle must be covered by mesh faces
  bool delaunay = false;
  bool solver = false;  ///< judge what solvers will make of it (solver_verdict.hpp); velocities are the project's
  /// How far rounding may have moved a mesh face off the input triangle that it stands for, in the mesh's unit.
  /// Negative: 1024 ulps of the largest coordinate (what lies nearer is brought together where crossings are rounded),
  /// and twice the project's `tolerance`; 8 ulps for coordinates in single precision.
  double tolerance = -1;
  /// How far surfaces may be off the input, both ways, beyond that: they were remeshed. Negative: what the project says
  /// (`honour: tolerance`), else 0. Where it is not 0, distances, topology and volumes are judged in place of coverage.
  double within = -1;
  /// Whether names, curves and arrays are judged too, where there are a project and a face set.
  enum class Contract { judged, passed_over } contract = Contract::judged;
};

struct CheckFault {
  std::string id;    ///< stable name, as listed in docs/checking.md: "inverted_tetrahedra", ...
  std::string what;  ///< one sentence with counts
  std::size_t count = 0;
  std::vector<std::size_t> examples;  ///< cells, faces or points, at most ten
  Vec3 place;                         ///< of the first example
};

struct CheckResult {
  std::size_t n_points = 0, n_tetrahedra = 0;
  double volume = 0;  ///< summed exactly, then rounded once
  struct RegionVolume {
    std::int32_t id;
    std::string name;
    std::size_t n_tetrahedra;
    double volume;
  };
  std::vector<RegionVolume> regions;
  std::optional<SolverVerdict> solver;   ///< where it was asked for
  std::vector<std::string> checks_done;  ///< what was checked, in words; and what was not, and why
  std::vector<CheckFault> faults;        ///< empty: the mesh passes
};

/// Collects every fault; never stops at the first. Throws Error{usage} where a file cannot be opened. Throws
/// Error{invalid_input} where one cannot be understood (a cell that names a point which is not there, a truncated file
/// ...). Near-linear in the cells, plus the triangles of the surfaces.
CheckResult check_mesh(const CheckRequest& request);

/// For a person: counts, what was checked, each fault on a line of its own, and the verdict.
std::string to_text(const CheckResult& result);
/// For a program: the members of CheckResult under their own names, and "passes".
std::string to_json(const CheckResult& result);

}  // namespace geomesh::geomodel
