// SPDX-License-Identifier: MIT
/// @file
/// The stages of recovery in constrained mode, in the order of Cavalcanti and Mello 1999, section 3: segments, facets,
/// removal of added points. All work is local to the missing items.
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

/// The mesh, constraints, counters and results of one attempt at recovery, which all its stages use.
struct Recovery {
  ConstrainedMesh& mesh;
  Constraints& constraints;
  RecoveryStatistics& statistics;
  const RunContext& context;
  /// Row in plc.points of each mesh vertex; no_vertex for vertices that are not in the input.
  const std::vector<VertexIndex>& input_vertex;
  const PiecewiseLinearComplex& plc;
  const ModelNames& names;  ///< indices and coordinate frame of the caller's model, for the texts of messages
  CrossingsOf& crossings;
  std::size_t n_points_added = 0;
  double expected_points_per_vertex =
      /// Number of added points per vertex beyond which, plus 300 points, the model is suspected to be invalid.
      recovery_budget.doubtful_points_per_vertex;
  std::vector<Index> hard_segments{},
      hard_facets{};  ///< model segments and facets that flips and cavities did not recover
  /// Least distance of a point on a segment from other points on it: 64 ulps of the largest coordinate. If a closer
  /// point would be needed, recovery starts again.
  double least_spacing = 0;
  /// Whether Steiner points have exact places (exact_places.hpp) and are rounded at the end.
  bool has_exact_points = false;
  unsigned attempt = 0;  ///< number of the attempt; each attempt works in another order and puts points elsewhere

  std::unordered_set<std::uint64_t> refuted_regions{};  ///< hash keys of regions for which no filling was found

  /// The reason why this attempt at recovery cannot go on. If a stage sets it, it and all later stages return at once.
  std::optional<Error> dead_end{};
  bool has_ended() const { return dead_end.has_value(); }
  /// Ends this attempt at recovery for the given reason, unless it has already ended for another one.
  void end(Error why) {
    if (!dead_end) dead_end = std::move(why);
  }

  /// Must be called for each point that flips could not avoid. If there are more points than valid models usually need,
  /// crossings of input items are searched for, and the attempt ends if one is found.
  void count_added_point();
  /// Returns Error{invalid_input} with both items if two items of the model cross.
  std::optional<Error> describe_crossing() const;
  bool has_crossings() const;
};

/// Makes every live subsegment an edge of the mesh: first by flips (segments_by_flips.cpp), then by points on segments
/// (segments_by_points.cpp). Ends this attempt at recovery if a vertex lies on a segment or two segments cross.
void recover_segments(Recovery& recovery);

/// Tries to make a-b an edge by flips alone. `work_left` is the number of edges and faces that may be tried, and is
/// reduced. Returns false if the edge is still missing.
bool recover_segment_by_flips(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth, std::size_t& work_left);

/// Makes every live subfacet a locked face of the mesh; all subsegments are present before and after. Flips come first,
/// then points where mesh edges pierce the facet. Ends this attempt if an input segment or vertex pierces a facet.
void recover_facets(Recovery& recovery);

/// Whether Steiner points may remain on segments and facets at the end.
enum class BoundaryPoints {
  may_stay,  ///< Steiner points on segments and facets are kept if the mesh needs them
  must_go,   ///< Steiner points leave segments and facets, at the cost of more points inside
};

/// Which cells are filled anew to remove a Steiner point that is on no facet or segment: its star, or also the region
/// around the star, which is several times faster once all points have been rounded to doubles.
enum class InnerEffort { star, region };

/// Removes Steiner points, or moves them from segments and facets into the regions, if the mesh allows it.
void remove_added_points(Recovery& recovery, BoundaryPoints boundary, InnerEffort effort_at_last = InnerEffort::region);

/// Ends this attempt at recovery if an added point is left on a segment or facet (preserve_boundary).
void require_untouched_boundary(Recovery& recovery);

/// The cells that are filled anew when an added point is removed.
enum class RefilledCells {
  star,               ///< the removed point's star, and cells behind faces that its new place does not see
  region_about_star,  ///< the removed point's star, and a region of cells around it
};

/// Removes one added point from its segment or facet (boundary_points_inward.cpp). Returns whether it did.
bool take_point_off_boundary(Recovery& recovery, VertexIndex x, RefilledCells cells = RefilledCells::star);

/// Counts of subfacets that are not in the mesh.
struct MissingSubfacets {
  std::size_t n = 0;
  std::size_t inner_edges = 0;  ///< edges inside triangulations of the missing polygonal subfacets
};
MissingSubfacets count_missing_subfacets(Recovery& recovery);

/// Checks links, locks and signs of the cells after any stage; throws InternalError if one is wrong. O(cells).
void validate_cells(const ConstrainedMesh& mesh);
/// Checks that each live subsegment is an edge of the mesh; throws InternalError otherwise.
void validate_segments(Recovery& recovery);

/// Throws InternalError unless the final cells satisfy every invariant of ConstrainedMesh and contain every constraint.
void validate_recovered(Recovery& recovery);

}  // namespace geomesh::recover
