// SPDX-License-Identifier: MIT
/// @file
/// Finds the best position of a vertex whose link is fixed: the nonsmooth optimisation of Freitag and Ollivier-Gooch
/// 1997 (section 3.2).
///
/// The least shape of the cells around the vertex is maximised by steps along the direction of steepest ascent. This is
/// the point nearest to the origin in the convex hull of the gradients of all shapes within a few per cent of the
/// least.
#pragma once

#include <optional>

#include "quality/measure/link_shapes.hpp"
#include "remesh/tolerance/cavity.hpp"

namespace geomesh::remesh {

struct StarProblem {
  LinkShapes& link;  ///< faces of the moved vertex's link; each forms a positive cell with any admissible position
  CellQuality measure = CellQuality();
  enum class Freedom { space, plane, line } freedom = Freedom::space;
  Vec3 direction = {};  ///< unit normal of the plane, or unit vector along the line, in which the vertex may move

  void set_link(const DomainMesh& mesh, const StarCavity& cavity);
  double shape_at(const Vec3& p, double enough = -1) const { return link.worst(p, enough); }
  Vec3 constrain(const Vec3& v) const;
};

struct OptimizeLimits {
  unsigned max_steps = 12;
  double good_enough = 2;      ///< the ascent stops once the worst shape around the vertex is above this limit
  double least_rise = 1.0005;  ///< each step of the ascent must raise the worst shape by at least this factor
};

struct OptimizedPlace {
  Vec3 point;
  double shape;  ///< worst shape around the vertex at this place; at least that at its first place
};

/// Finds the best position of a vertex by an ascent along the gradients of the worst shapes around it. Returns `start`
/// if the worst shape there is not positive.
OptimizedPlace optimize_place(const StarProblem& problem, const Vec3& start, const OptimizeLimits& limits = {});

/// Moves a vertex along the gradient of the sum of the worths (CellQuality::worth) of its cells, to raise this sum. All
/// shapes must be above `floor` at the start, and remain so. Ends when a step raises the sum by less than `least_gain`.
Vec3 optimize_mean(const StarProblem& problem, const Vec3& start, double floor, unsigned max_steps, double least_gain);

/// Returns the centroid of the link, its faces weighted by area.
Vec3 link_centroid(const StarProblem& problem);

}  // namespace geomesh::remesh
