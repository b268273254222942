// SPDX-License-Identifier: MIT
/// @file
/// From a valid tetrahedralization to one whose sizes and shapes a solver likes, with every constraint kept.
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
  exact,      ///< every facet, or what `facet_parent` makes one of several, stays a union of faces; points are added on
              ///< facets (off their plane by rounding), none leaves
  tolerance,  ///< surfaces may be remeshed within `RefineOptions::tolerance` of the input, both ways
};

enum class QualityLevel { fast, standard, best };

/// A size asked along a surface or curve.
struct AskedSize {
  double size = 0;    ///< 0: none
  double radius = 0;  ///< holds unchanged within this distance; grows with the gradation beyond
};

/// What sizes to ask for. Everything is optional; with nothing given the sizes follow the input's own edges and grow
/// inwards.
struct SizeOptions {
  double global = 0;                              ///< 0: none
  std::vector<double> component_size;             ///< per component; 0: none
  std::vector<AskedSize> patch_size;              ///< per patch (see RefineOptions::facet_patch); may be shorter
  std::vector<AskedSize> segment_size;            ///< per row of plc.segments; may be shorter
  std::vector<SizeSource> sources;                ///< asked near places (wells, points of interest), with radius
  std::function<double(const Vec3&)> background;  ///< called from one thread
  bool from_input_edges = true;          ///< surfaces ask for the mean length of the input edges about each point
  double curvature_angle = 0;            ///< degrees that one edge may turn on a curved patch; 0: not asked
  double gap_layers = 0.8;               ///< elements across a gap between surfaces that face each other; 0: not asked
  std::vector<double> component_layers;  ///< per component: elements across it from surface to surface, however thin it
                                         ///< is; 0 or missing: gap_layers
  double gap_floor = 0.25;               ///< gaps never ask for less than this share of the size asked otherwise
  double gradation = 0.3;                ///< growth of the size per unit of distance
  double min_size = 0;                   ///< 0: none
  double max_size = 0;                   ///< 0: none
};

struct RefineOptions {
  SizeOptions size;
  Honour honour = Honour::exact;
  double tolerance = 0;  ///< Honour::tolerance: largest distance between input and result, in model units
  /// Honour::tolerance: the distance allowed at a place has two more limits. One is this share of the size that is
  /// asked there by `size` (not by input edges, curvature and gaps). The other is half of the gap to the surface that
  /// faces it. 0: `tolerance` everywhere.
  double tolerance_share = 0;
  QualityLevel quality = QualityLevel::standard;
  /// What improvement maximises: first its least value over the cells, then its mean. Limits that levels set as angles
  /// stand for the value of a sliver with this least dihedral angle.
  QualityMeasure quality_measure = QualityMeasure::dihedral;
  /// Honour::exact: false puts no points on surfaces and curves for their sizes. Only the inside then follows the
  /// sizes asked, which near a vertex of a surface are those of the longest edge there; a few points may still go onto
  /// surfaces where the worst elements need them. For surfaces full of short edges that are to be kept with few
  /// elements.
  bool size_surfaces = true;
  /// Honour::tolerance: moves vertices off the input at the end, so that the faces between them enclose its volume and
  /// area. False for faces that will be curved onto the input, which must have their corners on it.
  bool balance_surfaces = true;
  bool refine = true;  ///< false: improve only, no points for size
  /// A start for parts that are refined on their own (refine_part.hpp). Surfaces get `sparse_surfaces` times the sizes
  /// asked, within the same tolerance. Sizes inside grow from there by this a unit of distance, up to `sparse_ratio`
  /// times as large. RefineResult::size_field has the larger sizes then. 0: all is as fine as asked.
  double sparse_growth = 0;
  double sparse_ratio = 10, sparse_surfaces = 1;
  std::vector<Index> facet_patch;  ///< per facet of the PLC; empty: facets with equal provenance rows are one patch
  /// Honour::exact: per facet of the PLC the input triangle that it is a piece of (any number that only its pieces
  /// have), no_index: none. Pieces of one triangle that join in one plane (to rounding) across edges where nothing else
  /// is are kept as one facet: crossings cut triangles into needles that nobody asked for. Empty: every facet is kept.
  std::vector<Index> facet_parent;
  /// Honour::tolerance: per row of plc.segments a number; rows of one number that lie on facets, on the same patches,
  /// are pieces of one curve: its points may move along it, and edges of the result name the first of these rows.
  /// no_index, and where this is empty: the segment's ends stay.
  std::vector<Index> segment_curve;
  /// Honour::tolerance: rows of plc.points that stay in their places. Nothing: those of plc.facet_points.
  std::optional<std::vector<VertexIndex>> fixed_points;
  double sharp_angle = 40;  ///< degrees between the normals of two faces of one patch from which their edge is a curve
  double time_budget = 0;   ///< seconds for improvement; 0: none. With a budget the result depends on the machine.
  std::size_t max_elements = 50'000'000;
  std::uint64_t seed = 1;
};

/// All but `runs` and `off_before` are of the last run, whose mesh is given out.
struct RefineStatistics {
  double estimated_elements = 0;  ///< before the work started
  std::size_t runs = 1;  ///< of stages refine and improve; more than one where surfaces had to be held more closely to
                         ///< keep a tolerance
  std::size_t off_before =
      0;  ///< places in all earlier runs that were not proven to keep it, or where surfaces crossed
  bool sizes_on_surfaces = true;  ///< false: surfaces got no points for sizes (RefineOptions::size_surfaces)
  std::size_t points_on_curves = 0, points_on_surfaces = 0, points_inside = 0;
  std::size_t collapses = 0, edge_removals = 0, face_removals = 0, smoothing_moves = 0, improving_insertions = 0;
  std::size_t passes = 0;
  QualityMeasure quality_measure = QualityMeasure::dihedral;  ///< that of the options
  /// Least value of that measure after refinement and at the end.
  double worst_shape_before = 0, worst_shape_after = 0;
  /// Largest distances found between surfaces and curves; all are proven to be within the tolerance. Zero in exact mode
  /// but for rounding.
  double deviation_result_to_input = 0, deviation_input_to_result = 0;
  double edges_within_size = 0;  ///< share of edges between half and twice the asked size
  bool out_of_time = false;
};

/// Where surfaces were kept exactly, since they could not be proven to be within the tolerance otherwise.
struct KeptPlace {
  Vec3 place{};
  Index facet = no_index;  ///< of the PLC, nearest
};

struct RefineResult {
  ConstrainedTetrahedralization mesh;
  RefineStatistics statistics;
  std::vector<std::string>
      warnings;                 ///< noted while it ran, as where short edges of the input ask for most of many elements
  std::vector<KeptPlace> kept;  ///< Honour::tolerance: places where facets were kept as they are
  bool all_kept = false;        ///< Honour::tolerance: all surfaces were kept in the end, since nothing else was proven
  SizeField size_field;
  SizeField asked;                ///< the same without what gaps ask for: what QualityOptions::asked takes
  std::vector<Index> kept_patch;  ///< per facet of the PLC: facets of one number were kept as one; what
                                  ///< QualityOptions::facet_patch asks for
};

/// Refines the mesh to the size field, then improves it to the quality level. Stages reported: refine, improve.
///
/// Preconditions: `mesh` is a result of tetrahedralize(plc) (all its invariants hold). The result has the same
/// invariants, except that points may have moved within the tolerance: such a point has input_vertex = no_vertex. In
/// `Honour::exact` every point of the PLC that was in the mesh is there unmoved. Faces keep the facet they are part of;
/// a face remade within a patch takes the facet of the patch nearest to it.
///
/// `Honour::tolerance`: triangles of the input and the result, and pieces of their curves, are proven within the
/// tolerance of the other's same patch or curve. Outer faces are proven to cross nowhere; up to six runs, each closer
/// to the input where the last was not so. From the fourth on the facets are kept where it was not. Where all of that
/// fails every surface is kept. Throws Error{cannot_mesh} where the estimated or the actual number of elements
/// exceeds the limit, Error{usage} on options out of range. Ends always: points are added for sizes only at a distance
/// from all others that the size field bounds from below. Improvement makes a bounded number of passes, none of
/// which lowers the worst shape but for rounding. Deterministic for given options unless a time budget is set.
///
/// Sources: Cavalcanti and Mello 1999, section 5 (points added automatically, smart smoothing); Freitag and
/// Ollivier-Gooch 1997 (combining flips with optimising smoothing); Klingner and Shewchuk 2007 (insertion, contraction
/// and the schedule of `best`).
RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization mesh,
                                const RefineOptions& options = {}, const RunContext& context = {});

/// The number of tetrahedra that the options ask for: integrals of the inverse of what an element of the asked size
/// takes of volume and of surfaces. Where surfaces stay, the cells that given points need are counted too. Within a
/// third of what comes out; not counted far beyond the limit.
double estimate_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options);

}  // namespace geomesh
