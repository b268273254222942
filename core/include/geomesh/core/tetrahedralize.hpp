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
  constrained,  ///< fewest added points; constrained faces need not be Delaunay
  conforming,   ///< Delaunay by Steiner points
};

struct RecoverOptions {
  MeshMode mode = MeshMode::constrained;
  bool preserve_boundary = false;  ///< no new point on any facet or segment of the PLC, only inside regions
  /// constrained: where added points end in a dead end, recovery is begun again; 1 to 12, and with 12 once more. With 1
  /// added points are doubles from the moment they are made, and none is held exactly: fast, for callers with another
  /// way.
  unsigned max_attempts = 12;
  std::size_t max_steiner_per_facet =
      200;  ///< conforming: a facet with small angles (or a segment's facets) is given up, and listed, beyond this
};

struct TetrahedralizeOptions {
  DelaunayOptions delaunay;
  RecoverOptions recover;
};

/// What a vertex of the result is.
enum class VertexOrigin : std::uint8_t { input = 0, on_segment = 2, on_facet = 3, inside = 4 };

/// The paper's terms (section 5 of it); see docs/output-files.md.
struct RecoveryStatistics {
  std::size_t segments_total = 0, facets_total = 0;
  std::size_t missing_edges_initial = 0;
  std::size_t missing_facets_before_segments = 0, missing_facets_initial = 0;
  std::size_t edges_reinserted = 0, facets_reinserted = 0;
  std::vector<Index> facets_not_recovered;  ///< conforming: facets that left Delaunay (the mesh has them all the same)
  std::size_t steiner_on_segments = 0, steiner_on_facets = 0, steiner_inside = 0;
  std::size_t tetrahedra_unconstrained = 0;  ///< finite cells of the whole hull before recovery
  std::size_t tetrahedra_final = 0;          ///< finite cells after classification, outside dropped
};

/// Result: plain arrays, outside removed, no unused point, input vertices first (in input order), deterministic order.
struct ConstrainedTetrahedralization {
  std::vector<Vec3> points;
  std::vector<VertexIndex> input_vertex;  ///< per point: row in plc.points, or no_vertex where added
  std::vector<VertexOrigin> origin;
  std::vector<Tetrahedron> tetrahedra;
  /// Per tetrahedron: component, numbered from 0 in the order of the first facet (by index) that touches it, lower side
  /// first. A component is a maximal set of tetrahedra joined through unconstrained faces. Components outside (joined
  /// with infinity) and those with a hole seed are dropped.
  std::vector<Index> component;
  std::size_t n_components = 0;
  std::vector<Index> component_seed;  ///< per component: id of the region seed inside, or no_index

  struct Face {
    Triangle vertices;  ///< in the orientation of the facet it stands for
    Index facet;        ///< a face on several coplanar facets, meshed as a polygon: the one with the centroid
    Index tetrahedron_below = no_index;  ///< on the side that the facet's normal points away from; no_index outside
    Index tetrahedron_above = no_index;  ///< on the side that it points to
  };
  std::vector<Face> faces;  ///< every mesh face that is part of a facet and borders a kept tetrahedron, once, by facet
  struct Edge {
    VertexIndex a, b;
    Index segment;  ///< row in plc.segments
  };
  std::vector<Edge> edges;                   ///< every mesh edge that is part of a segment listed in plc.segments
  std::vector<VertexIndex> isolated_points;  ///< rows here of plc.isolated_points that are in the mesh

  bool delaunay = false;  ///< all faces but those of facets_not_recovered are Delaunay (conforming mode)
  RecoveryStatistics recovery;
  DelaunayStatistics delaunay_statistics;
};

/// Throws Error{invalid_input} where the PLC is not valid (crossing facets, a vertex inside a facet) and names both.
/// Throws Error{cannot_mesh} where a facet or segment cannot be recovered or nothing is enclosed. Never returns a wrong
/// mesh: the result has been validated.
ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc,
                                             const TetrahedralizeOptions& options = {}, const RunContext& context = {});

}  // namespace geomesh
