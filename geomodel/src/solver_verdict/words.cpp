// SPDX-License-Identifier: GPL-3.0-or-later
// Formats a solver verdict as text and as JSON: to_lines and to_json of geomesh/geomodel/solver_verdict.hpp.
#include "geomesh/geomodel/words.hpp"

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/solver_verdict.hpp"

namespace geomesh::geomodel {

namespace {

std::string place_words(const Vec3& p) {
  return "(" + short_words(p.x) + ", " + short_words(p.y) + ", " + short_words(p.z) + ")";
}

std::string counted(std::size_t n, const std::string& what) { return std::to_string(n) + " " + what; }

std::string shapes(const SolverVerdict& v) {
  std::string text = "least volume over cube of longest edge " + short_words(v.least_volume) + " (" +
                     short_words(v.least_volume_16_digits) + " with 16 digits), least edge over diagonal " +
                     short_words(v.least_edge_over_diagonal);
  if (v.least_edge_over_size > 0) text += ", over the size requested there " + short_words(v.least_edge_over_size);
  return text + ", dihedral angles " + short_words(v.min_dihedral) + " to " + short_words(v.max_dihedral) + " degrees";
}

std::string counts(const SolverVerdict& v) {
  return "elements that would fail: " + counted(v.n_not_positive, "without positive volume, ") +
         counted(v.n_implicit, "too flat for implicit finite elements, ") +
         counted(v.n_iterative, "slow for iterative solvers, ") + counted(v.n_flux, "for two-point fluxes, ") +
         counted(v.n_explicit, "below a twentieth of the median explicit time step");
}

std::string steps(const SolverVerdict& v) {
  const std::string unit = v.has_velocities ? " s" : " over the velocity vp (least height of an element)";
  return "explicit time step " + short_words(v.time_step) + unit + ", without the worst ten elements " +
         short_words(v.time_step_without_worst_ten);
}

}  // namespace

std::vector<std::string> to_lines(const SolverVerdict& v) {
  std::vector<std::string> lines;
  if (v.passes()) {
    lines.push_back("elements are fit for solvers: every one has a positive volume, dihedral angles are " +
                    short_words(v.min_dihedral) + " to " + short_words(v.max_dihedral) + " degrees");
  } else {
    const WorstForSolver& worst = v.n_not_positive > 0 ? v.flattest : v.sharpest;
    lines.push_back("elements are not fit for solvers: " + counted(v.n_implicit, "of ") +
                    counted(v.n_tetrahedra, "elements are too flat, the worst at ") + place_words(worst.place));
  }
  lines.push_back("  " + shapes(v));
  lines.push_back("  " + counts(v));
  lines.push_back("  " + steps(v));
  return lines;
}

std::string to_json(const SolverVerdict& v) {
  const auto place = [](const WorstForSolver& w) {
    return nlohmann::ordered_json{{"tetrahedron", w.tetrahedron}, {"place", {w.place.x, w.place.y, w.place.z}}};
  };
  nlohmann::ordered_json j{{"passes", v.passes()},
                           {"least_volume", v.least_volume},
                           {"least_volume_16_digits", v.least_volume_16_digits},
                           {"least_edge", v.least_edge},
                           {"least_edge_over_diagonal", v.least_edge_over_diagonal},
                           {"min_dihedral", v.min_dihedral},
                           {"max_dihedral", v.max_dihedral},
                           {"not_positive", v.n_not_positive},
                           {"fail_implicit", v.n_implicit},
                           {"fail_iterative", v.n_iterative},
                           {"fail_two_point_flux", v.n_flux},
                           {"fail_explicit", v.n_explicit},
                           {"has_velocities", v.has_velocities},
                           {"time_step", v.time_step},
                           {"time_step_without_worst_ten", v.time_step_without_worst_ten},
                           {"median_time_step", v.median_time_step},
                           {"flattest", place(v.flattest)},
                           {"sharpest", place(v.sharpest)},
                           {"smallest_step", place(v.smallest_step)}};
  if (v.least_edge_over_size > 0) j["least_edge_over_size"] = v.least_edge_over_size;
  return j.dump();
}

}  // namespace geomesh::geomodel
