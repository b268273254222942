// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A horizon that runs on across a fault as a ramp: where, how wide and how high.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "rules/throw/fault_faces.hpp"

namespace geomesh::geomodel {

/// Median edges of the horizon in the map: how far from a fault its slopes are looked at.
inline constexpr double furthest_beside = 16;

/// How far a ramp reaches on the two sides of the fault, in edges.
struct RampWidth {
  double below = 0, above = 0;
};

/// The ramp along a fault, by stretches.
struct Ramp {
  std::map<long, RampWidth> at;
  std::vector<double> steps;  ///< m, by stretch that has it
  std::size_t n_stretches = 0;
  double length = 0;  ///< of the stretches that have it

  /// In a quarter of the stretches at least.
  bool is_there() const;
  /// That of the stretch and its neighbours, else of the nearest one. Only where the ramp is there.
  RampWidth width(long stretch) const;
};

double median(std::vector<double> values);
/// 0: no triangles.
double median_map_edge(const TriangulatedSurface& s);
/// The stretch of a fault that holds a place along its strike.
long stretch_at(double along, double edge);

/// A ramp is steeper across the fault than the median slope further out on both sides, by three times the spread of
/// slopes there. Triangles that are nearer to another of `faults` do not count; `own` is one of these. `edge`: of
/// median_map_edge(). Cost: the horizon's triangles near the fault times the triangles of all faults.
Ramp find_ramp(const TriangulatedSurface& horizon, std::span<const FaultFaces> faults, std::size_t own, double edge);

}  // namespace geomesh::geomodel
