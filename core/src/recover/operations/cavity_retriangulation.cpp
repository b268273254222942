// SPDX-License-Identifier: MIT
#include "recover/operations/cavity_retriangulation.hpp"

#include <algorithm>

#include "common/sort_unique.hpp"
#include "recover/model/crossing.hpp"

namespace geomesh::recover {

namespace {

/// Returns the same hash key for the edges a-b and b-a.
std::uint64_t edge_key(VertexIndex a, VertexIndex b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

}  // namespace

Cavity::Cavity(const Recovery& recovery, std::vector<CellIndex> cells, VertexIndex dropped)
    : recovery_(recovery), cells_(std::move(cells)), dropped_(dropped) {
  std::vector<CellIndex> sorted = cells_;
  std::sort(sorted.begin(), sorted.end());
  const ConstrainedMesh& mesh = recovery_.mesh;
  for (const CellIndex c : cells_)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef face(c, i);
      const CellIndex beyond = mesh.cells().mirror(face).cell();
      const bool is_inside = std::binary_search(sorted.begin(), sorted.end(), beyond) && !mesh.is_locked(face);
      if (!is_inside && !is_of_dropped(face)) add_side(face);
    }
}

/// Returns whether a face of the cavity has the vertex that is to be removed from the mesh.
bool Cavity::is_of_dropped(FaceRef face) const {
  const TetMesh& cells = recovery_.mesh.cells();
  return dropped_ != no_vertex && cells.vertex(face.cell(), face.face()) != dropped_ &&
         cells.has_vertex(face.cell(), dropped_);
}

void Cavity::add_side(FaceRef face) {
  const TetMesh& cells = recovery_.mesh.cells();
  const auto& l = face_vertices[face.face()];
  const CellIndex c = face.cell();
  boundary_.push_back({{cells.vertex(c, l[0]), cells.vertex(c, l[1]), cells.vertex(c, l[2])}, face});
}

void Cavity::add_cell(CellIndex c) {
  const ConstrainedMesh& mesh = recovery_.mesh;
  for (unsigned i = 0; i < 4; ++i) {
    const FaceRef face(c, i), outer = mesh.cells().mirror(face);
    if (is_of_dropped(face)) continue;
    if (contains(outer.cell()) && !mesh.is_locked(face))
      std::erase_if(boundary_, [&](const BoundaryFace& s) { return s.inner == outer; });
    else
      add_side(face);
  }
  cells_.push_back(c);
}

bool Cavity::is_valid() const {
  const TetMesh& cells = recovery_.mesh.cells();
  std::vector<std::uint64_t> kept;
  std::vector<VertexIndex> vertices;
  for (const BoundaryFace& s : boundary_)
    for (unsigned i = 0; i < 3; ++i) {
      kept.push_back(edge_key(s.triangle[i], s.triangle[(i + 1) % 3]));
      vertices.push_back(s.triangle[i]);
    }
  sort_unique(kept);
  sort_unique(vertices);
  for (CellIndex c : cells_) {
    if (cells.is_ghost(c)) return false;
    for (const auto& e : edge_vertices) {
      const VertexIndex a = cells.vertex(c, e[0]), b = cells.vertex(c, e[1]);
      if (a == dropped_ || b == dropped_) continue;
      if (!std::binary_search(vertices.begin(), vertices.end(), a) ||
          !std::binary_search(vertices.begin(), vertices.end(), b))
        return false;
      if (!std::binary_search(kept.begin(), kept.end(), edge_key(a, b)) && recovery_.constraints.is_subsegment(a, b))
        return false;
    }
  }
  return true;
}

std::vector<Triangle> Cavity::boundary() const {
  std::vector<Triangle> out;
  for (const BoundaryFace& s : boundary_) out.push_back(s.triangle);
  return out;
}

bool Cavity::has_edge(VertexIndex a, VertexIndex b) const {
  return std::any_of(boundary_.begin(), boundary_.end(), [&](const BoundaryFace& s) {
    const Triangle& t = s.triangle;
    return (t[0] == a || t[1] == a || t[2] == a) && (t[0] == b || t[1] == b || t[2] == b);
  });
}

std::vector<VertexIndex> Cavity::neighbors(VertexIndex v) const {
  std::vector<VertexIndex> out;
  for (const BoundaryFace& s : boundary_)
    if (std::find(s.triangle.begin(), s.triangle.end(), v) != s.triangle.end())
      for (VertexIndex w : s.triangle)
        if (w != v) out.push_back(w);
  sort_unique(out);
  return out;
}

bool Cavity::may_grow_over(const BoundaryFace& side) const {
  const ConstrainedMesh& mesh = recovery_.mesh;
  if (!side.inner.valid() || mesh.is_locked(side.inner)) return false;
  const CellIndex n = mesh.cells().mirror(side.inner).cell();
  return !mesh.cells().is_ghost(n) && !std::binary_search(forbidden_.begin(), forbidden_.end(), n);
}

/// Adds the cell beyond a face to the cavity. Returns false, changing nothing, if this would enclose a constraint.
bool Cavity::grow_over(FaceRef face) {
  const std::vector<BoundaryFace> before = boundary_;
  add_cell(recovery_.mesh.cells().mirror(face).cell());
  if (!swallows_constraint(before)) return true;
  boundary_ = before;
  cells_.pop_back();
  return false;
}

/// Returns whether the cell added last moved a vertex or a subsegment of the previous boundary inside the cavity. Only
/// vertices and edges of this cell can be affected.
bool Cavity::swallows_constraint(const std::vector<BoundaryFace>& before) const {
  const CellIndex last = cells_.back();
  for (const BoundaryFace& side : before) {
    if (!side.inner.valid() || recovery_.mesh.cells().mirror(side.inner).cell() != last ||
        recovery_.mesh.is_locked(side.inner))
      continue;
    for (unsigned i = 0; i < 3; ++i) {
      const VertexIndex a = side.triangle[i], b = side.triangle[(i + 1) % 3];
      if (!has_edge(a, b) &&
          (neighbors(a).empty() || neighbors(b).empty() || recovery_.constraints.is_subsegment(a, b)))
        return true;
    }
  }
  return false;
}

std::optional<std::vector<Tetrahedron>> Cavity::star_from(VertexIndex y, unsigned max_growths) {
  std::vector<Tetrahedron> out;
  for (unsigned growth = 0;; ++growth) {
    out.clear();
    FaceRef hidden;
    for (const BoundaryFace& s : boundary_) {
      out.push_back({s.triangle[0], s.triangle[1], s.triangle[2], y});
      if (recovery_.mesh.positive(out.back())) continue;
      if (!may_grow_over(s)) return std::nullopt;
      hidden = s.inner;
    }
    if (!hidden.valid()) return out;
    if (growth >= max_growths || !grow_over(hidden)) return std::nullopt;
  }
}

std::optional<std::vector<Tetrahedron>> Cavity::fill(const CavityEffort& effort) const {
  return fill_polyhedron(recovery_.mesh, recovery_.constraints, boundary(), {effort.max_faces, effort.max_nodes});
}

namespace {

bool fill_with_sheet(Recovery& recovery, Cavity cavity, const Triangle& sheet, const CavityEffort& effort) {
  cavity.add_sheet(sheet);
  cavity.add_sheet({sheet[0], sheet[2], sheet[1]});
  const auto filling = cavity.fill(effort);
  if (!filling) return false;
  recovery.mesh.replace(cavity.cells(), *filling);
  return true;
}

}  // namespace

bool recover_segment_by_cavity(Recovery& recovery, VertexIndex a, VertexIndex b, const CavityEffort& effort) {
  LineCrossings line;
  if (!walk_line(recovery.mesh, a, b, line)) return false;
  std::sort(line.cells.begin(), line.cells.end());
  const Cavity cavity(recovery, std::move(line.cells));
  if (!cavity.is_valid()) return false;
  std::vector<VertexIndex> apexes;
  const Index s = recovery.constraints.subsegment_of(a, b);
  if (s != no_index)
    for (Index f : recovery.constraints.subsegments[s].subfacets)
      for (VertexIndex v : recovery.constraints.subfacets[f].vertices)
        if (v != a && v != b) apexes.push_back(v);
  for (VertexIndex v : cavity.neighbors(a)) apexes.push_back(v);
  std::vector<VertexIndex> tried;
  for (VertexIndex c : apexes) {
    if (std::find(tried.begin(), tried.end(), c) != tried.end() || !cavity.has_edge(a, c) || !cavity.has_edge(b, c))
      continue;
    tried.push_back(c);
    if (fill_with_sheet(recovery, cavity, {a, b, c}, effort)) return true;
  }
  return false;
}

bool recover_face_by_cavity(Recovery& recovery, const Triangle& t, std::vector<CellIndex> pierced,
                            const CavityEffort& effort) {
  const Cavity cavity(recovery, std::move(pierced));
  return cavity.is_valid() && fill_with_sheet(recovery, cavity, t, effort);
}

}  // namespace geomesh::recover
