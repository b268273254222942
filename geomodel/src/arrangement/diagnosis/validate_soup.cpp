// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a polygon soup exactly. This validator shares no code with the arrangement except the core's predicates: it
// has its own search tree and its own case analysis.

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "common/parallel.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel {
namespace {

int to_int(Sign s) { return static_cast<int>(s); }

/// A bounding volume hierarchy, split at the median.
class MedianTree {
 public:
  explicit MedianTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, boxes_.size());
  }
  template <typename Visit>
  void query(const Box3& box, Visit&& visit) const {
    std::vector<std::size_t> stack;
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!meet(node.box, box)) continue;
      if (node.right == 0) {
        for (std::size_t k = node.begin; k < node.end; ++k)
          if (meet(boxes_[order_[k]], box)) visit(order_[k]);
        continue;
      }
      stack.push_back(node.right);
      stack.push_back(static_cast<std::size_t>(&node - nodes_.data()) + 1);
    }
  }

 private:
  struct Node {
    Box3 box;
    std::size_t begin, end, right = 0;
  };
  static bool meet(const Box3& a, const Box3& b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
    return true;
  }
  void build(std::size_t begin, std::size_t end) {
    const std::size_t node = nodes_.size();
    Box3 box;
    for (std::size_t k = begin; k < end; ++k) {
      box.add(boxes_[order_[k]].min);
      box.add(boxes_[order_[k]].max);
    }
    nodes_.push_back({box, begin, end});
    if (end - begin <= 6) return;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (box.max[i] - box.min[i] > box.max[axis] - box.min[axis]) axis = i;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](Index x, Index y) {
      const double cx = boxes_[x].min[axis] + boxes_[x].max[axis], cy = boxes_[y].min[axis] + boxes_[y].max[axis];
      return cx != cy ? cx < cy : x < y;
    });
    build(begin, middle);
    nodes_[node].right = nodes_.size();
    build(middle, end);
  }
  std::vector<Box3> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

/// Tests by exact signs whether two items of a polygon soup meet anywhere except in shared vertices and edges.
class MeetingTests {
 public:
  explicit MeetingTests(const PolygonSoup& soup) : soup_(soup) {}

  /// Returns whether edge a b meets the closed facet anywhere except in a shared vertex or as a shared edge.
  bool edge_meets_facet(VertexIndex a, VertexIndex b, const Triangle& t) const {
    const bool has_a = has(t, a), has_b = has(t, b);
    if (has_a && has_b) return false;
    if (has_a || has_b) {
      const VertexIndex v = has_a ? a : b, w = has_a ? b : a;
      if (side(t, w) != 0) return false;
      const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      return turn(t, v, t[(k + 1) % 3], w) >= 0 && turn(t, v, w, t[(k + 2) % 3]) >= 0;
    }
    const int sa = side(t, a), sb = side(t, b);
    if (sa * sb > 0) return false;
    if (sa == 0 && sb == 0) {
      if (point_in_facet(a, t) || point_in_facet(b, t)) return true;
      for (std::size_t k = 0; k < 3; ++k)
        if (coplanar_segments_meet(t, a, b, t[k], t[(k + 1) % 3])) return true;
      return false;
    }
    if (sa == 0) return point_in_facet(a, t);
    if (sb == 0) return point_in_facet(b, t);
    int least = 1, greatest = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int s = to_int(orient3d(p(a), p(b), p(t[k]), p(t[(k + 1) % 3])));
      least = std::min(least, s);
      greatest = std::max(greatest, s);
    }
    return least * greatest >= 0;
  }

  static bool are_equal(const Triangle& a, const Triangle& b) { return has(a, b[0]) && has(a, b[1]) && has(a, b[2]); }
  /// Returns a corner of `a` near which the facets a and b meet other than in shared vertices and edges, if they do.
  std::optional<VertexIndex> facets_meet(const Triangle& a, const Triangle& b) const {
    if (clear(a, b) || clear(b, a)) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k)
      if (edge_meets_facet(a[k], a[(k + 1) % 3], b) || edge_meets_facet(b[k], b[(k + 1) % 3], a)) return a[k];
    return std::nullopt;
  }

  bool segments_meet(const PolygonSoup::Segment& s, const PolygonSoup::Segment& t) const {
    if (on_open_segment(t.a, s.a, s.b) || on_open_segment(t.b, s.a, s.b) || on_open_segment(s.a, t.a, t.b) ||
        on_open_segment(s.b, t.a, t.b))
      return true;
    if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return false;
    if (orient3d(p(s.a), p(s.b), p(t.a), p(t.b)) != Sign::zero || collinear(p(s.a), p(s.b), p(t.a))) return false;
    return coplanar_segments_meet({s.a, s.b, t.a}, s.a, s.b, t.a, t.b);
  }

  bool on_open_segment(VertexIndex v, VertexIndex a, VertexIndex b) const {
    if (v == a || v == b || !collinear(p(a), p(b), p(v))) return false;
    return compare_lexicographic(p(a), p(v)) * compare_lexicographic(p(v), p(b)) > 0;
  }

  bool point_meets_facet(VertexIndex v, const Triangle& t) const {
    return !has(t, v) && side(t, v) == 0 && point_in_facet(v, t);
  }

 private:
  const Vec3& p(VertexIndex v) const { return soup_.points[v]; }
  static bool has(const Triangle& t, VertexIndex v) { return t[0] == v || t[1] == v || t[2] == v; }
  int side(const Triangle& t, VertexIndex v) const {
    return has(t, v) ? 0 : to_int(orient3d(p(t[0]), p(t[1]), p(t[2]), p(v)));
  }

  /// Returns the sign of the area of triangle abc times that of t, in the first coordinate plane in which t has an
  /// area.
  int turn(const Triangle& t, VertexIndex a, VertexIndex b, VertexIndex c) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto flat = [&](VertexIndex v) { return Vec2{p(v)[i], p(v)[j]}; };
      const int own = to_int(orient2d(flat(t[0]), flat(t[1]), flat(t[2])));
      if (own != 0) return own * to_int(orient2d(flat(a), flat(b), flat(c)));
    }
    return 0;
  }

  /// Returns whether the vertex v, which lies in the plane of triangle t, is in the closed triangle.
  bool point_in_facet(VertexIndex v, const Triangle& t) const {
    return turn(t, t[0], t[1], v) >= 0 && turn(t, t[1], t[2], v) >= 0 && turn(t, t[2], t[0], v) >= 0;
  }

  /// Returns whether coplanar segments without a common endpoint meet.
  bool coplanar_segments_meet(const Triangle& plane, VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) const {
    if (on_open_segment(a, c, d) || on_open_segment(b, c, d) || on_open_segment(c, a, b) || on_open_segment(d, a, b))
      return true;
    return turn(plane, a, b, c) * turn(plane, a, b, d) < 0 && turn(plane, c, d, a) * turn(plane, c, d, b) < 0;
  }

  /// Returns whether all corners of one facet that are not shared lie strictly on one side of the other, so that only
  /// shared vertices and edges can meet.
  bool clear(const Triangle& t, const Triangle& other) const {
    int positive = 0, negative = 0, shared = 0;
    for (const VertexIndex v : other) {
      if (has(t, v)) {
        ++shared;
        continue;
      }
      const int s = side(t, v);
      positive += s > 0;
      negative += s < 0;
    }
    return positive == 3 - shared || negative == 3 - shared;
  }

  const PolygonSoup& soup_;
};

/// Collects the faults of a polygon soup, up to a limit: wrong array sizes, points, facets, then contacts.
class Validator {
 public:
  Validator(const PolygonSoup& soup, std::size_t limit) : soup_(soup), tests_(soup), limit_(limit) {}

  std::vector<SoupFault> run() {
    check_sizes();
    if (!faults_.empty()) return std::move(faults_);
    check_points();
    check_degenerate();
    if (faults_.empty()) check_contacts();
    if (faults_.size() > limit_) faults_.resize(limit_);
    return std::move(faults_);
  }

 private:
  const Vec3& p(VertexIndex v) const { return soup_.points[v]; }
  void fault(const std::string& what, std::vector<Index> facets, const Vec3& place) {
    if (faults_.size() < limit_) faults_.push_back({what, std::move(facets), place});
  }

  void check_sizes() {
    const std::size_t n = soup_.points.size();
    if (soup_.kind.size() != n || soup_.input_point.size() != n)
      fault("kind or input_point not parallel to points", {}, {});
    if (soup_.origin_offsets.size() != soup_.facets.size() + 1 || soup_.origin_offsets.back() != soup_.origins.size())
      fault("origin offsets not parallel to facets", {}, {});
    for (Index f = 0; f < soup_.facets.size(); ++f) {
      for (const VertexIndex v : soup_.facets[f])
        if (v >= n) fault("facet names a point that is not there", {f}, {});
      if (f + 1 < soup_.origin_offsets.size() && soup_.origin_offsets[f] >= soup_.origin_offsets[f + 1])
        fault("facet without origin", {f}, {});
    }
    for (const auto& s : soup_.segments)
      if (s.a >= n || s.b >= n || s.a == s.b)
        fault("segment names a point that is not there, or one point twice", {}, {});
    for (const auto& s : soup_.isolated_points)
      if (s.v >= n) fault("isolated point names a point that is not there", {}, {});
  }

  void check_points() {
    std::vector<VertexIndex> order(soup_.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [this](VertexIndex a, VertexIndex b) { return compare_lexicographic(p(a), p(b)) < 0; });
    for (std::size_t k = 1; k < order.size(); ++k)
      if (p(order[k - 1]) == p(order[k])) fault("two points have equal coordinates", {}, p(order[k]));
    if (!exponents_are_safe(soup_.points)) fault("coordinates not finite or out of the predicates' range", {}, {});
  }

  void check_degenerate() {
    for (Index f = 0; f < soup_.facets.size(); ++f) {
      const Triangle& t = soup_.facets[f];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || collinear(p(t[0]), p(t[1]), p(t[2])))
        fault("degenerate facet", {f}, p(t[0]));
    }
  }

  void check_contacts() {
    std::vector<Box3> boxes;
    boxes.reserve(soup_.facets.size());
    for (const Triangle& t : soup_.facets) boxes.push_back(box_of({t[0], t[1], t[2]}));
    const MedianTree tree(boxes);
    std::vector<std::vector<SoupFault>> found((boxes.size() + chunk - 1) / chunk);
    parallel_for(found.size(), [&](std::size_t c) {
      for (Index f = static_cast<Index>(c * chunk); f < std::min((c + 1) * chunk, boxes.size()); ++f)
        tree.query(boxes[f], [&](Index g) {
          if (g > f && found[c].size() < limit_) test_facets(f, g, found[c]);
        });
    });
    for (auto& part : found) faults_.insert(faults_.end(), part.begin(), part.end());
    check_segments(tree);
  }

  void check_segments(const MedianTree& facets) {
    std::vector<Box3> boxes;
    for (const auto& s : soup_.segments) boxes.push_back(box_of({s.a, s.b}));
    const MedianTree segments(boxes);
    for (Index s = 0; s < boxes.size(); ++s) {
      const auto& [a, b, line] = soup_.segments[s];
      facets.query(boxes[s], [&, a = a, b = b](Index f) {
        if (tests_.edge_meets_facet(a, b, soup_.facets[f]))
          fault("segment meets a facet outside shared vertices and edges", {f}, p(a));
      });
      segments.query(boxes[s], [&, s](Index t) {
        if (t > s && tests_.segments_meet(soup_.segments[s], soup_.segments[t]))
          fault("two segments meet outside shared vertices", {}, p(soup_.segments[s].a));
      });
    }
    for (const auto& point : soup_.isolated_points) {
      const Box3 box = box_of({point.v});
      facets.query(box, [&](Index f) {
        if (tests_.point_meets_facet(point.v, soup_.facets[f])) fault("isolated point in a facet", {f}, p(point.v));
      });
      segments.query(box, [&](Index s) {
        if (tests_.on_open_segment(point.v, soup_.segments[s].a, soup_.segments[s].b))
          fault("isolated point on a segment", {}, p(point.v));
      });
    }
  }

  Box3 box_of(std::initializer_list<VertexIndex> vertices) const {
    Box3 box;
    for (const VertexIndex v : vertices) box.add(p(v));
    return box;
  }

  void test_facets(Index f, Index g, std::vector<SoupFault>& out) const {
    const Triangle &a = soup_.facets[f], &b = soup_.facets[g];
    if (MeetingTests::are_equal(a, b))
      out.push_back({"two facets are equal as sets", {f, g}, p(a[0])});
    else if (const auto at = tests_.facets_meet(a, b))
      out.push_back({"two facets meet outside shared vertices and edges", {f, g}, p(*at)});
  }

  static constexpr std::size_t chunk = 1024;
  const PolygonSoup& soup_;
  MeetingTests tests_;
  std::size_t limit_;
  std::vector<SoupFault> faults_;
};

}  // namespace

std::vector<SoupFault> validate_soup(const PolygonSoup& soup, std::size_t limit) {
  return Validator(soup, limit).run();
}

}  // namespace geomesh::geomodel
