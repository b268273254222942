// SPDX-License-Identifier: MIT
/// Takes an added point off its segment or facet. The facets about it are triangulated again without it; each sector of its star between
/// the facets is filled again: without a point where that can be, else with a point moved from the old place into the sector.
///
/// For a facet's inner point the two sectors are the halves of its star. A moved point sees the sector's part of the link if it moves little,
/// and sees the facets' new triangles if it moves to the inner side of their planes; which step is small enough is decided by exact
/// tests. A sector that goes all the way round (the border of a facet that hangs in a region, a well) has no such side: there only
/// fillings without a point are tried.
#include <algorithm>
#include <cmath>
#include <map>

#include "recover/polyhedron_filling.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

namespace {

/// The subfacets of one facet about x between two hard segments, or all round x.
struct Fan {
  Index facet = no_index;
  std::vector<VertexIndex> rim;  ///< in the facet's orientation; closed by the edge from back to front
  std::vector<Index> subfacets;
  std::vector<Triangle> triangles;  ///< what replaces them
};

struct Sector {
  std::vector<CellIndex> cells;
  std::vector<Triangle> boundary;  ///< counter-clockwise seen from inside; without x
  Vec3 inward;                     ///< sum of the inner unit normals of the fans
  bool wraps_round = false;        ///< both sides of a fan
  std::vector<Tetrahedron> filling;
};

class PointRemoval {
 public:
  PointRemoval(Recovery& recovery, VertexIndex x) : recovery_(recovery), mesh_(recovery.mesh), constraints_(recovery.constraints), x_(x) {}

  bool run() {
    mesh_.star(x_, star_);
    for (CellIndex c : star_)
      if (mesh_.cells().is_ghost(c)) return false;
    if (!gather_segment() || !gather_fans() || !triangulate_fans()) return false;
    gather_sectors();
    const std::size_t n_points = mesh_.points().size();
    for (Sector& s : sectors_)
      if (!fill(s)) {
        while (mesh_.points().size() > n_points) mesh_.drop_last_point();
        constraints_.vertices.resize(n_points);
        return false;
      }
    commit();
    return true;
  }

 private:
  /// The two hard subsegments at x, if any, and what they join.
  bool gather_segment() {
    for (VertexIndex v : mesh_.neighbors(x_)) {
      const Index s = constraints_.subsegment_of(x_, v);
      if (s == no_index || constraints_.subsegments[s].segment == no_index) continue;
      halves_.push_back(s);
      ends_.push_back(v);
    }
    if (halves_.empty()) return true;
    return halves_.size() == 2 && constraints_.subsegments[halves_[0]].segment == constraints_.subsegments[halves_[1]].segment &&
           mesh_.find_edge(ends_[0], ends_[1]) == no_cell;
  }

  bool gather_fans() {
    std::map<Index, std::pair<VertexIndex, VertexIndex>> rim_edge;  // subfacet -> directed edge opposite x
    for (CellIndex c : star_)
      for (unsigned i = 0; i < 4; ++i) {
        if (!mesh_.is_locked(FaceRef(c, i)) || mesh_.cells().vertex(c, i) == x_) continue;
        std::array<VertexIndex, 3> v;
        for (unsigned k = 0; k < 3; ++k) v[k] = mesh_.cells().vertex(c, face_vertices[i][k]);
        const Index f = constraints_.subfacet_of(v[0], v[1], v[2]);
        if (f == no_index) return false;
        const Triangle& t = constraints_.subfacets[f].vertices;
        const unsigned k = t[0] == x_ ? 0 : t[1] == x_ ? 1 : 2;
        rim_edge[f] = {t[(k + 1) % 3], t[(k + 2) % 3]};
      }
    while (!rim_edge.empty()) {
      Fan fan;
      const Index first = start_of_fan(rim_edge);
      fan.facet = constraints_.subfacets[first].facet;
      fan.rim.push_back(rim_edge[first].first);
      Index f = first;
      while (f != no_index) {
        const VertexIndex last = rim_edge[f].second;
        fan.subfacets.push_back(f);
        rim_edge.erase(f);
        if (last == fan.rim.front()) break;
        fan.rim.push_back(last);
        f = is_end(last) ? no_index : next_in_fan(rim_edge, fan.facet, last);
      }
      if (fan.rim.size() < 3) return false;
      const bool is_closed = !is_end(fan.rim.front()) || !is_end(fan.rim.back());
      if (is_closed != halves_.empty()) return false;
      fans_.push_back(std::move(fan));
    }
    return true;
  }
  bool is_end(VertexIndex v) const { return std::find(ends_.begin(), ends_.end(), v) != ends_.end(); }
  Index start_of_fan(const std::map<Index, std::pair<VertexIndex, VertexIndex>>& rim_edge) const {
    for (const auto& [f, e] : rim_edge)
      if (is_end(e.first)) return f;
    return rim_edge.begin()->first;
  }
  Index next_in_fan(const std::map<Index, std::pair<VertexIndex, VertexIndex>>& rim_edge, Index facet, VertexIndex from) const {
    for (const auto& [f, e] : rim_edge)
      if (e.first == from && constraints_.subfacets[f].facet == facet) return f;
    return no_index;
  }

  Vec3 fan_normal(const Fan& fan) const {
    Vec3 n;
    const Vec3& o = mesh_.point(x_);
    for (std::size_t i = 0; i < fan.rim.size(); ++i)
      n = n + cross(mesh_.point(fan.rim[i]) - o, mesh_.point(fan.rim[(i + 1) % fan.rim.size()]) - o);
    return n;
  }
  /// The rim polygon by ears that turn the right way in the facet's main projection, the roundest ear first.
  bool triangulate_fans() {
    for (Fan& fan : fans_) {
      const Vec3 n = fan_normal(fan);
      const unsigned axis = std::fabs(n.x) >= std::fabs(n.y) && std::fabs(n.x) >= std::fabs(n.z) ? 0 : std::fabs(n.y) >= std::fabs(n.z) ? 1 : 2;
      const auto flat = [&](VertexIndex v) {
        const Vec3& p = mesh_.point(v);
        const Vec2 q{p[(axis + 1) % 3], p[(axis + 2) % 3]};
        return n[axis] > 0 ? q : Vec2{q.y, q.x};
      };
      std::vector<VertexIndex> rim = fan.rim;
      while (rim.size() > 3) {
        std::size_t best = rim.size();
        double best_shape = -1;
        for (std::size_t i = 0; i < rim.size(); ++i) {
          const VertexIndex a = rim[(i + rim.size() - 1) % rim.size()], b = rim[i], c = rim[(i + 1) % rim.size()];
          if (orient2d(flat(a), flat(b), flat(c)) != Sign::positive || holds_other(rim, a, b, c, flat)) continue;
          const double shape = ear_shape(a, b, c);
          if (shape > best_shape) {
            best_shape = shape;
            best = i;
          }
        }
        if (best == rim.size()) return false;
        fan.triangles.push_back({rim[(best + rim.size() - 1) % rim.size()], rim[best], rim[(best + 1) % rim.size()]});
        rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(best));
      }
      if (orient2d(flat(rim[0]), flat(rim[1]), flat(rim[2])) != Sign::positive) return false;
      fan.triangles.push_back({rim[0], rim[1], rim[2]});
    }
    return true;
  }
  template <class Flat>
  static bool holds_other(const std::vector<VertexIndex>& rim, VertexIndex a, VertexIndex b, VertexIndex c, const Flat& flat) {
    return std::any_of(rim.begin(), rim.end(), [&](VertexIndex v) {
      return v != a && v != b && v != c && orient2d(flat(a), flat(b), flat(v)) != Sign::negative &&
             orient2d(flat(b), flat(c), flat(v)) != Sign::negative && orient2d(flat(c), flat(a), flat(v)) != Sign::negative;
    });
  }
  double ear_shape(VertexIndex a, VertexIndex b, VertexIndex c) const {
    const Vec3 u = mesh_.point(b) - mesh_.point(a), v = mesh_.point(c) - mesh_.point(b), w = mesh_.point(a) - mesh_.point(c);
    const Vec3 n = cross(u, v);
    return dot(n, n) / ((dot(u, u) + dot(v, v) + dot(w, w)) * (dot(u, u) + dot(v, v) + dot(w, w)));
  }

  void gather_sectors() {
    std::map<Index, std::size_t> fan_of;
    for (std::size_t i = 0; i < fans_.size(); ++i)
      for (Index f : fans_[i].subfacets) fan_of[f] = i;
    std::vector<CellIndex> left(star_);
    std::sort(left.begin(), left.end());
    while (!left.empty()) {
      Sector s;
      s.cells.push_back(left.front());
      left.erase(left.begin());
      std::map<std::size_t, unsigned> sides;  // fan -> bit 1: the sector is above it, bit 2: below
      for (std::size_t i = 0; i < s.cells.size(); ++i) extend(s, s.cells[i], left, sides, fan_of);
      for (const auto& [fan, side] : sides) add_fan(s, fans_[fan], side);
      sectors_.push_back(std::move(s));
    }
  }
  void extend(Sector& s, CellIndex c, std::vector<CellIndex>& left, std::map<std::size_t, unsigned>& sides,
              const std::map<Index, std::size_t>& fan_of) {
    const TetMesh& cells = mesh_.cells();
    for (unsigned i = 0; i < 4; ++i) {
      Triangle t;
      for (unsigned k = 0; k < 3; ++k) t[k] = cells.vertex(c, face_vertices[i][k]);
      if (cells.vertex(c, i) == x_) {
        s.boundary.push_back(t);
      } else if (mesh_.is_locked(FaceRef(c, i))) {
        const Index f = constraints_.subfacet_of(t[0], t[1], t[2]);
        const Triangle& v = constraints_.subfacets[f].vertices;
        const bool same = (v[0] == t[0] && v[1] == t[1]) || (v[0] == t[1] && v[1] == t[2]) || (v[0] == t[2] && v[1] == t[0]);
        sides[fan_of.at(f)] |= same ? 1u : 2u;
      } else {
        const auto it = std::lower_bound(left.begin(), left.end(), cells.neighbor_cell(c, i));
        if (it == left.end() || *it != cells.neighbor_cell(c, i)) continue;
        s.cells.push_back(*it);
        left.erase(it);
      }
    }
  }
  void add_fan(Sector& s, const Fan& fan, unsigned side) const {
    const Vec3 n = fan_normal(fan);
    const Vec3 unit = (1 / std::sqrt(dot(n, n))) * n;
    if (side & 1u) {
      s.inward = s.inward + unit;
      s.boundary.insert(s.boundary.end(), fan.triangles.begin(), fan.triangles.end());
    }
    if (side & 2u) {
      s.inward = s.inward - unit;
      for (const Triangle& t : fan.triangles) s.boundary.push_back({t[0], t[2], t[1]});
    }
    s.wraps_round = s.wraps_round || side == 3u;
  }

  bool fill(Sector& s) {
    std::vector<VertexIndex> corners;
    for (const Triangle& t : s.boundary) corners.insert(corners.end(), t.begin(), t.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (!s.wraps_round) {
      for (VertexIndex v : corners) {
        auto fan = fan_from(mesh_, constraints_, s.boundary, v);
        if (!fan || !has_segment(*fan)) continue;
        s.filling = std::move(*fan);
        return true;
      }
    }
    if (!fans_.empty() || halves_.empty()) {
      auto filling = fill_polyhedron(mesh_, constraints_, s.boundary);
      if (filling && has_segment(*filling)) {
        s.filling = std::move(*filling);
        return true;
      }
    }
    return !s.wraps_round && fill_about_moved_point(s, corners);
  }
  /// A well has no facet that would bring its segment along.
  bool has_segment(const std::vector<Tetrahedron>& filling) const {
    if (halves_.empty() || !fans_.empty()) return true;
    return std::any_of(filling.begin(), filling.end(), [&](const Tetrahedron& t) {
      return std::count_if(t.begin(), t.end(), [&](VertexIndex v) { return is_end(v); }) == 2;
    });
  }
  bool fill_about_moved_point(Sector& s, const std::vector<VertexIndex>& corners) {
    if (s.inward == Vec3{} || fans_.empty()) return false;
    const Vec3 direction = (1 / std::sqrt(dot(s.inward, s.inward))) * s.inward;
    const Vec3 origin = mesh_.point(x_);
    double reach = 0;
    for (VertexIndex v : corners) reach = std::max(reach, std::fabs(dot(mesh_.point(v) - origin, direction)));
    const VertexIndex moved = mesh_.add_point(origin);
    constraints_.vertices.resize(mesh_.points().size(), {VertexOrigin::inside, no_index});
    for (double step = reach / 2; step > reach * 1e-15; step /= 2) {
      mesh_.move_point(moved, origin + step * direction);
      auto fan = fan_from(mesh_, constraints_, s.boundary, moved);
      if (!fan) continue;
      s.filling = std::move(*fan);
      return true;
    }
    mesh_.drop_last_point();
    constraints_.vertices.pop_back();
    return false;
  }

  void commit() {
    std::vector<Tetrahedron> filling;
    for (const Sector& s : sectors_) filling.insert(filling.end(), s.filling.begin(), s.filling.end());
    mesh_.replace(star_, filling);
    mesh_.forget(x_);
    if (!halves_.empty()) {
      const Index segment = constraints_.subsegments[halves_[0]].segment;
      constraints_.add_subsegment(ends_[0], ends_[1], segment, no_index);
    }
    for (const Fan& fan : fans_)
      for (const Triangle& t : fan.triangles) {
        constraints_.add_subfacet(t, fan.facet);
        mesh_.lock(mesh_.find_face(t[0], t[1], t[2]));
      }
    for (const Fan& fan : fans_)
      for (Index f : fan.subfacets) constraints_.remove_subfacet(f);
    for (Index s : halves_) constraints_.remove_subsegment(s);
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Constraints& constraints_;
  VertexIndex x_;
  std::vector<CellIndex> star_;
  std::vector<Index> halves_;
  std::vector<VertexIndex> ends_;
  std::vector<Fan> fans_;
  std::vector<Sector> sectors_;
};

}  // namespace

bool take_point_off_boundary(Recovery& recovery, VertexIndex x) { return PointRemoval(recovery, x).run(); }

}  // namespace geomesh::recover
