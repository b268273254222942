// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes the nodes and triangles beside a run of border: a grid with extrapolated heights, connected to the border.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "rules/continuation/apron.hpp"
#include "rules/continuation/chain_in_plane.hpp"

namespace geomesh::geomodel {

/// A node of the strip beside a run of border: a vertex of the border (these come first, in order) or a grid point.
struct ApronNode {
  Vec2 place;
  Vec3 point;           ///< in the model
  double distance = 0;  ///< distance from the border's place from which the node's height is extrapolated
  Index edge = 0;       ///< border edge from which the node's height is extrapolated
  bool is_seen = true;  ///< whether no bounding surface lies between the node and the border
};

/// The nodes and triangles from which a strip beside a run of border is made. Nodes on the border come first, in its
/// order.
class ApronGrid {
 public:
  using Corners = std::array<Index, 3>;

  ApronGrid(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
            const ApronSetting& setting);

  const std::vector<ApronNode>& nodes() const { return nodes_; }
  /// The strip's triangles, except those at border edges that remain open.
  const std::vector<Corners>& triangles() const { return triangles_; }
  bool crosses_itself() const { return crosses_itself_; }  ///< whether the continued border crosses itself in the plane
  Index n_border() const { return n_border_; }
  const ChainInPlane& chain() const { return chain_; }
  /// Indices of the bounding surfaces that hide grid nodes from the continued border.
  const std::set<Index>& hidden_by() const { return crossed_; }
  /// Returns the strip's node at the place p of the plane, with the height extrapolated from the border.
  ApronNode node_at(const Vec2& p, const ChainInPlane::Nearest& at) const;

 private:
  bool is_hidden(const ApronNode& node, const ChainInPlane::Nearest& at);
  void add_grid();
  void add_node(const Vec2& p, double reach);
  bool find_triangles();
  bool is_in_model(const Vec3& p) const;
  void leave_out_open();

  Index row_;
  const BorderChain& border_;
  const Walls& walls_;
  const Frame& frame_;
  double within_;
  const Box3& bounds_;
  ChainInPlane chain_;
  double step_;
  Index n_border_ = 0;
  std::vector<ApronNode> nodes_;
  std::vector<Corners> triangles_;
  std::set<Index> crossed_;
  bool crosses_itself_ = false;
};

}  // namespace geomesh::geomodel
