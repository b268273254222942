// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/region_filling.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

#include "common/hash.hpp"
#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/steiner_removal/filling_candidates.hpp"
#include "recover/steiner_removal/sat_solver.hpp"

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

/// Returns those of the vertices, which must be sorted, that belong to none of the tetrahedra.
std::vector<VertexIndex> lost_vertices(const std::vector<VertexIndex>& vertices,
                                       const std::vector<Tetrahedron>& tetrahedra) {
  std::vector<VertexIndex> used, lost;
  for (const Tetrahedron& t : tetrahedra) used.insert(used.end(), t.begin(), t.end());
  sort_unique(used);
  std::set_difference(vertices.begin(), vertices.end(), used.begin(), used.end(), std::back_inserter(lost));
  return lost;
}

/// Adds neighbouring cells to a region, and their vertices to `vertices`, up to `max_vertices` vertices.
void spread(const ConstrainedMesh& mesh, std::span<const CellIndex> forbidden, std::vector<CellIndex>& cells,
            std::vector<VertexIndex>& vertices, std::size_t max_vertices) {
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

std::optional<Region> region_about(const Recovery& recovery, const std::vector<CellIndex>& seeds,
                                   std::span<const VertexIndex> dropped, std::size_t max_vertices,
                                   std::span<const CellIndex> forbidden) {
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

/// States the formula for the filling of a region and solves it. Its first variables are the possible cells, in order.
class RegionFiller {
 public:
  RegionFiller(const Region& region, const FillingCandidates& candidates) : region_(region), candidates_(candidates) {}

  std::optional<std::vector<Tetrahedron>> run(std::size_t max_conflicts) {
    if (!state() || solver_.solve(max_conflicts) != Satisfiability::satisfiable) return std::nullopt;
    std::vector<Tetrahedron> out;
    for (std::uint32_t i = 0; i < candidates_.cells().size(); ++i)
      if (solver_.is_true(i)) out.push_back(candidates_.global(candidates_.cells()[i]));
    return out;
  }

 private:
  /// Passes the formula that describes fillings of the region to the SAT solver. Returns false if clearly none exists.
  bool state() {
    const std::size_t n_cells = candidates_.cells().size(),
                      n_faces = std::min(2 * n_cells, candidates_.n_faces());  // a face has 2 or more possible cells
    solver_.reserve(n_cells + n_faces, 2 * n_faces, 4 * n_cells + 2 * n_faces);
    for (std::size_t i = 0; i < n_cells; ++i) solver_.new_variable();
    prefer_kept();
    for (std::uint32_t f = 0; f < candidates_.n_faces(); ++f) {
      const bool has_cells = !candidates_.beside(2 * f).empty() || !candidates_.beside(2 * f + 1).empty();
      if (!has_cells) continue;
      if (!candidates_.is_boundary(f)) state_inner(f);
      for (const std::uint32_t side : {2 * f, 2 * f + 1})
        if (candidates_.is_required(side)) state_boundary(side);
    }
    return state_segments();
  }
  /// Adds for each segment the clause that one of the tetrahedra with this edge is chosen.
  bool state_segments() {
    for (const auto& s : region_.segments) {
      const VertexMask ends = bit(candidates_.local(s[0])) | bit(candidates_.local(s[1]));
      clause_.clear();
      for (std::uint32_t c = 0; c < candidates_.cells().size(); ++c)
        if ((candidates_.cells()[c].mask() & ends) == ends) clause_.push_back(Literal::yes(c));
      if (clause_.empty()) return false;
      solver_.add_clause(clause_);
    }
    return true;
  }
  void prefer_kept() {
    std::vector<VertexMask> kept;
    for (const Tetrahedron& t : region_.kept) {
      VertexMask mask = 0;
      for (const VertexIndex v : t) mask |= bit(candidates_.local(v));
      kept.push_back(mask);
    }
    std::sort(kept.begin(), kept.end());
    for (std::uint32_t i = 0; i < candidates_.cells().size(); ++i)
      if (contains(kept, candidates_.cells()[i].mask())) solver_.prefer_yes(i);
  }
  void state_boundary(std::uint32_t side) {
    clause_.clear();
    for (const std::uint32_t c : candidates_.beside(side)) clause_.push_back(Literal::yes(c));
    solver_.add_clause(clause_);
    solver_.add_choice(candidates_.beside(side));
  }
  /// Adds clauses by which a triangle inside the region is a face of one chosen tetrahedron on each side, or of none.
  void state_inner(std::uint32_t face) {
    const std::uint32_t is_face = solver_.new_variable();
    for (const std::uint32_t side : {2 * face, 2 * face + 1}) {
      clause_.assign(1, Literal::no(is_face));
      for (const std::uint32_t c : candidates_.beside(side)) clause_.push_back(Literal::yes(c));
      solver_.add_clause(clause_);
      solver_.add_choice(candidates_.beside(side), is_face);
    }
  }

  const Region& region_;
  const FillingCandidates& candidates_;
  std::vector<Literal> clause_;
  SatSolver solver_;
};

}  // namespace

std::optional<std::vector<Tetrahedron>> fill_region(const ConstrainedMesh& mesh, const Constraints& constraints,
                                                    const Region& region, std::size_t max_conflicts) {
  if (region.vertices.size() > SideMasks::max_vertices) return std::nullopt;
  FillingCandidates candidates(mesh, constraints, region);
  if (!candidates.find()) return std::nullopt;
  auto filling = RegionFiller(region, candidates).run(max_conflicts);
  if (filling)
    for (const VertexIndex v : lost_vertices(region.vertices, *filling))
      if (v < mesh.n_input()) return std::nullopt;
  return filling;
}

void refill(ConstrainedMesh& mesh, const std::vector<CellIndex>& cells, const std::vector<Tetrahedron>& filling) {
  const std::vector<VertexIndex> lost = lost_vertices(vertices_of_cells(mesh.cells(), cells), filling);
  mesh.replace(cells, filling);
  for (const VertexIndex v : lost) mesh.forget(v);
}

namespace {

/// Returns a hash of all that determines a filling: vertices with places, boundary, segments and preferred cells.
std::uint64_t key_of(const ConstrainedMesh& mesh, const Region& region) {
  std::uint64_t key = 0;
  const auto add = [&key](std::uint64_t word) { key = mixed(key ^ word) + word; };
  const auto add_all = [&add](const auto& simplices) {
    add(simplices.size());
    for (const auto& simplex : simplices)
      for (const VertexIndex v : simplex) add(v);
  };
  for (const VertexIndex v : region.vertices) {
    add(v);
    for (std::size_t i = 0; i < 3; ++i) add(std::bit_cast<std::uint64_t>(mesh.point(v)[i]));
    if (!mesh.is_exact(v)) continue;
    const Vec3 rest = mesh.exact_places().rest_of(v);
    for (std::size_t i = 0; i < 3; ++i) add(std::bit_cast<std::uint64_t>(rest[i]));
  }
  add_all(region.boundary);
  add_all(region.segments);
  add_all(region.kept);
  return key;
}

}  // namespace

// Two regions with the same hash key would be taken for one; the worst result is a removable point that is kept.
std::optional<std::vector<Tetrahedron>> fill_region_once(Recovery& recovery, const Region& region) {
  const std::uint64_t key = key_of(recovery.mesh, region);
  if (recovery.refuted_regions.count(key) > 0) return std::nullopt;
  auto filling = fill_region(recovery.mesh, recovery.constraints, region, recovery_budget.region_conflicts);
  if (!filling) recovery.refuted_regions.insert(key);
  return filling;
}

}  // namespace geomesh::recover
