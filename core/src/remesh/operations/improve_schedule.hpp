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

/// The ascent of one vertex to its best place (star_optimizer.hpp).
struct AscentLimits {
  double first_reach = 0.3;   ///< of the distance to the nearest corner, 0..1: the first step; longer ones invert cells
  double least_reach = 1e-3;  ///< of the first reach, 0..1: shorter steps change nothing that is seen
  double active_share = 1.03;       ///< terms up to this factor of the least are raised together, >= 1
  double active_margin = 1e-4;      ///< and this much in shape, so that ties near zero count
  unsigned trials = 6;              ///< step lengths along one direction; a sixth one is 0.01 of the first
  double shorten = 0.4;             ///< factor of the step where it did not rise, 0..1
  double lengthen = 1.5;            ///< factor of the next step where it did, > 1
  double lengthen_mean = 2;         ///< the same for the mean, which is smoother
  double least_slope = 1e-6;        ///< rise of the shape over the whole reach, from which a step is tried
  double mean_reach_by_gain = 7.5;  ///< least reach for the mean, as a multiple of the least gain required
  unsigned hull_steps = 40;         ///< of Gilbert's iteration; a dozen mostly do
  double hull_accuracy = 1e-3;      ///< relative, of its squared distance: a direction needs no more
};
inline constexpr AscentLimits ascent_limits{};

/// New points that improvement adds (insertion.cpp); how near to others they may be is `usual_room` (improve.hpp).
struct PointLimits {
  double thin_gap = 0.25;       ///< of the target size, 0..1: between surfaces nearer than this points make flat cells
  double least_rise = 1.01;     ///< factor of the worst shape, > 1: less is not worth a point
  std::size_t most_cells = 40;  ///< of the cavity; larger ones have never been the best
  unsigned most_places = 3;     ///< cavity and place are found in turns, this often
  unsigned ascent_steps = 20;
};
inline constexpr PointLimits point_limits{};

/// Sequences of operations that look ahead (rescue.hpp).
struct RescueLimits {
  double room = 0.03;             ///< of the target size, 0..1: a bad cell is worse than a point too near
  double notable_rise = 1.05;     ///< factor of the worst shape, > 1, that is worth a sequence
  double notable_relief = 0.02;   ///< of one cell's way from flat to good, 0..1, that is worth a sequence of a search
  std::size_t most_given_up = 3;  ///< cells about which all was in vain, before a sequence ends
  unsigned most_openings = 8;     ///< of one trial of a search; later ones hardly ever mend
  std::size_t trials_a_clearing = 4;  ///< one trial of so many removes all points about the cell first
  double hopeless = 2;                ///< cells as flat that the place may lack more than before, until a trial ends
  unsigned most_vain_openings = 12;
  /// A bad cell that the input does not impose may be traded for at most this many additional ones that it imposes.
  std::size_t forced_instead = 1;
  double detour = 0.2;             ///< flat cells that the place may lack more, if a search continues from another cell
  unsigned steps = 40;             ///< operations of one sequence
  unsigned bad_sweeps = 4;         ///< over all bad cells; the third mends one in a hundred
  unsigned free_sweeps = 64;       ///< over those that the input does not impose; the budget of trials ends before
  std::size_t first_trials = 200;  ///< about one cell in the first sweep, twice as many after each sweep in vain
  std::size_t least_trials = 500;  ///< of all cells together, whatever the size of the mesh
  std::size_t most_trials = 60'000;
  std::size_t cells_a_vain_opening = 10;  ///< one sequence in vain for so many cells of the mesh
  std::size_t least_vain = 4'000;         ///< of all cells together, whatever the size of the mesh: some seconds
  std::size_t most_vain = 60'000;
  std::size_t least_vain_free = 10'000;  ///< the same for cells that nothing forces
  std::size_t most_vain_poor = 10'000;   ///< the same for cells that are poor and no more: a second or two
  std::size_t cells_a_trial = 25;  ///< one trial for so many cells of the mesh: less than a fifth of the whole time
};
inline constexpr RescueLimits rescue_limits{};

/// Settings of a level of quality, pass by pass; by default those of the standard level.
struct ImproveSchedule {
  // Passes that raise the mean.
  unsigned mean_rounds = 2;  ///< before the repair, which sees the worst cells alone, and after one that left many poor
  double mean_floor_angle = 30;    ///< no cell falls below this for the mean
  double floor_percentile = 0.01;  ///< of all cells, 0..1: so many may be below that floor already
  double much_gained = 3;          ///< of the least gain worth a move: vertices that gained more are examined again
  double many_poor = 0.1;          ///< of all cells, 0..1, below `target_angle`: then the mesh is poor altogether

  // Repair, the worst cell first.
  unsigned repair_rounds = 8;
  double target_angle = 32;       ///< cells below are repaired
  unsigned poor_classes = 32;      ///< of shape, the worst class first, each in the mesh's order, which is that of
                                  ///< memory; 0: the worst cell first
  double insertion_angle = 26;    ///< below this also by new points
  double good_above_target = 4;   ///< degrees above the target from which a vertex is not moved further
  unsigned smoothing_steps = 12;  ///< of one vertex
  double least_rise = 1.03;       ///< factor of the worst shape, > 1, that is worth a vertex's move
  double progress = 0.9;          ///< factor of the fewest poor cells so far that the next round must reach
  double progress_angle = 16;     ///< progress is measured on the cells below this too
  unsigned idle_rounds = 2;       ///< without a change, that end the repair
  unsigned first_round_with_points = 2;  ///< flips and moves alone in the first, contraction too in the second

  // Slivers, with points closer to others than sizes ask.
  unsigned sliver_rounds = 8;  ///< for each room
  double sliver_angle = 12;
  std::array<double, 2> sliver_rooms{0.15, 0.03};  ///< of the target size; the next if the last was too narrow
  double few_slivers = 0.05;                       ///< of all cells, 0..1; more are imposed by the surfaces
  double forced_share = 0.001;  ///< of all cells, 0..1: number of the worst repaired if they are imposed
  double forced_room = 0.01;    ///< of the target size
  double flat_angle = 1.5;      ///< degrees; below 1 solvers refuse a cell: these are mended at a high cost a cell
  double few_bad = 0.01;        ///< of all cells, 0..1: if more of them are bad, the surfaces impose them
  /// If few cells are below, they are repaired like those. Removing points that are too near must not make more.
  double aim_angle = 20;
  double few_below_aim = 2e-3;   ///< of all cells, 0..1; more are imposed by the surfaces
  unsigned thinning_rounds = 4;  ///< take points out again that were put near others in vain
};

constexpr ImproveSchedule schedule_of(QualityLevel level) {
  ImproveSchedule s;                  // one to three times as long as refinement
  if (level == QualityLevel::fast) {  // about as long as refinement
    s.mean_rounds = 1, s.repair_rounds = 2, s.sliver_rounds = 0;
    s.target_angle = 20, s.insertion_angle = 0;
    s.smoothing_steps = 6, s.least_rise = 1.05, s.much_gained = 6;
  } else if (level == QualityLevel::best) {  // until nothing improves
    s.repair_rounds = 60, s.sliver_rounds = 20, s.poor_classes = 0;
    s.target_angle = 36, s.insertion_angle = 30, s.aim_angle = 25;
    s.smoothing_steps = 20, s.least_rise = 1.0005, s.progress = 1.02;
  }
  return s;
}

}  // namespace geomesh::remesh
