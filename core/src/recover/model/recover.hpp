// SPDX-License-Identifier: MIT
/// @file
/// The stages of recovery in constrained mode, in the paper's order (section 3): segments, facets, what is still
/// missing. All work is local to what is missing.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "plc/find_crossing.hpp"
#include "plc/model_names.hpp"
#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

/// What every stage works on.
struct Recovery {
  ConstrainedMesh& mesh;
  Constraints& constraints;
  RecoveryStatistics& statistics;
  const RunContext& context;
  /// Row in plc.points per vertex (no_vertex where added).
  const std::vector<VertexIndex>& input_vertex;
  const PiecewiseLinearComplex& plc;
  const ModelNames& names;  ///< for the words of messages; their data name the items of `plc`
  CrossingsOf& crossings;
  std::size_t n_points_added = 0;
  double expected_points_per_vertex =
      recovery_budget.doubtful_points_per_vertex;  ///< more of them, and 300, cast doubt on the model
  std::vector<Index> hard_segments{},
      hard_facets{};  ///< model segments and facets that flips and cavities did not recover
  /// No point is added on a segment nearer to another of its points: 64 ulps of the largest coordinate. What would need
  /// it is begun again.
  double least_spacing = 0;
  bool has_exact_points = false;  ///< Steiner points are held exactly (exact_places.hpp) and rounded at the end
  unsigned attempt = 0;           ///< another attempt works in another order and puts points elsewhere

  std::unordered_set<std::uint64_t> refuted_regions{};  ///< keys of those without a filling (region_filling.cpp)

  /// Why this attempt cannot go on. Where a stage sets it, that stage and those after it return at once.
  std::optional<Error> dead_end{};
  bool has_ended() const { return dead_end.has_value(); }
  /// The first reason counts.
  void end(Error why) {
    if (!dead_end) dead_end = std::move(why);
  }

  /// Call for each point that flips could not spare. Facets that cross need points without end, so after as many as a
  /// valid model hardly ever takes the model is searched for crossings. Where there is one the attempt ends.
  void count_added_point();
  /// Error{invalid_input} with both items, where there is a crossing.
  std::optional<Error> describe_crossing() const;
  bool has_crossings() const;
};

/// Every live subsegment is an edge of the mesh afterwards: flips first (segments_by_flips.cpp), then points on
/// segments (segments_by_points.cpp). The attempt ends where a vertex lies on a segment or two segments
/// cross.
void recover_segments(Recovery& recovery);

/// Tries flips alone to make a-b an edge. `work_left`: edges and faces that may be tried; what has been is taken off.
/// False: still missing.
bool recover_segment_by_flips(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth, std::size_t& work_left);

/// Every live subfacet is a locked face of the mesh afterwards; all subsegments are present before and after. Flips
/// first, then points where mesh edges pierce the facet. The attempt ends where a segment or a vertex pierces a facet.
void recover_facets(Recovery& recovery);

/// Steiner points on segments and facets.
enum class BoundaryPoints {
  may_stay,  ///< where the mesh cannot do without
  must_go,   ///< at the price of more points inside
};

/// How hard the points inside regions are tried. Regions are decided several times faster in doubles than with exact
/// places, so they wait until places have been rounded.
enum class InnerEffort { star, region };

/// Takes Steiner points away again, or off segments and facets into the regions, where the mesh allows it.
void remove_added_points(Recovery& recovery, BoundaryPoints boundary, InnerEffort effort_at_last = InnerEffort::region);

/// The attempt ends where an added point is left on a segment or facet (preserve_boundary).
void require_untouched_boundary(Recovery& recovery);

/// What is filled again where an added point goes.
enum class RefilledCells {
  star,               ///< its own cells, and what a point moved inside does not see from there
  region_about_star,  ///< cells about them too
};

/// Takes one added point off its segment or facet (boundary_points_inward.cpp). False: nothing has changed.
bool take_point_off_boundary(Recovery& recovery, VertexIndex x, RefilledCells cells = RefilledCells::star);

/// Declared subfacets that are not in the mesh.
struct MissingSubfacets {
  std::size_t n = 0;
  std::size_t inner_edges = 0;  ///< of the pieces among them: as many as a triangulation of their borders has
};
MissingSubfacets count_missing_subfacets(Recovery& recovery);

/// Links, locks and signs of the cells, after any stage; throws InternalError where one is wrong. O(cells).
void validate_cells(const ConstrainedMesh& mesh);
/// Whether each live subsegment is an edge; throws as above.
void validate_segments(Recovery& recovery);

/// The cells as they are at the end satisfy every invariant of ConstrainedMesh and hold every constraint; throws
/// InternalError else.
void validate_recovered(Recovery& recovery);

}  // namespace geomesh::recover
