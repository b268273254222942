// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Combines shapes, times and counts of all ranks into one report.
#pragma once

#include <map>
#include <string>

#include "geomesh/geomodel/solver_verdict.hpp"
#include "numbering.hpp"
#include "ranks.hpp"
#include "sparse_model.hpp"
#include "verify_parts.hpp"

namespace geomesh::app {

/// Statistics of the shapes of tetrahedra, of one rank or summed over ranks. Plain data.
struct PartShapes {
  static constexpr std::size_t n_bins = 1800;  ///< bins of the histogram of dihedral angles, each of 0.1 degrees
  std::uint64_t n = 0;
  double least_dihedral = 180, greatest_dihedral = 0, least_radius_ratio = 1;
  double sum_min_dihedral = 0, sum_radius_ratio = 0, sum_mean_ratio = 0;
  std::array<std::uint64_t, n_bins> min_dihedral{};
  void add(const PartShapes& other);
};
PartShapes shapes_of(const RankMesh& mesh);

/// Predicts what solvers will do with the tetrahedra of one rank; velocities are those of their units.
geomodel::SolverVerdict judge_part(const RankModel& model, const RankMesh& mesh);

/// Time and memory used by one rank. Plain data.
struct RankCost {
  double cpu_seconds = 0, start_seconds = 0, model_seconds = 0, refine_seconds = 0, strips_seconds = 0;
  double verify_seconds = 0, write_seconds = 0;
  std::uint64_t peak_bytes = 0, sent_bytes = 0, n_own = 0, n_ghosts = 0, n_strip = 0;
};

struct PartsReport {
  const SparseModel& model;
  const SparseRun& run;
  const VerifiedParts& verified;
  const geomodel::ModelMesh& numbered;  ///< the mesh, with counts and volumes of all ranks
  PartShapes shapes;
  std::vector<RankCost> ranks;
  std::vector<geomodel::SolverVerdict> verdicts;  ///< by rank
  std::uint64_t n_points = 0, n_never_free = 0;
  std::vector<std::string> files;
};

std::string to_json(const PartsReport& report);
std::vector<std::string> summary_of(const PartsReport& report);

}  // namespace geomesh::app
