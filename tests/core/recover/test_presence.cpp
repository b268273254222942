// SPDX-License-Identifier: GPL-3.0-or-later
// What recovery remembers of where constraints are, and what it takes back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "corpus_models.hpp"
#include "recover/model/declare.hpp"
#include "recover/model/presence.hpp"
#include "recover/operations/edge_removal.hpp"
#include "recover/start/start_triangulation.hpp"
#include "tetrahedralize/canonical_form.hpp"

using namespace geomesh;
using recover::ConstrainedMesh;

namespace {

/// A corpus model, triangulated and not yet recovered.
struct Start {
  CanonicalForm form;
  recover::DeclaredModel model;
  ConstrainedMesh mesh;

  explicit Start(const char* name)
      : form(canonical_form(test::corpus_model(name).make())),
        model(recover::declare_constraints(form.plc, form.names, {})),
        mesh(triangulated(form, model)) {}

  static ConstrainedMesh triangulated(const CanonicalForm& form, recover::DeclaredModel& model) {
    recover::StartTriangulation start =
        recover::triangulate_start(form.plc, form.names, model, {}, {}, recover::StartFrame::may_be_stretched);
    return ConstrainedMesh(std::move(start.mesh), std::move(start.points), model.input_vertex.size());
  }

  /// Memories that are right, wrong, of other cells and of none.
  void confuse(std::mt19937& random) {
    const CellIndex n = mesh.cells().n_slots();
    for (recover::Subsegment& s : model.constraints.subsegments)
      if (random() % 4 != 0) s.seen_in = random() % 3 == 0 ? no_cell : static_cast<CellIndex>(random() % (n + 5));
    for (recover::Subfacet& f : model.constraints.subfacets)
      if (random() % 4 != 0) f.seen_in = random() % 3 == 0 ? no_cell : static_cast<CellIndex>(random() % (n + 5));
  }

  /// Each cell by its vertices from the least on, with the locked ones among the vertices opposite its faces; sorted.
  std::vector<std::pair<Tetrahedron, std::vector<VertexIndex>>> snapshot() const {
    std::vector<std::pair<Tetrahedron, std::vector<VertexIndex>>> out;
    for (CellIndex c = 0; c < mesh.cells().n_slots(); ++c) {
      if (!mesh.cells().is_live(c)) continue;
      out.push_back({mesh.cells().vertices(c), {}});
      for (unsigned i = 0; i < 4; ++i)
        if (mesh.is_locked(FaceRef(c, i))) out.back().second.push_back(mesh.cells().vertex(c, i));
      std::sort(out.back().first.begin(), out.back().first.end());
      std::sort(out.back().second.begin(), out.back().second.end());
    }
    std::sort(out.begin(), out.end());
    return out;
  }
};

}  // namespace

TEST_CASE("what is remembered of a constraint changes no answer", "[recover]") {
  std::mt19937 random(5);
  unsigned n_present = 0, n_missing = 0;
  for (const char* name : {"chazelle_4", "pinching_layers", "dodecahedron_icosahedron", "high_degree_vertex"}) {
    Start start(name);
    recover::EdgeRemover remover(start.mesh, start.model.constraints);
    for (unsigned round = 0; round < 4; ++round) {
      start.confuse(random);
      for (Index s = 0; s < start.model.constraints.subsegments.size(); ++s) {
        const auto& [a, b] =
            std::pair{start.model.constraints.subsegments[s].a, start.model.constraints.subsegments[s].b};
        const CellIndex cell = recover::cell_of_subsegment(start.mesh, start.model.constraints, s);
        REQUIRE((cell != no_cell) == (start.mesh.find_edge(a, b) != no_cell));
        (cell != no_cell ? n_present : n_missing) += 1;
        if (cell != no_cell)
          REQUIRE((start.mesh.cells().is_live(cell) && start.mesh.cells().has_vertex(cell, a) &&
                   start.mesh.cells().has_vertex(cell, b)));
      }
      for (Index f = 0; f < start.model.constraints.subfacets.size(); ++f) {
        if (start.model.constraints.is_piece(f)) continue;
        const Triangle t = start.model.constraints.subfacets[f].vertices;
        REQUIRE(recover::face_of_subfacet(start.mesh, start.model.constraints, f) ==
                start.mesh.find_face(t[0], t[1], t[2]));
      }
      for (unsigned flip = 0; flip < 50; ++flip) {  // so that memories grow old
        const CellIndex c = static_cast<CellIndex>(random() % start.mesh.cells().n_slots());
        if (start.mesh.cells().is_live(c) && !start.mesh.cells().is_ghost(c))
          remover.remove(start.mesh.cells().vertex(c, 0), start.mesh.cells().vertex(c, 1), 1, nullptr, 40);
      }
    }
  }
  CHECK(n_present > 1000);
  CHECK(n_missing > 100);
}

TEST_CASE("replacements that are taken back leave cells and locks as they were", "[recover]") {
  std::mt19937 random(9);
  Start start("pinching_layers");
  ConstrainedMesh& mesh = start.mesh;
  for (Index f = 0; f < start.model.constraints.subfacets.size(); ++f) {
    if (start.model.constraints.is_piece(f)) continue;
    if (const FaceRef face = recover::face_of_subfacet(mesh, start.model.constraints, f); face.valid()) mesh.lock(face);
  }
  recover::EdgeRemover remover(mesh, start.model.constraints);
  unsigned n_changed = 0;
  for (unsigned round = 0; round < 40; ++round) {
    const auto before = start.snapshot();
    const std::size_t outer = mesh.mark();
    std::size_t inner = outer;
    for (unsigned flip = 0; flip < 30; ++flip) {
      if (flip == 15) inner = mesh.mark();
      const CellIndex c = static_cast<CellIndex>(random() % mesh.cells().n_slots());
      if (mesh.cells().is_live(c) && !mesh.cells().is_ghost(c))
        remover.remove(mesh.cells().vertex(c, 0), mesh.cells().vertex(c, 3), 2, nullptr, 60);
    }
    n_changed += start.snapshot() != before;
    mesh.roll_back(inner);
    if (round % 2 == 0) {
      mesh.roll_back(outer);
      REQUIRE(start.snapshot() == before);
    } else {
      mesh.keep();
    }
  }
  CHECK(n_changed > 20);
}

TEST_CASE("flips stop where the work of their segment or facet is used up, and count all that they try", "[recover]") {
  Start start("chazelle_4");
  std::size_t work_left = 0;
  recover::EdgeRemover remover(start.mesh, start.model.constraints, &work_left);
  const auto snapshot_after = [&](std::size_t work) {
    work_left = work;
    for (CellIndex c = 0, n = start.mesh.cells().n_slots(); c < n; ++c) {
      if (!start.mesh.cells().is_live(c) || start.mesh.cells().is_ghost(c)) continue;
      if (remover.flip_face(FaceRef(c, 0))) continue;
      remover.remove(start.mesh.cells().vertex(c, 0), start.mesh.cells().vertex(c, 1), 1, nullptr, 10);
    }
    return start.snapshot();
  };
  const auto given = start.snapshot();
  CHECK((snapshot_after(0) == given && work_left == 0));
  const auto some = snapshot_after(200);
  CHECK((some != given && work_left == 0));
  CHECK(snapshot_after(0) == some);
  CHECK((snapshot_after(1000000) != some && work_left > 0 && work_left < 1000000 - 200));
}
