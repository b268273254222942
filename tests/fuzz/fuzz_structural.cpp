// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_structural [--family 0|1|2] [--first SEED] [--count N] [--mode constrained|preserve|conforming] [--seconds S]
//                 [--save DIR] [--verbose]
// Meshes sealed structural models with needles in fans (structural_models.hpp) and judges each mesh exactly. Prints a
// line a model: seed, triangles, needles (%), smallest angle (degrees), least height (m), added points on segments, on
// facets, inside, CPU seconds, verdict. Exit status 1 where anything failed.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "corpus_run.hpp"
#include "structural_models.hpp"

namespace {

using namespace geomesh;
using namespace geomesh::test;
using namespace geomesh::geomodel::testing;

struct Arguments {
  unsigned family = 0, first = 0, count = 20;
  std::string mode = "constrained", save;
  double seconds = 300;
  bool verbose = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    const auto number = [&] { return static_cast<unsigned>(std::strtoul(value().c_str(), nullptr, 10)); };
    if (word == "--family") a.family = std::min(number(), 2u);
    if (word == "--first") a.first = number();
    if (word == "--count") a.count = number();
    if (word == "--mode") a.mode = value();
    if (word == "--seconds") a.seconds = std::strtod(value().c_str(), nullptr);
    if (word == "--save") a.save = value();
    if (word == "--verbose") a.verbose = true;
  }
  return a;
}

/// True where the mesh passes the judge.
bool run(unsigned seed, const Arguments& a) {
  StructuralModel model;
  try {
    model = structural_model(seed, structural_options(seed, a.family));
  } catch (const Error& e) {
    std::printf("%u no model: %s\n", seed, e.what());
    return true;
  }
  const double share = 100.0 * static_cast<double>(model.n_needles) / static_cast<double>(model.plc.n_facets());
  const CorpusRun result = run_and_judge(model.plc,
                                         a.mode == "preserve"     ? preserving_mode()
                                         : a.mode == "conforming" ? conforming_mode()
                                                                  : constrained_mode(),
                                         a.seconds);
  const RecoveryStatistics s = result.mesh ? result.mesh->recovery : RecoveryStatistics{};
  std::printf("%u %zu triangles %.1f%% %.1e deg %.1e m: %zu %zu %zu points %zu given up %.2f s %s\n", seed,
              model.plc.n_facets(), share, model.smallest_angle, model.least_height, s.steiner_on_segments,
              s.steiner_on_facets, s.steiner_inside, s.facets_not_recovered.size(), result.cpu_seconds,
              result.ok() ? "ok" : result.trouble.c_str());
  std::fflush(stdout);
  if (!result.ok() && !a.save.empty())
    write_poly(model.plc, a.save + "/structural_" + std::to_string(a.family) + "_" + std::to_string(seed) + ".poly");
  return result.ok();
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  unsigned n_failed = 0;
  for (unsigned seed = a.first; seed < a.first + a.count; ++seed) n_failed += !run(seed, a);
  std::printf("%u of %u failed\n", n_failed, a.count);
  return n_failed == 0 ? 0 : 1;
}
