// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_structural [--family 0|1|2] [--first SEED] [--count N] [--mode constrained|preserve|conforming] [--seconds S]
//                 [--save DIR] [--verbose] [--minimise]
// Meshes sealed structural models with needles in fans (structural_models.hpp) and judges each mesh exactly. Prints a
// line a model: seed, triangles, needles (%), smallest angle (degrees), least height (m), added points on segments, on
// facets, inside, and all of them in % of the input's vertices, attempts that ended, CPU seconds, verdict. Then a line
// for all: the largest share of added points, the median and the largest time a triangle. --verbose: what each attempt
// came to, with CPU seconds. --minimise: writes to DIR as few facets of the model, in a box, as still need another
// attempt than the first. Exit status 1 where anything failed.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "minimise.hpp"
#include "structural_models.hpp"

namespace {

using namespace geomesh;
using namespace geomesh::test;
using namespace geomesh::geomodel::testing;

struct Arguments {
  unsigned family = 0, first = 0, count = 20;
  std::string mode = "constrained", save;
  double seconds = 300;
  bool verbose = false, minimise = false;
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
    if (word == "--minimise") a.minimise = true;
  }
  return a;
}

struct Outcome {
  bool ok = true;
  double added_percent = 0;             ///< of the input's vertices
  double microseconds_a_triangle = -1;  ///< negative where there is no model
};

/// Counts attempts that ended, and with `verbose` prints what happens when.
RunContext watch_of(unsigned& n_ended, bool verbose) {
  RunContext watch;
  const double start = thread_cpu_seconds();
  watch.log = [&n_ended, verbose, start](LogLevel, std::string_view text) {
    n_ended += text.substr(0, 8) == "attempt ";
    if (verbose)
      std::printf("  %.3f s %.*s\n", thread_cpu_seconds() - start, static_cast<int>(text.size()), text.data());
  };
  if (verbose)
    watch.stage = [start](std::string_view name, bool begins) {
      std::printf("  %.3f s %.*s %s\n", thread_cpu_seconds() - start, static_cast<int>(name.size()), name.data(),
                  begins ? "begins" : "ends");
    };
  return watch;
}

TetrahedralizeOptions mode_of(const Arguments& a) {
  if (a.mode == "preserve") return preserving_mode();
  return a.mode == "conforming" ? conforming_mode() : constrained_mode();
}

/// With the sides of a box about all, so that something is enclosed whatever is left of the model.
PiecewiseLinearComplex in_box(PiecewiseLinearComplex plc) {
  Box3 box;
  for (const Vec3& p : plc.points) box.add(p);
  const auto first = static_cast<VertexIndex>(plc.points.size());
  constexpr double margin = 1000;  // m
  for (unsigned corner = 0; corner < 8; ++corner)
    plc.points.push_back({corner & 1u ? box.max.x + margin : box.min.x - margin,
                          corner & 2u ? box.max.y + margin : box.min.y - margin,
                          corner & 4u ? box.max.z + margin : box.min.z - margin});
  const std::array<std::array<VertexIndex, 4>, 6> sides{
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  for (const auto& [a, b, c, d] : sides) {
    plc.add_triangle({first + a, first + b, first + c});
    plc.add_triangle({first + a, first + c, first + d});
  }
  return plc;
}

void minimise(const PiecewiseLinearComplex& plc, const Arguments& a, const std::string& path) {
  const auto needs_more_attempts = [&](const PiecewiseLinearComplex& smaller) {
    unsigned n_ended = 0;
    const CorpusRun result = run_and_judge(in_box(smaller), mode_of(a), a.seconds, watch_of(n_ended, false));
    return result.ok() && n_ended > 0;
  };
  const PiecewiseLinearComplex small = minimised_while(plc, needs_more_attempts);
  write_poly(in_box(small), path);
  std::printf("%zu facets left: %s\n", small.n_facets(), path.c_str());
}

Outcome run(unsigned seed, const Arguments& a) {
  StructuralModel model;
  try {
    model = structural_model(seed, structural_options(seed, a.family));
  } catch (const Error& e) {
    std::printf("%u no model: %s\n", seed, e.what());
    return {};
  }
  const auto n_triangles = static_cast<double>(model.plc.n_facets());
  unsigned n_ended = 0;
  const CorpusRun result = run_and_judge(model.plc, mode_of(a), a.seconds, watch_of(n_ended, a.verbose));
  const RecoveryStatistics s = result.mesh ? result.mesh->recovery : RecoveryStatistics{};
  const std::size_t n_added = s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside;
  const Outcome out{result.ok(), 100.0 * static_cast<double>(n_added) / static_cast<double>(model.plc.points.size()),
                    1e6 * result.cpu_seconds / n_triangles};
  std::printf("%u %zu triangles %.1f%% %.1e deg %.1e m: %zu %zu %zu points %.3f%% %zu given up %u ended %.2f s %s\n",
              seed, model.plc.n_facets(), 100.0 * static_cast<double>(model.n_needles) / n_triangles,
              model.smallest_angle, model.least_height, s.steiner_on_segments, s.steiner_on_facets, s.steiner_inside,
              out.added_percent, s.facets_not_recovered.size(), n_ended, result.cpu_seconds,
              result.ok() ? "ok" : result.trouble.c_str());
  std::fflush(stdout);
  const std::string path = a.save + "/structural_" + std::to_string(a.family) + "_" + std::to_string(seed) + ".poly";
  if (a.minimise && n_ended > 0)
    minimise(model.plc, a, path);
  else if (!result.ok() && !a.save.empty())
    write_poly(model.plc, path);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  unsigned n_failed = 0;
  double most_added = 0;
  std::vector<double> times;
  for (unsigned seed = a.first; seed < a.first + a.count; ++seed) {
    const Outcome outcome = run(seed, a);
    n_failed += !outcome.ok;
    most_added = std::max(most_added, outcome.added_percent);
    if (outcome.microseconds_a_triangle >= 0) times.push_back(outcome.microseconds_a_triangle);
  }
  std::sort(times.begin(), times.end());
  if (!times.empty())
    std::printf("added points: at most %.3f%%; microseconds a triangle: median %.1f, largest %.1f\n", most_added,
                times[times.size() / 2], times.back());
  std::printf("%u of %u failed\n", n_failed, a.count);
  return n_failed == 0 ? 0 : 1;
}
