// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One run of one triangulator in a process of its own.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace geomesh::bench {

/// Of a mesh's elements; angles in degrees, "least" is an element's least dihedral angle.
struct ElementShapes {
  double least = 0, largest = 0, first_percentile = 0, mean_of_least = 0;
  double share_below_10 = 0, share_above_24_85 = 0;
};

/// What a triangulator tells of itself; it may throw.
struct Answer {
  std::size_t tetrahedra = 0;
  std::size_t exact_calls = 0, walk_steps = 0, deferred = 0;
  std::size_t added_points = 0;  ///< recovery only
  double volume = 0;             ///< recovery only: of all regions together
  ElementShapes shapes;          ///< refinement only
  double meshing_cpu_s = 0;  ///< refinement only: from the start of the run to the mesh, its shapes not yet measured
  /// Refinement: delaunay, recover and classify, refine, improve. Recovery: delaunay, recover, classify.
  std::array<double, 4> stage_cpu_s{};
};
using Job = std::function<Answer()>;

struct Measurement {
  bool ok = false;
  std::string message;  ///< where the triangulator refused or died
  double cpu_s = 0, wall_s = 0;
  std::size_t peak_bytes = 0;  ///< peak resident size during the run less that before it
  Answer answer;
};

/// Ends this process (signal SIGXCPU) once it has used that much more processor time: for a job that may take too long.
void limit_cpu_seconds(double seconds);

/// Forks, runs each job and measures it there, so that no run sees the heap that another left and a crash is a result.
/// Several jobs run side by side.
std::vector<Measurement> measure(const std::vector<Job>& side_by_side);

}  // namespace geomesh::bench
