// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality_growth.hpp"

#include <cstdio>
#include <ctime>
#include <map>
#include <string>

#include "geomesh/core/refine.hpp"
#include "measured_run.hpp"
#include "quality_models.hpp"

namespace geomesh::bench {
namespace {

double own_cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Measurement run(const QualityModel& model, double size, double limit_s) {
  return measure({[&] {
    limit_cpu_seconds(limit_s);
    std::map<std::string, double> spent;
    RunContext context;
    context.stage = [&](std::string_view name, bool begins) {
      spent[std::string(name)] += begins ? -own_cpu() : own_cpu();
    };
    RefineOptions options;
    options.size.global = size;
    const RefineResult r = refine_and_improve(model.plc, tetrahedralize(model.plc, {}, context), options, context);
    Answer answer;
    answer.tetrahedra = r.mesh.tetrahedra.size();
    answer.stage_cpu_s = {spent["delaunay"], spent["recover"] + spent["classify"], spent["refine"], spent["improve"]};
    return answer;
  }})[0];
}

}  // namespace

void measure_growth(double limit_s) {
  std::printf(
      "| tetrahedra | Delaunay s (share) | recovery s (share) | refine s (share) | improve s (share) | whole s (CPU) | "
      "tetrahedra a CPU "
      "second | peak bytes a tetrahedron |\n|---|---|---|---|---|---|---|---|\n");
  const QualityModel model = grains(0, 1);
  for (const double size : {0.8, 0.55, 0.365}) {
    const Measurement m = run(model, size, limit_s);
    if (!m.ok) {
      std::printf("| size %.3g | – | – | – | – | %s (%.0f s) | – | – |\n", size, m.message.c_str(), limit_s);
      return;
    }
    std::printf("| %zu |", m.answer.tetrahedra);
    for (const double s : m.answer.stage_cpu_s) std::printf(" %.2f (%.0f %%) |", s, 100 * s / m.cpu_s);
    const double n = static_cast<double>(m.answer.tetrahedra);
    std::printf(" %.2f | %.0f | %.0f |\n", m.cpu_s, n / m.cpu_s, static_cast<double>(m.peak_bytes) / n);
    std::fflush(stdout);
  }
}

}  // namespace geomesh::bench
