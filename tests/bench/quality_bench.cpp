// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the tables of the Refinement section of docs/performance.md to standard output:
///     quality_bench [--section peers|levels|growth]... [--model NAME] [--limit SECONDS]
/// peers: beside `tetgen -pq1.414`, `gmsh -3 -optimize_netgen` (command-line programs) and Netgen on the same surfaces
/// and, within a tenth, the same number of tetrahedra; `--model`: on the models whose names contain NAME. levels: fast,
/// default and best, surfaces kept and within 0.2 % of a grain's size. growth: to a million tetrahedra, by stage.
/// `--limit`: processor seconds of one run.
#include <tbb/global_control.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

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
      for (const auto& [name, level] :
           {std::pair{"fast", QualityLevel::fast}, std::pair{"default", QualityLevel::standard},
            std::pair{"best", QualityLevel::best}}) {
        RefineOptions options;
        options.quality = level;
        options.size.gradation = 0.5;
        if (tolerance > 0) options.honour = Honour::tolerance, options.tolerance = tolerance;
        const Row r = run_geomesh(model, options,
                                  std::string(name) + (tolerance > 0 ? ", within 0.2 %" : ", surfaces kept"), limit_s);
        print_row(model.name, r);
      }
  }
}

constexpr const char* usage =
    "usage: quality_bench [--section peers|levels|growth]... [--model NAME] [--limit SECONDS]\n"
    "peers: beside tetgen, gmsh and Netgen, with --model on the models whose names contain NAME; levels: fast, "
    "default, best;\n"
    "growth: to a million tetrahedra. --limit: processor seconds of one run. Without --section: all three.\n";

struct Settings {
  std::set<std::string> sections;
  std::string model;
  double limit_s = 0;
};

/// Ends the program where the words are not of `usage`.
Settings parse(int argc, char** argv) {
  const auto refuse = [](const std::string& what) {
    std::fprintf(stderr, "%s\n%s", what.c_str(), usage);
    std::exit(2);
  };
  Settings s;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--help" || name == "-h") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    if (i + 1 == argc) refuse(name + " needs a value");
    const std::string value = argv[i + 1];
    if (name == "--section" && (value == "peers" || value == "levels" || value == "growth"))
      s.sections.insert(value);
    else if (name == "--model")
      s.model = value;
    else if (name == "--limit" && std::atof(value.c_str()) > 0)
      s.limit_s = std::atof(value.c_str());
    else
      refuse("not understood: " + name + " " + value);
  }
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  // One thread: runs are processes that fork from this one, and comparisons are by processor time.
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Settings settings = parse(argc, argv);
  CompareOptions options;
  options.only = settings.model;
  if (settings.limit_s > 0) options.peer_limit_s = options.own_limit_s = settings.limit_s;
  const auto wants = [&](const char* section) {
    return settings.sections.empty() || settings.sections.contains(section);
  };
  if (wants("peers")) compare_peers(options);
  if (wants("levels")) compare_levels(options.own_limit_s);
  if (wants("growth")) measure_growth(settings.limit_s > 0 ? settings.limit_s : 600);
}
