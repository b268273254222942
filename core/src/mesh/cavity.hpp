// SPDX-License-Identifier: MIT
/// @file
/// A cavity: a set of cells that is to be replaced. It grows across faces by a predicate (in-sphere, visibility). Then
/// cells are removed from it until a given point sees its whole border, so that the star of this point fills the
/// cavity.
///
/// The Delaunay triangulation has its own kind of cavity (delaunay/cavity_insertion.hpp), which tests four faces at a
/// time with vector instructions. ConstrainedMesh::find_cavity marks cells in their flags, because replace_by_star
/// needs them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/epoch_marks.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// A cavity that is stored in a list and in marks of the caller, which are set for exactly the cells in the list.
class Cavity {
 public:
  /// Starts a cavity with the cells `bases`, which are never removed from it. The mesh must not change meanwhile.
  Cavity(const TetMesh& mesh, EpochMarks& marks, std::vector<CellIndex>& cells, std::span<const CellIndex> bases)
      : mesh_(mesh), marks_(marks), cells_(cells), bases_(bases) {
    cells_.assign(bases.begin(), bases.end());
    marks_.begin();
    for (const CellIndex c : bases) marks_.mark(c);
  }

  bool has(CellIndex c) const { return marks_.marked(c); }
  const std::vector<CellIndex>& cells() const { return cells_; }
  void add(CellIndex c) {
    marks_.mark(c);
    cells_.push_back(c);
  }

  void erase(std::size_t i) {
    marks_.unmark(cells_[i]);
    cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  /// Adds each cell for which takes(cell) is true and that can be reached through faces for which may_cross(face) is
  /// true. These faces must have cells on both sides. Stops soon after the cavity has `most` cells.
  template <class MayCross, class Takes>
  void grow(std::size_t most, const MayCross& may_cross, const Takes& takes) {
    for (std::size_t k = 0; k < cells_.size() && cells_.size() < most; ++k)
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef f(cells_[k], i);
        if (!may_cross(f)) continue;
        const CellIndex n = mesh_.mirror(f).cell();
        if (!has(n) && takes(n)) add(n);
      }
  }

  /// Repeatedly removes cells of the cavity with a face on its border for which sees(face) is false, then cells that
  /// this separates from the initial cells. A face for which may_cross is false counts as on the border, unless
  /// is_inner(face) is true. Returns false if an initial cell would have to be removed.
  template <class MayCross, class IsInner, class Sees>
  bool shrink(const MayCross& may_cross, const IsInner& is_inner, const Sees& sees) {
    std::vector<CellIndex> given_up;
    const auto give_up = [&](CellIndex c) {
      marks_.unmark(c);
      given_up.push_back(c);
      return std::find(bases_.begin(), bases_.end(), c) == bases_.end();
    };
    const auto sees_border = [&](CellIndex c) {
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef f(c, i);
        if (may_cross(f) ? has(mesh_.mirror(f).cell()) : is_inner(f)) continue;
        if (!sees(f)) return false;
      }
      return true;
    };
    for (const CellIndex c : cells_)
      if (!sees_border(c) && !give_up(c)) return false;
    for (std::size_t k = 0; k < given_up.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef f(given_up[k], i);
        if (!may_cross(f)) continue;
        const FaceRef n = mesh_.mirror(f);
        if (has(n.cell()) && !sees(n) && !give_up(n.cell())) return false;
      }
    if (!given_up.empty()) keep_connected(may_cross);
    return true;
  }

 private:
  template <class MayCross>
  void keep_connected(const MayCross& may_cross) {
    std::vector<CellIndex> kept(bases_.begin(), bases_.end());
    for (const CellIndex c : bases_) marks_.unmark(c);
    for (std::size_t k = 0; k < kept.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) {
        const FaceRef f(kept[k], i);
        if (!may_cross(f)) continue;
        const CellIndex n = mesh_.mirror(f).cell();
        if (!has(n)) continue;
        marks_.unmark(n);
        kept.push_back(n);
      }
    for (const CellIndex c : cells_) marks_.unmark(c);
    for (const CellIndex c : kept) marks_.mark(c);
    cells_ = std::move(kept);
  }

  const TetMesh& mesh_;
  EpochMarks& marks_;
  std::vector<CellIndex>& cells_;
  std::span<const CellIndex> bases_;
};

}  // namespace geomesh
