// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include "delaunay_inputs.hpp"
#include "delaunay_peers.hpp"
using namespace geomesh; using namespace geomesh::bench;
int main(int argc, char** argv) {
  std::string input = argc > 1 ? argv[1] : "uniform";
  std::size_t n = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1000000;
  int reps = argc > 3 ? atoi(argv[3]) : 3;
  std::string which = argc > 4 ? argv[4] : "gcft";
  unsigned threads = argc > 5 ? atoi(argv[5]) : 1;
  auto points = make_points(input, n, 42);
  std::map<char, std::vector<Measurement>> all;
  for (int r = 0; r < reps; ++r) for (char w : which) {
    Job job;
    if (w == 'g') job = [&] { return run_geomesh(points, {}, threads); };
    if (w == 'c') job = [&] { return run_cgal_compact(points); };
    if (w == 'f') job = [&] { return run_cgal_fast_location(points); };
    if (w == 't') job = [&] { return run_tetgen(points); };
    if (w == 'p') job = [&] { return run_cgal_parallel(points, threads); };
    all[w].push_back(measure({job})[0]);
  }
  for (char w : which) {
    auto& m = all[w];
    std::sort(m.begin(), m.end(), [](auto& a, auto& b) { return a.cpu_s < b.cpu_s; });
    auto& k = m[m.size() / 2];
    printf("%s %zu %c: cpu %.3f (min %.3f) wall %.3f  %.3f Mtet/s  %.1f B/tet exact %zu walk/pt %.2f %s\n", input.c_str(), points.size(), w, k.cpu_s, m[0].cpu_s, k.wall_s, 1e-6 * k.answer.tetrahedra / k.cpu_s, double(k.peak_bytes) / k.answer.tetrahedra, k.answer.exact_calls, double(k.answer.walk_steps)/points.size(), k.message.c_str());
  }
}
