// SPDX-License-Identifier: MIT
#include "search/cover_proof.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/geometry.hpp"

namespace geomesh::search {

namespace {

using Polygon = std::vector<Vec3>;

constexpr std::size_t few = 24;      ///< a triangle with more of the set's triangles near it is halved before it is cut
constexpr std::size_t most_cut = 4;  ///< number of nearest triangles along whose sides a piece of a triangle may be cut
/// A triangle may be cut into pieces_besides pieces, and pieces_per_item more for each triangle of the set near it.
constexpr std::size_t pieces_per_item = 8;
constexpr std::size_t pieces_besides = 200;
constexpr double least_piece =
    1.0 / 64;  ///< pieces of a triangle with a smaller radius, as a share of the distance limit, are not halved
/// corners of a piece of a triangle that are nearer to a cutting plane than this share of its radius count as on it
constexpr double on_plane = 1e-9;

double distance_to(const Vec3& p, const PreparedTriangle* t) { return distance(p, t->closest_to(p)); }

bool is_line(const Corners& c) { return c[1] == c[2]; }

template <class Points>
Vec3 middle_of(const Points& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

template <class Points>
double radius_about(const Vec3& centre, const Points& points) {
  double r = 0;
  for (const Vec3& p : points) r = std::max(r, distance(centre, p));
  return r;
}

struct Plane {
  Vec3 point, normal;  ///< a point of the cutting plane; its unit normal, towards the triangle whose side lies in it
};

/// Returns planes perpendicular to a triangle through its sides (perpendicular to a line segment through its ends).
/// Returns none for a triangle without height.
std::vector<Plane> planes_on_sides(const Corners& t) {
  std::vector<Plane> planes;
  if (is_line(t)) {
    if (t[0] == t[1]) return planes;
    const Vec3 along = unit(t[1] - t[0]);
    return {{t[0], along}, {t[1], -1.0 * along}};
  }
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
  if (!(length(n) > 1e-9 * longest * longest)) return planes;
  for (std::size_t i = 0; i < 3; ++i) planes.push_back({t[i], unit(cross(n, t[(i + 1) % 3] - t[i]))});
  return planes;
}

struct Cut {
  Polygon over, beyond;
};

/// Divides a convex polygon (or a line, given by two points) into its parts on both sides of the plane. Points within
/// `tiny` of the plane belong to both parts. A part that consists of such points only is empty.
Cut cut(const Polygon& polygon, const Plane& plane, double tiny) {
  Cut parts;
  bool is_over = false, is_beyond = false;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % n];
    const double s = dot(p - plane.point, plane.normal), t = dot(q - plane.point, plane.normal);
    if (s >= -tiny) parts.over.push_back(p);
    if (s <= tiny) parts.beyond.push_back(p);
    is_over |= s > tiny;
    is_beyond |= s < -tiny;
    if ((s > tiny && t < -tiny) || (s < -tiny && t > tiny)) {
      const Vec3 between = p + (s / (s - t)) * (q - p);
      parts.over.push_back(between);
      parts.beyond.push_back(between);
    }
  }
  if (!is_over) parts.over.clear();
  if (!is_beyond) parts.beyond.clear();
  return parts;
}

/// Divides a triangle or line segment into two halves at the midpoint of its longest side.
std::array<Corners, 2> halves(const Corners& t) {
  std::size_t a = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (distance(t[i], t[(i + 1) % 3]) > distance(t[a], t[(a + 1) % 3])) a = i;
  const std::size_t b = (a + 1) % 3;
  const Vec3 middle = 0.5 * (t[a] + t[b]);
  if (is_line(t)) return {Corners{t[0], middle, middle}, Corners{middle, t[1], t[1]}};
  std::array<Corners, 2> parts{t, t};
  parts[0][b] = middle;
  parts[1][a] = middle;
  return parts;
}

}  // namespace

void CoverProver::look_at(const Vec3& p, double distance) {
  if (distance > cover_.farthest) cover_.farthest = distance, cover_.place = p;
}

bool CoverProver::fails_at(const Vec3& p, double distance) {
  look_at(p, distance);
  cover_.place = p;
  return false;
}

Cover CoverProver::judge(const Corners& item, Index group) {
  if (group_ != group) distances_.clear();
  group_ = group;
  cover_ = {};
  for (const Vec3& p : {item[0], item[1], item[2], 0.5 * (item[0] + item[1]), 0.5 * (item[1] + item[2]),
                        0.5 * (item[2] + item[0]), middle_of(item)})
    look_at(p, distances_.at(p, [&](const auto&) { return set_.closest(p, group).distance; }));
  if (cover_.farthest <= limit_) cover_.is_proven = is_over_sheet(item) || covers_all(item);
  return cover_;
}

bool CoverProver::covers_all(const Corners& item) {
  std::size_t n_about = 0;
  set_.for_each_row_in(box_about(item, limit_), group_, [&](Index) { ++n_about; });
  halves_left_ = pieces_besides + pieces_per_item * n_about;
  return covers_large(item);
}

bool CoverProver::is_over_sheet(const Corners& item) const {
  SheetProof proof(item, limit_);
  if (open_edges_.empty() || !proof.is_possible()) return false;
  bool has_border = false;
  set_.for_each_row_in(box_about(item, limit_), group_, [&](Index row) {
    if (!has_border) has_border = proof.judge({&set_.prepared(row), open_edges_[row]}) == Over::border;
  });
  return !has_border && proof.is_proven();
}

bool CoverProver::covers_large(const Corners& item) {
  const Vec3 centre = middle_of(item);
  const double r = radius_about(centre, item);
  double d = std::numeric_limits<double>::infinity();
  near_.clear();
  set_.for_each_row_in(box_about(item, limit_), group_, [&](Index row) {
    const PreparedTriangle& other = set_.prepared(row);
    const double from_centre = distance_to(centre, &other);
    d = std::min(d, from_centre);
    if (from_centre <= limit_ + r) near_.push_back(&other);
  });
  if (near_.size() > few) {
    look_at(centre, d);
    if (d + r <= limit_) return true;
    if (d > limit_) return fails_at(centre, d);
    // The piece of a triangle is proven if a single triangle of the set is within the limit of all its corners.
    const bool is_small = r <= least_piece * limit_;
    const auto has_all = [&](const PreparedTriangle* other) {
      return std::all_of(item.begin(), item.end(), [&](const Vec3& p) { return distance_to(p, other) <= limit_; });
    };
    if (std::any_of(near_.begin(), near_.end(), has_all)) return true;
    if (is_small) return fails_at(centre, d);
    if (halves_left_ == 0) return fails_at(centre, d);
    --halves_left_;
    const auto parts = halves(item);
    return covers_large(parts[0]) && covers_large(parts[1]);
  }
  std::vector<Index> rows(near_.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  pieces_left_ = pieces_besides + pieces_per_item * near_.size();
  return covers(is_line(item) ? Polygon{item[0], item[1]} : Polygon(item.begin(), item.end()), std::move(rows));
}

bool CoverProver::covers(const Polygon& piece, std::vector<Index> rows) {
  const Vec3 centre = middle_of(piece);
  const double radius = radius_about(centre, piece);
  std::vector<double> at_centre(near_.size());
  for (const Index row : rows) at_centre[row] = distance_to(centre, near_[row]);
  std::erase_if(rows, [&](Index row) { return at_centre[row] > limit_ + radius; });
  std::sort(rows.begin(), rows.end(),
            [&](Index a, Index b) { return at_centre[a] != at_centre[b] ? at_centre[a] < at_centre[b] : a < b; });
  if (rows.empty() || at_centre[rows[0]] > limit_) return fails_at(centre, set_.closest(centre, group_).distance);
  look_at(centre, at_centre[rows[0]]);
  if (at_centre[rows[0]] + radius <= limit_) return true;
  std::vector<std::size_t> n_corners(near_.size(), 0);
  for (const Vec3& p : piece) {
    bool is_near = false;
    for (const Index row : rows)
      if (distance_to(p, near_[row]) <= limit_) ++n_corners[row], is_near = true;
    if (!is_near) return fails_at(p, set_.closest(p, group_).distance);
  }
  if (std::any_of(rows.begin(), rows.end(), [&](Index row) { return n_corners[row] == piece.size(); })) return true;
  if (pieces_left_ == 0 || radius <= least_piece * limit_) return fails_at(centre, at_centre[rows[0]]);
  --pieces_left_;
  return covers_by_cuts(piece, rows);
}

bool CoverProver::covers_by_cuts(const Polygon& piece, const std::vector<Index>& rows) {
  const double tiny = on_plane * radius_about(middle_of(piece), piece);
  for (std::size_t k = 0; k < std::min(rows.size(), most_cut); ++k) {
    std::vector<Polygon> parts;
    Polygon rest = piece;
    for (const Plane& plane : planes_on_sides(near_[rows[k]]->corners())) {
      Cut both = cut(rest, plane, tiny);
      if (!both.beyond.empty()) parts.push_back(std::move(both.beyond));
      rest = std::move(both.over);
      if (rest.empty()) break;
    }
    if (rest.empty() || parts.empty()) continue;
    parts.push_back(std::move(rest));
    return std::all_of(parts.begin(), parts.end(), [&](const Polygon& part) { return covers(part, rows); });
  }
  return covers_halves(piece, rows);
}

bool CoverProver::covers_halves(const Polygon& piece, const std::vector<Index>& rows) {
  const Vec3 centre = middle_of(piece);
  const Vec3 farthest = *std::max_element(piece.begin(), piece.end(), [&](const Vec3& p, const Vec3& q) {
    return distance(centre, p) < distance(centre, q);
  });
  const double radius = distance(centre, farthest);
  const Cut parts = cut(piece, {centre, (1 / radius) * (farthest - centre)}, on_plane * radius);
  return covers(parts.over, rows) && covers(parts.beyond, rows);
}

}  // namespace geomesh::search
