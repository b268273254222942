// SPDX-License-Identifier: MIT
/// @file
/// The piecewise linear complex: the input of the engine.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Points, polygonal facets with holes and with inner segments and points, isolated segments and points, and seeds.
///
/// Invariants (validate_plc lists every violation): indices in range; coordinates finite and distinct. Each loop has at
/// least three different vertices and no repeated neighbour. Facets and segments meet only in shared vertices and
/// edges.
struct PiecewiseLinearComplex {
  std::vector<Vec3> points;

  /// Facet f has the loops loop_offsets[facet_loops[f]] .. facet_loops[f+1]; the first is its outer boundary, the
  /// others are holes. Loop l has the vertices loop_vertices[loop_offsets[l]] .. loop_offsets[l+1]. In a triangle soup
  /// each facet has one loop of three vertices.
  std::vector<VertexIndex> loop_vertices;
  std::vector<Index> loop_offsets{0};
  std::vector<Index> facet_loops{0};
  /// For each facet, the row in `provenance_sets` that lists the input surfaces to which the facet belongs.
  std::vector<Index> facet_provenance;
  std::vector<std::vector<Index>> provenance_sets;

  struct FacetSegment {
    Index facet;
    VertexIndex a, b;
  };
  std::vector<FacetSegment> facet_segments;  ///< segments in the interior of a facet
  struct FacetPoint {
    Index facet;
    VertexIndex v;
  };
  std::vector<FacetPoint> facet_points;  ///< isolated vertices in the interior of a facet

  struct Segment {
    VertexIndex a, b;
    Index curve = no_index;  ///< caller's id
  };
  /// Segments named by the caller: isolated ones (wells) and those on facet borders that are to be returned as curves.
  /// Facet borders are segments whether listed here or not.
  std::vector<Segment> segments;
  std::vector<VertexIndex> isolated_points;

  /// A point inside a region. A seed on a facet is refused (Error{invalid_input}), one outside the model reported.
  struct Seed {
    Vec3 point;
    Index id = no_index;
  };
  std::vector<Seed> region_seeds;
  std::vector<Seed> hole_seeds;

  std::size_t n_facets() const { return facet_loops.size() - 1; }
  std::size_t n_loops(Index f) const { return facet_loops[f + 1] - facet_loops[f]; }
  std::span<const VertexIndex> loop(Index l) const {
    return {loop_vertices.data() + loop_offsets[l], loop_vertices.data() + loop_offsets[l + 1]};
  }
  std::span<const VertexIndex> outer_loop(Index f) const { return loop(facet_loops[f]); }

  Index add_triangle(const Triangle& t, Index provenance = no_index) {
    loop_vertices.insert(loop_vertices.end(), t.begin(), t.end());
    return finish_facet(provenance);
  }
  /// Adds a facet and returns its index. The first loop is the outer boundary of the facet, the others are its holes.
  Index add_polygon(std::span<const std::vector<VertexIndex>> loops, Index provenance = no_index) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      loop_vertices.insert(loop_vertices.end(), loops[i].begin(), loops[i].end());
      if (i + 1 < loops.size()) loop_offsets.push_back(static_cast<Index>(loop_vertices.size()));
    }
    return finish_facet(provenance);
  }

 private:
  Index finish_facet(Index provenance) {
    loop_offsets.push_back(static_cast<Index>(loop_vertices.size()));
    facet_loops.push_back(static_cast<Index>(loop_offsets.size() - 1));
    facet_provenance.push_back(provenance);
    return static_cast<Index>(n_facets() - 1);
  }
};

/// One violation of the invariants of a piecewise linear complex (PLC).
struct PlcFault {
  std::string message;  ///< names the facets, segments or points that violate the invariant, and a place if useful
  ErrorContext context;
};

/// Lists all structural faults (indices, coordinates, equal points, degenerate or repeated facets, segments of zero
/// length). Crossing facets are not searched here, because recovery detects and reports them. O(n log n).
std::vector<PlcFault> validate_plc(const PiecewiseLinearComplex& plc);

}  // namespace geomesh
