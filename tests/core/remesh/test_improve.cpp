// SPDX-License-Identifier: MIT
// Every operation over every kind of edge, face, cell and vertex of small models, the validator after each that did
// something.
#include <algorithm>
#include <catch2/catch.hpp>

#include "geomesh/core/quality.hpp"
#include "quality/measure/shape.hpp"
#include "refine_bench.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"
#include "search/closest_point.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

TEST_CASE("The imported mesh is valid and comes back as it was", "[improve]") {
  for (const Model& model : {two_boxes(2), ball_in_box(4), box_with_well(4)}) {
    const DomainMesh mesh = import_domain(model.plc, model.mesh, {});
    CHECK(mesh.validate() == "");
    const ConstrainedTetrahedralization back = export_domain(mesh, model.mesh);
    CHECK(back.points == model.mesh.points);
    CHECK(back.tetrahedra == model.mesh.tetrahedra);
    CHECK(back.component == model.mesh.component);
    CHECK(back.faces.size() == model.mesh.faces.size());
    CHECK(back.edges.size() == model.mesh.edges.size());
  }
}

TEST_CASE("Points that are to stay are corners, others of a smooth surface are not", "[improve]") {
  const Model model = ball_in_box(4);
  RefineOptions options = Bench::make_options(0.05);
  const DomainMesh free = import_domain(model.plc, model.mesh, options);
  std::vector<VertexIndex> chosen;
  for (VertexIndex v = 0; v < model.mesh.points.size() && chosen.size() < 3; ++v)
    if (free.kind(v) == VertexKind::surface && model.mesh.input_vertex[v] != no_vertex) chosen.push_back(v);
  REQUIRE(chosen.size() == 3);
  options.fixed_points = std::vector<VertexIndex>{};
  for (const VertexIndex v : chosen) options.fixed_points->push_back(model.mesh.input_vertex[v]);
  const DomainMesh held = import_domain(model.plc, model.mesh, options);
  for (VertexIndex v = 0; v < model.mesh.points.size(); ++v) {
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), v) != chosen.end();
    CHECK(held.kind(v) == (is_chosen ? VertexKind::corner : free.kind(v)));
  }
}

TEST_CASE("Splitting any edge keeps the mesh valid and its volume", "[improve]") {
  Bench bench(box_with_well(4));
  const double before = bench.volume();
  for (unsigned e = 0; e < 6; ++e)
    CHECK(over_cells(bench, 7, [e](Bench& b, CellIndex c) {
            const Tetrahedron t = b.mesh.vertices(c);
            return split_edge(b.tools, c, t[edge_vertices[e][0]], t[edge_vertices[e][1]]).has_value();
          }) > 0);
  CHECK(bench.volume() == Approx(before));
  CHECK(bench.statistics.points_on_surfaces > 0);
  CHECK(bench.statistics.points_inside > 0);
}

TEST_CASE("Collapsing keeps the mesh valid, corners and the domain", "[improve]") {
  Bench bench(ball_in_box(4));
  over_cells(bench, 5, [](Bench& b, CellIndex c) {
    const Tetrahedron t = b.mesh.vertices(c);
    return split_edge(b.tools, c, t[0], t[1]).has_value();
  });
  std::size_t n_corners = 0;
  for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v) n_corners += bench.mesh.kind(v) == VertexKind::corner;
  const double before = bench.volume();
  for (unsigned e = 0; e < 6; ++e)
    over_cells(bench, 1, [e](Bench& b, CellIndex c) {
      const Tetrahedron t = b.mesh.vertices(c);
      return try_collapse(b.tools, t[edge_vertices[e][0]], t[edge_vertices[e][1]], CollapseRule::coarsen, 1e-3);
    });
  CHECK(bench.statistics.collapses > 0);
  CHECK(bench.volume() == Approx(before));
  for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v) n_corners -= bench.mesh.kind(v) == VertexKind::corner;
  CHECK(n_corners == 0);
}

TEST_CASE("Inner points too near to others go again where no shape falls below a floor", "[improve]") {
  Bench bench(two_boxes(3));
  SizeField::Limits limits;
  limits.global = 0.25;  // one and a half times the grid's spacing, so that its diagonals are not too long
  const SizeField size({}, limits);
  Toolbox tools(bench.mesh, bench.guard, size, bench.statistics);
  const double before = bench.volume();
  const auto worst = [&] {
    double least = 1;
    for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
      if (bench.mesh.is_live(c)) least = std::min(least, bench.mesh.shape_of(c));
    return least;
  };
  const double given = worst();
  const std::size_t n_added = over_cells(bench, 29, [&](Bench& b, CellIndex c) {
    const Tetrahedron& t = b.mesh.vertices(c);
    const Vec3 p = 0.7 * b.mesh.point(t[0]) + 0.1 * (b.mesh.point(t[1]) + b.mesh.point(t[2]) + b.mesh.point(t[3]));
    return insert_inside(tools, p, c, {LocalLength(1e-3), 1e-6}).has_value();
  });
  REQUIRE(n_added > 10);
  const double crowded = worst();
  REQUIRE(crowded < 0.5 * given);
  const std::size_t n_cells = bench.mesh.n_cells(), n_gone = thin_out(tools, ShortEdges::inside, given, 0, {});
  CHECK(n_gone > n_added / 2);
  CHECK(n_gone <= n_added);
  CHECK(bench.mesh.validate() == "");
  CHECK(bench.mesh.n_cells() + 4 * n_gone <= n_cells);
  CHECK(bench.volume() == Approx(before));
  CHECK(worst() >= 0.99 * crowded);
}

TEST_CASE("Insertion inside and on surfaces keeps the mesh valid", "[improve]") {
  Bench bench(two_boxes(1));
  const double before = bench.volume();
  CHECK(over_cells(bench, 3, [](Bench& b, CellIndex c) {
          const Tetrahedron& t = b.mesh.vertices(c);
          const Vec3 p = 0.25 * (b.mesh.point(t[0]) + b.mesh.point(t[1]) + b.mesh.point(t[2]) + b.mesh.point(t[3]));
          return insert_inside(b.tools, p, c, {LocalLength(1e-3), 1e-6}).has_value();
        }) > 5);
  CHECK(over_cells(bench, 3, [](Bench& b, CellIndex c) {
          for (unsigned i = 0; i < 4; ++i) {
            if (!b.mesh.tag(c, i).constrained()) continue;
            const Tetrahedron& t = b.mesh.vertices(c);
            const auto& f = face_vertices[i];
            const Vec3 p = (1.0 / 3) * (b.mesh.point(t[f[0]]) + b.mesh.point(t[f[1]]) + b.mesh.point(t[f[2]]));
            if (insert_on_surface(b.tools, p, FaceRef(c, i), {LocalLength(1e-3), 1e-6})) return true;
          }
          return false;
        }) > 5);
  CHECK(bench.volume() == Approx(before));
  CHECK(bench.statistics.points_on_surfaces > 5);
}

TEST_CASE("Flips, smoothing and improving insertions raise the worst shape about them", "[improve]") {
  for (const double tolerance : {0.0, 0.05}) {
    Model model = ball_in_box(4);
    disturb_inside(model, 11);
    Bench bench(std::move(model), tolerance);
    const auto worst = [&] {
      double w = 1;
      for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
        if (bench.mesh.is_live(c)) w = std::min(w, bench.mesh.shape_of(c));
      return w;
    };
    double before = worst();
    const auto rises = [&](bool done) {
      if (done) {
        const double now = worst();
        CHECK(now >= before);
        before = now;
      }
      return done;
    };
    over_cells(bench, 1, [&](Bench& b, CellIndex c) {
      const Tetrahedron t = b.mesh.vertices(c);
      for (const auto& e : edge_vertices)
        if (rises(remove_edge(b.tools, c, t[e[0]], t[e[1]]))) return true;
      return false;
    });
    over_cells(bench, 1, [&](Bench& b, CellIndex c) { return rises(remove_face(b.tools, c, c % 4)); });
    over_cells(bench, 1,
               [&](Bench& b, CellIndex c) { return rises(smooth_vertex(b.tools, b.mesh.vertices(c)[c % 4], {})); });
    over_cells(bench, 5, [&](Bench& b, CellIndex c) { return rises(insert_to_improve(b.tools, c)); });
    over_cells(bench, 5, [&](Bench& b, CellIndex c) {
      const Tetrahedron t = b.mesh.vertices(c);
      return rises(split_to_improve(b.tools, c, t[0], t[1]));
    });
    CHECK(bench.statistics.edge_removals > 0);
    CHECK(bench.statistics.smoothing_moves > 0);
    const Deviations found = bench.guard.deviations(bench.mesh, 1);
    const double out = found.result_to_input, back = found.input_to_result;
    CHECK(out <= std::max(tolerance, 1e-14));
    CHECK(back <= std::max(tolerance, 1e-14));
  }
}

TEST_CASE("Flips as openings make shapes worse, but none at or below the floor", "[improve]") {
  constexpr double floor = 0.05;
  Model model = ball_in_box(4);
  disturb_inside(model, 11);
  Bench bench(std::move(model));
  std::size_t n_worse = 0;
  const auto judge = [&](CellIndex c, const auto& flip) {
    double before = bench.mesh.shape_of(c), after = 1;
    std::vector<std::pair<Tetrahedron, double>> old;
    for (CellIndex k = 0; k < bench.mesh.n_slots(); ++k)
      old.emplace_back(bench.mesh.is_live(k) ? bench.mesh.vertices(k) : Tetrahedron{},
                       bench.mesh.is_live(k) ? bench.mesh.shape_of(k) : 1);
    if (!flip()) return false;
    for (CellIndex k = 0; k < bench.mesh.n_slots(); ++k) {
      const bool is_live = bench.mesh.is_live(k);
      if (k < old.size() && is_live && old[k].first == bench.mesh.vertices(k)) continue;
      if (is_live) after = std::min(after, bench.mesh.shape_of(k));
      if (k < old.size()) before = std::min(before, old[k].second);
    }
    CHECK(after > std::min(floor, before));
    n_worse += after < before;
    return true;
  };
  CHECK(over_cells(bench, 3, [&](Bench& b, CellIndex c) {
          const Tetrahedron t = b.mesh.vertices(c);
          return judge(c, [&] { return remove_edge_above(b.tools, c, t[c % 3], t[3], floor); });
        }) > 0);
  CHECK(n_worse > 0);
  n_worse = 0;
  CHECK(over_cells(bench, 3, [&](Bench& b, CellIndex c) {
          return judge(c, [&] { return remove_face_above(b.tools, c, c % 4, floor); });
        }) > 0);
  CHECK(n_worse > 0);
}

TEST_CASE("Where surfaces are kept, points added on input edges slide along them where that is asked for",
          "[improve]") {
  Bench bench(two_boxes(1));
  const DomainMesh input = bench.mesh;
  const auto edges = input.curve_edges();
  for (const auto& [a, b] : edges) {  // two points on each edge of the input, off the thirds
    for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c) {
      if (!bench.mesh.cells().has_vertex(c, a) || !bench.mesh.cells().has_vertex(c, b)) continue;
      const Vec3 p = input.point(a) + 0.25 * (input.point(b) - input.point(a)),
                 q = input.point(a) + 0.375 * (input.point(b) - input.point(a));
      const auto v = split_edge(bench.tools, c, a, b, 0, &p);
      REQUIRE(v);
      for (CellIndex k = 0; k < bench.mesh.n_slots(); ++k)
        if (bench.mesh.cells().has_vertex(k, *v) && bench.mesh.cells().has_vertex(k, b)) {
          REQUIRE(split_edge(bench.tools, k, *v, b, 0, &q));
          break;
        }
      break;
    }
  }
  REQUIRE(bench.mesh.validate() == "");
  const auto off_edge = [&](const Vec3& p, const std::array<VertexIndex, 2>& e) {
    return distance(p, search::closest_on_segment(p, input.point(e[0]), input.point(e[1])));
  };
  std::size_t n_moved = 0;
  for (VertexIndex v = 0; v < bench.mesh.n_vertices(); ++v) {
    if (bench.mesh.kind(v) != VertexKind::curve) continue;
    CHECK_FALSE(smooth_vertex(bench.tools, v, {}));
    const Vec3 old = bench.mesh.point(v);
    SmoothRule rule;
    rule.slides_on_edges = true;
    if (!smooth_vertex(bench.tools, v, rule)) continue;
    ++n_moved;
    const Vec3& now = bench.mesh.point(v);
    CHECK(!(now == old));
    CHECK(std::any_of(edges.begin(), edges.end(),
                      [&](const auto& e) { return off_edge(now, e) < 1e-15 && off_edge(old, e) < 1e-15; }));
    REQUIRE(bench.mesh.validate() == "");
  }
  CHECK(n_moved > 0);
  CHECK(bench.guard.deviations(bench.mesh, 1).result_to_input <= 1e-14);
}

TEST_CASE(
    "A flat cell with two faces on the outside goes where surfaces may be remeshed, and stays where they are kept",
    "[improve]") {
  for (const double tolerance : {0.0, 0.01}) {
    Bench bench(box_with_ridge(1e-6), tolerance);
    const auto flat_cell = [&] {
      for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
        if (bench.mesh.is_live(c) && bench.mesh.shape_of(c) < 1e-5) return c;
      return no_cell;
    };
    const CellIndex flat = flat_cell();
    REQUIRE(flat != no_cell);
    const double volume = bench.volume();
    const std::size_t n_cells = bench.mesh.n_cells();
    CHECK(remove_edge(bench.tools, flat, 4, 6) == (tolerance > 0));
    CHECK(bench.mesh.validate() == "");
    CHECK(bench.mesh.n_cells() == n_cells - (tolerance > 0));
    CHECK((flat_cell() == no_cell) == tolerance > 0);
    CHECK(bench.volume() == Approx(volume).margin(1e-5));
  }
}

TEST_CASE("Raising the mean keeps the mesh valid and the worst shape, and raises the mean worth", "[improve]") {
  for (const double tolerance : {0.0, 0.05}) {
    Model model = ball_in_box(4);
    disturb_inside(model, 11);
    Bench bench(std::move(model), tolerance);
    const double volume = bench.volume();
    const auto worst_and_mean = [&] {
      std::pair<double, double> r{1, 0};
      for (CellIndex c = 0; c < bench.mesh.n_slots(); ++c)
        if (bench.mesh.is_live(c))
          r.first = std::min(r.first, bench.mesh.shape_of(c)), r.second += CellQuality().worth(bench.mesh.shape_of(c));
      r.second /= static_cast<double>(bench.mesh.n_cells());
      return r;
    };
    const auto before = worst_and_mean();
    raise_mean(bench.tools, 0, 6, {});
    const auto loose = worst_and_mean();
    REQUIRE(bench.mesh.validate() == "");
    CHECK(loose.second > before.second + 0.01);
    CHECK(loose.first > before.first * (1 - 1e-6));
    CHECK(bench.volume() == Approx(volume).epsilon(tolerance > 0 ? 1e-1 : 1e-12));
    CHECK(bench.statistics.edge_removals > 0);
    CHECK(bench.statistics.smoothing_moves > 0);
    CHECK(bench.guard.deviations(bench.mesh, 1).result_to_input <= std::max(tolerance, 1e-14));
  }
}

TEST_CASE("What a shape counts falls faster below that of slivers, without a jump", "[improve]") {
  const CellQuality quality;
  const double s = DihedralMeasure::poor;
  CHECK(quality.worth(0.5) == 0.5);
  CHECK(quality.worth(s) == s);
  CHECK(quality.worth(s - 0.01) == Approx(s - 0.01 * poor_weight));
  CHECK(MeanGoal{0.3, 0.5}.least_after(0.4) == 0.3);
  CHECK(MeanGoal{0.3, 0.5}.least_after(0.2) == Approx(0.2));
}

TEST_CASE("Flips towards Delaunay leave no flippable face and keep the volume", "[improve]") {
  Model model = two_boxes(3);
  disturb_inside(model, 5);
  Bench bench(std::move(model));
  const double before = bench.volume();
  CHECK(flip_towards_delaunay(bench.tools, {}) > 0);
  CHECK(bench.mesh.validate() == "");
  CHECK(flip_towards_delaunay(bench.tools, {}) == 0);
  CHECK(bench.volume() == Approx(before));
}

TEST_CASE("Smoothing all vertices depends on no number of threads, and moves what smoothing one by one moves",
          "[improve]") {
  for (const double tolerance : {0.0, 0.02}) {
    Model model = two_boxes(9);
    disturb_inside(model, 11);
    Bench one(model, tolerance), two(model, tolerance), by_one(model, tolerance);
    const SmoothRule rule{6, 1, SmoothGoal::mean, 0.3};
    const auto go_on = [] { return false; };
    smooth_all(one.tools, rule, 1, go_on);
    smooth_all(two.tools, rule, 2, go_on);
    for (const VertexIndex v : by_one.mesh.vertices_by_cells()) smooth_vertex(by_one.tools, v, rule);
    CHECK(two.mesh.validate() == "");
    CHECK(two.statistics.smoothing_moves == one.statistics.smoothing_moves);
    CHECK(static_cast<double>(one.statistics.smoothing_moves) ==
          Approx(by_one.statistics.smoothing_moves).epsilon(0.02));
    std::size_t different = 0;
    for (VertexIndex v = 0; v < one.mesh.n_vertices(); ++v) different += !(one.mesh.point(v) == two.mesh.point(v));
    CHECK(different == 0);
  }
}

TEST_CASE("Sorted cells are the same cells, with their tags, shapes and neighbours", "[improve]") {
  Model model = ball_in_box(4);
  disturb_inside(model, 11);
  Bench bench(std::move(model));
  raise_mean(bench.tools, 0, 6, {});  // leaves free slots
  DomainMesh& mesh = bench.mesh;
  REQUIRE(mesh.n_cells() < mesh.n_slots());
  const auto listed = [&] {
    std::vector<std::tuple<Tetrahedron, Index, std::array<Index, 4>, double>> cells;
    for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
      if (!mesh.is_live(c)) continue;
      std::array<Index, 4> facets{};
      for (unsigned i = 0; i < 4; ++i) facets[i] = mesh.tag(c, i).constrained() ? mesh.tag(c, i).facet() : no_index;
      cells.emplace_back(mesh.vertices(c), mesh.component(c), facets, mesh.shape_of(c));
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  };
  const auto before = listed();
  mesh.sort_cells();
  CHECK(mesh.validate() == "");
  CHECK(mesh.n_cells() == mesh.n_slots());
  CHECK(listed() == before);
  // What is near is near: the mean step from a cell to its neighbour is small against the number of cells.
  double sum = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.has_neighbor(c, i))
        sum += std::abs(static_cast<double>(mesh.cells().neighbor_cell(c, i)) - static_cast<double>(c));
  CHECK(sum / (4.0 * mesh.n_cells()) < 0.15 * mesh.n_cells());
  std::vector<VertexIndex> vertices = mesh.vertices_by_cells();
  CHECK(vertices[0] == *std::find(mesh.vertices(0).begin(), mesh.vertices(0).end(), vertices[0]));
  std::sort(vertices.begin(), vertices.end());
  CHECK(std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end());
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
    CHECK(std::binary_search(vertices.begin(), vertices.end(), v) == (mesh.kind(v) != VertexKind::dead));
}

TEST_CASE("A star with more bad cells than the one it replaces is told, an equally bad one is not", "[improve]") {
  Bench bench(two_boxes(2));
  VertexIndex v = 0;
  while (bench.mesh.kind(v) != VertexKind::inside) ++v;
  StarCavity star;
  gather_star(bench.mesh, v, bench.tools.work.marks, star);
  const Vec3 middle = bench.mesh.point(v);
  const LinkFace& f = star.link[0];
  const Vec3 foot =
      (1.0 / 3) * (bench.mesh.point(f.vertices[0]) + bench.mesh.point(f.vertices[1]) + bench.mesh.point(f.vertices[2]));
  const auto towards = [&](double t) { return foot + t * (middle - foot); };
  REQUIRE(star_shape(bench.mesh, star, towards(0.01)) < DihedralMeasure::of_angle(bad_angle));
  CHECK_FALSE(adds_bad_cells(bench.mesh, star, middle));
  CHECK(adds_bad_cells(bench.mesh, star, towards(0.01)));
  std::vector<double> shapes;
  for (const LinkFace& g : star.link)
    shapes.push_back(CellQuality().shape(bench.mesh.point(g.vertices[0]), bench.mesh.point(g.vertices[1]),
                                         bench.mesh.point(g.vertices[2]), towards(0.01)));
  CHECK(adds_bad_cells(bench.mesh, star, shapes));
  // Once there, going a little back raises the worst shape and adds none.
  bench.mesh.move_vertex(v, towards(0.01));
  for (const CellIndex c : star.cells) bench.mesh.refresh_shape(c);
  CHECK_FALSE(adds_bad_cells(bench.mesh, star, towards(0.011)));
}

TEST_CASE("At the quickest level no element is left that solvers refuse", "[improve]") {
  const Model model = box_with_well(4);  // its last sliver is left by flips and moves alone
  RefineOptions options;
  options.size.global = 0.15;
  options.quality = QualityLevel::fast;
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  const MeshQuality q = measure_quality(model.plc, r.mesh);
  CHECK(q.whole.min_dihedral.min > 1);
  CHECK(q.whole.max_dihedral.max < 179);
}
