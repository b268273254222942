// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the tables of the Delaunay section of docs/performance.md to standard output; `--help` lists the
/// options.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "delaunay_inputs.hpp"
#include "delaunay_peers.hpp"
#include "delaunay_verify.hpp"

using namespace geomesh;
using namespace geomesh::bench;

namespace {

constexpr unsigned seed = 42;

constexpr const char* usage =
    "delaunay_bench [options]: the Delaunay stage beside CGAL and TetGen, each run in a process of its own\n"
    "  --section NAME           ratios, small, degenerate, growth, threads, clusters or verify; may be repeated "
    "(default: all)\n"
    "  --peer NAME              only triangulators whose names begin so: geomesh, CGAL, TetGen; may be repeated\n"
    "  --size N                 points of an input (1000000)\n"
    "  --largest N              largest input of growth (10000000)\n"
    "  --repetitions N          runs of each, of which the median counts (5)\n"
    "  --tetgen-repetitions N   the same for TetGen, which is slow (1)\n";

struct Settings {
  int repetitions = 5, tetgen_repetitions = 1;
  std::size_t size = 1000000, largest = 10000000;
  std::set<std::string> sections, peers;
  /// Whether a triangulator runs in repetition r: geomesh, CGAL, or TetGen, which is slow.
  bool runs(const std::string& name, int r) const {
    if (!peers.empty() &&
        std::none_of(peers.begin(), peers.end(), [&](const std::string& p) { return name.starts_with(p); }))
      return false;
    return name != "TetGen" || r < tetgen_repetitions;
  }
  bool wants(const char* section) const { return sections.empty() || sections.contains(section); }
};

Measurement median(std::vector<Measurement> runs, double Measurement::*key) {
  std::sort(runs.begin(), runs.end(), [key](const Measurement& a, const Measurement& b) { return a.*key < b.*key; });
  return runs[runs.size() / 2];
}

double bytes_a_tetrahedron(const Measurement& m) {
  return m.answer.tetrahedra == 0 ? 0 : static_cast<double>(m.peak_bytes) / static_cast<double>(m.answer.tetrahedra);
}

void compare_peers(const std::vector<std::string>& inputs, std::size_t n, const Settings& settings) {
  std::printf(
      "| input | points | triangulator | CPU s | million tetrahedra a CPU second | times geomesh | bytes a tetrahedron "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (const std::string& input : inputs) {
    const std::vector<Vec3> points = make_points(input, n, seed);
    const std::vector<std::pair<const char*, Job>> peers{
        {"geomesh", [&] { return run_geomesh(points, {}, 1); }},
        {"CGAL, compact location", [&] { return run_cgal_compact(points); }},
        {"CGAL, fast location", [&] { return run_cgal_fast_location(points); }},
        {"TetGen", [&] { return run_tetgen(points); }}};
    std::map<std::string, std::vector<Measurement>> runs;
    for (int r = 0; r < settings.repetitions; ++r)
      for (const auto& [name, job] : peers)
        if (settings.runs(name, r)) runs[name].push_back(measure({job})[0]);
    const double ours = runs["geomesh"].empty() ? 0 : median(runs["geomesh"], &Measurement::cpu_s).cpu_s;
    for (const auto& [name, job] : peers) {
      if (runs[name].empty()) continue;
      const Measurement m = median(runs[name], &Measurement::cpu_s);
      if (m.ok)
        std::printf("| %s | %zu | %s | %.2f | %.2f | %.2f | %.1f |\n", input.c_str(), points.size(), name, m.cpu_s,
                    1e-6 * static_cast<double>(m.answer.tetrahedra) / m.cpu_s, m.cpu_s / ours, bytes_a_tetrahedron(m));
      else
        std::printf("| %s | %zu | %s | | | | %s |\n", input.c_str(), points.size(), name, m.message.c_str());
      std::fflush(stdout);
    }
  }
}

void growth(const Settings& settings) {
  std::printf("| uniform points | CPU s | bytes a tetrahedron | walk steps a point |\n|---|---|---|---|\n");
  for (std::size_t n = 100000; n <= settings.largest; n *= 10) {
    const std::vector<Vec3> points = make_points("uniform", n, seed);
    std::vector<Measurement> runs;
    for (int r = 0; r < settings.repetitions; ++r)
      runs.push_back(measure({[&] { return run_geomesh(points, {}, 1); }})[0]);
    const Measurement m = median(runs, &Measurement::cpu_s);
    std::printf("| %zu | %.3f | %.1f | %.2f |\n", n, m.cpu_s, bytes_a_tetrahedron(m),
                static_cast<double>(m.answer.walk_steps) / static_cast<double>(n));
    std::fflush(stdout);
  }
}

/// Two threads against two runs of one thread side by side, by wall time.
void threads(const Settings& settings) {
  const std::vector<Vec3> points = make_points("uniform", settings.size, seed);
  const Job one = [&] { return run_geomesh(points, {}, 1); };
  std::vector<Measurement> alone, beside, two, cgal_one, cgal_two;
  for (int r = 0; r < settings.repetitions; ++r) {
    alone.push_back(measure({one})[0]);
    const auto pair = measure({one, one});
    beside.push_back(pair[0].wall_s > pair[1].wall_s ? pair[0] : pair[1]);
    two.push_back(measure({[&] { return run_geomesh(points, {}, 2); }})[0]);
    cgal_one.push_back(measure({[&] { return run_cgal_parallel(points, 1); }})[0]);
    cgal_two.push_back(measure({[&] { return run_cgal_parallel(points, 2); }})[0]);
  }
  const double t1 = median(alone, &Measurement::wall_s).wall_s, tb = median(beside, &Measurement::wall_s).wall_s,
               t2 = median(two, &Measurement::wall_s).wall_s;
  std::printf("| run | wall s | speed-up |\n|---|---|---|\n");
  std::printf(
      "| one thread | %.2f | 1 |\n| two runs of one thread side by side | %.2f | %.2f |\n| two threads | %.2f | %.2f "
      "|\n",
      t1, tb, 2 * t1 / tb, t2, t1 / t2);
  const double c1 = median(cgal_one, &Measurement::wall_s).wall_s, c2 = median(cgal_two, &Measurement::wall_s).wall_s;
  std::printf("| CGAL with TBB, one thread | %.2f | 1 |\n| CGAL with TBB, two threads | %.2f | %.2f |\n", c1, c2,
              c1 / c2);
  std::printf("\nTwo threads reach %.0f %% of the speed-up of two independent runs.\n",
              100 * (t1 / t2) / (2 * t1 / tb));
}

void clusters(const Settings& settings) {
  const std::vector<Vec3> points = make_points("clusters", settings.size, seed);
  std::printf(
      "| cluster distance | points deferred | CPU s | expansions | walk steps a point |\n|---|---|---|---|---|\n");
  for (const double distance : {0.0, -1.0, 1e-7, 1e-4, 1e-1, 1e2}) {
    std::vector<Measurement> runs;
    DelaunayOptions options;
    options.cluster_distance = distance;
    for (int r = 0; r < settings.repetitions; ++r)
      runs.push_back(measure({[&] { return run_geomesh(points, options, 1); }})[0]);
    const Measurement m = median(runs, &Measurement::cpu_s);
    char label[32];
    std::snprintf(label, sizeof label, "%g", distance);
    std::printf("| %s | %zu | %.2f | %zu | %.2f |\n", distance < 0 ? "auto" : label, m.answer.deferred, m.cpu_s,
                m.answer.exact_calls, static_cast<double>(m.answer.walk_steps) / static_cast<double>(points.size()));
    std::fflush(stdout);
  }
}

/// Returns whether all is right.
bool verify_all(const Settings& settings) {
  bool right = true;
  std::printf(
      "| input | points | tetrahedra | validator's faults | flips | two threads | CGAL "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const char* input : {"uniform", "horizons", "clusters", "grid", "sphere"}) {
    const std::size_t n = input == std::string("sphere") ? settings.size / 10 : settings.size;
    const std::vector<Vec3> points = make_points(input, n, seed);
    const Verification v = verify(points);
    const auto word = [](bool same) { return same ? "same" : "DIFFERENT"; };
    std::printf("| %s | %zu | %zu | %zu | %s | %s | %s |\n", input, points.size(), v.tetrahedra, v.faults,
                word(v.flips_agree), word(v.threads_agree), word(v.cgal_agrees));
    std::fflush(stdout);
    right = right && v.faults == 0 && v.flips_agree && v.threads_agree && v.cgal_agrees;
  }
  return right;
}

Settings parse(int argc, char** argv) {
  Settings s;
  const auto refuse = [](const std::string& what) {
    std::fprintf(stderr, "%s\n%s", what.c_str(), usage);
    std::exit(2);
  };
  for (int i = 1; i < argc; i += 2) {
    const std::string key = argv[i];
    if (key == "--help" || key == "-h") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    if (i + 1 == argc) refuse(key + " needs a value");
    const std::string value = argv[i + 1];
    if (key == "--repetitions")
      s.repetitions = std::stoi(value);
    else if (key == "--tetgen-repetitions")
      s.tetgen_repetitions = std::stoi(value);
    else if (key == "--size")
      s.size = std::stoul(value);
    else if (key == "--largest")
      s.largest = std::stoul(value);
    else if (key == "--peer")
      s.peers.insert(value);
    else if (key == "--section")
      s.sections.insert(value);
    else
      refuse("unknown option " + key);
  }
  return s;
}

void section(const Settings& settings, const char* name, const char* title, const std::function<void()>& body) {
  if (!settings.wants(name)) return;
  std::printf("\n#### %s\n\n", title);
  body();
}

}  // namespace

int main(int argc, char** argv) {
  const Settings settings = parse(argc, argv);
  section(settings, "ratios", "One core", [&] {
    compare_peers({"uniform", "horizons", "clusters", "grid"}, settings.size, settings);
  });
  section(settings, "small", "A tenth of the points",
          [&] { compare_peers({"uniform"}, settings.size / 10, settings); });
  section(settings, "degenerate", "Degenerate inputs", [&] {
    compare_peers({"sphere", "plane", "line"}, settings.size / 10, settings);
  });
  section(settings, "growth", "Growth", [&] { growth(settings); });
  section(settings, "threads", "Threads", [&] { threads(settings); });
  section(settings, "clusters", "Deferred insertion of clustered points", [&] { clusters(settings); });
  bool right = true;
  section(settings, "verify", "The same tetrahedra", [&] { right = verify_all(settings); });
  return right ? 0 : 1;
}
