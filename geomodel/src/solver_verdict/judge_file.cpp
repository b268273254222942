// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_verdict/judge_file.hpp"

#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns the velocity given for a region's own name, else for its unit (the name without suffix).
double velocity_of(const std::string& region, const Velocities& velocities) {
  if (const auto own = velocities.find(region); own != velocities.end()) return own->second;
  const auto unit = velocities.find(region.substr(0, region.rfind("__")));
  return unit == velocities.end() ? 0 : unit->second;
}

}  // namespace

void check_for_solvers(const checking::MeshFile& file, const Velocities& velocities, CheckResult& result) {
  std::map<std::int32_t, double> by_region;
  for (const auto& [id, name] : file.region_names) by_region[id] = velocity_of(name, velocities);
  MeshForSolver mesh{file.points, file.tetrahedra, {}, {}};
  if (file.region.size() == file.tetrahedra.size())
    mesh.velocity = [&](std::size_t t) {
      const auto at = by_region.find(file.region[t]);
      return at == by_region.end() ? 0.0 : at->second;
    };
  const SolverVerdict verdict = judge_for_solvers(mesh);
  result.solver = verdict;
  result.checks_done.emplace_back("what solvers will make of it");
  if (verdict.passes()) return;
  const WorstForSolver& worst = verdict.n_not_positive > 0 ? verdict.flattest : verdict.sharpest;
  result.faults.push_back({"unfit_for_solvers",
                           std::to_string(verdict.n_implicit) + " elements are too flat for solvers, " +
                               std::to_string(verdict.n_not_positive) + " of them without positive volume in doubles",
                           verdict.n_implicit,
                           {worst.tetrahedron},
                           worst.place});
}

}  // namespace geomesh::geomodel
