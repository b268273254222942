// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality_compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "geomesh/core/refine.hpp"
#include "quality_runs.hpp"

namespace geomesh::bench {
namespace {

/// How surfaces are honoured: as the input has them, with points on them (as TetGen does) or hardly any (as gmsh does
/// with discrete surfaces), or within a thousandth of the model's diagonal. The last two are for intersected models,
/// whose seams are full of short edges.
enum class Surfaces { kept, kept_unsized, within_a_thousandth };

/// One number that makes meshes coarser as it grows, from 0 to 1, and what it means for a model.
RefineOptions options_of(const QualityModel& model, Surfaces surfaces, double knob) {
  const double length = model.diagonal();
  RefineOptions options;
  options.facet_parent = model.facet_parent;
  if (surfaces == Surfaces::within_a_thousandth) options.honour = Honour::tolerance, options.tolerance = 0.001 * length;
  if (model.sizes_from_edges) {  // above 0.1 a gradation; below, a global size that shrinks with it
    options.size.gradation = std::max(knob, 0.1);
    if (knob < 0.1) options.size.global = length / 20 * knob / 0.1;
  } else if (surfaces != Surfaces::within_a_thousandth) {
    options.size_surfaces = surfaces == Surfaces::kept;
    options.size.gap_layers = 0;
    options.size.gradation = knob;
  } else {
    options.size.from_input_edges = false;
    options.size.gap_layers = 0;
    options.size.global = length * knob;
    options.size.gradation =
        std::max(options.size.gradation, 3 * knob);  // from the short chords that the tolerance asks for
  }
  return options;
}

constexpr double within_a_tenth = 0.1, close_enough = 0.03;

/// The knob is chosen so that the count is that of the peer, as close as eight runs bring it; those within three
/// hundredths end the search.
Row run_matched(const QualityModel& model, Surfaces surfaces, std::size_t wanted, double limit_s) {
  const std::string label =
      surfaces == Surfaces::within_a_thousandth ? "geomesh, as many, surfaces within 0.1 %" : "geomesh, as many";
  double low = 0.001, high = 0.9;
  if (model.sizes_from_edges) low = 0.02;
  if (!model.sizes_from_edges) low = 0.05;
  if (!model.sizes_from_edges && surfaces != Surfaces::within_a_thousandth) low = 0.1, high = 3;
  Row best;
  double best_off = 1e9;
  for (int trial = 0; trial < 8; ++trial) {
    const double knob = std::sqrt(low * high);
    Row row = run_geomesh(model, options_of(model, surfaces, knob), label, limit_s);
    if (row.tetrahedra == 0) {  // too many to end in time: coarser
      if (best.tetrahedra == 0) best = row;
      low = knob;
      continue;
    }
    const double ratio = static_cast<double>(row.tetrahedra) / static_cast<double>(wanted),
                 off = std::abs(std::log(ratio));
    if (off < best_off) best = row, best_off = off;
    if (std::abs(ratio - 1) < close_enough) return best;
    (ratio > 1 ? low : high) = knob;
  }
  if (best_off >= std::log1p(within_a_tenth)) best.tool += " (count not matched)";
  return best;
}

bool is_better_in_all(const Row& ours, const Row& peer) {
  const ElementShapes &a = ours.shapes, &b = peer.shapes;
  const bool fewer = a.share_below_10 < b.share_below_10 || (a.share_below_10 == 0 && b.share_below_10 == 0);
  return a.least > b.least && a.first_percentile > b.first_percentile && a.mean_of_least > b.mean_of_least && fewer;
}

bool is_matched(const Row& ours, const Row& peer) {
  return std::abs(static_cast<double>(ours.tetrahedra) / static_cast<double>(peer.tetrahedra) - 1) < within_a_tenth;
}

struct Verdict {
  std::string model, tetgen, gmsh, netgen, speed, within;
};

std::string judge_speed(const Row& ours, const Row& peer) {
  if (peer.tetrahedra == 0) return "gives no mesh";
  char text[80];
  std::snprintf(text, sizeof text, "%s (%.2f times its time)", ours.cpu_s <= peer.cpu_s ? "yes" : "no",
                ours.cpu_s / peer.cpu_s);
  return text;
}

std::string judge(const Row& ours, const Row& peer) {
  if (peer.tetrahedra == 0) return "gives no mesh";
  if (!is_matched(ours, peer))
    return is_better_in_all(ours, peer) ? "yes, but the count differs" : "no, and the count differs";
  return is_better_in_all(ours, peer) ? "yes" : "no";
}

std::vector<NamedModel> models() {
  std::vector<NamedModel> m{{"round grains", [] { return grains(0, 1); }},
                            {"irregular grains", [] { return grains(0.25, 1); }}};
#ifdef GEOMESH_BENCH_GEOMODEL
  for (const char* name : {"salt-dome", "faulted-layers"}) m.push_back({name, [name] { return sample(name); }});
  m.push_back({"modelA4", model_a4});
  m.push_back({"modelA4, remeshed surfaces", model_a4_remeshed});
#endif
  for (const char* file : {"sphere1.obj", "cube_minus_sphere.obj", "sphere2.obj", "soccerball.obj", "bunny25k.obj"})
    m.push_back({file, [file] { return solid(file); }});
  return m;
}

}  // namespace

void compare_peers(const CompareOptions& options) {
  print_row_header("tool");
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "geomesh_quality_bench";
  std::filesystem::create_directories(folder);
  const std::string stem = (folder / "model").string();
  std::vector<Verdict> verdicts;
  for (const auto& [name, make] : models()) {
    if (name.find(options.only) == std::string::npos) continue;
    const QualityModel model = make();
    if (model.plc.points.empty()) {
      std::fprintf(stderr, "skipped: %s is absent\n", model.name.c_str());
      continue;
    }
    QualityModel same = model;
    same.plc = model.merged();
    const std::array<Row, 3> peers{run_tetgen(same, stem, options.peer_limit_s),
                                   run_gmsh(same, stem, options.peer_limit_s),
                                   run_netgen(same, stem, options.peer_limit_s)};
    std::array<Row, 3> ours;
    for (std::size_t i = 0; i < peers.size(); ++i) {
      print_row(model.name, peers[i]);
      if (peers[i].tetrahedra == 0) continue;
      const Surfaces surfaces = model.sizes_from_edges || i == 0 ? Surfaces::kept : Surfaces::kept_unsized;
      ours[i] = run_matched(model, surfaces, peers[i].tetrahedra, options.own_limit_s);
      print_row(model.name, ours[i]);
    }
    if (peers[0].tetrahedra + peers[1].tetrahedra + peers[2].tetrahedra == 0) {  // nothing to match
      constexpr double gradation = 1, fiftieth = 0.02;
      print_row(model.name, run_geomesh(model, options_of(model, Surfaces::kept_unsized, gradation), "geomesh",
                                        options.own_limit_s));
      RefineOptions sized;  // of the whole model, and by the edges of its surfaces
      sized.facet_parent = model.facet_parent;
      sized.size.global = options_of(model, Surfaces::within_a_thousandth, fiftieth).size.global;
      print_row(model.name, run_geomesh(model, sized, "geomesh, size of a fiftieth", options.own_limit_s));
      print_row(model.name, run_geomesh(model, options_of(model, Surfaces::within_a_thousandth, fiftieth),
                                        "geomesh, size of a fiftieth, surfaces within 0.1 %", options.own_limit_s));
    }
    std::string within = "–";
    if (!model.sizes_from_edges && peers[1].tetrahedra > 0) {
      const Row free = run_matched(model, Surfaces::within_a_thousandth, peers[1].tetrahedra, options.own_limit_s);
      print_row(model.name, free);
      within = judge(free, peers[1]) + "; speed: " + judge_speed(free, peers[1]);
    }
    verdicts.push_back({model.name, judge(ours[0], peers[0]), judge(ours[1], peers[1]), judge(ours[2], peers[2]),
                        judge_speed(ours[1], peers[1]), within});
  }
  std::printf(
      "\n| model | all four better than tetgen | all four better than gmsh | all four better than netgen | "
      "no slower than gmsh | the same with surfaces within 0.1 %% |\n|---|---|---|---|---|---|\n");
  for (const Verdict& v : verdicts)
    std::printf("| %s | %s | %s | %s | %s | %s |\n", v.model.c_str(), v.tetgen.c_str(), v.gmsh.c_str(),
                v.netgen.c_str(), v.speed.c_str(), v.within.c_str());
  std::filesystem::remove_all(folder);
}

}  // namespace geomesh::bench
