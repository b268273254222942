// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the tables of the Refinement section of docs/performance.md to standard output:
///     quality_bench [--section peers|levels|growth]... [--model NAME] [--limit SECONDS]
/// peers: beside `tetgen -pq1.414` and `gmsh -3 -optimize_netgen` (command-line programs) on the same surfaces and, within a
/// tenth, the same number of tetrahedra; `--model`: on the models whose names contain NAME. levels: fast, default and best, surfaces
/// kept and within 0.2 % of a grain's size. growth: to a million tetrahedra, by stage. `--limit`: processor seconds of one run.
#include <cstdlib>
#include <set>
#include <string>
#include <tbb/global_control.h>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "quality_compare.hpp"
#include "quality_growth.hpp"
#include "quality_runs.hpp"

using namespace geomesh;
using namespace geomesh::bench;

namespace {

void compare_levels(double limit_s) {
  print_row_header("level");
  for (const double roughness : {0.0, 0.25}) {
    const QualityModel model = grains(roughness, 1);
    for (const double tolerance : {0.0, 0.002 * 2 * 3.435})
      for (const auto& [name, level] : {std::pair{"fast", QualityLevel::fast}, std::pair{"default", QualityLevel::standard},
                                        std::pair{"best", QualityLevel::best}}) {
        RefineOptions options;
        options.quality = level;
        options.size.gradation = 0.5;
        if (tolerance > 0) options.honour = Honour::tolerance, options.tolerance = tolerance;
        const Row r = run_geomesh(model, options, std::string(name) + (tolerance > 0 ? ", within 0.2 %" : ", surfaces kept"), limit_s);
        print_row(model.name, r);
      }
  }
}

}  // namespace

int main(int argc, char** argv) {
  // One thread: runs are processes that fork from this one, and comparisons are by processor time.
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::set<std::string> sections;
  CompareOptions options;
  double limit_s = 0;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--section") sections.insert(value);
    if (name == "--model") options.only = value;
    if (name == "--limit") limit_s = std::atof(value.c_str());
  }
  if (limit_s > 0) options.peer_limit_s = options.own_limit_s = limit_s;
  const auto wants = [&](const char* s) { return sections.empty() || sections.contains(s); };
  if (wants("peers")) compare_peers(options);
  if (wants("levels")) compare_levels(options.own_limit_s);
  if (wants("growth")) measure_growth(limit_s > 0 ? limit_s : 600);
}
