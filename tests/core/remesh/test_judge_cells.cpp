// SPDX-License-Identifier: MIT
// Which bad cells nothing forces, judged in the whole mesh and by what is near to them.
#include <algorithm>
#include <catch2/catch.hpp>

#include "common/epoch_marks.hpp"
#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/driver/judge_cells.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

TEST_CASE("Free cells told by what is near to them are those of the whole mesh", "[refine]") {
  std::size_t n_free = 0, n_forced = 0;
  for (Model& model : std::vector<Model>{two_boxes(3), ball_in_box(4), box_with_well(4)}) {
    disturb_inside(model, 8);
    const Bench bench(std::move(model));
    for (const double size : {0.5, 8.0}) {  // small sizes make no gap thin, large ones most
      RefineResult result;
      SizeField::Limits limits;
      limits.global = size;
      result.asked = SizeField({}, limits);
      result.kept_patch =
          patches_of_facets(bench.model.plc, bench.options, merge_pieces(bench.model.plc, bench.options.facet_parent));
      const FreeCellJudge judge = free_cell_judge(bench.model.plc, bench.model.mesh, bench.options, result);
      const std::vector<CellIndex> free = judge.find(bench.mesh);
      std::vector<CellIndex> bad;
      for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
        if (bench.mesh.is_live(c) && bench.mesh.shape_of(c) < DihedralMeasure::of_angle(8)) bad.push_back(c);
      CAPTURE(size, bad.size(), free.size());
      n_free += free.size();
      n_forced += bad.size() - free.size();
      std::size_t n_different = 0;
      for (const CellIndex c : bad) {
        const bool is_free = std::find(free.begin(), free.end(), c) != free.end();
        n_different += judge.find_among(bench.mesh, std::span(&c, 1)).size() != (is_free ? 1u : 0u);
      }
      CHECK(n_different == 0);
      CHECK(judge.find_among(bench.mesh, bad) == free);
      std::vector<CellIndex> touched;
      const std::uint64_t since = bench.mesh.changed_at(bench.mesh.vertices(bad.front())[0]) / 2;
      for (const CellIndex c : free)
        if (changed_since(bench.mesh, bench.mesh.vertices(c), since)) touched.push_back(c);
      CHECK(judge.find_since(bench.mesh, since) == touched);
    }
  }
  CHECK(n_free > 10);
  CHECK(n_forced > 0);
}

TEST_CASE(
    "A piece of a mesh has the cells about the given ones, and faces, edges and input vertices as the mesh has them",
    "[refine]") {
  const Bench bench(box_with_well(4));
  const ConstrainedTetrahedralization whole = export_domain(bench.mesh, bench.model.mesh);
  const CellIndex given = 3;
  ExportScratch scratch;
  const auto one = export_about(bench.mesh, std::span(&given, 1), 1, bench.model.mesh, scratch);
  std::vector<CellIndex> star, about;
  for (const VertexIndex v : bench.mesh.vertices(given)) {
    bench.mesh.star(v, scratch.marks, star);
    about.insert(about.end(), star.begin(), star.end());
  }
  std::sort(about.begin(), about.end());
  about.erase(std::unique(about.begin(), about.end()), about.end());
  CHECK(one.tetrahedra.size() == about.size());
  for (unsigned i = 0; i < 4; ++i)
    CHECK(one.points[one.tetrahedra[0][i]] == bench.mesh.point(bench.mesh.vertices(given)[i]));
  const auto all = export_about(bench.mesh, std::span(&given, 1), 100, bench.model.mesh, scratch);
  CHECK(all.points.size() == whole.points.size());
  CHECK(all.tetrahedra.size() == whole.tetrahedra.size());
  CHECK(all.faces.size() == whole.faces.size());
  CHECK(all.edges.size() == whole.edges.size());
  for (VertexIndex v = 0; v < all.points.size(); ++v)
    if (all.input_vertex[v] != no_vertex) CHECK(all.points[v] == bench.model.plc.points[all.input_vertex[v]]);
  CHECK(std::count(all.input_vertex.begin(), all.input_vertex.end(), no_vertex) ==
        std::count(whole.input_vertex.begin(), whole.input_vertex.end(), no_vertex));
}
