// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Detects where a horizon runs across a fault as a ramp, with the ramp's width and height.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "rules/throw/fault_faces.hpp"

namespace geomesh::geomodel {

/// Distance from a fault up to which slopes of the horizon are examined, in median edge lengths of the horizon in the
/// map.
inline constexpr double furthest_beside = 16;

/// Width, in edge lengths, of a ramp (steep zone where a gridded horizon crosses a fault) on both sides of the fault.
struct RampWidth {
  double below = 0, above = 0;
};

/// The ramp by which a gridded horizon crosses a fault, by segments along the fault's strike.
struct Ramp {
  std::map<long, RampWidth> at;
  std::vector<double> steps;  ///< heights of the ramp in m, for those segments of the fault that have a ramp
  std::size_t n_stretches = 0;
  double length = 0;  ///< total length of the fault's segments that have a ramp

  /// Returns whether at least a quarter of the fault's segments have a ramp.
  bool is_there() const;
  /// Returns the ramp's width around a segment of the fault, or in the nearest one with a ramp; requires is_there().
  RampWidth width(long stretch) const;
};

double median(std::vector<double> values);
/// 0: no triangles.
double median_map_edge(const TriangulatedSurface& s);
/// Returns the segment of a fault that contains a position along its strike.
long stretch_at(double along, double edge);

/// Finds the ramp of a horizon across the fault `own`. A ramp is steeper across the fault than the median slope farther
/// away on both sides, by three times the spread of slopes there. Triangles closer to another of `faults` than to `own`
/// are ignored. `edge` is the result of median_map_edge(). Cost: the horizon's triangles near the fault times the
/// triangles of all faults.
Ramp find_ramp(const TriangulatedSurface& horizon, std::span<const FaultFaces> faults, std::size_t own, double edge);

}  // namespace geomesh::geomodel
