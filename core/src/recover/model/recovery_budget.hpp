// SPDX-License-Identifier: MIT
/// @file
/// The constants of recovery: they limit how long each step is tried before the next step takes over. None of them
/// affects correctness, which exact predicates ensure. `recovery_bench` measures their effect on points and time.
#pragma once

#include <array>
#include <cstddef>

namespace geomesh::recover {

struct RecoveryBudget {
  // Attempts.
  /// Largest number of attempts. Models an ulp thick needed up to 7 in tests. More would only delay a refusal.
  unsigned attempts = 12;
  /// Number of points without a suitable double, over all attempts, at which the model is refused. It equals the number
  /// of attempts, so that all are made if each leaves one such point (soup 7944 with its boundary kept is meshed in the
  /// ninth). Most models that are too thin leave 7 to 55 in one attempt, some 1 or 2 (test_thin_models.cpp).
  std::size_t points_without_double = 12;
  /// Number of orientations of exact places for each facet, over all attempts, at which the model is refused. Needle
  /// plates and walls needed at most 3,600 before their last attempt; eight cracks need 115,000 in one attempt.
  std::size_t decisions_per_facet = 500000;
  /// Least distance between rounded points on a segment, in ulps of the largest coordinate. Closer points would crowd.
  double least_spacing_ulps = 64;
  /// Number of added points after which a model is searched for crossings; a share of its vertices is added to this
  /// number. Crossing facets need points without end, and a valid model rarely needs so many.
  double doubtful_points = 300;
  double doubtful_points_per_vertex = 0.25;
  /// Number of added points per vertex after which conforming mode, which adds many, searches for crossings.
  double doubtful_points_per_vertex_conforming = 10;

  // Start (start_triangulation.cpp, scale_forecast.cpp).
  std::size_t few_missing = 20;   ///< if at most this many segments are missing, no axis is stretched
  std::size_t stretch_from = 10;  ///< axes are stretched if more than one in this many segments is missing
  std::size_t stretch_gain = 20;  ///< stretching an axis by one step must save one in this many missing segments
  int stretch_steps = 12;         ///< power of two by which an axis is stretched at most
  /// Number of crossings of missing segments per cell from which axes are stretched to reduce them. A crossing costs
  /// about 30 microseconds of flips, a cell 1.5 of triangulation, so two dozen triangulations cost less than a third of
  /// what they may save. Two fans of 500 needles have 4.7 to 9.1, of 2,000 more than 15. The solids, structural models
  /// and corpus models of recovery_bench have up to 3.7 (chazelle_16).
  double crossings_per_cell = 4;
  /// A triangulation with fewer crossings is accepted if it misses at most one more in this many segments. Fans miss up
  /// to 8 percent more. Plates of rotated needles miss 63 percent more, and would get more points.
  std::size_t crossings_loss = 4;
  /// Slopes of a shear are multiples of this number, because the tilted plates of test models have simple slopes.
  double slope_step = 0x1p-10;
  std::size_t forecast_sample = 300;  ///< number of segments of each kind that a forecast examines
  double forecast_reach = 1e6;        ///< farthest centre of an empty sphere through a segment, in half lengths of it

  // Flips (segments_by_flips.cpp, edge_removal.hpp).
  std::size_t ring = 24;  ///< edges with more cells around them are not removed, which costs O(n^3)
  /// Number of edges and faces that flips try for a segment with its parts, or an edge that pierces a facet, before
  /// points are added. Segments that flips finally recovered took up to 16,000; 4,000 doubles the time of
  /// chazelle_slits_8.
  std::size_t flips_tried = 16000;
  /// Number of edges tried for the removal of one edge, by depth of recursion. Removals that succeed do so early.
  std::array<unsigned, 4> edges_by_depth{1, 40, 160, 600};
  unsigned flips_of_segment = 200;  ///< largest number of flips for one segment, from both ends
  unsigned sideways_flips = 3;      ///< flips allowed that leave as many crossings of a segment as before

  // Walks.
  /// Largest number of steps towards a neighbour. Then the whole star is searched, because stars are small.
  unsigned star_walk = 24;
  std::size_t line_walk = 400;  ///< largest number of cells in a walk along a segment

  // Cavities (cavity_retriangulation.hpp, polyhedron_filling.hpp, star_insertion.cpp).
  std::size_t star_cells = 400;  ///< largest number of cells in the cavity of an insertion
  /// Number of tetrahedra tried by a search for a filling, times the levels of flips. Longer searches find little more.
  std::size_t filling_nodes = 200;
  /// Number of tetrahedra tried to fill a sector beside a removed point, because fillings of regions find the rest.
  std::size_t filling_nodes_sector = 100;
  std::size_t filling_faces = 90;  ///< largest number of faces of a cavity for which a filling is searched
  unsigned filling_looks = 4;  ///< number of open faces that are examined to find the hardest, which is filled first

  // Points on segments (segments_by_points.cpp, crossed_cells.cpp).
  /// Share of a subsegment next to its ends in which no point is added, because rounded points would crowd there.
  double least_part = 1e-6;
  double near_crossing = 1e-7;         ///< share of a subsegment: items this close to a new point are removed with it
  std::size_t crossings_flipped = 20;  ///< largest number of crossings at which flips two levels deep are tried again
  /// Largest number of points on a subsegment, plus points_on_crossing for each crossing, because more would crowd.
  std::size_t points_on_subsegment = 100;
  std::size_t points_on_crossing = 4;  ///< additional points for each crossing of the subsegment
  /// Relative errors allowed for an exact parameter, tried one after the other. The first is nearly always sufficient.
  std::array<double, 4> parameter_errors{0x1p-50, 0x1p-75, 0x1p-100, 0x1p-150};

  // Points on facets (facets.cpp).
  unsigned facet_depth = 3;        ///< levels of flips before a facet gets points
  unsigned facet_depth_first = 2;  ///< levels of flips before the first point on a facet; before others, one level
  /// Largest number of faces and piercing edges found by traces of a facet, which order its flips and points. Without
  /// such traces chazelle_16 and SALT get one more point each; without a limit plates of 5,464 points took over 85 s.
  std::size_t traced_of_facet = 20000;

  // Removal of Steiner points (steiner_removal/).
  unsigned removal_passes = 8;        ///< largest number of passes over all added points, while any is removed
  unsigned removal_effort = 2;        ///< number of passes over added points before the greatest effort is made
  unsigned star_rounds = 8;           ///< rounds of flips at an inner point, each with an attempt to fill its star
  unsigned star_edges = 60;           ///< number of edges tried to reduce a point's degree by one
  unsigned link_edges = 200;          ///< number of edges of a point's link that are removed, each before an attempt
  unsigned link_edge_effort = 40;     ///< number of edges tried to remove one edge of a point's link
  unsigned link_edge_depth = 1;       ///< levels of flips for an edge of a link, 0 to 3: each costs ten times more
  unsigned chord_effort = 200;        ///< number of edges tried to remove the chord beside a point of a segment
  unsigned chord_depth = 2;           ///< levels of flips for a chord, because a single chord blocks everything else
  unsigned sheets = 3;                ///< largest number of triangles that divide a sector around a segment
  std::size_t sheet_apexes = 6;       ///< number of vertices tried as apex of each triangle that divides a sector
  unsigned moved_growths = 12;        ///< number of cells by which a sector grows for a point moved inside
  double least_move = 1e-15;          ///< least move of a point into a sector, as a share of the sector's extent
  double least_move_exact = 1e-30;    ///< least move of an exact point, as a share of the sector's extent
  unsigned sheet_point_growths = 60;  ///< number of cells that may be removed for a point beside a segment
  double sheet_point_reach = 0.25;    ///< first distance of a point beside a segment, relative to its shorter half
  double sheet_point_least = 1e-12;   ///< last distance of a point beside a segment, relative to its shorter half
  double sheet_point_part = 0.25;     ///< factor between the distances tried, because visibility changes slowly
  /// Directions of points beside a segment, in sixths of a turn from a facet attached to the segment. No attempt
  /// follows the first point, because it leaves a sector of 240 degrees; the following points halve the rest.
  std::array<double, 5> sheet_turns{2, 4, 3, 1, 5};
  /// Numbers of vertices of the regions that are filled by formulas; 52 would cost a quarter more.
  std::array<std::size_t, 3> region_vertices{20, 28, 40};
  std::size_t region_conflicts = 2000;  ///< number of conflicts allowed to the solver: most formulas need a few

  // Rounding (rounding.cpp).
  unsigned rounding_runs = 3;        ///< runs of rounding; points are removed from segments and facets in between
  unsigned rounding_rounds = 8;      ///< number of passes in each run: neighbours that have moved leave more room
  unsigned centring_sweeps = 10;     ///< in each round
  unsigned centring_steps = 100;     ///< largest number of steps of the linear program: about ten are needed
  double centring_gain = 1.01;       ///< a point is moved only if its least height grows by more than this factor
  double least_centring_part = 0.1;  ///< least part of a centring step; if only less is possible, the height was wrong
  int ulps = 2;                      ///< largest distance of a rounded point from the nearest double, in ulps
  unsigned rounding_growths = 30;    ///< number of cells that may be removed for a double beside a star
  // Doubles in thin stars (wide_polyhedron.cpp).
  unsigned analytic_steps = 200;  ///< largest number of steps of Newton's method: about twenty are needed
  /// Largest number of steps of a basis reduction. Stars that are 1e15 times longer than thick need about a hundred.
  unsigned lattice_steps = 2000;
  double lattice_layers = 20;      ///< number of layers of a lattice searched on each side of the centre
  std::size_t lattice_lines = 9;   ///< in each layer
  std::size_t lattice_points = 3;  ///< on each line

  // Conforming mode (conforming.hpp).
  double sharp_cosine = 0.5;     ///< cosine of 60 degrees: segments at a smaller angle meet sharply
  double sharp_rounding = 1e-9;  ///< error of a cosine that rounding of the directions may cause
  int least_edge = -40;          ///< shortest edge, as a power of two relative to the largest coordinate: 4096 ulps
  std::size_t points_per_vertex = 30;  ///< points allowed per vertex at sharp angles, and as many elsewhere
  std::size_t sharp_points = 3000;     ///< additional points allowed at sharp angles, in all
  std::size_t other_points = 100000;   ///< additional points allowed elsewhere, where refinement terminates by itself
};
inline constexpr RecoveryBudget recovery_budget{};

}  // namespace geomesh::recover
