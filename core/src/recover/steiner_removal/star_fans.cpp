// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/star_fans.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace geomesh::recover {

namespace {

class FanSearch {
 public:
  FanSearch(Recovery& recovery, VertexIndex x, const std::vector<CellIndex>& star)
      : mesh_(recovery.mesh), constraints_(recovery.constraints), x_(x), star_(star) {}

  std::optional<StarFans> run() {
    if (!gather_segment() || !gather_fans() || !triangulate_fans()) return std::nullopt;
    return std::move(out_);
  }

 private:
  /// The two hard subsegments at x, if any, and what they join.
  bool gather_segment() {
    for (VertexIndex v : mesh_.neighbors(x_)) {
      const Index s = constraints_.subsegment_of(x_, v);
      if (s == no_index || constraints_.subsegments[s].segment == no_index) continue;
      out_.halves.push_back(s);
      out_.ends.push_back(v);
    }
    if (out_.halves.empty()) return true;
    return out_.halves.size() == 2 &&
           constraints_.subsegments[out_.halves[0]].segment == constraints_.subsegments[out_.halves[1]].segment;
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
        f = out_.is_end(last) ? no_index : next_in_fan(rim_edge, fan.facet, last);
      }
      fan.is_closed = !out_.is_end(fan.rim.front()) || !out_.is_end(fan.rim.back());
      if (fan.rim.size() < 3 && fan.is_closed) return false;
      if (fan.is_closed != out_.halves.empty()) return false;
      out_.fans.push_back(std::move(fan));
    }
    return true;
  }
  Index start_of_fan(const std::map<Index, std::pair<VertexIndex, VertexIndex>>& rim_edge) const {
    for (const auto& [f, e] : rim_edge)
      if (out_.is_end(e.first)) return f;
    return rim_edge.begin()->first;
  }
  Index next_in_fan(const std::map<Index, std::pair<VertexIndex, VertexIndex>>& rim_edge, Index facet,
                    VertexIndex from) const {
    for (const auto& [f, e] : rim_edge)
      if (e.first == from && constraints_.subfacets[f].facet == facet) return f;
    return no_index;
  }

  /// The rim polygon by ears that turn the right way in the facet's main projection, the roundest ear first.
  bool triangulate_fans() {
    for (Fan& fan : out_.fans) {
      if (fan.is_thin()) continue;
      const Vec3 n = fan_normal(mesh_, x_, fan);
      const unsigned axis = std::fabs(n.x) >= std::fabs(n.y) && std::fabs(n.x) >= std::fabs(n.z) ? 0
                            : std::fabs(n.y) >= std::fabs(n.z)                                   ? 1
                                                                                                 : 2;
      const std::size_t i = (axis + (n[axis] > 0 ? 1u : 2u)) % 3, j = (axis + (n[axis] > 0 ? 2u : 1u)) % 3;
      const auto turn = [&](VertexIndex a, VertexIndex b, VertexIndex c) { return mesh_.orient_flat(a, b, c, i, j); };
      std::vector<VertexIndex> rim = fan.rim;
      while (rim.size() > 3) {
        std::size_t best = rim.size();
        double best_shape = -1;
        for (std::size_t k = 0; k < rim.size(); ++k) {
          const VertexIndex a = rim[(k + rim.size() - 1) % rim.size()], b = rim[k], c = rim[(k + 1) % rim.size()];
          if (turn(a, b, c) != Sign::positive || holds_other(rim, {a, b, c}, turn)) continue;
          const double shape = ear_shape(a, b, c);
          if (shape > best_shape) {
            best_shape = shape;
            best = k;
          }
        }
        if (best == rim.size()) return false;
        fan.triangles.push_back({rim[(best + rim.size() - 1) % rim.size()], rim[best], rim[(best + 1) % rim.size()]});
        rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(best));
      }
      if (turn(rim[0], rim[1], rim[2]) != Sign::positive) return false;
      fan.triangles.push_back({rim[0], rim[1], rim[2]});
    }
    return true;
  }
  template <class Turn>
  static bool holds_other(const std::vector<VertexIndex>& rim, const Triangle& ear, const Turn& turn) {
    return std::any_of(rim.begin(), rim.end(), [&](VertexIndex v) {
      return v != ear[0] && v != ear[1] && v != ear[2] && turn(ear[0], ear[1], v) != Sign::negative &&
             turn(ear[1], ear[2], v) != Sign::negative && turn(ear[2], ear[0], v) != Sign::negative;
    });
  }
  double ear_shape(VertexIndex a, VertexIndex b, VertexIndex c) const {
    const Vec3 u = mesh_.offset(a, b), v = mesh_.offset(b, c), w = mesh_.offset(c, a);
    const Vec3 n = cross(u, v);
    return dot(n, n) / ((dot(u, u) + dot(v, v) + dot(w, w)) * (dot(u, u) + dot(v, v) + dot(w, w)));
  }

  ConstrainedMesh& mesh_;
  const Constraints& constraints_;
  VertexIndex x_;
  const std::vector<CellIndex>& star_;
  StarFans out_;
};

}  // namespace

std::optional<StarFans> find_star_fans(Recovery& recovery, VertexIndex x, const std::vector<CellIndex>& star) {
  return FanSearch(recovery, x, star).run();
}

Vec3 fan_normal(const ConstrainedMesh& mesh, VertexIndex x, const Fan& fan) {
  Vec3 n;
  const std::size_t size = fan.rim.size();
  for (std::size_t i = 0; i < size; ++i)
    n = n + cross(mesh.offset(x, fan.rim[i]), mesh.offset(x, fan.rim[(i + 1) % size]));
  return n;
}

}  // namespace geomesh::recover
