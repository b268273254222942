// SPDX-License-Identifier: MIT
/// @file
/// The core's one entry for users: from a piecewise linear complex to a classified tetrahedral mesh. The driver reads
/// as the paper's stages: Delaunay triangulation (section 2), segments (3.1), facets (3.2), what is still missing
/// (3.3), classification (4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/geometry.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh {

enum class MeshMode {
  constrained,  ///< as few added points as possible; constrained faces need not be Delaunay
  conforming,   ///< Delaunay, by means of Steiner points
};

struct RecoverOptions {
  MeshMode mode = MeshMode::constrained;
  bool preserve_boundary = false;  ///< no added point on any facet or segment of the PLC, only inside regions
  /// constrained: number of attempts at recovery if added points lead to a dead end; 1 to 12, and with 12 one more.
  /// With 1, added points are doubles from the start and none is represented exactly: fast, for callers that have an
  /// alternative.
  unsigned max_attempts = 12;
  std::size_t max_steiner_per_facet =
      /// Conforming: limit beyond which a facet with small angles (or the facets of a segment) is given up and listed.
      200;
};

struct TetrahedralizeOptions {
  DelaunayOptions delaunay;
  RecoverOptions recover;
};

/// The origin of a vertex of the result.
enum class VertexOrigin : std::uint8_t { input = 0, on_segment = 2, on_facet = 3, inside = 4 };

/// Statistics in the paper's terms (its section 5); see docs/output-files.md.
struct RecoveryStatistics {
  std::size_t segments_total = 0, facets_total = 0;
  std::size_t missing_edges_initial = 0;
  std::size_t missing_facets_before_segments = 0, missing_facets_initial = 0;
  std::size_t edges_reinserted = 0, facets_reinserted = 0;
  /// Conforming: facets that are not Delaunay (the mesh contains them nevertheless).
  std::vector<Index> facets_not_recovered;
  std::size_t steiner_on_segments = 0, steiner_on_facets = 0, steiner_inside = 0;
  std::size_t tetrahedra_unconstrained = 0;  ///< finite cells of the whole hull before recovery
  std::size_t tetrahedra_final = 0;          ///< finite cells after classification, without the outside
};

/// The result in plain arrays: without the outside and unused points, input vertices first (in input order), in a
/// deterministic order.
struct ConstrainedTetrahedralization {
  std::vector<Vec3> points;
  std::vector<VertexIndex> input_vertex;  ///< for each point: row in plc.points, or no_vertex if it was added
  std::vector<VertexOrigin> origin;
  std::vector<Tetrahedron> tetrahedra;
  /// For each tetrahedron its component, numbered from 0 in the order of the first facet (by index) that touches it,
  /// lower side first. A component is a maximal set of tetrahedra joined through unconstrained faces. Components
  /// outside (connected with infinity) and those with a hole seed are dropped.
  std::vector<Index> component;
  std::size_t n_components = 0;
  std::vector<Index> component_seed;  ///< for each component: id of the region seed inside, or no_index

  struct Face {
    Triangle vertices;  ///< in the orientation of the facet to which it belongs
    /// For a face on several coplanar facets that were meshed as one polygon: the facet that contains the centroid.
    Index facet;
    /// Tetrahedron on the side that the facet's normal points away from; no_index outside.
    Index tetrahedron_below = no_index;
    Index tetrahedron_above = no_index;  ///< tetrahedron on the side to which it points
  };
  /// All mesh faces that are part of a facet and border on a kept tetrahedron, each once, by facet.
  std::vector<Face> faces;
  struct Edge {
    VertexIndex a, b;
    Index segment;  ///< row in plc.segments
  };
  std::vector<Edge> edges;                   ///< all mesh edges that are part of a segment listed in plc.segments
  std::vector<VertexIndex> isolated_points;  ///< rows, in this mesh, of plc.isolated_points that are part of it

  bool delaunay = false;  ///< conforming mode: whether all faces except those of facets_not_recovered are Delaunay
  RecoveryStatistics recovery;
  DelaunayStatistics delaunay_statistics;
};

/// Throws Error{invalid_input} if the PLC is not valid (crossing facets, a vertex inside a facet), with both items.
/// Throws Error{cannot_mesh} if a facet or segment cannot be recovered or nothing is enclosed. Never returns a wrong
/// mesh, because the result is validated.
ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc,
                                             const TetrahedralizeOptions& options = {}, const RunContext& context = {});

}  // namespace geomesh
