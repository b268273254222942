// SPDX-License-Identifier: MIT
/// @file
/// Exact search for edges and triangles of a PLC that cross. Recovery runs it only after it has added more points than
/// a valid model is likely to need.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh {

/// A segment or an edge of a facet, and a triangular facet, that meet outside shared vertices and edges.
struct PlcCrossing {
  VertexIndex a = no_vertex, b = no_vertex;  ///< the edge
  Index edge_facet = no_index;               ///< the facet to which the edge belongs; no_index for a separate segment
  Index facet = no_index;                    ///< the facet met
};

/// Returns the first crossing, ordered by edge, then facet. Only triangular facets are searched; polygons, and
/// triangles with points or segments inside, were checked when recovery triangulated them. O(n log n) plus the pairs
/// whose boxes overlap along the longest axis.
std::optional<PlcCrossing> find_crossing(const PiecewiseLinearComplex& plc);
/// Returns all crossings of an edge with a triangular facet of the complex, sorted by edge, then by facet.
std::vector<PlcCrossing> find_crossings(const PiecewiseLinearComplex& plc, unsigned threads = 1);

/// Finds the first crossing of a complex when it is first requested, and remembers it.
class CrossingsOf {
 public:
  explicit CrossingsOf(const PiecewiseLinearComplex& plc) : plc_(plc) {}
  const std::optional<PlcCrossing>& first() {
    if (!is_known_) first_ = find_crossing(plc_);
    is_known_ = true;
    return first_;
  }

 private:
  const PiecewiseLinearComplex& plc_;
  std::optional<PlcCrossing> first_;
  bool is_known_ = false;
};

}  // namespace geomesh
