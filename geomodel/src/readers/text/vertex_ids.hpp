// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts the vertex ids of a file, which may begin with any number and come in any order with gaps, to rows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Map from vertex ids to rows. Ids up to `dense_limit` are in a table, others in a tree. The limit depends on the
/// file's size, so that a wrong id costs no memory.
class VertexIds {
 public:
  explicit VertexIds(std::size_t dense_limit) : dense_limit_(dense_limit) {}

  void set(std::int64_t id, VertexIndex row) {
    if (id >= 0 && static_cast<std::uint64_t>(id) < dense_limit_) {
      const auto i = static_cast<std::size_t>(id);
      if (i >= dense_.size()) dense_.resize(std::max(i + 1, std::min(dense_limit_, 2 * dense_.size())), no_vertex);
      dense_[i] = row;
    } else {
      sparse_[id] = row;
    }
  }

  /// Returns the row of a vertex id, or `no_vertex` if the id is unknown.
  VertexIndex find(std::int64_t id) const {
    if (id >= 0 && static_cast<std::uint64_t>(id) < dense_.size()) return dense_[static_cast<std::size_t>(id)];
    const auto it = sparse_.find(id);
    return it == sparse_.end() ? no_vertex : it->second;
  }

 private:
  std::size_t dense_limit_;
  std::vector<VertexIndex> dense_;
  std::map<std::int64_t, VertexIndex> sparse_;
};

}  // namespace geomesh::geomodel
