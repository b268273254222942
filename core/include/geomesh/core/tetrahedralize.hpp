// SPDX-License-Identifier: MIT
/// @file
/// The main entry of the core: makes a classified tetrahedral mesh from a piecewise linear complex. The driver follows
/// the stages of Cavalcanti and Mello 1999: Delaunay triangulation (section 2), segments (3.1), facets (3.2), what is
/// still missing (3.3), classification (4).
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
  constrained,  ///< meshes with as few added points as possible; constrained faces need not be Delaunay
  conforming,   ///< makes the mesh Delaunay by means of Steiner points
};

struct RecoverOptions {
  MeshMode mode = MeshMode::constrained;
  bool preserve_boundary = false;  ///< whether to add points only inside regions, none on facets or segments of the PLC
  /// Constrained mode: largest number of attempts at recovery if added points lead to a dead end, from 1 to 12. With 1,
  /// added points are doubles from the start and none is represented exactly: fast, for callers with an alternative.
  unsigned max_attempts = 12;
  /// Conforming mode: largest number of Steiner points on a facet or segment with small angles. Beyond this limit the
  /// facet, or every facet at the segment, is given up and listed in facets_not_recovered.
  std::size_t max_steiner_per_facet = 200;
};

struct TetrahedralizeOptions {
  DelaunayOptions delaunay;
  RecoverOptions recover;
};

/// The origin of a vertex of the result.
enum class VertexOrigin : std::uint8_t { input = 0, on_segment = 2, on_facet = 3, inside = 4 };

/// Statistics of recovery, in the terms of Cavalcanti and Mello 1999, section 5; see docs/output-files.md.
struct RecoveryStatistics {
  std::size_t segments_total = 0, facets_total = 0;
  std::size_t missing_edges_initial = 0;
  std::size_t missing_facets_before_segments = 0, missing_facets_initial = 0;
  std::size_t edges_reinserted = 0, facets_reinserted = 0;
  /// Conforming mode: facets that are not Delaunay (the mesh contains them nevertheless).
  std::vector<Index> facets_not_recovered;
  std::size_t steiner_on_segments = 0, steiner_on_facets = 0, steiner_inside = 0;
  std::size_t tetrahedra_unconstrained = 0;  ///< number of tetrahedra of the whole convex hull before recovery
  std::size_t tetrahedra_final = 0;  ///< number of tetrahedra after classification, without those outside the model
};

/// The tetrahedral mesh in plain arrays, in a deterministic order: input vertices first, in input order. It does not
/// contain the outside or unused points.
struct ConstrainedTetrahedralization {
  std::vector<Vec3> points;
  std::vector<VertexIndex> input_vertex;  ///< for each point, its index in plc.points, or no_vertex if it was added
  std::vector<VertexOrigin> origin;
  std::vector<Tetrahedron> tetrahedra;
  /// For each tetrahedron its component, numbered from 0 in the order of the first facet (by index) that touches it,
  /// lower side first. A component is a maximal set of tetrahedra joined through unconstrained faces. Components
  /// outside (connected with infinity) and those with a hole seed are dropped.
  std::vector<Index> component;
  std::size_t n_components = 0;
  std::vector<Index> component_seed;  ///< for each component: id of the region seed inside, or no_index

  struct Face {
    Triangle vertices;  ///< vertices in the orientation of the facet to which the face belongs
    /// The facet that contains the face, or, of coplanar facets meshed as one polygon, that with the face's centroid.
    Index facet;
    /// Tetrahedron on the side that the facet's normal points away from; no_index if that side is outside.
    Index tetrahedron_below = no_index;
    Index tetrahedron_above = no_index;  ///< tetrahedron on the side to which the facet's normal points
  };
  /// All mesh faces that are part of a facet and belong to a tetrahedron of the mesh, each once, ordered by facet.
  std::vector<Face> faces;
  struct Edge {
    VertexIndex a, b;
    Index segment;  ///< row in plc.segments
  };
  std::vector<Edge> edges;                   ///< all mesh edges that are part of a segment listed in plc.segments
  std::vector<VertexIndex> isolated_points;  ///< vertices of this mesh that are isolated points of the PLC

  bool delaunay = false;  ///< conforming mode: whether all faces except those of facets_not_recovered are Delaunay
  RecoveryStatistics recovery;
  DelaunayStatistics delaunay_statistics;
};

/// Meshes a piecewise linear complex (PLC). Throws Error{invalid_input} if the PLC is not valid (crossing facets, a
/// vertex inside a facet); the error lists both items. Throws Error{cannot_mesh} if a facet or segment cannot be
/// recovered or nothing is enclosed. Never returns a wrong mesh, because the result is validated.
ConstrainedTetrahedralization tetrahedralize(const PiecewiseLinearComplex& plc,
                                             const TetrahedralizeOptions& options = {}, const RunContext& context = {});

}  // namespace geomesh
