// SPDX-License-Identifier: MIT
/// @file
/// What a DomainMesh was before a trial, so that the trial can be undone.
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

/// A cell that was live has vertices; of a free slot nothing else is of interest.
struct SavedCell {
  CellIndex cell;
  TetMesh::Cell links;
  Index component;
  std::array<FaceTag, 4> tags;
  double shape;
};

/// The class of a curve edge, no_index where it was none.
struct SavedCurve {
  VertexIndex a, b;
  Index curve;
};

/// A slot that was taken or freed.
struct SlotEvent {
  enum class What : std::uint8_t { freed, reused, made };
  CellIndex cell;
  What what;
};

/// Each vertex and each cell is saved before its first change; slots and curve edges at every change, in order.
class MeshJournal {
 public:
  struct Start {
    std::size_t n_vertices;
    CellIndex n_slots;
    std::uint64_t clock;
  };

  bool is_open() const { return open_; }
  const Start& start() const { return start_; }
  void open(const Start& start) {
    open_ = true;
    start_ = start;
    n_slots_ = start.n_slots;
    vertices_.clear();
    cells_.clear();
    curves_.clear();
    slots_.clear();
    vertex_marks_.begin(start.n_vertices);
    cell_marks_.begin(start.n_slots);
  }
  void close() { open_ = false; }

  /// Whether it was there at the start and is not saved yet; it counts as saved from now on.
  bool is_new_vertex(VertexIndex v) { return v < start_.n_vertices && vertex_marks_.mark_first(v); }
  bool is_new_cell(CellIndex c) { return c < start_.n_slots && cell_marks_.mark_first(c); }

  void save(const SavedVertex& v) { vertices_.push_back(v); }
  void save(const SavedCell& c) { cells_.push_back(c); }
  void save(const SavedCurve& c) { curves_.push_back(c); }
  void note_freed(CellIndex c) { slots_.push_back({c, SlotEvent::What::freed}); }
  void note_added(CellIndex c) {
    const bool is_made = c == n_slots_;
    n_slots_ += is_made;
    slots_.push_back({c, is_made ? SlotEvent::What::made : SlotEvent::What::reused});
    if (is_new_cell(c)) save(SavedCell{c, {{no_vertex, no_vertex, no_vertex, no_vertex}, {}}, no_index, {}, 0});
  }

  const std::vector<SavedVertex>& vertices() const { return vertices_; }
  const std::vector<SavedCell>& cells() const { return cells_; }
  const std::vector<SavedCurve>& curves() const { return curves_; }
  const std::vector<SlotEvent>& slots() const { return slots_; }

 private:
  bool open_ = false;
  Start start_{};
  CellIndex n_slots_ = 0;
  std::vector<SavedVertex> vertices_;
  std::vector<SavedCell> cells_;
  std::vector<SavedCurve> curves_;
  std::vector<SlotEvent> slots_;
  EpochMarks vertex_marks_, cell_marks_;
};

}  // namespace geomesh::remesh
