// SPDX-License-Identifier: GPL-3.0-or-later
#include "recovery_peer.hpp"

#include <tetgen.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "corpus_run.hpp"
#include "recovery_families.hpp"

namespace geomesh::bench {

namespace {

/// A TetGen model; TetGen frees the arrays.
std::unique_ptr<tetgenio> tetgen_model(const PiecewiseLinearComplex& plc) {
  auto in = std::make_unique<tetgenio>();
  in->firstnumber = 0;
  in->numberofpoints = static_cast<int>(plc.points.size());
  in->pointlist = new REAL[3 * plc.points.size()];
  for (std::size_t i = 0; i < plc.points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) in->pointlist[3 * i + k] = plc.points[i][k];
  std::vector<std::vector<std::vector<VertexIndex>>> facets(plc.n_facets());
  std::vector<std::vector<Vec3>> holes(plc.n_facets());
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
      const auto loop = plc.loop(l);
      facets[f].emplace_back(loop.begin(), loop.end());
      Vec3 mean;  // the holes of the inputs are convex: it lies inside
      for (VertexIndex v : loop) mean = mean + (1.0 / static_cast<double>(loop.size())) * plc.points[v];
      if (l > plc.facet_loops[f]) holes[f].push_back(mean);
    }
  for (const auto& s : plc.facet_segments) facets[s.facet].push_back({s.a, s.b});
  for (const auto& s : plc.segments) {
    facets.push_back({{s.a, s.b}});
    holes.emplace_back();
  }
  in->numberoffacets = static_cast<int>(facets.size());
  in->facetlist = new tetgenio::facet[facets.size()];
  for (std::size_t f = 0; f < facets.size(); ++f) {
    tetgenio::facet& facet = in->facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = static_cast<int>(facets[f].size());
    facet.polygonlist = new tetgenio::polygon[facets[f].size()];
    for (std::size_t p = 0; p < facets[f].size(); ++p) {
      tetgenio::polygon& polygon = facet.polygonlist[p];
      polygon.numberofvertices = static_cast<int>(facets[f][p].size());
      polygon.vertexlist = new int[facets[f][p].size()];
      for (std::size_t k = 0; k < facets[f][p].size(); ++k) polygon.vertexlist[k] = static_cast<int>(facets[f][p][k]);
    }
    facet.numberofholes = static_cast<int>(holes[f].size());
    facet.holelist = holes[f].empty() ? nullptr : new REAL[3 * holes[f].size()];
    for (std::size_t h = 0; h < holes[f].size(); ++h)
      for (std::size_t k = 0; k < 3; ++k) facet.holelist[3 * h + k] = holes[f][h][k];
  }
  in->numberofholes = static_cast<int>(plc.hole_seeds.size());
  if (!plc.hole_seeds.empty()) in->holelist = new REAL[3 * plc.hole_seeds.size()];
  for (std::size_t h = 0; h < plc.hole_seeds.size(); ++h)
    for (std::size_t k = 0; k < 3; ++k) in->holelist[3 * h + k] = plc.hole_seeds[h].point[k];
  return in;
}

/// TetGen's codes of its own failures (terminatetetgen).
const char* tetgen_failure(int code) {
  switch (code) {
    case 1:
      return "out of memory";
    case 2:
      return "internal error";
    case 3:
      return "refuses: facets or segments cross";
    case 4:
      return "refuses: a very small feature";
    case 5:
      return "refuses: two very close facets";
    default:
      return "refuses the input";
  }
}

}  // namespace

Measurement measure_ours(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                         unsigned limit_seconds) {
  RunContext one_core;
  one_core.threads = 1;
  const Job mesh = [&] {
    alarm(limit_seconds);
    Answer answer;
    double began = 0;
    RunContext timed = one_core;
    timed.stage = [&](std::string_view stage, bool begins) {
      const std::size_t row = stage == "delaunay" ? 0 : stage == "recover" ? 1 : 2;
      answer.stage_cpu_s[row] += begins ? 0 : test::thread_cpu_seconds() - began;
      began = test::thread_cpu_seconds();
    };
    const ConstrainedTetrahedralization out = tetrahedralize(plc, options, timed);
    answer.tetrahedra = out.tetrahedra.size();
    for (VertexIndex row : out.input_vertex) answer.added_points += row == no_vertex;
    answer.volume = test::volume_of(out);
    return answer;
  };
  const Job judge = [&] {
    alarm(4 * limit_seconds);
    const test::CorpusRun run = test::run_and_judge(plc, options, limit_seconds);
    if (!run.ok()) throw std::runtime_error(run.trouble);
    return Answer{};
  };
  Measurement m = measure({mesh})[0];
  if (!m.ok) return m;
  const Measurement verdict = measure({judge})[0];
  m.ok = verdict.ok;
  m.message = verdict.message;
  return m;
}

Measurement measure_tetgen(const PiecewiseLinearComplex& plc, const std::string& switches, unsigned limit_seconds) {
  const std::unique_ptr<tetgenio> in = tetgen_model(plc);
  std::string words = switches;
  const Job mesh = [&] {
    alarm(limit_seconds);
    tetgenio out;
    try {
      tetrahedralize(words.data(), in.get(), &out);
    } catch (int code) {
      throw std::runtime_error(tetgen_failure(code));
    }
    Answer answer;
    answer.tetrahedra = static_cast<std::size_t>(out.numberoftetrahedra);
    const auto n_points = static_cast<std::size_t>(out.numberofpoints);
    answer.added_points = n_points > plc.points.size() ? n_points - plc.points.size() : 0;
    return answer;
  };
  return measure({mesh})[0];
}

std::size_t n_triangles(const PiecewiseLinearComplex& plc) {
  std::size_t n = 0;
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
      n += l == plc.facet_loops[f] ? plc.loop(l).size() - 2 : plc.loop(l).size() + 2;
  return n;
}

}  // namespace geomesh::bench
