// SPDX-License-Identifier: MIT
/// @file
/// The constants of improvement: how often each pass runs, on which cells, and when it ends.
///
/// Angles are dihedral angles in degrees. They stand for the shape of the sliver with this least angle, by the quality
/// measure chosen (CellQuality::of_angle). Factors and shares have no unit. `quality_bench --section levels` shows
/// what the levels reach and cost, `--section peers` beside tetgen and gmsh.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/core/refine.hpp"

namespace geomesh::remesh {

/// Parameters of the ascent that moves one vertex to its best place (star_optimizer.hpp).
struct AscentLimits {
  double first_reach = 0.3;  ///< first step, as a share of the distance to the nearest corner; longer ones invert cells
  double least_reach = 1e-3;   ///< smallest step, as a share of the first; shorter ones make no visible difference
  double active_share = 1.03;  ///< terms up to this factor of the smallest are raised together
  /// Terms within this difference of the smallest are raised together, too, so that ties near zero count.
  double active_margin = 1e-4;
  unsigned trials = 6;              ///< number of step lengths tried along one direction; a sixth is 0.01 of the first
  double shorten = 0.4;             ///< factor of the step length after a step without gain
  double lengthen = 1.5;            ///< factor of the step length after a step with gain
  double lengthen_mean = 2;         ///< the same for the mean, which is a smoother function
  double least_slope = 1e-6;        ///< a step is tried if its slope promises a rise of the shape above this
  double mean_reach_by_gain = 7.5;  ///< smallest step for the mean, as a multiple of the least gain
  unsigned hull_steps = 40;         ///< iterations of Gilbert's method; usually a dozen suffice
  double hull_accuracy = 1e-3;      ///< relative accuracy of the squared distance, which suffices for a direction
};
inline constexpr AscentLimits ascent_limits{};

/// Parameters of points that improvement adds (insertion.cpp). The least distance to other points is `usual_room`
/// (improve.hpp).
struct PointLimits {
  double thin_gap = 0.25;  ///< share of the target size; between surfaces nearer than this, points only make flat cells
  double least_rise = 1.01;     ///< smallest factor by which a new point must raise the worst shape
  std::size_t most_cells = 40;  ///< largest number of cells in the cavity; larger ones have never been the best
  unsigned most_places = 3;     ///< how often cavity and place are optimised in turn
  unsigned ascent_steps = 20;
};
inline constexpr PointLimits point_limits{};

/// Parameters of sequences of operations that look ahead (rescue.hpp).
struct RescueLimits {
  /// Least distance of a new point to others, as a share of the target size; points may be close, since a bad cell is
  /// worse.
  double room = 0.03;
  double notable_rise = 1.05;  ///< factor of the worst shape that makes a sequence worthwhile
  /// Improvement of one cell, as a share of the way from flat to good, that makes a search worthwhile.
  double notable_relief = 0.02;
  std::size_t most_given_up = 3;  ///< a sequence ends after this many cells could not be improved
  unsigned most_openings = 8;     ///< number of first steps in one trial of a search; later ones hardly ever succeed
  std::size_t trials_a_clearing = 4;  ///< one of this many trials first removes all points around the cell
  double hopeless = 2;  ///< a trial ends when the place is worse than before by as much as this many flat cells
  unsigned most_vain_openings = 12;
  /// A bad cell that the input does not impose may be replaced by at most this many additional ones that it does
  /// impose.
  std::size_t forced_instead = 1;
  /// A search continues from another cell only if the place is worse by at most this, in flat cells.
  double detour = 0.2;
  unsigned steps = 40;      ///< largest number of operations in one sequence
  unsigned bad_sweeps = 4;  ///< sweeps over all bad cells; the third improves one in a hundred
  /// Sweeps over the cells that the input does not impose; usually the budget of trials ends earlier.
  unsigned free_sweeps = 64;
  /// Trials around one cell in the first sweep; doubled after each sweep without success.
  std::size_t first_trials = 200;
  std::size_t least_trials = 500;  ///< budget of trials for all cells together, whatever the size of the mesh
  std::size_t most_trials = 60'000;
  std::size_t cells_a_vain_opening = 10;  ///< the mesh's number of cells for each sequence that may fail
  std::size_t least_vain = 4'000;         ///< of all cells together, whatever the size of the mesh: some seconds
  std::size_t most_vain = 60'000;
  std::size_t least_vain_free = 10'000;  ///< the same for cells that nothing forces
  std::size_t most_vain_poor = 10'000;   ///< the same for cells that are poor and no more: a second or two
  std::size_t cells_a_trial = 25;  ///< one trial for so many cells of the mesh: less than a fifth of the whole time
};
inline constexpr RescueLimits rescue_limits{};

/// Parameters of each pass for one quality level. The defaults are those of the standard level.
struct ImproveSchedule {
  // Passes that raise the mean.
  unsigned mean_rounds = 1;          ///< before the repair, which sees the worst cells alone
  unsigned mean_rounds_if_poor = 2;  ///< before and after the repair where the mesh is poor altogether
  double mean_floor_angle = 30;      ///< no cell falls below this for the mean
  double floor_percentile = 0.01;    ///< of all cells, 0..1: so many may be below that floor already
  double many_poor = 0.1;            ///< of all cells, 0..1, below `target_angle`: then the mesh is poor altogether

  // Repair, in which the worst cells come first.
  unsigned repair_rounds = 8;
  double target_angle = 32;       ///< cells below are repaired
  unsigned poor_classes = 32;     ///< of shape, the worst class first, each in the mesh's order, which is that of
                                  ///< memory; 0: the worst cell first
  double insertion_angle = 26;    ///< below this also by new points
  double good_above_target = 4;   ///< degrees above the target from which a vertex is not moved further
  unsigned smoothing_steps = 12;  ///< of one vertex
  double least_rise = 1.03;       ///< factor of the worst shape, > 1, that is worth a vertex's move
  double progress = 0.9;          ///< factor of the fewest poor cells so far that the next round must reach
  double progress_angle = 16;     ///< progress is measured on the cells below this too
  unsigned idle_rounds = 2;       ///< without a change, that end the repair
  unsigned first_round_with_points = 2;  ///< flips and moves alone in the first, contraction too in the second

  // Repair of slivers, with points closer to others than the sizes require.
  unsigned sliver_rounds = 8;  ///< for each room
  double sliver_angle = 12;
  /// Distances as shares of the target size; the second is used if the first does not suffice.
  std::array<double, 2> sliver_rooms{0.15, 0.03};
  double few_slivers = 0.05;  ///< share of all cells; if more are slivers, the surfaces impose them
  /// Number of the worst cells that are repaired if the surfaces impose them, as a share of all cells.
  double forced_share = 0.001;
  double forced_room = 0.01;  ///< distance of points in that case, as a share of the target size
  /// Degrees; solvers refuse cells below 1 degree, so these are repaired at a high cost for each cell.
  double flat_angle = 1.5;
  double few_bad = 0.01;  ///< share of all cells; if more are bad, the surfaces impose them
  /// Cells below these angles are repaired like slivers, one aim after the other, as long as they are `few`: a share of
  /// all cells. If more are below, the surfaces impose them. Removing points that are too near must not create more.
  struct Aim {
    double angle, few;
  };
  std::array<Aim, 2> aims{{{20, 2e-3}, {25, 2e-4}}};
  unsigned thinning_rounds = 4;  ///< rounds that remove points which were put near others without gain
};

constexpr ImproveSchedule schedule_of(QualityLevel level) {
  ImproveSchedule s;                  // takes one to three times as long as refinement
  if (level == QualityLevel::fast) {  // takes about as long as refinement
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
