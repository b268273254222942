// SPDX-License-Identifier: MIT
/// @file
/// Points with equal coordinates.
#pragma once

#include <utility>
#include <vector>

#include "delaunay/kernels/point_record.hpp"

namespace geomesh {

/// The position, in insertion order, of a point that equals an already inserted vertex.
struct Twin {
  VertexIndex position, vertex;
};

/// Assigns to each vertex the least id of the points equal to it. Returns for each point the least id of the points
/// equal to it, which is its own id if there are none.
inline std::vector<VertexIndex> merge_twins(const std::vector<Twin>& twins, PointRecord* records, VertexIndex n) {
  std::vector<VertexIndex> representative(n);
  for (VertexIndex i = 0; i < n; ++i) representative[i] = i;
  for (const Twin& t : twins) {
    VertexIndex &kept = records[t.vertex].id, &other = records[t.position].id;
    if (other < kept) std::swap(kept, other);
    representative[other] = kept;
  }
  // Each entry of the list is the point's own id or the lesser id of an equal point, whose entry is final already.
  for (VertexIndex i = 0; i < n; ++i) representative[i] = representative[representative[i]];
  return representative;
}

}  // namespace geomesh
