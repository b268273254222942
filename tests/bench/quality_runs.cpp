// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality_runs.hpp"

#include <cstdio>
#include <ctime>

namespace geomesh::bench {

ElementShapes shapes_of(const ShapeStatistics& s) {
  return {s.min_dihedral.min,  s.max_dihedral.max, s.min_dihedral.first_percentile,
          s.min_dihedral.mean, s.share_below_10,   s.share_above_24_85};
}

void print_row_header(const char* second_column) {
  std::printf(
      "| model | %s | tetrahedra | least angle | largest | first percentile | mean of least | below 10 %% | above "
      "24.85 %% | "
      "CPU s |\n|---|---|---|---|---|---|---|---|---|---|\n",
      second_column);
}

void print_row(const std::string& model, const Row& r) {
  const ElementShapes& s = r.shapes;
  if (r.tetrahedra == 0)
    std::printf("| %s | %s | – | – | – | – | – | – | – | %.2f |\n", model.c_str(), r.tool.c_str(), r.cpu_s);
  else
    std::printf("| %s | %s | %zu | %.4f | %.2f | %.2f | %.2f | %.3f | %.3f | %.2f |\n", model.c_str(), r.tool.c_str(),
                r.tetrahedra, s.least, s.largest, s.first_percentile, s.mean_of_least, 100 * s.share_below_10,
                100 * s.share_above_24_85, r.cpu_s);
  std::fflush(stdout);
}

Row run_geomesh(const QualityModel& model, const RefineOptions& options, const std::string& label, double limit_s) {
  const Measurement m = measure({[&] {
    limit_cpu_seconds(limit_s);
    const RefineResult r = refine_and_improve(model.plc, tetrahedralize(model.plc), options);
    Answer answer;
    answer.tetrahedra = r.mesh.tetrahedra.size();
    answer.meshing_cpu_s =
        static_cast<double>(std::clock()) / CLOCKS_PER_SEC;  // of this process, which began with the run
    answer.shapes = shapes_of(measure_shapes(r.mesh.points, r.mesh.tetrahedra));
    return answer;
  }})[0];
  return {m.ok ? label : label + ": " + m.message, m.answer.tetrahedra, m.answer.shapes,
          m.ok ? m.answer.meshing_cpu_s : limit_s};
}

}  // namespace geomesh::bench
