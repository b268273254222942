// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/fault_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "naming/sheets.hpp"

namespace geomesh::geomodel {
namespace {

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double uu = dot(u, u);
  return uu > 0 ? a + std::clamp(dot(p - a, u) / uu, 0.0, 1.0) * u : a;
}

}  // namespace

FaultFaces::FaultFaces(const TriangulatedSurface& fault) : steep_centres_({}), tree_(std::vector<Box3>{}) {
  const UpwardSides up = orient_upward(fault);
  Vec3 sum{};
  for (Index t = 0; t < fault.triangles.size(); ++t) {
    const Triangle& v = fault.triangles[t];
    Face face{{fault.points[v[0]], fault.points[v[1]], fault.points[v[2]]}, {}, {}};
    const Vec3 n =
        (up.as_stored[t] ? 1.0 : -1.0) * cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
    if (!(norm(n) > 0)) continue;
    sum = sum + n;
    face.normal = (1 / norm(n)) * n;
    for (const Vec3& p : face.corners) {
      face.bounds.add(p);
      bounds_.add(p);
    }
    faces_.push_back(face);
  }
  std::vector<Vec3> centres;
  std::vector<Box3> boxes;
  for (Index f = 0; f < faces_.size(); ++f) {
    boxes.push_back(faces_[f].bounds);
    if (std::hypot(faces_[f].normal.x, faces_[f].normal.y) == 0) continue;
    const std::array<Vec3, 3>& c = faces_[f].corners;
    steep_.push_back(f);
    centres.push_back((1.0 / 3) * (c[0] + c[1] + c[2]));
  }
  steep_centres_ = NearestPoint(std::move(centres));
  tree_ = arrangement::BoxTree(boxes);
  const double level = std::hypot(sum.x, sum.y);
  if (level > 0) strike_ = {-sum.y / level, sum.x / level};
}

bool FaultFaces::Face::is_further(const Vec3& p, double reach) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < bounds.min[i] - reach || p[i] > bounds.max[i] + reach) return true;
  return false;
}

std::pair<double, bool> FaultFaces::Face::distance(const Vec3& p) const {
  const double off = dot(p - corners[0], normal);
  const Vec3 foot = p - off * normal, n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  bool is_over = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
    is_over = is_over && dot(cross(b - a, foot - a), n) >= 0;
    nearest = std::min(nearest, norm(p - nearest_on_segment(p, a, b)));
  }
  constexpr double over_a_bend = 1.1;
  return is_over ? std::pair(std::abs(off), true) : std::pair(nearest, nearest <= over_a_bend * std::abs(off));
}

std::vector<Index> FaultFaces::faces_within(const Vec3& p, double reach) const {
  std::vector<Index> found;
  const Vec3 off{reach, reach, reach};
  Box3 box;
  box.add(p - off);
  box.add(p + off);
  tree_.boxes_meeting(box, [&](Index f) { found.push_back(f); });
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<Beside> FaultFaces::beside(const Vec3& p, double reach) const {
  if (steep_.empty() || !may_be_near(p, reach)) return std::nullopt;
  const double bound = faces_[steep_[steep_centres_.find(p)]].distance(p).first;
  const Face* nearest = nullptr;
  double least = reach;
  bool is_within = false;
  for (const Index row : faces_within(p, std::min(bound, reach))) {
    const Face& f = faces_[row];
    if (f.is_further(p, least) || std::hypot(f.normal.x, f.normal.y) == 0) continue;
    const auto [distance, is_over] = f.distance(p);
    if (distance >= least) continue;
    least = distance, nearest = &f, is_within = is_over;
  }
  if (nearest == nullptr) return std::nullopt;
  const Vec3& n = nearest->normal;
  const double level = std::hypot(n.x, n.y);
  return Beside{least,
                dot(p - nearest->corners[0], n) / level,
                strike_.x * p.x + strike_.y * p.y,
                {n.x / level, n.y / level},
                is_within};
}

bool FaultFaces::may_be_near(const Vec3& p, double reach) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] > bounds_.max[i] + reach || p[i] < bounds_.min[i] - reach) return false;
  return true;
}

}  // namespace geomesh::geomodel
