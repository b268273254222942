// SPDX-License-Identifier: MIT
/// @file
/// What has changed since a point was refused somewhere: refusals are not tried again before.
#pragma once

#include <algorithm>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Numbers of passes, from 1. A place is known by its vertices.
class ChangeStamps {
 public:
  unsigned begin_pass() { return ++pass_; }
  /// Cells were made.
  void note(const DomainMesh& mesh, const std::vector<CellIndex>& created) {
    if (changed_.size() < mesh.n_vertices()) changed_.resize(mesh.n_vertices() + mesh.n_vertices() / 4, 0);
    for (const CellIndex c : created)
      for (const VertexIndex v : mesh.vertices(c)) changed_[v] = pass_;
  }
  /// Anything may have changed.
  void note_all() { std::fill(changed_.begin(), changed_.end(), pass_); }
  /// Whether a cell was made at one of the vertices in the pass `since` or later.
  template <class Vertices>
  bool changed(const Vertices& vertices, unsigned since) const {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](VertexIndex v) { return (v < changed_.size() ? changed_[v] : 0u) >= since; });
  }

 private:
  unsigned pass_ = 0;
  std::vector<unsigned> changed_;  // by vertex: the pass of the last change about it
};

}  // namespace geomesh::remesh
