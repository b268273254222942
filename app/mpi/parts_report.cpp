// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geomesh/core/quality.hpp"
#include "report/named_parts.hpp"
#include "solver_verdict/velocities.hpp"

namespace geomesh::app {

namespace {

using nlohmann::ordered_json;

double first_percentile(const PartShapes& shapes) {
  std::uint64_t seen = 0;
  for (std::size_t k = 0; k < PartShapes::n_bins; ++k) {
    seen += shapes.min_dihedral[k];
    if (100 * seen >= shapes.n) return 0.1 * static_cast<double>(k);
  }
  return 0;
}

/// Combines the predictions of all ranks for solvers: minima, maxima and sums. Numbers that depend on the median time
/// step of all elements are left out.
geomodel::SolverVerdict of_all(const std::vector<geomodel::SolverVerdict>& by_rank) {
  geomodel::SolverVerdict all;
  for (const geomodel::SolverVerdict& v : by_rank) {
    if (v.n_tetrahedra == 0) continue;
    const bool is_first = all.n_tetrahedra == 0;
    const auto least = [&](double& now, double own) {
      const bool is_less = is_first || own < now;
      if (is_less) now = own;
      return is_less;
    };
    if (least(all.least_volume, v.least_volume)) all.flattest = v.flattest;
    if (least(all.min_dihedral, v.min_dihedral)) all.sharpest = v.sharpest;
    if (least(all.time_step, v.time_step)) all.smallest_step = v.smallest_step;
    least(all.least_volume_16_digits, v.least_volume_16_digits);
    least(all.least_edge, v.least_edge);
    least(all.least_edge_over_size, v.least_edge_over_size);
    all.max_dihedral = std::max(all.max_dihedral, v.max_dihedral);
    all.n_tetrahedra += v.n_tetrahedra;
    all.n_not_positive += v.n_not_positive;
    all.n_implicit += v.n_implicit;
    all.n_iterative += v.n_iterative;
    all.n_flux += v.n_flux;
    all.has_velocities |= v.has_velocities;
  }
  return all;
}

/// Returns the predictions for solvers with the same keys as in the report of a single process, without the keys that
/// would need all elements at once.
ordered_json solver_json(const PartsReport& report) {
  geomodel::SolverVerdict all = of_all(report.verdicts);
  Box3 box;
  for (const Vec3& p : report.model.mesh.points) box.add(p);
  const Vec3 extent = box.max - box.min;
  all.least_edge_over_diagonal = all.least_edge / std::sqrt(dot(extent, extent));
  ordered_json j = ordered_json::parse(geomodel::to_json(all));
  for (const char* of_median : {"fail_explicit", "time_step_without_worst_ten", "median_time_step"}) j.erase(of_median);
  for (const char* worst : {"flattest", "sharpest", "smallest_step"}) j[worst].erase("tetrahedron");
  return j;
}

double mean(double sum, const PartShapes& shapes) { return shapes.n > 0 ? sum / static_cast<double>(shapes.n) : 0; }

std::string words(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

void PartShapes::add(const PartShapes& other) {
  n += other.n;
  least_dihedral = std::min(least_dihedral, other.least_dihedral);
  greatest_dihedral = std::max(greatest_dihedral, other.greatest_dihedral);
  least_radius_ratio = std::min(least_radius_ratio, other.least_radius_ratio);
  sum_min_dihedral += other.sum_min_dihedral;
  sum_radius_ratio += other.sum_radius_ratio;
  sum_mean_ratio += other.sum_mean_ratio;
  for (std::size_t k = 0; k < n_bins; ++k) min_dihedral[k] += other.min_dihedral[k];
}

PartShapes shapes_of(const RankMesh& mesh) {
  PartShapes shapes;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const TetrahedronShape s =
        tetrahedron_shape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    ++shapes.n;
    shapes.least_dihedral = std::min(shapes.least_dihedral, s.min_dihedral);
    shapes.greatest_dihedral = std::max(shapes.greatest_dihedral, s.max_dihedral);
    shapes.least_radius_ratio = std::min(shapes.least_radius_ratio, s.radius_ratio);
    shapes.sum_min_dihedral += s.min_dihedral;
    shapes.sum_radius_ratio += s.radius_ratio;
    shapes.sum_mean_ratio += s.mean_ratio;
    const auto bin = static_cast<std::size_t>(std::max(0.0, 10 * s.min_dihedral));
    ++shapes.min_dihedral[std::min(bin, PartShapes::n_bins - 1)];
  }
  return shapes;
}

geomodel::SolverVerdict judge_part(const RankModel& model, const RankMesh& mesh) {
  const std::vector<double> velocity = geomodel::velocity_by_region(model.sparse.mesh);
  const SizeField& size = model.sparse.size;
  geomodel::MeshForSolver judged;
  judged.points = mesh.points;
  judged.tetrahedra = mesh.tetrahedra;
  judged.threads = 1;
  judged.velocity = [&](std::size_t t) {
    return velocity[static_cast<std::size_t>(model.region_of_component[mesh.component[t]] - 1)];
  };
  judged.largest_size = std::min(size.limits().global, size.limits().max_size);
  judged.size = [&](std::size_t t, const Vec3& p, double enough) {
    return size.at_unless_below(enough, p, mesh.component[t]);
  };
  return geomodel::judge_for_solvers(judged);
}

std::string to_json(const PartsReport& report) {
  ordered_json root;
  root["command"] = "geomesh-mpi";
  root["name"] = report.model.mesh.name;
  root["ranks"] = report.ranks.size();
  root["input"] = ordered_json::parse(report.run.input_json);
  for (const auto& s : report.run.stages)
    root["stages_of_rank_0"].push_back(
        {{"name", s.name}, {"wall_s", s.wall_s}, {"cpu_s", s.cpu_s}, {"peak_bytes", s.peak_bytes}});
  root["points"] = report.n_points;
  root["tetrahedra"] = report.verified.n_tetrahedra;
  root["sparse_tetrahedra"] = report.model.mesh.tetrahedra.size();
  root["halvings"] = report.model.halvings;
  root["divide_cpu_s"] = report.run.divide_seconds;
  root["broadcast_bytes"] = report.run.broadcast_bytes;
  root["faces_between_ranks"] = report.verified.n_faces_between_ranks;
  root["points_between_ranks_never_moved"] = report.n_never_free;
  root["faces"] = report.numbered.faces.size();
  root.update(geomodel::named_parts_json(report.numbered));
  const PartShapes& q = report.shapes;
  root["quality"] = {
      {"min_dihedral",
       {{"min", q.least_dihedral}, {"mean", mean(q.sum_min_dihedral, q)}, {"first_percentile", first_percentile(q)}}},
      {"max_dihedral", q.greatest_dihedral},
      {"radius_ratio", {{"min", q.least_radius_ratio}, {"mean", mean(q.sum_radius_ratio, q)}}},
      {"mean_ratio", mean(q.sum_mean_ratio, q)}};
  root["solver"] = solver_json(report);
  for (std::size_t r = 0; r < report.ranks.size(); ++r) {
    const RankCost& c = report.ranks[r];
    const geomodel::SolverVerdict& v = report.verdicts[r];
    root["by_rank"].push_back({{"tetrahedra", c.n_own},
                               {"ghosts", c.n_ghosts},
                               {"in_strips", c.n_strip},
                               {"not_positive", v.n_not_positive},
                               {"fail_implicit", v.n_implicit},
                               {"fail_iterative", v.n_iterative},
                               {"fail_two_point_flux", v.n_flux},
                               {"cpu_s", c.cpu_seconds},
                               {"start_cpu_s", c.start_seconds},
                               {"model_cpu_s", c.model_seconds},
                               {"refine_cpu_s", c.refine_seconds},
                               {"strips_cpu_s", c.strips_seconds},
                               {"verify_cpu_s", c.verify_seconds},
                               {"write_cpu_s", c.write_seconds},
                               {"sent_bytes", c.sent_bytes},
                               {"peak_bytes", c.peak_bytes}});
  }
  root["notes"] = report.run.notes;
  root["warnings"] = report.run.warnings;
  root["files"] = report.files;
  return root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::vector<std::string> summary_of(const PartsReport& report) {
  std::vector<std::string> lines;
  lines.push_back(std::to_string(report.verified.n_tetrahedra) + " tetrahedra, " + std::to_string(report.n_points) +
                  " points, " + std::to_string(report.numbered.regions.size()) + " regions on " +
                  std::to_string(report.ranks.size()) + " ranks");
  lines.push_back("verified: all tetrahedra are positive, " + std::to_string(report.verified.n_faces_between_ranks) +
                  " faces between ranks are the same bit by bit, and regions have the volumes between their surfaces");
  const PartShapes& q = report.shapes;
  lines.push_back("dihedral angles are " + words("%.4g", q.least_dihedral) + " to " +
                  words("%.4g", q.greatest_dihedral) + " degrees; the least of an element is " +
                  words("%.4g", mean(q.sum_min_dihedral, q)) + " in the mean");
  lines.push_back(geomodel::to_lines(of_all(report.verdicts)).front());
  return lines;
}

}  // namespace geomesh::app
