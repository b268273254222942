// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/filling_candidates.hpp"

#include <algorithm>
#include <bit>

namespace geomesh::recover {

namespace {

LocalVertex lowest(VertexMask m) { return static_cast<LocalVertex>(std::countr_zero(m)); }
VertexMask beyond(LocalVertex v) { return v == 63 ? 0 : ~VertexMask{0} << (v + 1); }
std::uint32_t face_row(LocalVertex a, LocalVertex b, LocalVertex c) {
  return static_cast<std::uint32_t>(SideMasks::row_of(a, b, c));
}

}  // namespace

FillingCandidates::FillingCandidates(const ConstrainedMesh& mesh, const Constraints& constraints, const Region& region)
    : constraints_(constraints),
      region_(region),
      n_(region.vertices.size()),
      sides_(mesh, region.vertices),
      forced_(n_, 0),
      allowed_(n_, 0),
      thirds_(n_ * n_, 0),
      is_required_(2 * SideMasks::n_triples(n_), 0) {
  for (const Triangle& t : region.boundary) boundary_.push_back(local(t));
  for (const auto& s : region.segments) force_edge(local(s[0]), local(s[1]));
  for (const LocalTriangle& t : boundary_)
    for (unsigned i = 0; i < 3; ++i) force_edge(t[i], t[(i + 1) % 3]);
}

bool FillingCandidates::find() {
  sides_.decide_all();
  mark_required();
  find_allowed_edges();
  find_allowed_faces();
  gather();
  list_by_side();
  return prune();
}

LocalVertex FillingCandidates::local(VertexIndex v) const {
  return static_cast<LocalVertex>(std::lower_bound(region_.vertices.begin(), region_.vertices.end(), v) -
                                  region_.vertices.begin());
}

Tetrahedron FillingCandidates::global(const Cell& c) const {
  const auto& v = region_.vertices;
  const Tetrahedron out{v[c.vertices[0]], v[c.vertices[1]], v[c.vertices[2]], v[c.vertices[3]]};
  return c.is_positive ? out : Tetrahedron{out[1], out[0], out[2], out[3]};
}

void FillingCandidates::force_edge(LocalVertex a, LocalVertex b) {
  forced_[a] |= bit(b);
  forced_[b] |= bit(a);
}

void FillingCandidates::mark_required() {
  for (LocalTriangle t : boundary_) {
    const bool odd = SideMasks::sort(t);
    is_required_[2 * face_row(t[0], t[1], t[2]) + (odd ? 1 : 0)] = 1;
  }
}

/// Returns the vertices b for which the line from a to b passes through triangle t or its border.
VertexMask FillingCandidates::crossing(LocalVertex a, const LocalTriangle& t) {
  VertexMask above = 0, below = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const SideMasks::Masks wall = sides_.sides({t[i], t[(i + 1) % 3], a});
    above |= wall.first;
    below |= wall.second;
  }
  return ~(above & below);
}

/// Finds the edges allowed in the region, as a mask for each vertex: they cross no boundary triangle or required edge.
void FillingCandidates::find_allowed_edges() {
  for (LocalVertex a = 0; a < n_; ++a)
    for (LocalVertex b = 0; b < a; ++b) {
      if (constraints_.skips_added_points(region_.vertices[a], region_.vertices[b])) continue;
      allowed_[a] |= bit(b);
      allowed_[b] |= bit(a);
    }
  for (LocalVertex c = 2; c < n_; ++c)
    for (LocalVertex b = 1; b < c; ++b)
      for (LocalVertex a = 0; a < b; ++a) forbid_edges_in_plane({a, b, c});
  for (const LocalTriangle& t : boundary_) forbid_edges_through(t);
}

/// Forbids each edge of triangle t that crosses, in the plane of t, a required edge at the third vertex of t. Two edges
/// cross if the ends of each are strictly on different sides of the other.
void FillingCandidates::forbid_edges_in_plane(const LocalTriangle& t) {
  const SideMasks::Masks& sides = sides_.of_sorted(t[0], t[1], t[2]);
  const VertexMask off = sides.first | sides.second, in_plane = all() & ~(off | mask_of(t));
  if (in_plane == 0 || off == 0) return;
  const LocalVertex apex = lowest(off);
  for (unsigned i = 0; i < 3; ++i) {
    const LocalVertex a = t[(i + 1) % 3], b = t[(i + 2) % 3], c = t[i];
    if (!(allowed_[a] & bit(b))) continue;
    for (VertexMask of_d = forced_[c] & in_plane; of_d != 0; of_d &= of_d - 1) {
      const LocalVertex d = lowest(of_d);
      if (sides_.sign(apex, a, b, c) * sides_.sign(apex, a, b, d) >= 0 ||
          sides_.sign(apex, c, d, a) * sides_.sign(apex, c, d, b) >= 0)
        continue;
      allowed_[a] &= ~bit(b);
      allowed_[b] &= ~bit(a);
      break;
    }
  }
}

void FillingCandidates::forbid_edges_through(const LocalTriangle& t) {
  const VertexMask below = sides_.below(t);
  for (VertexMask of_a = sides_.above(t); of_a != 0; of_a &= of_a - 1) {
    const LocalVertex a = lowest(of_a);
    VertexMask of_b = below & allowed_[a];
    if (of_b == 0) continue;
    of_b &= crossing(a, t);
    allowed_[a] &= ~of_b;
    for (; of_b != 0; of_b &= of_b - 1) allowed_[lowest(of_b)] &= ~bit(a);
  }
}

/// Finds the possible faces of new cells in the region: all edges are allowed, and no required edge pierces the face.
void FillingCandidates::find_allowed_faces() {
  for (LocalVertex c = 0; c < n_; ++c)
    for (VertexMask of_d = allowed_[c]; of_d != 0; of_d &= of_d - 1)
      thirds(c, lowest(of_d)) = allowed_[c] & allowed_[lowest(of_d)];
  for (LocalVertex a = 0; a < n_; ++a)
    for (VertexMask of_b = forced_[a] & beyond(a); of_b != 0; of_b &= of_b - 1) forbid_faces_about(a, lowest(of_b));
}

/// Forbids the faces (c, d, e) whose interior or border edge a-b meets: their edges pass a-b on the same side, and a
/// and b lie on different sides. For each pair of vertices c, d, bit masks decide all vertices e at once.
void FillingCandidates::forbid_faces_about(LocalVertex a, LocalVertex b) {
  std::array<SideMasks::Masks, SideMasks::max_vertices> about;
  for (LocalVertex c = 0; c < n_; ++c)
    if (c != a && c != b) about[c] = sides_.of_edge(a, b, c);
  for (LocalVertex c = 0; c < n_; ++c) {
    if (c == a || c == b) continue;
    for (VertexMask of_d = allowed_[c] & beyond(c) & ~(bit(a) | bit(b)); of_d != 0; of_d &= of_d - 1) {
      const LocalVertex d = lowest(of_d);
      VertexMask of_e = 0;
      if (!(about[c].second & bit(d))) of_e |= ~(about[d].second | about[c].first);
      if (!(about[c].first & bit(d))) of_e |= ~(about[d].first | about[c].second);
      of_e &= thirds(c, d) & beyond(d);
      if (of_e == 0) continue;
      const SideMasks::Masks with_a = sides_.of_edge(c, d, a), with_b = sides_.of_edge(c, d, b);
      of_e &= (with_a.first & with_b.second) | (with_a.second & with_b.first);
      for (; of_e != 0; of_e &= of_e - 1) forbid_face({c, d, lowest(of_e)});
    }
  }
}

void FillingCandidates::forbid_face(const LocalTriangle& t) {
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (i != j) thirds(t[i], t[j]) &= ~bit(t[3 - i - j]);
}

void FillingCandidates::gather() {
  for (LocalVertex a = 0; a < n_; ++a)
    for (VertexMask of_b = allowed_[a] & beyond(a); of_b != 0; of_b &= of_b - 1) {
      const LocalVertex b = lowest(of_b);
      for (VertexMask of_c = thirds(a, b) & beyond(b); of_c != 0; of_c &= of_c - 1)
        gather_above_face(a, b, lowest(of_c));
    }
}

/// Collects the possible cells of the region with the vertices a, b, c and a greater one.
void FillingCandidates::gather_above_face(LocalVertex a, LocalVertex b, LocalVertex c) {
  const SideMasks::Masks& abc = sides_.of_sorted(a, b, c);
  for (VertexMask of_d = thirds(a, b) & thirds(a, c) & thirds(b, c) & (abc.first | abc.second) & beyond(c); of_d != 0;
       of_d &= of_d - 1) {
    const LocalVertex d = lowest(of_d);
    Cell cell{{a, b, c, d},
              (abc.first & bit(d)) != 0,
              {face_row(b, c, d), face_row(a, c, d), face_row(a, b, d), face_row(a, b, c)}};
    // A positive cell (a, b, c, d) lies above its faces (a, b, c) and (a, c, d), and below (a, b, d) and (b, c, d).
    for (std::uint32_t i = 0; i < 4; ++i)
      cell.sides[i] = 2 * cell.sides[i] + ((i % 2 == 1) == cell.is_positive ? 0 : 1);
    if (!holds_another(cell)) cells_.push_back(cell);
  }
}

bool FillingCandidates::holds_another(const Cell& c) const {
  VertexMask outside = c.mask();
  for (const std::uint32_t side : c.sides) {
    const SideMasks::Masks& of_face = sides_.of_row(side / 2);
    outside |= side % 2 == 0 ? of_face.second : of_face.first;
  }
  return (~outside & all()) != 0;
}

void FillingCandidates::list_by_side() {
  begin_.assign(is_required_.size() + 1, 0);
  for (const Cell& c : cells_)
    for (const std::uint32_t side : c.sides) ++begin_[side + 1];
  for (std::size_t s = 1; s < begin_.size(); ++s) begin_[s] += begin_[s - 1];
  end_.assign(begin_.begin(), begin_.end() - 1);
  rows_.resize(4 * cells_.size());
  for (std::uint32_t row = 0; row < cells_.size(); ++row)
    for (const std::uint32_t side : cells_[row].sides) rows_[end_[side]++] = row;
}

/// Removes possible tetrahedra that have no other one across one of their inner faces, then those that needed the
/// removed ones, and so on. Rebuilds the lists of tetrahedra. Returns false if a boundary face has none left.
bool FillingCandidates::prune() {
  std::vector<std::uint32_t> n_beside(is_required_.size()), emptied;
  std::vector<std::uint8_t> is_gone(cells_.size(), 0);
  for (std::uint32_t side = 0; side < n_beside.size(); ++side) n_beside[side] = end_[side] - begin_[side];
  for (std::uint32_t side = 0; side < n_beside.size(); ++side) {
    if (is_required(side) && n_beside[side] == 0) return false;
    if (is_boundary(side / 2) ? !is_required(side) : n_beside[side ^ 1u] == 0) emptied.push_back(side);
  }
  while (!emptied.empty()) {
    const std::uint32_t side = emptied.back();
    emptied.pop_back();
    for (const std::uint32_t row : beside(side)) {
      if (is_gone[row]) continue;
      is_gone[row] = 1;
      for (const std::uint32_t other : cells_[row].sides) {
        if (--n_beside[other] > 0) continue;
        if (is_required(other)) return false;
        if (!is_boundary(other / 2)) emptied.push_back(other ^ 1u);
      }
    }
  }
  std::size_t n_left = 0;
  for (std::size_t row = 0; row < cells_.size(); ++row)
    if (!is_gone[row]) cells_[n_left++] = cells_[row];
  cells_.resize(n_left);
  list_by_side();
  return true;
}

}  // namespace geomesh::recover
