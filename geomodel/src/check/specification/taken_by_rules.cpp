// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/specification/taken_by_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "check/exact/deviation.hpp"
#include "check/exact/vertical_line.hpp"

namespace geomesh::geomodel::checking {
TakenByRules::TakenByRules(const Specification& specification, double room)
    : specification_(specification), room_(room) {
  for (const TriangulatedSurface& s : specification.surfaces) trees_.push_back(tree_over_triangles(s));
  for (const TriangulatedSurface& s : specification.surfaces) {
    Vec3& up = upward_.emplace_back();
    for (const Triangle& t : s.triangles) {
      const Vec3 n = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
      up = n.z < 0 ? up - n : up + n;
    }
  }
}

bool TakenByRules::is_outside(const Vec3& p) const {
  if (!specification_.volume) return false;
  const Box3& box = specification_.volume->bounds;
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < box.min[i] + room_ || p[i] > box.max[i] - room_) return true;
  if (specification_.volume->box) return false;
  const auto& sides = specification_.volume->sides;
  bool inside = false;
  for (std::size_t i = 0; i + 2 < sides.size(); ++i) {  // the last two sides of a model volume are its bottom and top
    const Vec3 &a = sides[i].points[0], &b = sides[i].points[1];
    const double t = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) /
                                    std::max((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y), 1e-300),
                                0.0, 1.0);
    if (std::hypot(p.x - a.x - t * (b.x - a.x), p.y - a.y - t * (b.y - a.y)) <= room_) return true;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return !inside;
}

/// Returns whether a fault of the input crosses the vertical line between p and the height z, farther than `room_` from
/// both.
bool TakenByRules::is_fault_between(const Vec3& p, double z) const {
  bool is_between = false;
  for (Index s = 0; s < specification_.surfaces.size() && !is_between; ++s) {
    if (specification_.surfaces[s].kind != SurfaceKind::fault) continue;
    for_each_height(specification_.surfaces[s], trees_[s], p, 0, [&](Index, double at) {
      is_between = is_between || (at > std::min(p.z, z) + room_ && at < std::max(p.z, z) - room_);
    });
  }
  return is_between;
}

/// Returns whether p is above (below) the other surface, compared along the vertical line through p; if the other
/// surface is not on that line, compared with its nearest point.
bool TakenByRules::is_beyond(Index other, const Vec3& p, bool above, Heights heights) const {
  const TriangulatedSurface& cutter = specification_.surfaces[other];
  bool any = false, beyond = false;
  for_each_height(cutter, trees_[other], p, room_, [&](Index, double z) {
    any = true;
    beyond = beyond || ((above ? p.z >= z - room_ : p.z <= z + room_) &&
                        !(heights == Heights::of_one_block && is_fault_between(p, z)));
  });
  if (any) return beyond;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : cutter.triangles) {
    const Vec3 q = nearest_on_triangle(p, {cutter.points[t[0]], cutter.points[t[1]], cutter.points[t[2]]});
    const double distance = dot(q - p, q - p);
    if (distance >= nearest) continue;
    nearest = distance;
    beyond = above ? p.z >= q.z - room_ : p.z <= q.z + room_;
  }
  return beyond;
}

bool TakenByRules::is_near_another(Index surface, const Vec3& p, double distance, bool faults_alone) const {
  for (Index other = 0; other < specification_.surfaces.size(); ++other) {
    const TriangulatedSurface& s = specification_.surfaces[other];
    if (other == surface || (faults_alone && s.kind != SurfaceKind::fault)) continue;
    bool near = false;
    trees_[other].query(inflated(box_of(p, p, p), distance), [&](Index t) {
      const Triangle& v = s.triangles[t];
      const Vec3 d = nearest_on_triangle(p, {s.points[v[0]], s.points[v[1]], s.points[v[2]]}) - p;
      near = near || dot(d, d) <= distance * distance;
    });
    if (near) return true;
  }
  return false;
}

bool TakenByRules::is_beyond_cutters(Index surface, const Vec3& p, Heights heights) const {
  if (!specification_.may_be_trimmed(surface)) return false;
  const auto beyond = [&](const std::vector<Index>& rows, bool above) {
    return std::any_of(rows.begin(), rows.end(), [&](Index row) {
      const bool are_horizons = specification_.surfaces[surface].kind == SurfaceKind::horizon &&
                                specification_.surfaces[row].kind == SurfaceKind::horizon;
      return is_beyond(row, p, above, are_horizons ? heights : Heights::of_all_blocks);
    });
  };
  return beyond(specification_.trims[surface].above, true) || beyond(specification_.trims[surface].below, false);
}

bool TakenByRules::is_beyond_cutters(Index surface, const Vec3& p) const {
  return is_beyond_cutters(surface, p, Heights::of_one_block);
}

bool TakenByRules::is_above_fault(Index fault, const Vec3& p) const {
  const TriangulatedSurface& s = specification_.surfaces[fault];
  double nearest = std::numeric_limits<double>::infinity(), height = 0;
  const auto visit = [&](Index t) {
    const Vec3 &a = s.points[s.triangles[t][0]], &b = s.points[s.triangles[t][1]], &c = s.points[s.triangles[t][2]];
    const Vec3 d = p - nearest_on_triangle(p, {a, b, c});
    if (dot(d, d) >= nearest) return;
    nearest = dot(d, d);
    const Vec3 n = cross(b - a, c - a);
    height = dot(n, upward_[fault]) < 0 ? -dot(n, p - a) : dot(n, p - a);
  };
  // Doubles the search distance until the nearest triangle of the fault that it finds must be the nearest of all.
  Box3 bounds;
  for (const Vec3& q : s.points) bounds.add(q);
  const Vec3 size = bounds.max - bounds.min, away = p - bounds.min;
  const double widest = std::sqrt(dot(size, size)) + std::sqrt(dot(away, away));
  for (double reach = std::max(room_, widest / 256);; reach *= 2) {
    trees_[fault].query(inflated(box_of(p, p, p), reach), visit);
    if (nearest <= reach * reach || reach > widest) return height > 0;
  }
}

/// Returns whether p is outside the fault block in which the scalar field that made its triangle is valid, or near a
/// fault that bounds the block.
bool TakenByRules::is_outside_domain(Index surface, Index triangle, const Vec3& p) const {
  const std::vector<FieldPart>& fields = specification_.trims[surface].fields;
  const auto part = std::find_if(fields.begin(), fields.end(), [&](const FieldPart& f) { return triangle < f.end; });
  if (part == fields.end()) return false;
  if (is_near_another(surface, p, room_, true)) return true;
  for (Index s = 0; s < specification_.surfaces.size(); ++s) {
    if (specification_.surfaces[s].kind != SurfaceKind::fault || specification_.surfaces[s].triangles.empty()) continue;
    std::optional<bool> side;
    if (part->block) side = is_above_fault(s, *part->block);
    for (const auto& [name, is_above] : part->sides)
      if (name == specification_.surfaces[s].name) side = is_above;
    if (side && is_above_fault(s, p) != *side) return true;
  }
  return false;
}

bool TakenByRules::may_be_away(Index surface, Index triangle, const Vec3& p) const {
  const bool has_throw = specification_.may_be_trimmed(surface) && specification_.trims[surface].given_beyond_faults;
  return has_throw || may_be_away_but_for_throw(surface, triangle, p);
}

bool TakenByRules::may_be_away_but_for_throw(Index surface, Index triangle, const Vec3& p) const {
  if (is_outside(p)) return true;
  if (!specification_.may_be_trimmed(surface)) return false;
  const TrimRules& trim = specification_.trims[surface];
  if (trim.continuation && triangle >= trim.n_given_triangles) return true;
  return is_beyond_cutters(surface, p, Heights::of_all_blocks) || is_outside_domain(surface, triangle, p) ||
         (trim.near_others > 0 && is_near_another(surface, p, trim.near_others + room_, false)) ||
         (trim.near_faults > 0 && is_near_another(surface, p, trim.near_faults + room_, true));
}

}  // namespace geomesh::geomodel::checking
