// SPDX-License-Identifier: MIT
// Implements changes of ConstrainedMesh: exchanges of cells for others in one region, and the journal to undo them.
#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

void ConstrainedMesh::replace(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra) {
  const bool is_noted = journal_depth_ > 0;
  if (is_noted) {
    journal_.push_back({journal_removed_.size(), journal_created_.size()});
    for (CellIndex c : old_cells) journal_removed_.push_back(mesh_.vertices(c));
  } else {
    begin_change();
    for (CellIndex c : old_cells) note_change(mesh_.vertices(c));
    for (const Tetrahedron& t : tetrahedra) note_change(t);
  }
  exchange_cells(old_cells, tetrahedra, is_noted);
}

void ConstrainedMesh::exchange_cells(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra,
                                     bool is_noted) {
  const auto make = [&](std::size_t k) {
    if (k == 0) created_.clear();  // cleared this late because the removed cells may be listed in created_
    const CellIndex c = mesh_.add_cell(tetrahedra[k]);
    created_.push_back(c);
    if (is_noted) journal_created_.push_back({tetrahedra[k], c});
    for (VertexIndex v : tetrahedra[k]) cell_of_[v] = c;
    return c;
  };
  const auto nothing = [](CellIndex) {};
  exchange(old_cells, tetrahedra.size(), make, nothing, nothing);
}

/// Turns around edge p-q from a cell of the cavity through its face `exit`, and returns the first face of the cavity's
/// boundary, as seen from outside.
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
  // Cells outside the cavity are linked to the new cells. Old cells keep their links, for turns around edges inside it.
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
  if (!journal_.empty()) {
    begin_change();
    for (const Tetrahedron& t : journal_removed_) note_change(t);
    for (const CreatedCell& c : journal_created_) note_change(c.vertices);
  }
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
      // The cell may be in another slot than at its creation. A positive (a,b,c,d) is then found above its face a,b,c.
      const auto& [t, slot] = journal_created_[i];
      cells.push_back(mesh_.vertices(slot) == t ? slot : find_face(t[0], t[1], t[2]).cell());
    }
    exchange_cells(cells, std::span(journal_removed_).subspan(entry.removed), false);
    journal_created_.resize(entry.created);
    journal_removed_.resize(entry.removed);
  }
  journal_depth_ = depth;
  keep();
}

}  // namespace geomesh::recover
