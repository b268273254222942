// SPDX-License-Identifier: MIT
/// @file
/// Refines a valid tetrahedralization to target sizes and improves the shapes of elements. All constraints are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/quality_measure.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/size_field.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh {

enum class Honour {
  /// Every facet, or the union of facets with the same `facet_parent`, remains a union of faces of the mesh. Points are
  /// added on facets (off their plane only by rounding); no point of the input is removed.
  exact,
  tolerance,  ///< surfaces may be remeshed within `RefineOptions::tolerance` of the input, in both directions
};

enum class QualityLevel { fast, standard, best };

/// A target size along a surface or curve.
struct AskedSize {
  double size = 0;    ///< 0: none
  double radius = 0;  ///< distance from the place up to which the size is constant; beyond, it grows with the gradation
};

/// The target sizes. All members are optional. By default sizes follow the input edges and grow into the interior.
struct SizeOptions {
  double global = 0;                   ///< 0: none
  std::vector<double> component_size;  ///< target size of each component; 0: none
  /// Target size of each patch (see RefineOptions::facet_patch); may be shorter than the list of patches.
  std::vector<AskedSize> patch_size;
  std::vector<AskedSize> segment_size;  ///< Target size of each segment of the PLC; may be shorter than plc.segments.
  std::vector<SizeSource> sources;      ///< target sizes near places (wells, points of interest), within radii
  std::function<double(const Vec3&)> background;  ///< target size at a place; called from one thread
  bool from_input_edges = true;  ///< whether surfaces request the mean length of the input edges around each point
  double curvature_angle = 0;    ///< largest angle in degrees over which one edge may span a curved patch; 0: no limit
  double gap_layers = 0.8;  ///< number of elements across a gap between surfaces that face each other; 0: none required
  /// Number of elements across each component from surface to surface, however thin it is; 0 or missing: gap_layers.
  std::vector<double> component_layers;
  double gap_floor = 0.25;  ///< least size that gaps require, as a share of the other target sizes
  double gradation = 0.3;   ///< growth of the target size per unit of distance
  double min_size = 0;      ///< 0: none
  double max_size = 0;      ///< 0: none
};

struct RefineOptions {
  SizeOptions size;
  Honour honour = Honour::exact;
  double tolerance = 0;  ///< Honour::tolerance: largest distance between input and result, in model units
  /// Honour::tolerance: two more limits on the distance between input and result at a place. One is this share of the
  /// target size there (without the sizes of input edges, curvature and gaps). The other is half of the gap to the
  /// opposite surface. 0: `tolerance` is the only limit.
  double tolerance_share = 0;
  QualityLevel quality = QualityLevel::standard;
  /// The measure that improvement maximises: first its least value over the cells, then its mean. Quality levels have
  /// limits given as angles; such a limit is converted to the measure of a sliver with this least dihedral angle.
  QualityMeasure quality_measure = QualityMeasure::dihedral;
  /// Honour::exact: if false, no points are added on surfaces and curves for their sizes. Only the interior then
  /// follows the target sizes, which near a vertex of a surface are those of the longest edge there; a few points may
  /// still be added on surfaces for the worst elements. Suits surfaces with many short edges to be kept.
  bool size_surfaces = true;
  /// Honour::tolerance: whether vertices are finally moved off the input, so that the faces between them enclose the
  /// same volume and area as the input. Should be false if faces will be curved onto the input, because their corners
  /// must be on it.
  bool balance_surfaces = true;
  bool refine = true;  ///< whether to add points for sizes before improvement
  /// Above 0, makes a coarse start for parts that are refined separately (refine_part.hpp). Surfaces get
  /// `sparse_surfaces` times the target sizes, within the same tolerance. Sizes in the interior grow from there by
  /// `sparse_growth` per unit of distance, up to `sparse_ratio` times the target sizes; RefineResult::size_field then
  /// contains the larger sizes. 0: the whole mesh has the target sizes.
  double sparse_growth = 0;
  double sparse_ratio = 10, sparse_surfaces = 1;
  /// Patch of each facet of the PLC; empty: facets with equal provenance rows form one patch.
  std::vector<Index> facet_patch;
  /// Honour::exact: for each facet of the PLC the input triangle of which it is a piece (any number that only its
  /// pieces have); no_index: none. Pieces of one triangle that are connected in one plane (up to rounding) across edges
  /// without other constraints are kept as one facet, because crossings of surfaces would otherwise leave needles in
  /// the mesh. Empty: every facet is kept.
  std::vector<Index> facet_parent;
  /// Honour::tolerance: for each row of plc.segments a number. Rows with the same number that lie on facets, on the
  /// same patches, are pieces of one curve: the points of the curve may move along it, and edges of the result refer to
  /// the first of these rows. With no_index, or if this is empty, the ends of the segment are fixed.
  std::vector<Index> segment_curve;
  /// Honour::tolerance: indices of the PLC's points that must not move. Not given: the vertices of plc.facet_points.
  std::optional<std::vector<VertexIndex>> fixed_points;
  /// Angle in degrees between the normals of two faces of one patch from which their edge is a feature edge.
  double sharp_angle = 40;
  double time_budget = 0;  ///< seconds for improvement; 0: unlimited. With a budget the result depends on the machine.
  std::size_t max_elements = 50'000'000;
  std::uint64_t seed = 1;
};

/// Statistics of a refinement. All members except `runs` and `off_before` refer to the last run, which gave the mesh.
struct RefineStatistics {
  double estimated_elements = 0;  ///< number of elements estimated before refinement
  /// Number of runs of the stages refine and improve; above one if surfaces had to be kept closer to the input.
  std::size_t runs = 1;
  /// Number of places, over all earlier runs, where surfaces crossed or were not proven to be within the tolerance.
  std::size_t off_before = 0;
  bool sizes_on_surfaces = true;  ///< false: surfaces got no points for sizes (RefineOptions::size_surfaces)
  std::size_t points_on_curves = 0, points_on_surfaces = 0, points_inside = 0;
  std::size_t collapses = 0, edge_removals = 0, face_removals = 0, smoothing_moves = 0, improving_insertions = 0;
  std::size_t passes = 0;
  QualityMeasure quality_measure = QualityMeasure::dihedral;  ///< the quality measure from the options
  /// Quality measure of the worst element after refinement, and at the end.
  double worst_shape_before = 0, worst_shape_after = 0;
  /// Largest distances found between the surfaces and curves of the input and those of the result. All distances are
  /// proven to be within the tolerance. In exact mode they are zero up to rounding.
  double deviation_result_to_input = 0, deviation_input_to_result = 0;
  bool out_of_time = false;
};

/// A place where surfaces were kept exactly, because they could not be proven to be within the tolerance otherwise.
struct KeptPlace {
  Vec3 place{};
  Index facet = no_index;  ///< facet of the PLC that is nearest to `place`
};

struct RefineResult {
  ConstrainedTetrahedralization mesh;
  RefineStatistics statistics;
  /// Warnings of the run, for example that short edges of the input require most of the elements.
  std::vector<std::string> warnings;
  std::vector<KeptPlace> kept;  ///< Honour::tolerance: places where facets were kept unchanged
  /// Honour::tolerance: whether all surfaces were kept unchanged in the end, as no other result was proven.
  bool all_kept = false;
  SizeField size_field;
  SizeField asked;  ///< target sizes without those that gaps require, as needed by `QualityOptions::asked`
  /// Facets of the PLC with the same number here were kept as one facet; needed by QualityOptions::facet_patch.
  std::vector<Index> kept_patch;
};

/// Refines the mesh to the size field, then improves it to the quality level. Stages reported: refine, improve.
///
/// Preconditions: `mesh` is a result of tetrahedralize(plc) (all its invariants hold). The result has the same
/// invariants, except that points may have moved within the tolerance: such a point has input_vertex = no_vertex. In
/// `Honour::exact` every point of the PLC that was in the mesh is also in the result, unmoved. Faces keep the facet of
/// which they are part; a face that is remade within a patch gets the nearest facet of the patch. `Honour::tolerance`:
/// every triangle of the input is proven to be within the tolerance of the same patch of the result, and vice versa; so
/// are pieces of curves. Outer faces are proven not to cross. There are up to six runs, each closer to the input at the
/// places where the previous one was not proven; from the fourth on the facets are kept there. If all of that fails,
/// every surface is kept. Throws Error{cannot_mesh} if the estimated or the actual number of elements exceeds the
/// limit, Error{usage} for options out of range. Always terminates: points are added for sizes only at a distance from
/// all others that the size field bounds from below. Improvement makes a bounded number of passes, none of which lowers
/// the worst shape, except by rounding. Deterministic for given options unless a time budget is set.
///
/// Sources: Cavalcanti and Mello 1999, section 5 (points added automatically, smart smoothing); Freitag and
/// Ollivier-Gooch 1997 (combining flips with optimising smoothing); Klingner and Shewchuk 2007 (insertion, contraction
/// and the schedule of `best`).
RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization mesh,
                                const RefineOptions& options = {}, const RunContext& context = {});

/// Estimates the number of tetrahedra that the options require, by integrating inverse powers of the target size over
/// the volume and the surfaces. If surfaces are kept exactly, the cells that the points of the input need are counted
/// too. Within a third of the actual number; not computed far beyond the limit.
double estimate_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options);

}  // namespace geomesh
