// SPDX-License-Identifier: MIT
// ConstrainedMesh's changes: cells exchanged for others of the same region, and the journal that takes them back.
#include <algorithm>
#include <bit>

#include "common/geometry.hpp"
#include "common/hash.hpp"
#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

namespace {

Triangle sorted_face(const TetMesh& mesh, FaceRef f) {
  const auto& local = face_vertices[f.face()];
  const auto& v = mesh.vertices(f.cell());
  return sorted({v[local[0]], v[local[1]], v[local[2]]});
}

}  // namespace

void ConstrainedMesh::replace(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra) {
  if (journal_depth_ > 0) {
    journal_.push_back({journal_removed_.size(), journal_created_.size()});
    for (CellIndex c : old_cells) journal_removed_.push_back(mesh_.vertices(c));
  }
  for (CellIndex c : old_cells) mesh_.flags(c) |= cavity_flag;
  await_faces(4 * (old_cells.size() + tetrahedra.size()));
  inner_locks_.clear();
  for (CellIndex c : old_cells)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef outer = mesh_.neighbor(c, i);
      if (!(mesh_.flags(outer.cell()) & cavity_flag)) {
        link_or_wait(outer);
      } else if (is_locked(outer)) {
        inner_locks_.push_back(sorted_face(mesh_, outer));
      }
    }
  for (CellIndex c : old_cells) mesh_.free_cell(c);
  created_.clear();
  for (const Tetrahedron& t : tetrahedra) {
    const CellIndex c = mesh_.add_cell(t);
    created_.push_back(c);
    if (journal_depth_ > 0) journal_created_.push_back({t, c});
    for (unsigned i = 0; i < 4; ++i) link_or_wait(FaceRef(c, i));
    for (VertexIndex v : t) cell_of_[v] = c;
  }
  GEOMESH_CHECK(n_waiting_ == 0);
}

/// Before the first of at most `n_faces` calls of link_or_wait.
void ConstrainedMesh::await_faces(std::size_t n_faces) {
  const std::size_t size = std::bit_ceil(n_faces + 1);
  if (waiting_.size() < size) waiting_.resize(size);
  std::fill(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(size), WaitingFace{});
  waiting_mask_ = size - 1;
  n_waiting_ = 0;
}

/// Links the face with the one of the same vertices that waits, or lets it wait for that one. Which waits where changes
/// nothing.
void ConstrainedMesh::link_or_wait(FaceRef f) {
  const Triangle key = sorted_face(mesh_, f);
  for (std::size_t i = hash_of(key) & waiting_mask_;; i = (i + 1) & waiting_mask_) {
    WaitingFace& slot = waiting_[i];
    if (!slot.face.valid()) {
      slot = {key, f, false};
      ++n_waiting_;
      return;
    }
    if (slot.key[0] != key[0] || slot.key[1] != key[1] || slot.key[2] != key[2]) continue;
    const FaceRef g = slot.face;
    GEOMESH_CHECK(!slot.is_linked);
    mesh_.link(f, g);
    slot.is_linked = true;
    --n_waiting_;
    const bool was_inside =
        !inner_locks_.empty() && std::find(inner_locks_.begin(), inner_locks_.end(), key) != inner_locks_.end();
    if (is_locked(f) || is_locked(g) || was_inside) lock(f);
    return;
  }
}

/// From a cell of the cavity about edge p-q, through its face `exit` and on: the face of the cavity's boundary that
/// comes first, from outside.
FaceRef ConstrainedMesh::boundary_about_edge(CellIndex cell, unsigned exit, VertexIndex p, VertexIndex q) const {
  FaceRef next = mesh_.neighbor(cell, exit);
  while (is_in_cavity(next.cell())) {
    const CellIndex c = next.cell();
    next = mesh_.neighbor(c, 6 - mesh_.index_of(c, p) - mesh_.index_of(c, q) - next.face());
  }
  return next;
}

void ConstrainedMesh::replace_by_star(std::span<const CellIndex> cavity, VertexIndex x) {
  GEOMESH_CHECK(journal_depth_ == 0);
  created_.clear();
  star_faces_.clear();
  // The old cells keep their links, so that they can be turned in; their outer neighbours lead to the new ones.
  for (const CellIndex c : cavity)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef outer = mesh_.neighbor(c, i);
      if (is_in_cavity(outer.cell())) continue;
      const auto v = mesh_.vertices(c);
      const auto& l = face_vertices[i];
      const CellIndex made = mesh_.add_cell({v[l[0]], v[l[1]], v[l[2]], x});
      mesh_.link(FaceRef(made, 3), outer);
      created_.push_back(made);
      star_faces_.push_back(FaceRef(c, i));
    }
  for (std::size_t k = 0; k < created_.size(); ++k) {
    const CellIndex made = created_[k];
    const auto v = mesh_.vertices(made);
    for (unsigned j = 0; j < 3; ++j) {
      if (mesh_.neighbor(made, j).valid()) continue;
      const VertexIndex p = v[(j + 1) % 3], q = v[(j + 2) % 3];
      const FaceRef outer = boundary_about_edge(star_faces_[k].cell(), face_vertices[star_faces_[k].face()][j], p, q);
      const CellIndex other = mesh_.mirror(outer).cell();
      mesh_.link(FaceRef(made, j), FaceRef(other, 3 - mesh_.index_of(other, p) - mesh_.index_of(other, q)));
    }
    for (const VertexIndex u : v) cell_of_[u] = made;
  }
  for (const CellIndex c : cavity) {
    mesh_.flags(c) = 0;
    mesh_.free_cell(c);
  }
}

std::size_t ConstrainedMesh::mark() {
  ++journal_depth_;
  return journal_.size();
}

void ConstrainedMesh::keep() {
  if (--journal_depth_ > 0) return;
  journal_.clear();
  journal_removed_.clear();
  journal_created_.clear();
}

void ConstrainedMesh::roll_back(std::size_t mark) {
  const std::size_t depth = journal_depth_;
  journal_depth_ = 0;
  std::vector<CellIndex> cells;
  while (journal_.size() > mark) {
    const JournalEntry entry = journal_.back();
    journal_.pop_back();
    cells.clear();
    for (std::size_t i = entry.created; i < journal_created_.size(); ++i) {
      // Slots are reused, so it may have come back to another; a positive cell (a,b,c,d) is the one above its face
      // a,b,c.
      const auto& [t, slot] = journal_created_[i];
      cells.push_back(mesh_.vertices(slot) == t ? slot : find_face(t[0], t[1], t[2]).cell());
    }
    replace(cells, std::span(journal_removed_).subspan(entry.removed));
    journal_created_.resize(entry.created);
    journal_removed_.resize(entry.removed);
  }
  journal_depth_ = depth;
  keep();
}

}  // namespace geomesh::recover
