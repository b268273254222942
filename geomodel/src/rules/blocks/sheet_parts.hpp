// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A horizon cut by fault blocks: which pieces of it hang together within one block.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "rules/blocks/throw_blocks.hpp"

namespace geomesh::geomodel {

/// What of a triangle lies in one block; no_index: outside of the model.
struct Fragment {
  Index triangle, block;
  double area;
};

/// The parts of a horizon's sheets: blocks cut triangles into fragments, and fragments of one sheet and one block that
/// hang together across edges are a part. Refers to the horizon and the setting, which outlive it.
class SheetParts {
 public:
  using Areas = std::map<Index, std::map<Index, double>>;  ///< by part and block

  /// `sheet`: as sort_into_blocks takes it.
  SheetParts(const TriangulatedSurface& horizon, const std::vector<Index>& sheet, const SortingSetting& setting);

  Index n() const { return n_; }
  Index n_fragments() const { return static_cast<Index>(fragments_.size()); }
  const Fragment& fragment(Index i) const { return fragments_[i]; }
  Index first_fragment(Index t) const { return first_[t]; }  ///< of a triangle, or one behind the last
  Index part(Index i) const { return part_[i]; }             ///< of a fragment: the first fragment of its part
  Index sheet(Index t) const { return sheet_[t]; }
  /// Whether a triangle crosses a fault as given, or touches it.
  bool touches(Index t, std::size_t fault) const { return crossed_[fault][t] == Crossing::fault; }
  bool touches_fault(Index t) const;
  /// Whether a triangle meets faults as given, and nothing that continues one in the box.
  bool meets_fault(Index t) const { return meets_[t] == Meets::fault; }
  bool meets_nothing(Index t) const { return meets_[t] == Meets::nothing; }
  bool is_whole(Index t) const { return first_[t + 1] == first_[t] + 1; }
  bool is_outside(Index t) const { return is_whole(t) && block(t) == no_index; }
  /// Whether some of a triangle that meets faults or their continuations lies outside of the model.
  bool reaches_outside(Index t) const { return reaches_outside_[t]; }
  /// The block of a triangle that lies in one; no_index for others.
  Index block(Index t) const { return is_whole(t) ? fragments_[first_[t]].block : no_index; }
  /// Whether a triangle is of several sheets (BuiltRows::of_every_block).
  bool is_of_several(Index t) const { return sheet_[t] == BuiltRows::of_every_block; }
  /// Fragments of one block that hang together, one of them of several sheets.
  const std::vector<std::pair<Index, Index>>& beside() const { return beside_; }
  /// The area of each part inside of the model in the blocks of a framework that may have further walls.
  Areas areas(const BlockFramework& finer) const;
  /// Calls visit(t, other) for triangles of one sheet that share an edge, each way.
  template <class F>
  void for_each_neighbour(F&& visit) const {
    for (const auto& [a, b] : neighbours_) visit(a, b), visit(b, a);
  }

 private:
  enum class Meets : std::uint8_t { nothing, fault, continuation };

  void find_what_they_meet(const ThrowFault& fault);
  void add_fragments();
  void join_fragments();
  void find_ends();
  /// Whether fragments of one block hang together across this edge. Outside of the model what crosses a fault is apart
  /// from what does not.
  bool hang_together(const Fragment& a, const Fragment& b, const std::vector<VertexIndex>& edge) const;
  /// Whether one of two triangles crosses a fault, and the other one a fault's continuation.
  bool are_beside_end(Index t, Index other) const;
  /// Whether a sheet may be torn up to this edge, beside a fault that ends there: an end of the edge is on the border
  /// of the sheet, and whole triangles of the block end at it.
  bool may_be_torn(const std::vector<VertexIndex>& edge, Index block) const;
  /// Vertices that two neighbours share.
  std::vector<VertexIndex> shared(Index t, Index other) const;
  std::array<Vec3, 3> corners(Index t) const {
    const Triangle& v = horizon_.triangles[t];
    return {horizon_.points[v[0]], horizon_.points[v[1]], horizon_.points[v[2]]};
  }

  const TriangulatedSurface& horizon_;
  const SortingSetting& setting_;
  Index n_;
  std::vector<Triangle> triangles_;              ///< of merged_triangles
  std::map<VertexIndex, std::set<Index>> ends_;  ///< per vertex on the border: blocks of whole triangles there
  std::vector<Index> sheet_;                     ///< per triangle, like meets_
  std::vector<Meets> meets_;
  std::vector<std::vector<Crossing>> crossed_;  ///< per fault and triangle
  std::vector<std::pair<Index, Index>> neighbours_;
  std::vector<Fragment> fragments_;    ///< by triangle
  std::vector<bool> reaches_outside_;  ///< per triangle
  std::vector<Index> first_;           ///< per triangle, and one more
  std::vector<Index> part_;            ///< per fragment
  std::vector<std::pair<Index, Index>> beside_;
};

}  // namespace geomesh::geomodel
