// SPDX-License-Identifier: MIT
#pragma once

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::remesh {

/// The live cells of a mesh, in the order of their slots, for a range-based `for`. Slots that are added during the loop
/// are not visited. `std::views::filter` is not used: clang 14 cannot compile it with libstdc++ 12.
///
/// The type Mesh must have `bool is_live(CellIndex)` and `CellIndex n_slots()`.
template <class Mesh>
class LiveCells {
 public:
  struct End {};

  class Iterator {
   public:
    Iterator(const Mesh& mesh, CellIndex end) : mesh_(&mesh), end_(end) { to_live(); }
    CellIndex operator*() const { return at_; }
    Iterator& operator++() {
      ++at_;
      to_live();
      return *this;
    }
    bool operator==(End) const { return at_ == end_; }

   private:
    void to_live() {
      while (at_ != end_ && !mesh_->is_live(at_)) ++at_;
    }

    const Mesh* mesh_;
    CellIndex at_ = 0, end_;
  };

  explicit LiveCells(const Mesh& mesh) : mesh_(mesh), end_(mesh.n_slots()) {}
  Iterator begin() const { return {mesh_, end_}; }
  End end() const { return {}; }

 private:
  const Mesh& mesh_;
  CellIndex end_;
};

}  // namespace geomesh::remesh
