// SPDX-License-Identifier: MIT
/// @file
/// Best place for a vertex whose link is fixed: the nonsmooth optimisation of Freitag and Ollivier-Gooch 1997
/// (section 3.2).
///
/// The least of all dihedral measures about the vertex is maximised by steps along the steepest ascent direction: the
/// point nearest to the origin in the convex hull of the gradients of the active terms. Active are those within a few
/// per cent of the least.
#pragma once

#include <optional>

#include "quality/measure/link_shapes.hpp"
#include "remesh/tolerance/cavity.hpp"

namespace geomesh::remesh {

struct StarProblem {
  LinkShapes& link;  ///< (corners, p) is positive if p is admissible
  CellQuality measure = CellQuality();
  enum class Freedom { space, plane, line } freedom = Freedom::space;
  Vec3 direction = {};  ///< unit vector: the normal of a plane, or the direction of a line

  void set_link(const DomainMesh& mesh, const StarCavity& cavity);
  double shape_at(const Vec3& p, double enough = -1) const { return link.worst(p, enough); }
  Vec3 constrain(const Vec3& v) const;
};

struct OptimizeLimits {
  unsigned max_steps = 12;
  double good_enough = 2;      ///< stops once the worst shape is above this
  double least_rise = 1.0005;  ///< a step that raises the worst shape by a smaller factor is not made
};

struct OptimizedPlace {
  Vec3 point;
  double shape;  ///< worst shape around the vertex; at least that at the start
};

/// Finds the best place by an ascent along the gradients of the worst terms. A start whose worst shape is not above 0
/// is returned as it is.
OptimizedPlace optimize_place(const StarProblem& problem, const Vec3& start, const OptimizeLimits& limits = {});

/// Climbs the sum of the worths (MeanGoal) of all cells at the vertex by its gradient. It starts where all are above
/// `floor`, and keeps them above. Ends when a step raises the sum by less than `least_gain`.
Vec3 optimize_mean(const StarProblem& problem, const Vec3& start, double floor, unsigned max_steps, double least_gain);

/// Centroid of the link weighted by the areas of its faces.
Vec3 link_centroid(const StarProblem& problem);

}  // namespace geomesh::remesh
