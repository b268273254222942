// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/star_fans.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace geomesh::recover {

namespace {

/// Triangulates a polygon in a projection, the roundest ear first. An ear is examined again only when a neighbour was
/// removed, or the vertex that was found in it. Each examination takes O(n) orientations for n vertices, and few ears
/// need more than one: O(n^2) in practice, O(n^3) at worst.
class EarClipping {
 public:
  EarClipping(const ConstrainedMesh& mesh, const std::vector<VertexIndex>& rim, std::size_t i, std::size_t j)
      : mesh_(mesh), i_(i), j_(j) {
    for (const VertexIndex v : rim) corners_.push_back({v});
    for (std::size_t k = 0; k < corners_.size(); ++k) look_at(k);
  }

  /// Returns the triangles; nothing if no ear is left, or the last triangle has the wrong orientation.
  std::optional<std::vector<Triangle>> run() {
    std::vector<Triangle> triangles;
    while (corners_.size() > 3) {
      const std::size_t k = find_ear();
      if (k == corners_.size()) return std::nullopt;
      triangles.push_back(ear(k));
      cut(k);
    }
    const Triangle last{corners_[0].vertex, corners_[1].vertex, corners_[2].vertex};
    if (!turns(last[0], last[1], last[2])) return std::nullopt;
    triangles.push_back(last);
    return triangles;
  }

 private:
  struct Corner {
    VertexIndex vertex;
    double shape = -1;  ///< quality of the triangle that is cut off at this corner of a polygon; negative if inverted
    VertexIndex found_inside = no_vertex;  ///< a polygon vertex inside the triangle that is cut off at the corner
  };

  Triangle ear(std::size_t k) const {
    const std::size_t n = corners_.size();
    return {corners_[(k + n - 1) % n].vertex, corners_[k].vertex, corners_[(k + 1) % n].vertex};
  }

  bool turns(VertexIndex a, VertexIndex b, VertexIndex c) const {
    return mesh_.orient_flat(a, b, c, i_, j_) == Sign::positive;
  }

  void look_at(std::size_t k) {
    const Triangle t = ear(k);
    corners_[k].shape = turns(t[0], t[1], t[2]) ? ear_shape(t[0], t[1], t[2]) : -1;
    corners_[k].found_inside = no_vertex;
  }

  /// Returns the corner with the roundest ear that contains no polygon vertex; the number of corners if there is none.
  std::size_t find_ear() {
    while (true) {
      std::size_t best = corners_.size();
      double best_shape = -1;
      for (std::size_t k = 0; k < corners_.size(); ++k)
        if (corners_[k].found_inside == no_vertex && corners_[k].shape > best_shape) {
          best_shape = corners_[k].shape;
          best = k;
        }
      if (best == corners_.size()) return best;
      corners_[best].found_inside = vertex_inside(ear(best));
      if (corners_[best].found_inside == no_vertex) return best;
    }
  }

  VertexIndex vertex_inside(const Triangle& ear) const {
    const auto is_beside = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
      return mesh_.orient_flat(a, b, c, i_, j_) != Sign::negative;
    };
    for (const Corner& corner : corners_) {
      const VertexIndex v = corner.vertex;
      if (v != ear[0] && v != ear[1] && v != ear[2] && is_beside(ear[0], ear[1], v) && is_beside(ear[1], ear[2], v) &&
          is_beside(ear[2], ear[0], v))
        return v;
    }
    return no_vertex;
  }

  void cut(std::size_t k) {
    const VertexIndex gone = corners_[k].vertex;
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(k));
    for (Corner& corner : corners_)
      if (corner.found_inside == gone) corner.found_inside = no_vertex;
    const std::size_t n = corners_.size();
    look_at((k + n - 1) % n);
    look_at(k % n);
  }

  double ear_shape(VertexIndex a, VertexIndex b, VertexIndex c) const {
    const Vec3 u = mesh_.offset(a, b), v = mesh_.offset(b, c), w = mesh_.offset(c, a);
    const Vec3 n = cross(u, v);
    return dot(n, n) / ((dot(u, u) + dot(v, v) + dot(w, w)) * (dot(u, u) + dot(v, v) + dot(w, w)));
  }

  const ConstrainedMesh& mesh_;
  std::size_t i_, j_;
  std::vector<Corner> corners_;
};

class FanSearch {
 public:
  FanSearch(Recovery& recovery, VertexIndex x, const std::vector<CellIndex>& star)
      : mesh_(recovery.mesh), constraints_(recovery.constraints), x_(x), star_(star) {}

  std::optional<StarFans> run() {
    if (!gather_segment() || !gather_fans() || !triangulate_fans()) return std::nullopt;
    return std::move(out_);
  }

 private:
  /// Collects the two subsegments of a model segment at x, if any, and their other ends. Returns false if the segment
  /// ends at x or more than one segment meets there.
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
    std::map<Index, std::pair<VertexIndex, VertexIndex>> rim_edge;  // per subfacet: directed edge opposite vertex x
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

  /// Triangulates, in the facet's main projection, the polygons that remain in facets when x is removed.
  bool triangulate_fans() {
    for (Fan& fan : out_.fans) {
      if (fan.is_thin()) continue;
      const Vec3 n = fan_normal(mesh_, x_, fan);
      const unsigned axis = std::fabs(n.x) >= std::fabs(n.y) && std::fabs(n.x) >= std::fabs(n.z) ? 0
                            : std::fabs(n.y) >= std::fabs(n.z)                                   ? 1
                                                                                                 : 2;
      const std::size_t i = (axis + (n[axis] > 0 ? 1u : 2u)) % 3, j = (axis + (n[axis] > 0 ? 2u : 1u)) % 3;
      auto triangles = EarClipping(mesh_, fan.rim, i, j).run();
      if (!triangles) return false;
      fan.triangles = std::move(*triangles);
    }
    return true;
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
