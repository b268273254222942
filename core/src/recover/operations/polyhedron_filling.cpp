// SPDX-License-Identifier: MIT
#include "recover/operations/polyhedron_filling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/side_masks.hpp"

namespace geomesh::recover {

namespace {

LocalTriangle reversed(const LocalTriangle& t) { return {t[0], t[2], t[1]}; }
/// Returns the same key for all rotations of a triangle. The key of the reversed triangle differs in the last bit.
std::uint32_t key_of(LocalTriangle t) {
  const bool odd = SideMasks::sort(t);
  return static_cast<std::uint32_t>(2 * SideMasks::row_of(t[0], t[1], t[2]) + (odd ? 1 : 0));
}
/// Returns the faces other than t of the tetrahedron with face t and opposite vertex v, as seen from its inside.
std::array<LocalTriangle, 3> side_faces(const LocalTriangle& t, LocalVertex v) {
  return {LocalTriangle{t[0], v, t[1]}, LocalTriangle{t[1], v, t[2]}, LocalTriangle{t[2], v, t[0]}};
}

/// The vertices of a polyhedron by local number. Tests with exact signs which cells between them are possible.
class Corners {
 public:
  Corners(const ConstrainedMesh& mesh, std::vector<VertexIndex>&& vertices)
      : mesh_(mesh), vertices_(std::move(vertices)), sides_(mesh, vertices_) {}
  Corners(const Corners&) = delete;
  Corners& operator=(const Corners&) = delete;

  std::size_t size() const { return vertices_.size(); }
  VertexIndex operator[](LocalVertex v) const { return vertices_[v]; }
  LocalVertex local(VertexIndex v) const {
    return static_cast<LocalVertex>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
  }
  SideMasks::Masks sides(const LocalTriangle& t) { return sides_.sides(t); }

  /// Sorts the candidates for the fourth vertex of a tetrahedron on face t by the height of its circumcentre over t:
  /// the lower the centre, the emptier the sphere. Returns the number of candidates.
  std::size_t sort_by_sphere(const LocalTriangle& t, VertexMask candidates,
                             std::array<LocalVertex, SideMasks::max_vertices>& order) const {
    const Vec3 &a = point(t[0]), u = point(t[1]) - a, w = point(t[2]) - a, n = cross(u, w);
    const Vec3 centre = 0.5 / dot(n, n) * (dot(u, u) * cross(w, n) + dot(w, w) * cross(n, u));
    std::array<double, SideMasks::max_vertices> height;
    std::size_t count = 0;
    for (VertexMask left = candidates; left != 0; left &= left - 1) {
      const LocalVertex v = static_cast<LocalVertex>(std::countr_zero(left));
      const Vec3 d = point(v) - a;
      height[v] = (dot(d, d) - 2 * dot(d, centre)) / dot(d, n);
      order[count++] = v;
    }
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
              [&](LocalVertex x, LocalVertex y) { return height[x] != height[y] ? height[x] < height[y] : x < y; });
    return count;
  }

  /// Returns whether a tetrahedron contains a vertex besides its own. `t` is one of its faces, `side` has the others.
  bool holds_vertex(const LocalTriangle& t, const std::array<LocalTriangle, 3>& side) {
    return ~(sides_.below(t) | sides_.below(side[0]) | sides_.below(side[1]) | sides_.below(side[2]) | mask_of(t) |
             mask_of(side[0])) &
           all();
  }
  /// Returns whether triangle h crosses the tetrahedron of triangle t and vertex v; `side` has its three other faces.
  bool crosses(const LocalTriangle& t, LocalVertex v, const std::array<LocalTriangle, 3>& side,
               const LocalTriangle& h) {
    for (LocalVertex f : t)
      if (edge_crosses(f, v, h)) return true;
    for (const LocalTriangle& s : side)
      for (unsigned i = 0; i < 3; ++i)
        if (edge_crosses(h[i], h[(i + 1) % 3], s)) return true;
    return false;
  }

 private:
  const Vec3& point(LocalVertex v) const { return mesh_.point(vertices_[v]); }
  VertexMask all() const { return vertices_.size() == 64 ? ~VertexMask{0} : (VertexMask{1} << vertices_.size()) - 1; }

  /// Returns whether edge a-b meets triangle t without vertex a or b, in the interior of both or on the border of one.
  bool edge_crosses(LocalVertex a, LocalVertex b, const LocalTriangle& t) {
    if (mask_of(t) & (bit(a) | bit(b))) return false;
    if (sides_.sign(t[0], t[1], t[2], a) * sides_.sign(t[0], t[1], t[2], b) >= 0) return false;
    const int s0 = sides_.sign(a, b, t[0], t[1]), s1 = sides_.sign(a, b, t[1], t[2]),
              s2 = sides_.sign(a, b, t[2], t[0]);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
  }

  const ConstrainedMesh& mesh_;
  std::vector<VertexIndex> vertices_;
  SideMasks sides_;
};

/// A face of the part of a polyhedron that is not yet filled with cells, as seen from inside that part.
struct OpenFace {
  LocalTriangle v{};
  std::uint32_t key = 0;
  SideMasks::Masks sides{};   ///< masks of the vertices above and below the plane of the face
  VertexMask candidates = 0;  ///< mask of the vertices that may form a tetrahedron with the face
  int n_candidates = 0;
  bool is_filtered = false;  ///< whether candidates whose tetrahedron would cross an unfilled face were removed
};

/// Counts for each triangle how often it bounds the unfilled part of a polyhedron; records changes for undoing.
class OpenCounts {
 public:
  explicit OpenCounts(std::size_t n_keys) : n_(n_keys, 0) {}

  bool has(std::uint32_t key) const { return n_[key] > 0; }
  void open(std::uint32_t key) {
    ++n_[key];
    changes_.push_back({key, true});
  }
  void close(std::uint32_t key) {
    --n_[key];
    changes_.push_back({key, false});
  }
  std::size_t mark() const { return changes_.size(); }
  void take_back(std::size_t mark) {
    for (; changes_.size() > mark; changes_.pop_back()) n_[changes_.back().key] += changes_.back().is_opening ? -1 : 1;
  }

 private:
  struct Change {
    std::uint32_t key;
    bool is_opening;
  };
  std::vector<std::int8_t> n_;
  std::vector<Change> changes_;
};

/// Fills a polyhedron with tetrahedra by backtracking, first at the face with the fewest possible fourth vertices.
class Filler {
 public:
  Filler(const ConstrainedMesh& mesh, const Constraints& constraints, std::span<const Triangle> boundary,
         const FillingLimits& limits)
      : constraints_(constraints),
        limits_(limits),
        corners_(mesh, vertices_of(boundary)),
        open_(2 * SideMasks::n_triples(corners_.size())) {
    levels_.reserve(limits.max_faces + 4);
    levels_.emplace_back();
    for (const Triangle& t : boundary)
      open(levels_[0], {corners_.local(t[0]), corners_.local(t[1]), corners_.local(t[2])});
  }

  bool run() { return solve(0); }
  std::vector<Tetrahedron> cells() const {
    std::vector<Tetrahedron> out;
    for (const auto& c : cells_) out.push_back({corners_[c[0]], corners_[c[1]], corners_[c[2]], corners_[c[3]]});
    return out;
  }

 private:
  using Front = std::vector<OpenFace>;

  void open(Front& front, const LocalTriangle& t) {
    const SideMasks::Masks sides = corners_.sides(t);
    front.push_back({t, key_of(t), sides, sides.first, std::popcount(sides.first), false});
    open_.open(front.back().key);
  }

  bool solve(std::size_t depth) {
    if (levels_[depth].empty()) return true;
    const std::size_t row = hardest_face(levels_[depth]);
    const OpenFace face = levels_[depth][row];
    if (face.candidates == 0) return false;
    std::array<LocalVertex, SideMasks::max_vertices> order;
    const std::size_t n = corners_.sort_by_sphere(face.v, face.candidates, order);
    if (levels_.size() < depth + 2) levels_.resize(depth + 2);
    for (std::size_t i = 0; i < n; ++i) {
      if (++n_nodes_ > limits_.max_nodes) return false;
      levels_[depth + 1] = levels_[depth];
      const std::size_t mark = open_.mark();
      place(levels_[depth + 1], face.v, order[i]);
      if (solve(depth + 1)) return true;
      take_back(mark);
    }
    return false;
  }

  /// Returns, among a few faces of the unfilled part, the one that the fewest vertices complete to a tetrahedron.
  std::size_t hardest_face(Front& front) {
    for (OpenFace& f : front) f.is_filtered = false;
    std::size_t best = 0;
    for (unsigned look = 0; look < recovery_budget.filling_looks; ++look) {
      best = 0;
      for (std::size_t i = 1; i < front.size(); ++i)
        if (front[i].n_candidates < front[best].n_candidates) best = i;
      if (front[best].is_filtered) return best;
      filter(front, front[best]);
      if (front[best].candidates == 0) return best;
    }
    std::size_t filtered = front.size();
    for (std::size_t i = 0; i < front.size(); ++i)
      if (front[i].is_filtered && (filtered == front.size() || front[i].n_candidates < front[filtered].n_candidates))
        filtered = i;
    return filtered;
  }
  /// Removes from a face's candidates the vertices whose tetrahedron with the face would cross other unfilled faces.
  void filter(const Front& front, OpenFace& face) {
    for (VertexMask left = face.candidates; left != 0; left &= left - 1) {
      const LocalVertex v = static_cast<LocalVertex>(std::countr_zero(left));
      if (!fits(front, face.v, v)) face.candidates &= ~bit(v);
    }
    face.n_candidates = std::popcount(face.candidates);
    face.is_filtered = true;
  }

  static std::size_t find(const Front& front, std::uint32_t key) {
    for (std::size_t i = 0; i < front.size(); ++i)
      if (front[i].key == key) return i;
    return front.size();
  }

  bool fits(const Front& front, const LocalTriangle& t, LocalVertex v) {
    const auto side = side_faces(t, v);
    unsigned n_closed = 0;
    for (const LocalTriangle& s : side) {
      const std::uint32_t key = key_of(s);
      if (open_.has(key)) {
        ++n_closed;
      } else if (open_.has(key ^ 1u)) {
        return false;
      }
    }
    if (n_closed == 3) return true;
    if (corners_.holds_vertex(t, side) || crosses_open_face(front, t, v, side)) return false;
    for (LocalVertex f : t)
      if (constraints_.skips_added_points(corners_[f], corners_[v])) return false;
    return true;
  }
  bool crosses_open_face(const Front& front, const LocalTriangle& t, LocalVertex v,
                         const std::array<LocalTriangle, 3>& side) {
    const VertexMask cell = mask_of(t) | bit(v);
    const VertexMask inner[4] = {corners_.sides(t).first, corners_.sides(side[0]).first, corners_.sides(side[1]).first,
                                 corners_.sides(side[2]).first};
    for (const OpenFace& h : front) {
      const VertexMask m = mask_of(h.v);
      if (!(inner[0] & m) || !(inner[1] & m) || !(inner[2] & m) || !(inner[3] & m)) continue;
      if (!(h.sides.first & cell) || !(h.sides.second & cell)) continue;
      if (!corners_.crosses(t, v, side, h.v)) continue;
      return true;
    }
    return false;
  }

  void close(Front& front, std::size_t row) {
    open_.close(front[row].key);
    front[row] = front.back();
    front.pop_back();
  }
  void place(Front& front, const LocalTriangle& t, LocalVertex v) {
    close(front, find(front, key_of(t)));
    for (const LocalTriangle& s : side_faces(t, v)) {
      const std::size_t row = find(front, key_of(s));
      if (row < front.size()) {
        close(front, row);
      } else {
        open(front, reversed(s));
      }
    }
    cells_.push_back({t[0], t[1], t[2], v});
  }
  /// Undoes the last step of the search: removes the tetrahedron it added, and restores the counts of open faces.
  void take_back(std::size_t mark) {
    open_.take_back(mark);
    cells_.pop_back();
  }

  const Constraints& constraints_;
  FillingLimits limits_;
  Corners corners_;
  std::vector<Front> levels_;  ///< faces of the unfilled part of the polyhedron, by depth of the search
  OpenCounts open_;            ///< how often each triangle bounds the unfilled part at the current depth of the search
  std::vector<std::array<LocalVertex, 4>> cells_;
  std::size_t n_nodes_ = 0;
};

}  // namespace

std::vector<VertexIndex> vertices_of(std::span<const Triangle> boundary) {
  std::vector<VertexIndex> out;
  for (const Triangle& t : boundary) out.insert(out.end(), t.begin(), t.end());
  sort_unique(out);
  return out;
}

std::optional<std::vector<Tetrahedron>> fan_from(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                 std::span<const Triangle> boundary, VertexIndex v) {
  std::vector<Tetrahedron> out;
  for (const Triangle& t : boundary) {
    if (t[0] == v || t[1] == v || t[2] == v) continue;
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
  if (boundary.size() > limits.max_faces || vertices_of(boundary).size() > SideMasks::max_vertices) return std::nullopt;
  Filler filler(mesh, constraints, boundary, limits);
  if (!filler.run()) return std::nullopt;
  return filler.cells();
}

}  // namespace geomesh::recover
