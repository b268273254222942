// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolates surfaces between fault sticks, declared in geomesh/geomodel/sticks.hpp.
#include "geomesh/geomodel/sticks.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {
namespace {

struct Stick {
  std::vector<Vec3> points;
  double place = 0;  ///< position of the stick's midpoint along the direction normal to all sticks of the fault
};

Eigen::Vector3d eigen(const Vec3& p) { return {p.x, p.y, p.z}; }

/// Returns the direction of largest extent from a sum of outer products of points. Its largest component is positive.
Eigen::Vector3d main_direction(const Eigen::Matrix3d& sum) {
  Eigen::Vector3d d = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
  Eigen::Index largest = 0;
  d.cwiseAbs().maxCoeff(&largest);
  return d[largest] < 0 ? -d : d;
}

std::vector<Stick> clean_sticks(const std::vector<Polyline>& lines) {
  std::vector<Stick> sticks;
  for (const Polyline& line : lines) {
    Stick stick;
    for (const Vec3& p : line.points)
      if (stick.points.empty() || stick.points.back() != p) stick.points.push_back(p);
    if (stick.points.size() > 1) sticks.push_back(std::move(stick));
  }
  if (sticks.size() < 2)
    throw Error(ErrorKind::invalid_input,
                "a surface is made between two lines or more, each of two points or more, and there " +
                    std::string(sticks.empty() ? "are none" : "is one") +
                    ": give the sticks of the fault as lines, or points to be gridded");
  return sticks;
}

/// Mean direction of the fault sticks, and the direction, normal to it, in which they lie side by side.
struct Directions {
  Eigen::Vector3d along, across;
};

/// Orients all fault sticks in the same direction, and sorts them across that direction.
Directions arrange(std::vector<Stick>& sticks) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d origin = eigen(sticks.front().points.front());
  for (const Stick& s : sticks) {
    const Eigen::Vector3d d = eigen(s.points.back() - s.points.front());
    sum += d * d.transpose();
  }
  Directions directions;
  directions.along = main_direction(sum);
  std::vector<Eigen::Vector3d> middles;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Stick& s : sticks) {
    if (eigen(s.points.back() - s.points.front()).dot(directions.along) < 0)
      std::reverse(s.points.begin(), s.points.end());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Vec3& p : s.points) middle += (eigen(p) - origin) / static_cast<double>(s.points.size());
    middles.push_back(middle - middle.dot(directions.along) * directions.along);
    mean += middles.back() / static_cast<double>(sticks.size());
  }
  sum.setZero();
  for (const Eigen::Vector3d& m : middles) sum += (m - mean) * (m - mean).transpose();
  directions.across = main_direction(sum);
  for (std::size_t i = 0; i < sticks.size(); ++i) sticks[i].place = middles[i].dot(directions.across);
  std::stable_sort(sticks.begin(), sticks.end(), [](const Stick& a, const Stick& b) { return a.place < b.place; });
  return directions;
}

double distance(const Vec3& a, const Vec3& b) { return eigen(a - b).norm(); }

double nearest(const Stick& a, const Stick& b) {
  double least = distance(a.points.front(), b.points.front());
  for (const Vec3& p : a.points)
    for (const Vec3& q : b.points) least = std::min(least, distance(p, q));
  return least;
}

/// Adds triangles between two neighbouring sticks, always with the shorter diagonal. The points of the sticks begin at
/// the indices first_a and first_b.
void join(const Stick& a, VertexIndex first_a, const Stick& b, VertexIndex first_b, std::vector<Triangle>& triangles) {
  std::size_t i = 0, j = 0;
  const std::size_t last_a = a.points.size() - 1, last_b = b.points.size() - 1;
  while (i < last_a || j < last_b) {
    const bool along_a =
        j == last_b || (i < last_a && distance(a.points[i + 1], b.points[j]) <= distance(a.points[i], b.points[j + 1]));
    const Vec3 &p = a.points[i], &q = b.points[j], &next = along_a ? a.points[i + 1] : b.points[j + 1];
    const auto row_a = first_a + static_cast<VertexIndex>(i), row_b = first_b + static_cast<VertexIndex>(j);
    if (p != q && p != next && q != next) triangles.push_back({row_a, row_b, along_a ? row_a + 1 : row_b + 1});
    ++(along_a ? i : j);
  }
}

/// Finds triangles that are inverted, compared with most others, in the projection along and across the sticks.
void find_folds(const Directions& directions, SurfaceOfSticks& made) {
  double whole = 0;
  std::vector<double> areas;
  for (const Triangle& t : made.surface.triangles) {
    const std::vector<Vec3>& p = made.surface.points;
    const Eigen::Vector3d u = eigen(p[t[1]] - p[t[0]]), v = eigen(p[t[2]] - p[t[0]]);
    areas.push_back(u.dot(directions.along) * v.dot(directions.across) -
                    u.dot(directions.across) * v.dot(directions.along));
    whole += areas.back();
  }
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (areas[t] * whole >= 0) continue;
    if (made.n_folded++ == 0) made.fold = made.surface.points[made.surface.triangles[t][0]];
  }
}

}  // namespace

SurfaceOfSticks surface_of_sticks(const std::vector<Polyline>& lines, double max_distance) {
  std::vector<Stick> sticks = clean_sticks(lines);
  const Directions directions = arrange(sticks);
  SurfaceOfSticks made;
  made.n_sticks = sticks.size();
  std::vector<VertexIndex> first;
  for (const Stick& s : sticks) {
    first.push_back(static_cast<VertexIndex>(made.surface.points.size()));
    made.surface.points.insert(made.surface.points.end(), s.points.begin(), s.points.end());
  }
  for (std::size_t k = 0; k + 1 < sticks.size(); ++k) {
    if (max_distance > 0 && nearest(sticks[k], sticks[k + 1]) > max_distance) {
      ++made.n_gaps;
    } else {
      join(sticks[k], first[k], sticks[k + 1], first[k + 1], made.surface.triangles);
    }
  }
  if (made.surface.triangles.empty())
    throw Error(ErrorKind::invalid_input,
                "no triangle is left between its lines: gridding.max_distance is shorter than they are apart");
  find_folds(directions, made);
  return made;
}

std::string name_without_part(const std::string& name) {
  const std::size_t at = name.rfind("__");
  const bool is_part = at != std::string::npos && at > 0 && at + 2 < name.size() &&
                       name.find_first_not_of("0123456789", at + 2) == std::string::npos;
  return is_part ? name.substr(0, at) : name;
}

}  // namespace geomesh::geomodel
