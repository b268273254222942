// SPDX-License-Identifier: MIT
/// @file
/// The declared constraints: which vertex pairs are subsegments and which triples are subfacets, and to which segments
/// and facets they belong. Membership is declared when something is split and never tested again by coordinates.
///
/// Invariants:
///   1. live subsegments, and live subfacets that are not pieces, are found by their vertices, in any order;
///   2. each border edge of a live subfacet is a live subsegment, which lists that subfacet;
///   3. the live subfacets of a facet, projected on it, cover it once.
#pragma once

#include <vector>

#include "common/flat_map.hpp"
#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::recover {

struct Subsegment {
  VertexIndex a = no_vertex, b = no_vertex;
  Index segment = no_index;  ///< row in Constraints::segments, or no_index for an edge inside a facet
  Index facet = no_index;    ///< the facet that contains the edge in its inside; no_index for other subsegments
  bool live = true;
  std::vector<Index> subfacets;
  CellIndex seen_in = no_cell;  ///< a cell that had the edge when it was last found (presence.hpp)
};

using DirectedEdge = std::array<VertexIndex, 2>;

/// A triangle that is, or should become, a mesh face, or a `piece`: a part of a facet that any mesh faces may cover.
struct Subfacet {
  Triangle vertices{};  ///< corners of the subfacet in the facet's orientation; for a piece three that span its plane
  Index facet = no_index;
  bool live = true;
  Index piece = no_index;
  CellIndex seen_in = no_cell;  ///< a cell that had the subfacet as a face when it was last found (presence.hpp)
};

/// A part of a facet with more than three vertices on its border or inside: an exactly planar polygon, or a triangle on
/// whose border points were added. Any mesh faces between its vertices may cover it, so inner edges require no points.
struct FacetPiece {
  std::vector<DirectedEdge>
      border;  ///< border edges, with the facet's piece on their left seen from above; segments inside it both ways
  std::vector<VertexIndex> members;  ///< all vertices on the border of the facet's piece and inside it
  std::vector<Triangle> seen{};      ///< mesh faces that covered the piece of the facet when they were last found
  std::vector<CellIndex> seen_in{};  ///< for each face of `seen`, the cell in which it was found
};

/// A segment of the model: a facet's border or one that the caller lists.
struct ModelSegment {
  VertexIndex a = no_vertex, b = no_vertex;
  Index row = no_index;  ///< in PiecewiseLinearComplex::segments
};

/// The input item on which a vertex was placed, as recorded at its insertion instead of found by its coordinates.
struct VertexRecord {
  VertexOrigin origin = VertexOrigin::input;
  Index owner = no_index;  ///< row of the model segment or facet on which meshing added the vertex
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

  /// Returns whether a and b lie on one model segment with added points between them: such an edge would run beside
  /// these points at the distance of a rounding error, so recovery never makes it.
  bool skips_added_points(VertexIndex a, VertexIndex b) const {
    const bool a_added = vertices[a].origin != VertexOrigin::input, b_added = vertices[b].origin != VertexOrigin::input;
    if (!a_added && !b_added) return split_map_.find({a, b}) != no_index;
    return lies_on_segment_of(a, b) || lies_on_segment_of(b, a);
  }

  Index add_subsegment(VertexIndex a, VertexIndex b, Index segment, Index facet);
  /// Adds a subfacet. Edges that are not subsegments yet become edges inside the facet.
  Index add_subfacet(const Triangle& t, Index facet);
  /// Removes a subfacet, and its edges inside the facet that bound no other subfacet.
  void remove_subfacet(Index subfacet);
  void remove_subsegment(Index subsegment);

  /// Adds a piece of a facet, given by its border. The edges of the border must be subsegments.
  Index add_piece(const Triangle& plane, FacetPiece piece, Index facet);
  const FacetPiece& piece_of(Index subfacet) const { return pieces_[subfacets[subfacet].piece]; }
  /// Stores the mesh faces that cover a piece of a facet, and cells that contain them, for later searches.
  void remember(Index subfacet, const std::vector<Triangle>& faces, const std::vector<CellIndex>& cells) {
    pieces_[subfacets[subfacet].piece].seen = faces;
    pieces_[subfacets[subfacet].piece].seen_in = cells;
  }
  bool is_piece(Index subfacet) const { return subfacets[subfacet].piece != no_index; }

  /// Converts a triangular subfacet to a piece: a part of a facet with any border and inner points.
  void make_piece(Index subfacet);
  /// Declares that vertex x lies inside subfacet f, which must be a piece.
  void add_member(Index f, VertexIndex x) {
    pieces_[subfacets[f].piece].members.push_back(x);
    pieces_[subfacets[f].piece].seen.clear();
  }

  /// Splits subsegment s at vertex x into a-x and x-b. The subfacets at it become pieces with x on their border.
  std::array<Index, 2> split_subsegment(Index s, VertexIndex x);

 private:
  EdgeMap subsegment_map_;
  /// Returns whether a was added on a segment on which b is too, and a-b is not a subsegment.
  bool lies_on_segment_of(VertexIndex a, VertexIndex b) const {
    const VertexRecord& r = vertices[a];
    if (r.origin != VertexOrigin::on_segment) return false;
    const bool b_is_on = (vertices[b].origin == VertexOrigin::on_segment && vertices[b].owner == r.owner) ||
                         segments[r.owner].a == b || segments[r.owner].b == b;
    return b_is_on && !is_subsegment(a, b);
  }

  EdgeMap split_map_;  ///< model segments that have added points
  FaceMap subfacet_map_;
  std::vector<FacetPiece> pieces_;
};

}  // namespace geomesh::recover
