// SPDX-License-Identifier: MIT
/// @file
/// The constants of recovery: how long each step is tried before the next one takes over. None decides what is right,
/// which exact predicates do. `recovery_bench` shows what they reach, in points and time.
#pragma once

#include <array>
#include <cstddef>

namespace geomesh::recover {

struct RecoveryBudget {
  // Attempts.
  /// Models an ulp thick took up to 7 on what was tried. More would only put off a refusal.
  unsigned attempts = 12;
  /// Points that no double did for, over all attempts: from there on the model is refused. As many as attempts: where
  /// one point is left each time, all of them are made (soup 7944 with its boundary kept is meshed in the ninth). Most
  /// too thin models leave 7 to 55 in one attempt, some 1 or 2 (test_thin_models.cpp).
  std::size_t points_without_double = 12;
  /// Orientations of exact places decided for each facet, over all attempts: from there on the model is refused. Needle
  /// plates and walls have taken at most 3,600 before their last attempt; eight slits take 115,000 in one.
  std::size_t decisions_per_facet = 500000;
  /// Ulps of the largest coordinate. Rounded points of a segment come no nearer to each other, or they crowd.
  double least_spacing_ulps = 64;
  /// Points after which a model is searched for crossings: this many, and a share of its vertices. Crossing facets need
  /// points without end, and a valid model hardly ever so many.
  double doubtful_points = 300;
  double doubtful_points_per_vertex = 0.25;
  double doubtful_points_per_vertex_conforming = 10;  ///< where points are cheap and many are normal

  // Start (start_triangulation.cpp, scale_forecast.cpp).
  std::size_t few_missing = 20;   ///< segments missing up to which no axis is stretched
  std::size_t stretch_from = 10;  ///< one missing of so many segments, and more, and axes are stretched
  std::size_t stretch_gain = 20;  ///< a step of an axis has to save one of so many missing ones
  int stretch_steps = 12;         ///< powers of two of an axis at most
  /// Crossings of missing segments for each cell, from which axes are stretched to reduce them. A crossing costs some
  /// 30 microseconds of flips, a cell 1.5 of triangulation, so two dozen triangulations cost less than a third of what
  /// they may save. Two fans of 500 needles have 4.7 to 9.1, of 2,000 more than 15. The solids, structural models and
  /// corpus models of recovery_bench have up to 3.7 (chazelle_16).
  double crossings_per_cell = 4;
  /// A step that reduces crossings may miss one more of so many segments. Fans miss up to 8 percent more, plates of
  /// turned needles, which then get more points, 63.
  std::size_t crossings_loss = 4;
  double slope_step = 0x1p-10;        ///< of a shear: plates of the tilted families have whole slopes
  std::size_t forecast_sample = 300;  ///< segments of each kind that a forecast looks at
  double forecast_reach = 1e6;        ///< half lengths of a segment: empty spheres beyond are no hope

  // Flips (segments_by_flips.cpp, edge_removal.hpp).
  std::size_t ring = 24;  ///< cells about an edge that is removed: O(n^3) each
  /// Edges and faces that flips try for one segment and all its parts, or for each edge that pierces a facet: what
  /// takes more gets points. Segments that flips recovered at last took up to 16,000; 4,000 double the time of
  /// chazelle_slits_8.
  std::size_t flips_tried = 16000;
  std::array<unsigned, 4> edges_by_depth{1, 40, 160, 600};  ///< edges of one removal: those that succeed do so early
  unsigned flips_of_segment = 200;                          ///< for one segment, from both ends
  unsigned sideways_flips = 3;                              ///< that leave as many crossings as before

  // Walks.
  unsigned star_walk = 24;      ///< steps towards a neighbour until the whole star is searched: stars are small
  std::size_t line_walk = 400;  ///< cells along a segment

  // Cavities (cavity_retriangulation.hpp, polyhedron_filling.hpp, star_insertion.cpp).
  std::size_t star_cells = 400;     ///< of the cavity of an insertion
  std::size_t filling_nodes = 200;  ///< tetrahedra tried in a search for each level of flips; deeper finds little
  std::size_t filling_nodes_sector = 100;  ///< the same beside a point that goes: regions take what it leaves
  std::size_t filling_faces = 90;          ///< of a cavity that is searched
  unsigned filling_looks = 4;              ///< faces of which the hardest is filled first

  // Points on segments (segments_by_points.cpp, crossed_cells.cpp).
  double least_part = 1e-6;                ///< of a subsegment, next to its ends: rounded points there would crowd
  double near_crossing = 1e-7;             ///< of a subsegment: what is so near to a new point goes with it
  std::size_t crossings_flipped = 20;      ///< crossings up to which flips two levels deep are tried again
  std::size_t points_on_subsegment = 100;  ///< more points only crowd; and for each crossing
  std::size_t points_on_crossing = 4;      ///< so many more
  /// Parts of itself by which an exact parameter may be off, one after the other. The first is nearly always enough.
  std::array<double, 4> parameter_errors{0x1p-50, 0x1p-75, 0x1p-100, 0x1p-150};

  // Points on facets (facets.cpp).
  unsigned facet_depth = 3;        ///< levels of flips before a facet gets points
  unsigned facet_depth_first = 2;  ///< before its first point; one level between points
  /// Faces and piercing edges found by the traces of a facet that order its flips and points. With no such trace
  /// chazelle_16 and SALT get one more point each; without a limit plates of 5,464 points took over 85 CPU seconds.
  std::size_t traced_of_facet = 20000;

  // Steiner points taken out (steiner_removal/).
  unsigned removal_passes = 8;        ///< of all points, while any goes
  unsigned removal_effort = 2;        ///< passes after which the greatest effort is made
  unsigned star_rounds = 8;           ///< of flips at an inner point, each with a try at its star
  unsigned star_edges = 60;           ///< edges tried to lower a point's degree by one
  unsigned link_edges = 200;          ///< of a point's link, each removed before a try
  unsigned link_edge_effort = 40;     ///< edges tried for the removal of one of them
  unsigned link_edge_depth = 1;       ///< levels of flips for that, 0 to 3: each costs ten times the one before
  unsigned chord_effort = 200;        ///< edges tried for the removal of a segment's own chord
  unsigned chord_depth = 2;           ///< levels of flips for that: one chord, which blocks all else
  unsigned sheets = 3;                ///< triangles that part a sector which goes all the way round
  std::size_t sheet_apexes = 6;       ///< vertices tried for each of them
  unsigned moved_growths = 12;        ///< cells that a sector grows over for a point moved inside
  double least_move = 1e-15;          ///< of the sector's reach: a point moved less is where it was
  double least_move_exact = 1e-30;    ///< the same for exact points
  unsigned sheet_point_growths = 60;  ///< cells that give way to a point beside a segment
  double sheet_point_reach = 0.25;    ///< of the shorter half of the segment: where such a point is tried first
  double sheet_point_least = 1e-12;   ///< and last
  double sheet_point_part = 0.25;     ///< of the distance before, each time: what is seen changes slowly
  /// Sixths of a turn about a segment, from a facet that hangs on it, in which such points are put. The first leaves a
  /// sector of 240 degrees, so no try follows it; those after it halve what is left.
  std::array<double, 5> sheet_turns{2, 4, 3, 1, 5};
  std::array<std::size_t, 3> region_vertices{20, 28, 40};  ///< sizes of regions filled as formulas; 52 costs a quarter
  std::size_t region_conflicts = 2000;                     ///< of the solver: most are decided by a handful

  // Rounding (rounding.cpp).
  unsigned rounding_runs = 3;        ///< each after points have been taken off segments and facets
  unsigned rounding_rounds = 8;      ///< over the points of a run: neighbours that have moved leave more room
  unsigned centring_sweeps = 10;     ///< in each round
  unsigned centring_steps = 100;     ///< from vertex to vertex of a linear program: some ten are taken
  double centring_gain = 1.01;       ///< of the least height, below which a point stays
  double least_centring_part = 0.1;  ///< of a step: below, the height has been misjudged
  int ulps = 2;                      ///< from the nearest double
  unsigned rounding_growths = 30;    ///< cells that give way to a double beside a star
  // Doubles in thin stars (wide_polyhedron.cpp).
  unsigned analytic_steps = 200;   ///< of Newton's method: some twenty are taken
  unsigned lattice_steps = 2000;   ///< of a basis' reduction: some hundred where a star is 1e15 times longer than thick
  double lattice_layers = 20;      ///< looked through on each side of the centre
  std::size_t lattice_lines = 9;   ///< in each layer
  std::size_t lattice_points = 3;  ///< on each line

  // Conforming mode (conforming.hpp).
  double sharp_cosine = 0.5;           ///< segments that meet at less than 60 degrees meet sharply
  double sharp_rounding = 1e-9;        ///< of a cosine: what rounding the directions may do
  int least_edge = -40;                ///< power of two of the largest coordinate: 4096 ulps of it
  std::size_t points_per_vertex = 30;  ///< in all, where angles are sharp, and elsewhere
  std::size_t sharp_points = 3000;     ///< and so many more where angles are sharp
  std::size_t other_points = 100000;   ///< elsewhere, where refinement ends by itself
};
inline constexpr RecoveryBudget recovery_budget{};

}  // namespace geomesh::recover
