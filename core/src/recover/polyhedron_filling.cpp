// SPDX-License-Identifier: MIT
#include "recover/polyhedron_filling.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace geomesh::recover {

namespace {

Triangle canonical(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}
Triangle reversed(const Triangle& t) { return canonical({t[0], t[2], t[1]}); }
bool has(const Triangle& t, VertexIndex v) { return t[0] == v || t[1] == v || t[2] == v; }

class Filler {
 public:
  Filler(const ConstrainedMesh& mesh, const Constraints& constraints, std::span<const Triangle> boundary, const FillingLimits& limits)
      : mesh_(mesh), constraints_(constraints), limits_(limits) {
    for (const Triangle& t : boundary) {
      open(canonical(t));
      vertices_.insert(vertices_.end(), t.begin(), t.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (auto& [face, candidates] : open_) candidates = visible(face);
  }

  bool solve() {
    if (open_.empty()) return true;
    const auto best = std::min_element(open_.begin(), open_.end(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    const Triangle face = best->first;
    std::vector<VertexIndex> candidates = best->second;
    sort_by_sphere(face, candidates);
    for (VertexIndex v : candidates) {
      if (++n_nodes_ > limits_.max_nodes) return false;
      if (!fits(face, v)) continue;
      const auto before = open_;
      place(face, v);
      if (solve()) return true;
      open_ = before;
      cells_.pop_back();
    }
    return false;
  }
  const std::vector<Tetrahedron>& cells() const { return cells_; }

 private:
  void open(const Triangle& t) { open_[t]; }

  std::vector<VertexIndex> visible(const Triangle& t) const {
    std::vector<VertexIndex> out;
    for (VertexIndex v : vertices_)
      if (!has(t, v) && mesh_.orient(t[0], t[1], t[2], v) == Sign::positive) out.push_back(v);
    return out;
  }

  /// The nearer the centre of the sphere through face and vertex lies, the emptier that sphere.
  void sort_by_sphere(const Triangle& t, std::vector<VertexIndex>& candidates) const {
    const Vec3 &a = mesh_.point(t[0]), &b = mesh_.point(t[1]), &c = mesh_.point(t[2]);
    const Vec3 u = b - a, w = c - a, n = cross(u, w);
    const double nn = dot(n, n);
    const Vec3 centre = 0.5 / nn * (dot(u, u) * cross(w, n) + dot(w, w) * cross(n, u));
    const auto height = [&](VertexIndex v) {
      const Vec3 d = mesh_.point(v) - a;
      return (dot(d, d) - 2 * dot(d, centre)) / dot(d, n);
    };
    std::sort(candidates.begin(), candidates.end(), [&](VertexIndex x, VertexIndex y) {
      const double hx = height(x), hy = height(y);
      return hx != hy ? hx < hy : x < y;
    });
  }

  static std::array<Triangle, 3> side_faces(const Triangle& t, VertexIndex v) {
    // As seen from inside the new cell.
    return {canonical({t[0], v, t[1]}), canonical({t[1], v, t[2]}), canonical({t[2], v, t[0]})};
  }

  bool fits(const Triangle& t, VertexIndex v) const {
    unsigned n_closed = 0;
    for (const Triangle& s : side_faces(t, v)) {
      if (open_.count(s)) {
        ++n_closed;
      } else if (open_.count(reversed(s))) {
        return false;
      }
    }
    if (n_closed == 3) return true;
    for (VertexIndex f : t)
      if (constraints_.skips_added_points(f, v)) return false;
    return !holds_vertex(t, v) && !crosses_open_face(t, v);
  }
  bool holds_vertex(const Triangle& t, VertexIndex v) const {
    for (VertexIndex w : vertices_) {
      if (w == v || has(t, w) || mesh_.orient(t[0], t[1], t[2], w) == Sign::negative) continue;
      bool inside = true;
      for (const Triangle& s : side_faces(t, v)) inside = inside && mesh_.orient(s[0], s[1], s[2], w) != Sign::negative;
      if (inside) return true;
    }
    return false;
  }
  /// Edge a-b against triangle t, none of whose vertices it has: they meet in the inside of both, or on the border of one.
  bool edge_crosses(VertexIndex a, VertexIndex b, const Triangle& t) const {
    if (has(t, a) || has(t, b)) return false;
    const Sign sa = mesh_.orient(t[0], t[1], t[2], a), sb = mesh_.orient(t[0], t[1], t[2], b);
    if (sa * sb != Sign::negative) return false;
    const Sign s0 = mesh_.orient(a, b, t[0], t[1]), s1 = mesh_.orient(a, b, t[1], t[2]), s2 = mesh_.orient(a, b, t[2], t[0]);
    const bool no_negative = s0 != Sign::negative && s1 != Sign::negative && s2 != Sign::negative;
    const bool no_positive = s0 != Sign::positive && s1 != Sign::positive && s2 != Sign::positive;
    return no_negative || no_positive;
  }
  bool crosses_open_face(const Triangle& t, VertexIndex v) const {
    const auto sides = side_faces(t, v);
    for (const auto& [h, candidates] : open_) {
      for (VertexIndex f : t)
        if (edge_crosses(f, v, h)) return true;
      for (const Triangle& s : sides)
        for (unsigned i = 0; i < 3; ++i)
          if (edge_crosses(h[i], h[(i + 1) % 3], s)) return true;
    }
    return false;
  }

  void place(const Triangle& t, VertexIndex v) {
    open_.erase(t);
    for (const Triangle& s : side_faces(t, v)) {
      if (open_.erase(s)) continue;
      const Triangle outward = reversed(s);
      open_[outward] = visible(outward);
    }
    cells_.push_back({t[0], t[1], t[2], v});
  }

  const ConstrainedMesh& mesh_;
  const Constraints& constraints_;
  FillingLimits limits_;
  std::vector<VertexIndex> vertices_;
  std::map<Triangle, std::vector<VertexIndex>> open_;  ///< faces not yet covered, with the vertices they see
  std::vector<Tetrahedron> cells_;
  std::size_t n_nodes_ = 0;
};

}  // namespace

std::optional<std::vector<Tetrahedron>> fan_from(const ConstrainedMesh& mesh, const Constraints& constraints, std::span<const Triangle> boundary, VertexIndex v) {
  std::vector<Tetrahedron> out;
  for (const Triangle& t : boundary) {
    if (has(t, v)) continue;
    const Tetrahedron cell{t[0], t[1], t[2], v};
    if (!mesh.positive(cell)) return std::nullopt;
    for (VertexIndex w : t)
      if (constraints.skips_added_points(v, w)) return std::nullopt;
    out.push_back(cell);
  }
  return out;
}

std::optional<std::vector<Tetrahedron>> fill_polyhedron(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                        std::span<const Triangle> boundary,
                                                        const FillingLimits& limits) {
  if (boundary.size() > limits.max_faces) return std::nullopt;
  Filler filler(mesh, constraints, boundary, limits);
  if (!filler.solve()) return std::nullopt;
  return filler.cells();
}

}  // namespace geomesh::recover
