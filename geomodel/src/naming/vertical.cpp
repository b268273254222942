// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the horizons directly above and below a point, declared in naming/column.hpp.
#include <limits>

#include "geomesh/core/predicates.hpp"
#include "naming/column.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the height of the triangle a b c at the map position of p, if p lies in the triangle's projection. Inclusion
/// is decided exactly, the height is rounded.
double height_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const auto map = [](const Vec3& q) { return Vec2{q.x, q.y}; };
  bool positive = false, negative = false;
  for (const auto& [s, t] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
    const Sign side = orient2d(map(*s), map(*t), map(p));
    positive = positive || side == Sign::positive;
    negative = negative || side == Sign::negative;
  }
  if (positive == negative) return std::numeric_limits<double>::quiet_NaN();
  const Vec3 n = cross(b - a, c - a);
  return a.z - (n.x * (p.x - a.x) + n.y * (p.y - a.y)) / n.z;
}

class Nearest {
 public:
  explicit Nearest(const Vec3& p) : p_(p) {}
  /// If several horizons coincide above the point, the oldest of them bounds its unit; if they coincide below it, the
  /// youngest does.
  void look_at(Index horizon, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double z = height_at(a, b, c, p_);
    if (z >= p_.z && (z < over_ || (z == over_ && horizon > above_))) over_ = z, above_ = horizon;
    if (z < p_.z && (z > under_ || (z == under_ && horizon < below_))) under_ = z, below_ = horizon;
  }
  bool found() const { return above_ != no_index || below_ != no_index; }
  HorizonContacts contacts() const {
    HorizonContacts contacts;
    if (above_ != no_index) contacts.lies_below[above_] = 1;
    if (below_ != no_index) contacts.lies_above[below_] = 1;
    return contacts;
  }

 private:
  Vec3 p_;
  double over_ = std::numeric_limits<double>::infinity(), under_ = -over_;
  Index above_ = no_index, below_ = no_index;
};

}  // namespace

HorizonContacts contacts_on_vertical(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                     const Column& column, const Vec3& p) {
  std::map<Index, Index> row;  // for each horizon's surface, its index in the column
  for (Index h = 0; h < column.horizons.size(); ++h) row[column.horizons[h]] = h;
  Nearest nearest(p);
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k) {
      const auto horizon = row.find(soup.origins[k].surface);
      const Triangle& t = soup.facets[f];
      if (horizon != row.end())
        nearest.look_at(horizon->second, soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    }
  if (nearest.found()) return nearest.contacts();
  for (const auto& [surface, horizon] : row)
    for (const Triangle& t : surfaces[surface].triangles)
      nearest.look_at(horizon, surfaces[surface].points[t[0]], surfaces[surface].points[t[1]],
                      surfaces[surface].points[t[2]]);
  return nearest.contacts();
}

}  // namespace geomesh::geomodel
