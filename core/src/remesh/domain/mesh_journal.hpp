// SPDX-License-Identifier: MIT
/// @file
/// Records the former state of a DomainMesh during a trial, so that the trial can be undone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/epoch_marks.hpp"
#include "remesh/domain/mesh_elements.hpp"

namespace geomesh::remesh {

struct SavedVertex {
  VertexIndex vertex;
  Vec3 point;
  VertexKind kind;
  Index support;
  CellIndex incident;
  std::uint64_t changed;
};

/// The saved state of a cell slot. A live cell has vertices; a free slot needs no other data.
struct SavedCell {
  CellIndex cell;
  TetMesh::Cell links{{no_vertex, no_vertex, no_vertex, no_vertex}, {}};
  Index component = no_index;
  std::array<FaceTag, 4> tags{};
  double shape = 0;
};

/// The saved class of an edge on a curve, or no_index if the edge was on no curve.
struct SavedCurve {
  VertexIndex a, b;
  Index curve;
};

/// A change of a cell slot, which was freed, reused or added.
struct SlotEvent {
  enum class What : std::uint8_t { freed, reused, made };
  CellIndex cell;
  What what;
};

/// The recorded changes of an undoable trial. Vertices and cells are saved before their first change. Slots and curve
/// edges are saved at every change, in order.
struct MeshJournal {
  bool is_open = false;
  std::size_t n_vertices = 0;  ///< number of vertices at the start of the undoable trial
  CellIndex n_slots = 0;
  std::uint64_t clock = 0;
  std::vector<SavedVertex> vertices;
  std::vector<SavedCell> cells;
  std::vector<SavedCurve> curves;
  std::vector<SlotEvent> slots;

  void open(std::size_t vertices_before, CellIndex slots_before, std::uint64_t clock_before) {
    is_open = true;
    n_vertices = vertices_before, n_slots = slots_now_ = slots_before, clock = clock_before;
    vertices.clear(), cells.clear(), curves.clear(), slots.clear();
    vertex_marks_.begin();
    cell_marks_.begin();
  }
  /// Returns whether the vertex is older than the undoable trial and not yet saved in it, and marks it as saved.
  bool is_new_vertex(VertexIndex v) { return v < n_vertices && vertex_marks_.mark_first(v); }
  bool is_new_cell(CellIndex c) { return c < n_slots && cell_marks_.mark_first(c); }
  void note_freed(CellIndex c) { slots.push_back({c, SlotEvent::What::freed}); }
  void note_added(CellIndex c) {
    const bool is_made = c == slots_now_;
    slots_now_ += is_made;
    slots.push_back({c, is_made ? SlotEvent::What::made : SlotEvent::What::reused});
    if (is_new_cell(c)) cells.push_back({.cell = c});
  }

 private:
  CellIndex slots_now_ = 0;
  EpochMarks vertex_marks_, cell_marks_;
};

}  // namespace geomesh::remesh
