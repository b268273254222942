// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What solvers will make of a mesh, judged as they will see it: from its doubles, and from coordinates written with 16
/// digits, by plain floating-point arithmetic.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::geomodel {

/// From which value on an element is counted as one at which a kind of solver fails or loses its speed.
struct SolverLimits {
  /// Volume over the cube of the longest edge: below it the Jacobian of a solver in doubles is no longer positive for
  /// sure once coordinates are rounded.
  double least_volume = 1e-10;
  double least_implicit_angle = 1, most_implicit_angle = 179;    ///< degrees: direct solvers lose digits beyond
  double least_iterative_angle = 5, most_iterative_angle = 175;  ///< degrees: iterative solvers take longer beyond
  double most_flux_angle = 170;  ///< degrees: two-point fluxes of finite volumes are far off beyond
  double least_step = 0.05;      ///< of the median explicit time step
};

/// An element that is the worst of all in one respect.
struct WorstForSolver {
  std::size_t tetrahedron = 0;
  Vec3 place;  ///< centroid
};

struct SolverVerdict {
  std::size_t n_tetrahedra = 0;
  double least_volume = 0;            ///< in doubles, over the cube of the element's longest edge
  double least_volume_16_digits = 0;  ///< the same once coordinates are rounded to 16 significant digits
  double least_edge = 0, least_edge_over_diagonal = 0;
  double least_edge_over_size = 0;  ///< 0: sizes are not known
  double min_dihedral = 0, max_dihedral = 0;
  std::size_t n_not_positive = 0;  ///< volume at most zero, in doubles or with 16 digits
  std::size_t n_implicit = 0, n_iterative = 0, n_flux = 0, n_explicit = 0;  ///< beyond the limits; see SolverLimits
  /// Least height over velocity: seconds where velocities are given, else the least height itself.
  double time_step = 0, time_step_without_worst_ten = 0, median_time_step = 0;
  bool has_velocities = false;
  WorstForSolver flattest, sharpest, smallest_step;

  /// A direct or iterative finite element solver takes the mesh.
  bool passes() const { return n_tetrahedra > 0 && n_not_positive == 0 && n_implicit == 0; }
};

struct MeshForSolver {
  std::span<const Vec3> points;
  std::span<const Tetrahedron> tetrahedra;  ///< positively oriented
  /// Velocity of compressional waves in a tetrahedron; empty, or a value of 0: not known.
  std::function<double(std::size_t)> velocity;
  /// Edge length asked in a tetrahedron at a place; where it is at most that given last, anything up to that will do.
  /// Empty: not known.
  std::function<double(std::size_t, const Vec3&, double)> size;
  /// No size asked anywhere is larger: sizes need not be looked up where edges are not that short.
  double largest_size = std::numeric_limits<double>::infinity();
  unsigned threads = 0;  ///< 0: all cores. Both functions are asked by all of them at once; the verdict is the same
};

/// O(n).
SolverVerdict judge_for_solvers(const MeshForSolver& mesh, const SolverLimits& limits = {});

/// The attribute that holds a unit's velocity of compressional waves, in the mesh's unit of length a second.
inline constexpr const char* velocity_attribute = "vp";

/// For a program: the members of SolverVerdict under their own names, and `passes`. A JSON object.
std::string to_json(const SolverVerdict& verdict);
/// Lines for a person: the verdict first.
std::vector<std::string> to_lines(const SolverVerdict& verdict);

}  // namespace geomesh::geomodel
