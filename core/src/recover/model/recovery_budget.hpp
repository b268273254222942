// SPDX-License-Identifier: MIT
/// @file
/// The constants of recovery: they limit how long each step is tried before the next step takes over. None of them
/// affects correctness, which exact predicates ensure. `recovery_bench` measures their effect on points and time.
#pragma once

#include <array>
#include <cstddef>

namespace geomesh::recover {

struct RecoveryBudget {
  /// Largest number of attempts at recovery. Models an ulp thick needed up to 7 in tests.
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
  std::size_t few_missing = 20;   ///< no axis is scaled if at most this many segments are no Delaunay edges
  std::size_t stretch_from = 10;  ///< axes are scaled if more than one segment in this many is no Delaunay edge
  std::size_t stretch_gain = 20;  ///< doubling an axis' scale must make one in this many missing segments an edge
  int stretch_steps = 12;         ///< largest exponent of two by which an axis of the frame is scaled
  /// Number of crossings of missing segments per cell from which axes are stretched to reduce them. A crossing costs
  /// about 30 microseconds of flips, a cell 1.5 of triangulation, so two dozen triangulations cost less than a third of
  /// what they may save. Two fans of 500 needles have 4.7 to 9.1, of 2,000 more than 15. The solids, structural models
  /// and corpus models of recovery_bench have up to 3.7 (chazelle_16).
  double crossings_per_cell = 4;
  /// A start triangulation with fewer crossings is accepted if its number of missing segments grows by at most the
  /// reciprocal of this number (25 percent). Fans need up to 8 percent, plates of rotated needles 63 (not accepted).
  std::size_t crossings_loss = 4;
  /// Slopes of a shear are multiples of this number, because the tilted plates of test models have simple slopes.
  double slope_step = 0x1p-10;
  std::size_t forecast_sample = 300;  ///< number of missing segments, and of present ones, that a forecast examines
  double forecast_reach = 1e6;        ///< largest distance of an empty sphere's centre from a segment, in half lengths

  // Flips (segments_by_flips.cpp, edge_removal.hpp).
  std::size_t ring = 24;  ///< edges with more cells around them are not removed by flips, which costs O(n^3)
  /// Number of edges and faces that flips try for a segment with its parts, or an edge that pierces a facet, before
  /// points are added. Segments that flips finally recovered took up to 16,000; 4,000 doubles the time of
  /// chazelle_slits_8.
  std::size_t flips_tried = 16000;
  /// Number of edges tried for the removal of one edge, by depth of recursion. Removals that succeed do so early.
  std::array<unsigned, 4> edges_by_depth{1, 40, 160, 600};
  unsigned flips_of_segment = 200;  ///< largest number of flips for one segment, from both ends
  unsigned sideways_flips = 3;      ///< flips allowed that do not reduce the number of mesh items on a segment's way

  /// Largest number of steps of a walk in a vertex' star towards a neighbour; then all cells of the star are searched.
  unsigned star_walk = 24;
  std::size_t line_walk = 400;  ///< largest number of mesh cells in a walk along a segment

  // Limits for cavities (cavity_retriangulation.hpp, polyhedron_filling.hpp, star_insertion.cpp).
  std::size_t star_cells = 400;  ///< largest number of cells in the cavity of an inserted point
  /// Number of tetrahedra tried to fill a cavity, per level of recursion of the flips that failed before.
  std::size_t filling_nodes = 200;
  /// Number of tetrahedra tried to fill a part of a removed point's star, because fillings of regions find the rest.
  std::size_t filling_nodes_sector = 100;
  std::size_t filling_faces = 90;  ///< largest number of faces of a cavity for which a filling is searched
  unsigned filling_looks = 4;      ///< faces of a cavity examined to find the one that the fewest tetrahedra fit

  // Points on segments (segments_by_points.cpp, crossed_cells.cpp).
  /// Share of a subsegment next to its ends in which no point is added, because rounded points would crowd there.
  double least_part = 1e-6;
  double near_crossing = 1e-7;         ///< cells this near to a new point join its cavity (share of the subsegment)
  std::size_t crossings_flipped = 20;  ///< segments that cross more mesh items get flips one level deep, not two
  /// Largest number of points on a subsegment, plus points_on_crossing for each crossing, because more would crowd.
  std::size_t points_on_subsegment = 100;
  std::size_t points_on_crossing = 4;  ///< points allowed on a subsegment for each mesh item that it crosses
  /// Relative errors allowed for the parameter of an exact point on its line, tried in turn. The first mostly suffices.
  std::array<double, 4> parameter_errors{0x1p-50, 0x1p-75, 0x1p-100, 0x1p-150};

  // Limits for the recovery of facets (facets.cpp).
  unsigned facet_depth = 3;        ///< levels of recursion of flips before points are added to facets
  unsigned facet_depth_first = 2;  ///< levels of recursion of flips while the facet has no added point; afterwards 1
  /// Largest number of faces and piercing edges that repeated searches may find for a facet. Without such searches
  /// chazelle_16 and SALT get one more point each; without a limit plates of 5,464 points took over 85 s.
  std::size_t traced_of_facet = 20000;

  // Limits for the removal of Steiner points (steiner_removal/).
  unsigned removal_passes = 8;     ///< largest number of passes over all added points, while any is removed
  unsigned removal_effort = 2;     ///< passes of removal over all added points before the most costly methods are used
  unsigned star_rounds = 8;        ///< rounds of flips at a Steiner point in a region, each with a try to remove it
  unsigned star_edges = 60;        ///< edges that flips try to remove to reduce a point's degree by one
  unsigned link_edges = 200;       ///< number of attempts at a point's removal, each after another link edge is removed
  unsigned link_edge_effort = 40;  ///< number of edges tried to remove one edge of a point's link by flips
  unsigned link_edge_depth = 1;    ///< levels of recursion (0 to 3) of flips at link edges; each costs ten times more
  unsigned chord_effort = 200;     ///< edges tried to remove the edge between a point's neighbours on its segment
  unsigned chord_depth = 2;        ///< levels of recursion of flips that remove an edge between a point's neighbours
  unsigned sheets = 3;             ///< largest number of triangles that divide the star of a removed point
  std::size_t sheet_apexes = 6;    ///< vertices tried as corner of a triangle that divides a removed point's star
  unsigned moved_growths = 12;     ///< cells that may be added to a sector of a star that a point is moved into
  double least_move = 1e-15;       ///< least distance of a point's move off its facet, as a share of its star's extent
  double least_move_exact = 1e-30;    ///< least distance of an exact point's move off its facet, per extent of its star
  unsigned sheet_point_growths = 60;  ///< cells that may be added to the cavity of a point placed beside a segment
  /// Distances tried for a point beside a segment: first, least (relative to the shorter subsegment there), and ratio.
  double sheet_point_reach = 0.25;
  double sheet_point_least = 1e-12;
  double sheet_point_part = 0.25;
  /// Directions tried for points beside a segment that replace a Steiner point, in sixths of a turn from a facet at the
  /// segment. One point alone leaves a sector of 240 degrees and is not tried; the others halve the rest.
  std::array<double, 5> sheet_turns{2, 4, 3, 1, 5};
  /// Largest numbers of vertices of a region that the SAT solver fills, tried in turn; 52 would cost a quarter more.
  std::array<std::size_t, 3> region_vertices{20, 28, 40};
  std::size_t region_conflicts = 2000;  ///< number of conflicts allowed to the SAT solver: most formulas need a few

  // Rounding (rounding.cpp).
  unsigned rounding_runs = 3;        ///< how often all Steiner points are rounded, with removals in between
  unsigned rounding_rounds = 8;      ///< passes over the Steiner points in each run of rounding
  unsigned centring_sweeps = 10;     ///< in each round
  unsigned centring_steps = 100;     ///< largest number of steps of the linear program: about ten are needed
  double centring_gain = 1.01;       ///< a point moves only if its least height over link faces grows by this factor
  double least_centring_part = 0.1;  ///< least share of a computed move to a star's centre that is tried, by halving
  int ulps = 2;                      ///< largest distance of a rounded point from the nearest double, in ulps
  unsigned rounding_growths = 30;    ///< cells that may join a star, to replace its exact point by a double outside it
  // Limits of the search for doubles in thin stars (wide_polyhedron.cpp).
  unsigned analytic_steps = 200;  ///< largest number of steps of Newton's method: about twenty are needed
  /// Largest number of steps of a basis reduction. Stars that are 1e15 times longer than thick need about a hundred.
  unsigned lattice_steps = 2000;
  double lattice_layers = 20;      ///< lattice planes that are searched on each side of a polyhedron's centre
  std::size_t lattice_lines = 9;   ///< in each layer
  std::size_t lattice_points = 3;  ///< on each line

  // Conforming mode (conforming.hpp).
  double sharp_cosine = 0.5;     ///< cosine of 60 degrees: two segments at a smaller angle meet sharply
  double sharp_rounding = 1e-9;  ///< error of a cosine of two directions that rounding of the directions may cause
  int least_edge = -40;          ///< shortest edge allowed: this power of two times the largest coordinate (4096 ulps)
  std::size_t points_per_vertex = 30;  ///< added points allowed per vertex near sharp angles, and as many elsewhere
  std::size_t sharp_points = 3000;     ///< added points allowed near sharp angles, besides points_per_vertex
  std::size_t other_points = 100000;   ///< added points allowed away from sharp angles, besides points_per_vertex
};
inline constexpr RecoveryBudget recovery_budget{};

}  // namespace geomesh::recover
