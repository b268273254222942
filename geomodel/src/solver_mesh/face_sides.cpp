// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/face_sides.hpp"

#include <algorithm>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::geomodel {

namespace {

struct Sorted {
  Triangle vertices;
  bool even;
};

Sorted sorted(Triangle t) {
  bool even = true;
  for (std::size_t pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < 2; ++i)
      if (t[i] > t[i + 1]) {
        std::swap(t[i], t[i + 1]);
        even = !even;
      }
  return {t, even};
}

/// Finds the neighbours of tetrahedra by sorting faces. Faces are sorted in portions, by their smallest vertices,
/// because a list of all faces would take five times the memory of the mesh.
class AcrossFaces {
 public:
  AcrossFaces(const std::vector<Tetrahedron>& tetrahedra, std::span<const TetrahedronRows> pieces)
      : tetrahedra_(tetrahedra), pieces_(pieces) {
    VertexIndex last = 0;
    for_each([&](std::uint32_t, const Tetrahedron& v) {
      ++n_tetrahedra_;
      last = std::max(last, *std::max_element(v.begin(), v.end()));
    });
    n_faces_at_.assign(n_tetrahedra_ > 0 ? last + std::size_t{1} : 0, 0);
    for_each([&](std::uint32_t, const Tetrahedron& v) {
      const auto [first, second] = two_smallest(v);
      n_faces_at_[first] += 3;
      ++n_faces_at_[second];
    });
  }

  std::vector<Neighbours> find() {
    std::vector<Neighbours> across(n_tetrahedra_, {no_neighbour, no_neighbour, no_neighbour, no_neighbour});
    constexpr std::size_t n_windows = 32, least_at_once = 1 << 12;
    const std::size_t at_once = std::max(least_at_once, 4 * n_tetrahedra_ / n_windows);
    for (std::size_t from = 0; from < n_faces_at_.size();) {
      std::size_t to = from, n = 0;
      do {
        n += n_faces_at_[to++];
      } while (to < n_faces_at_.size() && n + n_faces_at_[to] <= at_once);
      collect(from, to, n);
      pair_up(across);
      from = to;
    }
    return across;
  }

 private:
  struct Use {
    Triangle vertices;
    /// Number of the face: four times the tetrahedron plus 0 to 3; meshes have fewer than 2^30 cells.
    std::uint32_t code;
  };
  template <class F>
  void for_each(F&& f) const {
    std::uint32_t number = 0;
    if (pieces_.empty())
      for (const Tetrahedron& t : tetrahedra_) f(number++, t);
    for (const TetrahedronRows& piece : pieces_)
      for (const VertexIndex t : piece) f(number++, tetrahedra_[t]);
  }
  /// Returns the two smallest vertex numbers of a tetrahedron. The smallest vertex of three of its faces is the first
  /// of these, that of the fourth face is the second.
  static std::pair<VertexIndex, VertexIndex> two_smallest(const Tetrahedron& v) {
    // Minimum and maximum avoid branches, because it is unpredictable which of two vertex numbers is smaller.
    const VertexIndex a = std::min(v[0], v[1]), c = std::min(v[2], v[3]);
    return {std::min(a, c), std::min(std::max(a, c), std::min(std::max(v[0], v[1]), std::max(v[2], v[3])))};
  }
  /// Collects the `n` faces whose smallest vertex number is in the range [from, to).
  void collect(std::size_t from, std::size_t to, std::size_t n) {
    uses_.clear();
    uses_.reserve(n);
    const auto is_here = [&](VertexIndex v) { return v >= from && v < to; };
    for_each([&](std::uint32_t t, const Tetrahedron& v) {
      const auto [first, second] = two_smallest(v);
      if (!is_here(first) && !is_here(second)) return;
      for (unsigned i = 0; i < 4; ++i) {
        const Triangle own = sorted({v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]}).vertices;
        if (is_here(own[0])) uses_.push_back({own, 4 * t + i});
      }
    });
    const auto rest = [](const Use& a) { return std::uint64_t{a.vertices[1]} << 32 | a.vertices[2]; };
    std::sort(uses_.begin(), uses_.end(), [&](const Use& a, const Use& b) {
      if (a.vertices[0] != b.vertices[0]) return a.vertices[0] < b.vertices[0];
      const std::uint64_t of_a = rest(a), of_b = rest(b);
      return of_a != of_b ? of_a < of_b : a.code < b.code;
    });
  }
  void pair_up(std::vector<Neighbours>& across) const {
    for (std::size_t k = 0; k + 1 < uses_.size(); ++k) {
      if (uses_[k].vertices != uses_[k + 1].vertices) continue;
      const std::uint32_t a = uses_[k].code, b = uses_[k + 1].code;
      across[a / 4][a % 4] = b / 4;
      across[b / 4][b % 4] = a / 4;
    }
  }

  const std::vector<Tetrahedron>& tetrahedra_;
  std::span<const TetrahedronRows> pieces_;
  std::size_t n_tetrahedra_ = 0;
  std::vector<std::uint32_t> n_faces_at_;  // by smallest vertex
  std::vector<Use> uses_;
};

}  // namespace

std::vector<std::array<TetrahedronSide, 2>> tetrahedra_at_faces(const std::vector<Tetrahedron>& tetrahedra,
                                                                const std::vector<Triangle>& faces) {
  struct Face {
    Triangle vertices;
    bool even;
    std::size_t row;
  };
  std::vector<Face> list;
  list.reserve(faces.size());
  std::size_t n_vertices = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Sorted s = sorted(faces[f]);
    list.push_back({s.vertices, s.even, f});
    n_vertices = std::max<std::size_t>(n_vertices, s.vertices[2] + 1u);
  }
  std::sort(list.begin(), list.end(), [](const Face& a, const Face& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.row < b.row;
  });
  std::vector<std::size_t> first(n_vertices + 1, 0);  // for each vertex: first face in which it is the lowest-numbered
  for (const Face& face : list) ++first[face.vertices[0] + 1];
  for (std::size_t v = 0; v < n_vertices; ++v) first[v + 1] += first[v];
  std::vector<std::array<TetrahedronSide, 2>> sides(faces.size(), {{{no_side, 0}, {no_side, 0}}});
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      const Tetrahedron& v = tetrahedra[t];
      const Sorted s = sorted({v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]});
      if (s.vertices[0] >= n_vertices) continue;
      const auto end = list.begin() + static_cast<std::ptrdiff_t>(first[s.vertices[0] + 1]);
      auto face = std::lower_bound(list.begin() + static_cast<std::ptrdiff_t>(first[s.vertices[0]]), end, s.vertices,
                                   [](const Face& a, const Triangle& b) { return a.vertices < b; });
      // Faces of a tetrahedron are listed with normals that point inwards, so the normal of a face with the same
      // orientation points to this tetrahedron.
      for (; face != end && face->vertices == s.vertices; ++face)
        sides[face->row][face->even == s.even ? 1 : 0] = {t, static_cast<unsigned>(i)};
    }
  return sides;
}

std::vector<Neighbours> tetrahedra_across(const std::vector<Tetrahedron>& tetrahedra,
                                          std::span<const TetrahedronRows> pieces) {
  return AcrossFaces(tetrahedra, pieces).find();
}

}  // namespace geomesh::geomodel
