// SPDX-License-Identifier: MIT
#include "recover/region_filling.hpp"

#include <algorithm>
#include <bit>

#include "recover/sat_solver.hpp"
#include "recover/side_masks.hpp"
#include "recover/sort_unique.hpp"

namespace geomesh::recover {

namespace {

template <class T>
bool contains(const std::vector<T>& sorted, const T& value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

std::vector<VertexIndex> vertices_of_cells(const TetMesh& cells, const std::vector<CellIndex>& list) {
  std::vector<VertexIndex> out;
  for (CellIndex c : list) out.insert(out.end(), cells.vertices(c).begin(), cells.vertices(c).end());
  sort_unique(out);
  return out;
}

/// Adds neighbours to the cells, and their vertices to `vertices`, while there is room.
void spread(const ConstrainedMesh& mesh, std::span<const CellIndex> forbidden, std::vector<CellIndex>& cells, std::vector<VertexIndex>& vertices,
            std::size_t max_vertices) {
  std::vector<CellIndex> in = cells;
  std::sort(in.begin(), in.end());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (unsigned f = 0; f < 4; ++f) {
      const FaceRef face(cells[i], f);
      const CellIndex next = mesh.cells().neighbor_cell(cells[i], f);
      if (mesh.is_locked(face) || mesh.cells().is_ghost(next) || contains(in, next)) continue;
      if (std::binary_search(forbidden.begin(), forbidden.end(), next)) continue;
      const VertexIndex apex = mesh.cells().vertex(next, mesh.cells().mirror(face).face());
      const auto place = std::lower_bound(vertices.begin(), vertices.end(), apex);
      if (place == vertices.end() || *place != apex) {
        if (vertices.size() >= max_vertices) continue;
        vertices.insert(place, apex);
      }
      in.insert(std::lower_bound(in.begin(), in.end(), next), next);
      cells.push_back(next);
    }
}

}  // namespace

std::optional<Region> region_about(const Recovery& recovery, const std::vector<CellIndex>& seeds, std::span<const VertexIndex> dropped,
                                   std::size_t max_vertices, std::span<const CellIndex> forbidden) {
  const ConstrainedMesh& mesh = recovery.mesh;
  const TetMesh& cells = mesh.cells();
  const auto is_dropped = [&](VertexIndex v) { return std::find(dropped.begin(), dropped.end(), v) != dropped.end(); };
  Region out;
  out.cells = seeds;
  out.vertices = vertices_of_cells(cells, seeds);
  if (out.vertices.size() > max_vertices + dropped.size()) return std::nullopt;
  spread(mesh, forbidden, out.cells, out.vertices, max_vertices + dropped.size());
  std::erase_if(out.vertices, is_dropped);
  std::vector<CellIndex> in = out.cells;
  std::sort(in.begin(), in.end());
  for (CellIndex c : out.cells) {
    const Tetrahedron& v = cells.vertices(c);
    if (std::none_of(v.begin(), v.end(), is_dropped)) out.kept.push_back(v);
    for (unsigned i = 0; i < 4; ++i) {
      const auto& l = face_vertices[i];
      const Triangle t{v[l[0]], v[l[1]], v[l[2]]};
      if (!mesh.is_locked(FaceRef(c, i)) && contains(in, cells.neighbor_cell(c, i))) continue;
      if (std::none_of(t.begin(), t.end(), is_dropped)) out.boundary.push_back(t);
    }
    for (const auto& e : edge_vertices) {
      const VertexIndex a = std::min(v[e[0]], v[e[1]]), b = std::max(v[e[0]], v[e[1]]);
      if (!is_dropped(a) && !is_dropped(b) && recovery.constraints.is_subsegment(a, b)) out.segments.push_back({a, b});
    }
  }
  sort_unique(out.segments);
  return out;
}

namespace {

class RegionFiller {
 public:
  RegionFiller(const ConstrainedMesh& mesh, const Constraints& constraints, const Region& region)
      : constraints_(constraints), region_(region), n_(region.vertices.size()), sides_(mesh, region.vertices), faces_(n_ * (n_ - 1) * (n_ - 2) / 6),
        forced_(n_, 0), allowed_(n_, 0) {
    for (const Triangle& t : region.boundary) boundary_.push_back(local(t));
    for (const auto& s : region.segments) force_edge(local(s[0]), local(s[1]));
    for (const LocalTriangle& t : boundary_)
      for (unsigned i = 0; i < 3; ++i) force_edge(t[i], t[(i + 1) % 3]);
  }

  std::optional<std::vector<Tetrahedron>> run(std::size_t max_conflicts) {
    sides_.decide_all();
    find_allowed_edges();
    gather_candidates();
    if (!state()) return std::nullopt;
    if (solver_.solve(max_conflicts) != Satisfiability::satisfiable) return std::nullopt;
    std::vector<Tetrahedron> out;
    for (std::uint32_t i = 0; i < cells_.size(); ++i)
      if (solver_.is_true(i)) out.push_back(global(cells_[i]));
    return out;
  }

 private:
  using Cell = std::array<LocalVertex, 4>;
  enum class Presence : std::uint8_t { unknown, allowed, pierced };

  /// A triangle of three vertices in increasing order.
  struct Face {
    Presence presence = Presence::unknown;
    bool required[2] = {false, false};         ///< the boundary asks for a cell above, below
    std::vector<std::uint32_t> cells[2];       ///< candidates above, below
  };

  LocalVertex local(VertexIndex v) const {
    return static_cast<LocalVertex>(std::lower_bound(region_.vertices.begin(), region_.vertices.end(), v) - region_.vertices.begin());
  }
  LocalTriangle local(const Triangle& t) const { return {local(t[0]), local(t[1]), local(t[2])}; }
  Tetrahedron global(const Cell& c) const {
    return {region_.vertices[c[0]], region_.vertices[c[1]], region_.vertices[c[2]], region_.vertices[c[3]]};
  }
  void force_edge(LocalVertex a, LocalVertex b) {
    forced_[a] |= bit(b);
    forced_[b] |= bit(a);
  }
  VertexMask all() const { return n_ == 64 ? ~VertexMask{0} : (VertexMask{1} << n_) - 1; }

  /// The face, and whether the triangle is an odd permutation of its vertices.
  std::pair<Face*, bool> face_of(LocalTriangle t) {
    bool odd = false;
    for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
      if (t[i] > t[j]) {
        std::swap(t[i], t[j]);
        odd = !odd;
      }
    const std::size_t i = t[0], j = t[1], k = t[2];
    return {&faces_[k * (k - 1) * (k - 2) / 6 + j * (j - 1) / 2 + i], odd};
  }

  /// a-b, whose ends lie strictly on either side of t, passes through the inside of t or its border.
  bool crosses(LocalVertex a, LocalVertex b, const LocalTriangle& t) {
    const int s0 = sides_.sign(a, b, t[0], t[1]), s1 = sides_.sign(a, b, t[1], t[2]), s2 = sides_.sign(a, b, t[2], t[0]);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
  }
  /// a-b passes through the inside of a forced edge in a plane of both: each has its ends strictly on either side of the other.
  bool crosses_forced_in_plane(LocalVertex a, LocalVertex b) {
    for (LocalVertex c = 0; c < n_; ++c) {
      if (c == a || c == b) continue;
      const VertexMask off = sides_.above({a, b, c}) | sides_.below({a, b, c});
      if (off == 0) continue;
      const LocalVertex apex = lowest(off);
      for (VertexMask of_d = forced_[c] & beyond(c) & ~(off | bit(a) | bit(b)); of_d != 0; of_d &= of_d - 1) {
        const LocalVertex d = lowest(of_d);
        if (sides_.sign(apex, a, b, c) * sides_.sign(apex, a, b, d) < 0 && sides_.sign(apex, c, d, a) * sides_.sign(apex, c, d, b) < 0) return true;
      }
    }
    return false;
  }
  /// Edges that cross no boundary triangle and no edge that must be there, as masks of the other ends.
  void find_allowed_edges() {
    for (LocalVertex a = 0; a < n_; ++a)
      for (LocalVertex b = 0; b < a; ++b) {
        if (constraints_.skips_added_points(region_.vertices[a], region_.vertices[b]) || crosses_forced_in_plane(a, b)) continue;
        allowed_[a] |= bit(b);
        allowed_[b] |= bit(a);
      }
    for (const LocalTriangle& t : boundary_) forbid_edges_through(t);
  }
  void forbid_edges_through(const LocalTriangle& t) {
    const VertexMask above = sides_.above(t), below = sides_.below(t);
    for (VertexMask of_a = above; of_a != 0; of_a &= of_a - 1) {
      const LocalVertex a = lowest(of_a);
      for (VertexMask of_b = below & allowed_[a]; of_b != 0; of_b &= of_b - 1) {
        const LocalVertex b = lowest(of_b);
        if (!crosses(a, b, t)) continue;
        allowed_[a] &= ~bit(b);
        allowed_[b] &= ~bit(a);
      }
    }
  }
  bool is_pierced(const LocalTriangle& t) {
    Presence& p = face_of(t).first->presence;
    if (p == Presence::unknown) p = is_pierced_by_forced(t) ? Presence::pierced : Presence::allowed;
    return p == Presence::pierced;
  }
  bool is_pierced_by_forced(const LocalTriangle& t) {
    const VertexMask above = sides_.above(t), below = sides_.below(t);
    for (VertexMask of_a = above; of_a != 0; of_a &= of_a - 1) {
      const LocalVertex a = lowest(of_a);
      for (VertexMask of_b = below & forced_[a]; of_b != 0; of_b &= of_b - 1)
        if (crosses(a, lowest(of_b), t)) return true;
    }
    return false;
  }

  void gather_candidates() {
    for (LocalVertex a = 0; a < n_; ++a)
      for (VertexMask of_b = allowed_[a] & beyond(a); of_b != 0; of_b &= of_b - 1) {
        const LocalVertex b = lowest(of_b);
        for (VertexMask of_c = allowed_[a] & allowed_[b] & beyond(b); of_c != 0; of_c &= of_c - 1) {
          const LocalVertex c = lowest(of_c);
          if (is_pierced({a, b, c})) continue;
          const VertexMask above = sides_.above({a, b, c}), beside = above | sides_.below({a, b, c});
          for (VertexMask of_d = allowed_[a] & allowed_[b] & allowed_[c] & beside & beyond(c); of_d != 0; of_d &= of_d - 1)
            add_candidate(above & of_d & -of_d ? Cell{a, b, c, lowest(of_d)} : Cell{b, a, c, lowest(of_d)});
        }
      }
  }
  static LocalVertex lowest(VertexMask m) { return static_cast<LocalVertex>(std::countr_zero(m)); }
  static VertexMask beyond(LocalVertex v) { return v == 63 ? 0 : ~VertexMask{0} << (v + 1); }
  /// A positive cell whose edges cross nothing, unless it is pierced or holds another vertex.
  void add_candidate(const Cell& cell) {
    const auto& [a, b, c, d] = cell;
    if (is_pierced({a, b, d}) || is_pierced({a, c, d}) || is_pierced({b, c, d})) return;
    VertexMask outside = bit(a) | bit(b) | bit(c) | bit(d);
    for (const auto& l : face_vertices) outside |= sides_.below({cell[l[0]], cell[l[1]], cell[l[2]]});
    if (~outside & all()) return;
    for (const auto& l : face_vertices) {
      const auto [face, odd] = face_of({cell[l[0]], cell[l[1]], cell[l[2]]});
      face->cells[odd].push_back(static_cast<std::uint32_t>(cells_.size()));
    }
    cells_.push_back(cell);
  }

  /// False where that shows already that there is no filling.
  bool state() {
    for (const LocalTriangle& t : boundary_) {
      const auto [face, odd] = face_of(t);
      face->required[odd] = true;
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) solver_.new_variable();
    prefer_kept();
    for (Face& f : faces_) {
      const bool is_boundary = f.required[0] || f.required[1];
      if (!is_boundary && f.cells[0].empty() && f.cells[1].empty()) continue;
      for (unsigned side = 0; side < 2; ++side) {
        if (f.required[side] && f.cells[side].empty()) return false;
        if (is_boundary) state_boundary(f.cells[side], f.required[side]);
      }
      if (!is_boundary) state_inner(f);
    }
    return state_segments();
  }
  /// Each segment is an edge of some cell.
  bool state_segments() {
    for (const auto& s : region_.segments) {
      const VertexMask ends = bit(local(s[0])) | bit(local(s[1]));
      clause_.clear();
      for (std::uint32_t c = 0; c < cells_.size(); ++c)
        if (std::popcount(vertices_of(cells_[c]) & ends) == 2) clause_.push_back(Literal(c, false));
      if (clause_.empty()) return false;
      solver_.add_clause(clause_);
    }
    return true;
  }
  static VertexMask vertices_of(const Cell& c) { return bit(c[0]) | bit(c[1]) | bit(c[2]) | bit(c[3]); }
  void prefer_kept() {
    std::vector<Tetrahedron> kept;
    for (Tetrahedron t : region_.kept) {
      std::sort(t.begin(), t.end());
      kept.push_back(t);
    }
    std::sort(kept.begin(), kept.end());
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
      Tetrahedron t = global(cells_[i]);
      std::sort(t.begin(), t.end());
      if (contains(kept, t)) solver_.prefer(i, true);
    }
  }
  void state_boundary(const std::vector<std::uint32_t>& cells, bool required) {
    clause_.clear();
    for (std::uint32_t c : cells) {
      if (required) clause_.push_back(Literal(c, false));
      if (const Literal no = Literal(c, true); !required) solver_.add_clause({&no, 1});
    }
    if (!required) return;
    solver_.add_clause(clause_);
    solver_.add_choice(cells);
  }
  /// A cell on one side makes the triangle a face, and a face has a cell on each side.
  void state_inner(const Face& f) {
    const std::uint32_t is_face = solver_.new_variable();
    for (const std::vector<std::uint32_t>& cells : f.cells) {
      clause_.assign(1, Literal(is_face, true));
      for (std::uint32_t c : cells) clause_.push_back(Literal(c, false));
      solver_.add_clause(clause_);
      solver_.add_choice(cells, is_face);
    }
  }
  const Constraints& constraints_;
  const Region& region_;
  std::size_t n_;
  SideMasks sides_;
  std::vector<Face> faces_;
  std::vector<LocalTriangle> boundary_;
  std::vector<VertexMask> forced_;   ///< the other ends of edges that must be there
  std::vector<VertexMask> allowed_;  ///< of edges that may be there
  std::vector<Cell> cells_;
  std::vector<Literal> clause_;
  SatSolver solver_;
};

}  // namespace

std::optional<std::vector<Tetrahedron>> fill_region(const ConstrainedMesh& mesh, const Constraints& constraints, const Region& region,
                                                    std::size_t max_conflicts) {
  if (region.vertices.size() > SideMasks::max_vertices) return std::nullopt;
  return RegionFiller(mesh, constraints, region).run(max_conflicts);
}

}  // namespace geomesh::recover
