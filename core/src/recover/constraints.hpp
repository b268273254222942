// SPDX-License-Identifier: MIT
/// @file
/// The declared constraints: which vertex pairs are subsegments and which triples are subfacets, and what they stand for. Membership is
/// declared when something is split and never tested again by coordinates.
///
/// Invariants:
///   1. live subsegments (subfacets) are found by their vertices, in any order;
///   2. each edge of a live subfacet is a live subsegment, which lists that subfacet;
///   3. the live subfacets of a facet, projected on it, cover it once.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "recover/flat_map.hpp"

namespace geomesh::recover {

struct Subsegment {
  VertexIndex a = no_vertex, b = no_vertex;
  Index segment = no_index;  ///< row in Constraints::segments, or no_index for an edge inside a facet
  Index facet = no_index;    ///< for an edge inside a facet: that facet
  bool live = true;
  std::vector<Index> subfacets;
};

struct Subfacet {
  Triangle vertices{};  ///< in the orientation of the facet
  Index facet = no_index;
  bool live = true;
};

/// A segment of the model: a facet border or one that the caller lists.
struct ModelSegment {
  VertexIndex a = no_vertex, b = no_vertex;
  Index row = no_index;  ///< in PiecewiseLinearComplex::segments
};

/// What a vertex is: declared, not measured.
struct VertexRecord {
  VertexOrigin origin = VertexOrigin::input;
  Index owner = no_index;  ///< model segment or facet
};

class Constraints {
 public:
  std::vector<ModelSegment> segments;
  std::vector<VertexRecord> vertices;
  std::vector<Subsegment> subsegments;
  std::vector<Subfacet> subfacets;

  void reserve(std::size_t n_subsegments, std::size_t n_subfacets);

  Index subsegment_of(VertexIndex a, VertexIndex b) const { return subsegment_map_.find({a, b}); }
  Index subfacet_of(VertexIndex a, VertexIndex b, VertexIndex c) const { return subfacet_map_.find({a, b, c}); }
  bool is_subsegment(VertexIndex a, VertexIndex b) const { return subsegment_of(a, b) != no_index; }

  Index add_subsegment(VertexIndex a, VertexIndex b, Index segment, Index facet);
  /// Edges that are no subsegments yet become edges inside the facet.
  Index add_subfacet(const Triangle& t, Index facet);
  /// Takes a subfacet out; edges inside a facet that bound nothing any more go with it.
  void remove_subfacet(Index subfacet);
  void remove_subsegment(Index subsegment);

  struct SegmentSplit {
    Index first = no_index, second = no_index;  ///< a-x and x-b
    std::vector<Index> inner;                   ///< the new edges from x to the third vertices of the facets about it
    std::vector<Index> subfacets;               ///< the halves
  };
  /// Splits subsegment s at vertex x; each subfacet about it becomes two.
  SegmentSplit split_subsegment(Index s, VertexIndex x);

 private:
  EdgeMap subsegment_map_;
  FaceMap subfacet_map_;
};

}  // namespace geomesh::recover
