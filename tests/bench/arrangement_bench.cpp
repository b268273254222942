// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The arrangement beside CGAL's corefine and experimental::autorefine on the same triangles.
///
///     arrangement_bench [--all] [--alone] [--repeats N] [--limit SECONDS] [--threads N] [--grid CELLS]... [FOLDER...]
///
/// The .ts files of each folder together, then two crossing grids of 20,000 and 200,000 triangles each (--all: also
/// 400,000 and 1,000,000; --grid: of CELLS x CELLS cells instead). --alone: without the peers. The best of N runs in
/// seconds of processor time (all threads) and on the clock; CGAL without the time to build its mesh. Every run is in a
/// process of its own, which is stopped after the limit. Between more than two surfaces corefine goes from pair to
/// pair. Every soup of ours is validated. Prints a Markdown table.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>

#include "../geomodel/support/arrangement_inputs.hpp"

namespace {

using namespace geomesh;
using namespace geomesh::geomodel;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace Processing = CGAL::Polygon_mesh_processing;

struct Options {
  bool alone = false;
  int repeats = 3;
  unsigned limit = 60, threads = 0;
  std::vector<unsigned> grids{100, 316};
  std::vector<std::string> folders;
};

Options parse(int n, char** arguments) {
  Options options;
  std::vector<unsigned> grids;
  for (int k = 1; k < n; ++k) {
    const std::string word = arguments[k];
    const auto value = [&] { return static_cast<unsigned>(std::stoul(k + 1 < n ? arguments[++k] : "0")); };
    if (word == "--all")
      options.grids = {100, 316, 447, 707};
    else if (word == "--alone")
      options.alone = true;
    else if (word == "--repeats")
      options.repeats = static_cast<int>(value());
    else if (word == "--limit")
      options.limit = value();
    else if (word == "--threads")
      options.threads = value();
    else if (word == "--grid")
      grids.push_back(value());
    else
      options.folders.push_back(word);
  }
  if (!grids.empty()) options.grids = grids;
  return options;
}

/// What a run tells through its pipe.
struct Outcome {
  bool done = false, sound = true;
  double wall = 1e300, cpu = 1e300;
  std::size_t facets = 0, crossings = 0, peak_bytes = 0;
};

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
}

void time_once(Outcome& best, const std::function<void()>& run) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  run();
  best.cpu = std::min(best.cpu, double(std::clock() - cpu) / CLOCKS_PER_SEC);
  best.wall = std::min(best.wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
}

/// Runs the job in a child process, so that a peer that crashes or never ends is an outcome.
Outcome in_a_child(unsigned limit, const std::function<void(Outcome&)>& job) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot open a pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    alarm(limit);
    Outcome outcome;
    try {
      job(outcome);
      outcome.done = true;
    } catch (const std::exception&) {
      outcome.done = false;
    }
    _exit(write(ends[1], &outcome, sizeof outcome) == static_cast<ssize_t>(sizeof outcome) ? 0 : 1);
  }
  close(ends[1]);
  Outcome outcome;
  if (read(ends[0], &outcome, sizeof outcome) != static_cast<ssize_t>(sizeof outcome)) outcome.done = false;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return outcome;
}

/// Surfaces that are no manifold are cut where they are not, as CGAL's meshes ask for.
Mesh to_mesh(const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  for (const TriangulatedSurface& s : surfaces) {
    const std::size_t first = points.size();
    for (const Vec3& p : s.points) points.emplace_back(p.x, p.y, p.z);
    for (const auto& [a, b, c] : s.triangles) faces.push_back({first + a, first + b, first + c});
  }
  Processing::orient_polygon_soup(points, faces);
  Mesh mesh;
  Processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return mesh;
}

void run_arrange(const std::vector<TriangulatedSurface>& surfaces, const Options& options, Outcome& outcome) {
  RunContext context;
  context.threads = options.threads;
  ArrangementResult result;
  const std::size_t before = peak_bytes();
  for (int k = 0; k < options.repeats; ++k) {
    time_once(outcome, [&] { result = arrange(surfaces, {}, {}, {}, context); });
    if (k == 0) outcome.peak_bytes = peak_bytes() - before;
  }
  outcome.facets = result.soup.facets.size();
  outcome.crossings = result.n_crossing_pairs;
  outcome.sound = validate_soup(result.soup).empty();
}

void run_corefine(const std::vector<TriangulatedSurface>& surfaces, int repeats, Outcome& outcome) {
  for (int k = 0; k < repeats; ++k) {
    std::vector<Mesh> meshes;
    for (const TriangulatedSurface& s : surfaces) meshes.push_back(to_mesh({s}));
    time_once(outcome, [&] {
      for (std::size_t a = 0; a < meshes.size(); ++a)
        for (std::size_t b = a + 1; b < meshes.size(); ++b)
          Processing::corefine(meshes[a], meshes[b], CGAL::parameters::throw_on_self_intersection(false));
    });
  }
}

void run_autorefine(const std::vector<TriangulatedSurface>& surfaces, int repeats, Outcome& outcome) {
  for (int k = 0; k < repeats; ++k) {
    Mesh mesh = to_mesh(surfaces);
    time_once(outcome, [&] { Processing::experimental::autorefine(mesh); });
  }
}

std::string cell(const Outcome& o, unsigned limit) {
  if (!o.done) return "refuses or exceeds " + std::to_string(limit) + " s";
  char text[80];
  std::snprintf(text, sizeof text, "%.3f (%.3f)", o.cpu, o.wall);
  return text;
}

void compare(const std::string& name, const std::vector<TriangulatedSurface>& surfaces, const Options& options) {
  std::size_t n = 0;
  for (const auto& s : surfaces) n += s.triangles.size();
  const Outcome ours = in_a_child(options.limit, [&](Outcome& o) { run_arrange(surfaces, options, o); });
  std::printf("| %s | %zu | %zu | %zu | %s%s | %.0f |", name.c_str(), n, ours.facets, ours.crossings,
              cell(ours, options.limit).c_str(), ours.sound ? "" : " **faulty**",
              static_cast<double>(ours.peak_bytes) / static_cast<double>(n + ours.facets));
  if (!options.alone) {
    const Outcome corefine = in_a_child(options.limit, [&](Outcome& o) { run_corefine(surfaces, options.repeats, o); });
    std::printf(" %s |", cell(corefine, options.limit).c_str());
    std::fflush(stdout);
    const Outcome autorefine =
        in_a_child(options.limit, [&](Outcome& o) { run_autorefine(surfaces, options.repeats, o); });
    const double fastest = std::min(corefine.done ? corefine.cpu : 1e300, autorefine.done ? autorefine.cpu : 1e300);
    std::printf(" %s | %.2f |", cell(autorefine, options.limit).c_str(), fastest < 1e300 ? ours.cpu / fastest : 0.0);
  }
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<TriangulatedSurface> crossing_grids(unsigned cells) {
  return {testing::grid_surface("level", SurfaceKind::surface, cells, 0, 1000, 0, 1000,
                                [](double x, double y) { return 10 * std::sin(x * 0.01) * std::cos(y * 0.013); }),
          testing::grid_surface("ramp", SurfaceKind::surface, cells, 0.123, 1000.123, 0.0517, 1000.0517,
                                [](double x, double y) { return 0.3 * (x - 500) + 7 * std::sin(y * 0.02); })};
}

std::vector<TriangulatedSurface> load_folder(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".ts") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<TriangulatedSurface> surfaces;
  for (const auto& file : files) surfaces.push_back(testing::load_ts(file));
  return surfaces;
}

}  // namespace

int main(int n, char** arguments) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_warning_behaviour(CGAL::CONTINUE);
  const Options options = parse(n, arguments);
  std::printf("| input | triangles | facets | crossing pairs | arrange | bytes |%s\n|---|---|---|---|---|---|%s\n",
              options.alone ? "" : " corefine | autorefine | arrange / fastest peer |",
              options.alone ? "" : "---|---|---|");
  for (const std::string& folder : options.folders)
    compare(std::filesystem::path(folder).filename().string(), load_folder(folder), options);
  for (const unsigned cells : options.grids)
    compare("two grids of " + std::to_string(2 * cells * cells), crossing_grids(cells), options);
}
