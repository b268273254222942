// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Predicts what solvers will do with a mesh. The measures are computed as solvers compute them: in plain
/// floating-point arithmetic, from doubles and from coordinates rounded to 16 digits.
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

/// Limits beyond which an element makes a kind of solver fail or slow down.
struct SolverLimits {
  /// Least volume of an element divided by the cube of its longest edge. Below this value a solver that computes in
  /// doubles may find a Jacobian that is not positive, once coordinates have been rounded.
  double least_volume = 1e-10;
  /// Dihedral angles in degrees beyond which direct solvers lose digits.
  double least_implicit_angle = 1, most_implicit_angle = 179;
  /// Dihedral angles in degrees beyond which iterative solvers converge more slowly.
  double least_iterative_angle = 5, most_iterative_angle = 175;
  /// Dihedral angle in degrees beyond which two-point fluxes of finite volumes are inaccurate.
  double most_flux_angle = 170;
  double least_step = 0.05;  ///< least stable time step of explicit solvers, as a share of the median one
};

/// The element with the worst value of one measure.
struct WorstForSolver {
  std::size_t tetrahedron = 0;
  Vec3 place;  ///< centroid
};

struct SolverVerdict {
  std::size_t n_tetrahedra = 0;
  /// Least volume of an element, computed in doubles, divided by the cube of its longest edge.
  double least_volume = 0;
  /// Least volume of an element divided by the cube of its longest edge, after coordinates are rounded to 16 digits.
  double least_volume_16_digits = 0;
  double least_edge = 0, least_edge_over_diagonal = 0;
  double least_edge_over_size = 0;  ///< least ratio of an edge to its target size; 0 if target sizes are not known
  double min_dihedral = 0, max_dihedral = 0;
  std::size_t n_not_positive = 0;  ///< number of elements whose volume is not positive, in doubles or with 16 digits
  /// Numbers of elements beyond the limits of each kind of solver (SolverLimits).
  std::size_t n_implicit = 0, n_iterative = 0, n_flux = 0, n_explicit = 0;
  /// Explicit time step, which is least height divided by velocity: in seconds if velocities are given, else the least
  /// height itself.
  double time_step = 0, time_step_without_worst_ten = 0, median_time_step = 0;
  bool has_velocities = false;
  WorstForSolver flattest, sharpest, smallest_step;

  /// Whether a finite element solver, direct or iterative, can use the mesh.
  bool passes() const { return n_tetrahedra > 0 && n_not_positive == 0 && n_implicit == 0; }
};

struct MeshForSolver {
  std::span<const Vec3> points;
  std::span<const Tetrahedron> tetrahedra;  ///< positively oriented
  /// Returns the velocity of compressional waves in a tetrahedron. An empty function, or a value of 0, means unknown.
  std::function<double(std::size_t)> velocity;
  /// Returns the target edge length in a tetrahedron at a place. The last argument is a length: if the target is at
  /// most this length, any value up to it may be returned. An empty function means unknown.
  std::function<double(std::size_t, const Vec3&, double)> size;
  /// Upper bound of all target sizes. Target sizes are not looked up for elements whose edges are so long, compared
  /// with this bound, that they cannot have the least ratio of edge to target size.
  double largest_size = std::numeric_limits<double>::infinity();
  /// Number of threads, 0 for all cores. All threads call the functions `velocity` and `size` at the same time; the
  /// result does not depend on the number of threads.
  unsigned threads = 0;
};

/// O(n).
SolverVerdict judge_for_solvers(const MeshForSolver& mesh, const SolverLimits& limits = {});

/// Name of the attribute that holds a unit's velocity of compressional waves, in the mesh's unit of length per second.
inline constexpr const char* velocity_attribute = "vp";

/// Returns the solver verdict as a JSON object: the members of SolverVerdict under their own names, and `passes`.
std::string to_json(const SolverVerdict& verdict);
/// Describes the solver verdict for a person, in lines that begin with the verdict.
std::vector<std::string> to_lines(const SolverVerdict& verdict);

}  // namespace geomesh::geomodel
