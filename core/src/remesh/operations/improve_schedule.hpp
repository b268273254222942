// SPDX-License-Identifier: MIT
/// @file
/// The constants of improvement: how often each pass runs, on which cells, and when it ends.
///
/// Angles are dihedral angles in degrees. An angle stands for the shape of the sliver with this least angle, by the
/// chosen quality measure (CellQuality::of_angle). Factors and shares have no unit. `quality_bench --section levels`
/// shows what the quality levels reach and cost; `--section peers` compares them with tetgen and gmsh.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/core/refine.hpp"

namespace geomesh::remesh {

/// Parameters of the ascent that moves one vertex to its best place (star_optimizer.hpp).
struct AscentLimits {
  /// First step, as a share of the distance to the nearest vertex of the link; longer steps invert cells.
  double first_reach = 0.3;
  double least_reach = 1e-3;   ///< smallest step of the vertex, as a share of its first; shorter ones do not matter
  double active_share = 1.03;  ///< a step of the ascent raises all shapes up to this factor times the least shape
  /// A step also raises the shapes within this difference of the least, so that shapes near zero count as equal.
  double active_margin = 1e-4;
  unsigned trials = 6;        ///< number of step lengths tried along one direction; the sixth is 0.01 of the first
  double shorten = 0.4;       ///< factor of the step length after a step that did not raise the worst shape
  double lengthen = 1.5;      ///< factor of the step length after a step that raised the worst shape
  double lengthen_mean = 2;   ///< factor of the step length after a step that raised the mean shape
  double least_slope = 1e-6;  ///< the ascent ends if its slope predicts that the worst shape rises by less than this
  double mean_reach_by_gain = 7.5;  ///< when the mean shape is raised: shortest step / first step = this * least gain
  unsigned hull_steps = 40;         ///< iterations of Gilbert's method for the direction of a step; usually 12 suffice
  double hull_accuracy = 1e-3;      ///< relative accuracy in Gilbert's method, which suffices for a direction
};
inline constexpr AscentLimits ascent_limits{};

/// Parameters for adding points to improve shapes. Their least distance to others is `usual_room` (improve.hpp).
struct PointLimits {
  /// Width of gaps between surfaces, as a share of the target size, below which points only make flat cells.
  double thin_gap = 0.25;
  double least_rise = 1.01;     ///< smallest factor by which a new point must raise the worst shape
  std::size_t most_cells = 40;  ///< largest number of cells in a cavity; larger cavities were never the best
  unsigned most_places = 3;  ///< number of times that the cavity and the place of its new point are optimised in turn
  unsigned ascent_steps = 20;
};
inline constexpr PointLimits point_limits{};

/// Parameters of the sequences of operations that repair a bad cell, and are kept only if the result is better.
struct RescueLimits {
  /// Least distance of a new point to others, in target sizes; small, as a bad cell is worse than a short edge.
  double room = 0.03;
  double notable_rise = 1.05;  ///< factor by which a sequence of repair must raise the worst shape to be worthwhile
  /// With as many bad cells as before, a trial succeeds if the sum of their 1 - shape / bad_shape falls by this.
  double notable_relief = 0.02;
  std::size_t most_given_up = 3;  ///< repair around a bad cell ends once this many cells could not be improved
  /// Number of openings (random changes that may worsen shapes) in one trial to repair a cell; more hardly ever help.
  unsigned most_openings = 8;
  std::size_t trials_a_clearing = 4;  ///< one of this many repair trials first removes all points around the bad cell
  double hopeless = 2;                ///< a trial fails if the sum of 1 - shape / bad_shape rises by more than this
  unsigned most_vain_openings = 12;
  /// Largest number of bad cells imposed by the input that may be added to remove one that it does not impose.
  std::size_t forced_instead = 1;
  /// A search continues from a new bad cell unless the sum of 1 - shape / bad_shape has risen by more than this.
  double detour = 0.2;
  unsigned steps = 40;      ///< largest number of operations in one sequence that repairs a bad cell
  unsigned bad_sweeps = 4;  ///< number of sweeps over all bad cells; the third improves one in a hundred
  /// Number of sweeps over the bad cells that the input does not impose; usually the budget of trials ends earlier.
  unsigned free_sweeps = 64;
  /// Number of trials around one cell in the first sweep; doubled after each sweep that has not improved every cell.
  std::size_t first_trials = 200;
  std::size_t least_trials = 500;  ///< number of trials to repair bad cells that any mesh may take, however small
  std::size_t most_trials = 60'000;
  std::size_t cells_a_vain_opening = 10;  ///< one sequence of repair operations may fail per so many cells of the mesh
  std::size_t least_vain = 4'000;  ///< failed sequences of repair allowed in any mesh, however small; takes seconds
  std::size_t most_vain = 60'000;
  std::size_t least_vain_free =
      10'000;  ///< failed sequences of repair allowed, in any mesh, at cells not imposed by the input
  std::size_t most_vain_poor = 10'000;  ///< most failed sequences of repair allowed at poor cells; takes 1 to 2 s
  /// One trial to repair a bad cell is allowed per so many cells. All trials take less than a fifth of the time.
  std::size_t cells_a_trial = 25;
};
inline constexpr RescueLimits rescue_limits{};

/// Parameters of each pass for one quality level. The defaults are those of the standard level.
struct ImproveSchedule {
  // Parameters of the passes that raise the mean shape.
  unsigned mean_rounds = 1;  ///< rounds that raise the mean shape before repair, which improves the worst cells only
  /// rounds that raise the mean shape before and after repair if many cells are poor
  unsigned mean_rounds_if_poor = 2;
  double mean_floor_angle = 30;    ///< raising the mean shape lowers no cell below this angle (see floor_percentile)
  double floor_percentile = 0.01;  ///< percentile (0..1) of all shapes to which raising their mean may lower a shape
  double many_poor = 0.1;          ///< share of cells (0..1) below `target_angle` from which many cells count as poor

  // Parameters of repair, which treats the worst cells first.
  unsigned repair_rounds = 8;
  double target_angle = 32;  ///< cells whose least dihedral angle is below this are repaired
  /// Number of classes of shape in which poor cells are repaired, the worst class first; within a class in the order of
  /// memory. 0: strictly the worst cell first.
  unsigned poor_classes = 32;
  double insertion_angle = 26;    ///< cells whose least dihedral angle is below this are also repaired by new points
  double good_above_target = 4;   ///< degrees above `target_angle` from which a vertex is not moved further
  unsigned smoothing_steps = 12;  ///< of one vertex
  double least_rise = 1.03;       ///< factor (> 1) by which a move must raise the worst shape around a vertex
  double progress = 0.9;       ///< repair continues if the number of poor cells falls below this factor of its minimum
  double progress_angle = 16;  ///< repair also continues while the number of cells below this angle falls
  unsigned idle_rounds = 2;    ///< number of rounds without a change after which repair ends
  /// Number of the first round that adds points; round 0 only flips and moves, round 1 also contracts edges.
  unsigned first_round_with_points = 2;

  // Parameters of the repair of slivers, with points closer to others than the target sizes require.
  unsigned sliver_rounds = 8;  ///< for each room
  double sliver_angle = 12;
  /// Least distances of points that repair slivers, as shares of the target size; the second is tried after the first.
  std::array<double, 2> sliver_rooms{0.15, 0.03};
  double few_slivers = 0.05;  ///< if more than this share of all cells are slivers, the surfaces impose them
  /// If the surfaces impose slivers, number of the worst cells that are repaired, as a share of all cells.
  double forced_share = 0.001;
  /// Least distance of points in slivers that surfaces impose, as a share of the target size.
  double forced_room = 0.01;
  /// Cells below this angle are repaired at a high cost for each cell, because solvers refuse cells below 1 degree.
  double flat_angle = 1.5;
  double few_bad = 0.01;  ///< if more than this share of all cells are bad, the surfaces impose them
  /// Cells below `angle` are repaired like slivers if they are at most the share `few` of all cells; if there are more,
  /// the surfaces impose them. Removing points that are too close must not create more such cells.
  struct Aim {
    double angle, few;
  };
  std::array<Aim, 2> aims{{{20, 2e-3}, {25, 2e-4}}};
  unsigned thinning_rounds = 4;  ///< rounds that remove points which repair has added close to others without gain
};

constexpr ImproveSchedule schedule_of(QualityLevel level) {
  ImproveSchedule s;  // improvement at the standard level takes one to three times as long as refinement
  if (level == QualityLevel::fast) {  // improvement takes about as long as refinement
    s.mean_rounds_if_poor = 1, s.repair_rounds = 2, s.sliver_rounds = 0;
    s.target_angle = 20, s.insertion_angle = 0;
    s.smoothing_steps = 6, s.least_rise = 1.05;
  } else if (level == QualityLevel::best) {  // until nothing improves
    s.mean_rounds = 2, s.repair_rounds = 60, s.sliver_rounds = 20, s.poor_classes = 0;
    s.target_angle = 36, s.insertion_angle = 30, s.aims = {{{20, 2e-3}, {25, 2e-3}}};
    s.smoothing_steps = 20, s.least_rise = 1.0005, s.progress = 1.02;
  }
  return s;
}

}  // namespace geomesh::remesh
