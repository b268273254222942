// SPDX-License-Identifier: MIT
// Surfaces within a tolerance: what is proven of the whole result, what a shifted vertex does to it, and how it is
// mended.
#include <catch2/catch.hpp>
#include <cmath>

#include "common/epoch_marks.hpp"
#include "quality/measure/shape.hpp"
#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/sizes/sizes.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

VertexIndex vertex_of_kind(const DomainMesh& mesh, VertexKind kind) {
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
    if (mesh.kind(v) == kind) return v;
  FAIL("no such vertex");
  return no_vertex;
}

/// Of faces alone: a result that is imported again has other numbers for its curves.
Deviations verify_faces(const DomainMesh& mesh, const ReferenceModel& input, double tolerance) {
  Deviations found = verify_surfaces(mesh, input, LocalTolerance(tolerance), 2);
  std::erase_if(found.breaches, [](const Breach& b) { return b.on_curve; });
  return found;
}

std::vector<Vec3> places_of(const std::vector<Breach>& breaches) {
  std::vector<Vec3> places;
  for (const Breach& b : breaches) places.push_back(b.place);
  return places;
}

/// Every seventh vertex, where it is on a surface and cells stay positive. Returns how many.
std::size_t shift_surface_vertices(Toolbox& tools, double by) {
  DomainMesh& mesh = tools.mesh;
  std::size_t n = 0;
  for (VertexIndex v = 0; v < mesh.n_vertices(); v += 7) {
    const Vec3 to = mesh.point(v) + by * Vec3{0.48, 0.6, 0.64};
    gather_star(mesh, v, tools.work.marks, tools.work.cavity);
    if (mesh.kind(v) != VertexKind::surface || !star_is_positive(mesh, tools.work.cavity, to)) continue;
    mesh.move_vertex(v, to);
    for (const CellIndex c : tools.work.cavity.cells) mesh.refresh_shape(c);
    ++n;
  }
  return n;
}

/// Segments along all curves of the model, each with a row of its own.
Model with_listed_curves(Model model) {
  const DomainMesh mesh = import_domain(model.plc, model.mesh, within(0.1, 1));
  for (const auto& [a, b] : mesh.curve_edges()) {
    model.mesh.edges.push_back({a, b, static_cast<Index>(model.plc.segments.size())});
    model.plc.segments.push_back({model.mesh.input_vertex[a], model.mesh.input_vertex[b], no_index});
  }
  return model;
}

std::size_t count_kind(const DomainMesh& mesh, VertexKind kind) {
  std::size_t n = 0;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) n += mesh.kind(v) == kind;
  return n;
}

}  // namespace

TEST_CASE("Whatever the tolerance, the result is proven to be within it both ways, and so are volumes", "[refine]") {
  const Model model = ball_in_box(5);
  const DomainMesh given = import_domain(model.plc, model.mesh, within(1, 1));
  const search::TriangleSurfaces faces = faces_of(given), curves = curves_of(given);
  const ReferenceModel input{faces, curves};
  const std::vector<double> before = component_volumes(model.mesh);
  double area = 0;
  for (const double a : facet_areas(model.plc, model.mesh)) area += a;
  double farthest = 0;
  for (const double tolerance : {0.1, 0.02, 0.004})
    for (const double size : {1.0, 0.3}) {
      const RefineOptions options = within(tolerance, size);
      const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
      require_valid(r.mesh);
      const Deviations found = verify_faces(import_domain(model.plc, r.mesh, options), input, tolerance);
      CHECK(found.breaches.empty());
      CHECK(r.statistics.deviation_result_to_input <= tolerance);
      CHECK(r.statistics.deviation_input_to_result <= tolerance);
      farthest = std::max(farthest, r.statistics.deviation_input_to_result);
      const std::vector<double> after = component_volumes(r.mesh);
      for (std::size_t c = 0; c < before.size(); ++c) CHECK(std::abs(after[c] - before[c]) <= tolerance * area);
    }
  CHECK(farthest > 0.02);  // surfaces did move
}

TEST_CASE("A vertex shifted by more than the tolerance is found, from the result and from the input", "[refine]") {
  const Model model = ball_in_box(4);
  const double tolerance = 0.01;
  const DomainMesh given = import_domain(model.plc, model.mesh, within(tolerance, 1));
  const search::TriangleSurfaces faces = faces_of(given), curves = curves_of(given);
  const ReferenceModel input{faces, curves};
  CHECK(verify_surfaces(given, input, LocalTolerance(tolerance), 1).breaches.empty());
  for (const VertexKind kind : {VertexKind::surface, VertexKind::curve}) {
    CAPTURE(static_cast<int>(kind));
    DomainMesh mesh = given;
    const VertexIndex v = vertex_of_kind(mesh, kind);
    const Vec3 old = mesh.point(v);
    VerifiedSurfaces before;
    const auto found_at_height = [&](double height) {
      mesh.move_vertex(v, old + height * Vec3{0.48, 0.6, 0.64});
      const Deviations found = verify_surfaces(mesh, input, LocalTolerance(tolerance), 2);
      const Deviations remembered = verify_surfaces(mesh, input, LocalTolerance(tolerance), 2, &before);
      CHECK(remembered.result_to_input == found.result_to_input);
      CHECK(remembered.input_to_result == found.input_to_result);
      CHECK(places_of(remembered.breaches) == places_of(found.breaches));
      return found;
    };
    CHECK(found_at_height(0.9 * tolerance).breaches.empty());
    const Deviations found = found_at_height(4 * tolerance);
    REQUIRE_FALSE(found.breaches.empty());
    CHECK(std::any_of(found.breaches.begin(), found.breaches.end(), [](const Breach& b) { return b.of_input; }));
    CHECK(std::any_of(found.breaches.begin(), found.breaches.end(), [](const Breach& b) { return !b.of_input; }));
    CHECK(std::any_of(found.breaches.begin(), found.breaches.end(), [](const Breach& b) { return b.on_curve; }) ==
          (kind == VertexKind::curve));
    CHECK(found.result_to_input > tolerance);
    const Deviations again = verify_surfaces(mesh, input, LocalTolerance(tolerance), 1);
    CHECK(again.breaches.size() == found.breaches.size());
    CHECK(again.result_to_input == found.result_to_input);
    CHECK(found_at_height(0).breaches.empty());
  }
}

namespace {

/// A vertex on a surface, and what a guard says of its moves.
class SurfaceVertex {
 public:
  /// `turned`: all faces are given the other way round.
  SurfaceVertex(const Model& model, double tolerance, bool turned = false)
      : mesh_(import_domain(model.plc, model.mesh, within(tolerance, 1))),
        guard_(mesh_, mesh_, model.plc, Honour::tolerance, LocalTolerance(tolerance)),
        place_(mesh_.point(vertex_of_kind(mesh_, VertexKind::surface))),
        turned_(turned) {
    EpochMarks marks;
    gather_star(mesh_, vertex_of_kind(mesh_, VertexKind::surface), marks, star_);
    REQUIRE(star_.spokes.size() > 3);
  }

  /// To the middle of each side of the star.
  std::vector<Vec3> ways() const {
    std::vector<Vec3> ways;
    for (const Spoke& s : star_.spokes) ways.push_back(0.5 * (mesh_.point(s.a) + mesh_.point(s.b)) - place_);
    return ways;
  }
  bool may_move_by(const Vec3& way) const { return guard_.admits(faces_at(place_), faces_at(place_ + way)); }

 private:
  SurfacePart faces_at(const Vec3& p) const {
    SurfacePart part = surface_of(mesh_, star_, p);
    part.curves.clear();
    if (turned_)
      for (SurfaceFace& f : part.faces) std::swap(f.corners[0], f.corners[1]);
    return part;
  }

  DomainMesh mesh_;
  SurfaceGuard guard_;
  StarCavity star_;
  Vec3 place_;
  bool turned_;
};

}  // namespace

TEST_CASE("A face that folds over is not admitted, however near to the input it is", "[refine]") {
  const Model model = ball_in_box(6);
  const double tolerance = 1;  // of the order of the ball: distances allow nearly all
  const SurfaceVertex v(model, tolerance);
  for (const Vec3& way : v.ways()) {
    CHECK(v.may_move_by(0.5 * way));
    CHECK_FALSE(v.may_move_by(1.5 * way));  // beyond the side opposite to it
  }
}

TEST_CASE(
    "Of faces over a sheet of the input one that folds over is told by its side, whichever way round all are given",
    "[refine]") {
  const Model model = two_boxes(6);
  const double tolerance = 0.01;
  const SurfaceVertex v(model, tolerance, GENERATE(false, true));
  for (const Vec3& way : v.ways()) {
    CHECK(v.may_move_by(0.3 * way));
    CHECK_FALSE(v.may_move_by(1.2 * way));
  }
}

TEST_CASE(
    "In exact mode a face that turns over in a plane that leans is not admitted, though its corners are on the plane",
    "[refine]") {
  const Model model = ball_in_box(6);
  RefineOptions options = within(0.5, 1);
  options.honour = Honour::exact;
  const DomainMesh mesh = import_domain(model.plc, model.mesh, options);
  const SurfaceGuard guard(mesh, mesh, model.plc, Honour::exact, LocalTolerance());
  std::size_t n_judged = 0;
  mesh.for_each_facet_face([&](FaceRef f) {
    const auto [a, b, c] = mesh.places(mesh.facet_face(f));
    const Vec3 normal = cross(b - a, c - a);
    if (normal.x == 0 || normal.y == 0 || normal.z == 0) return;  // a side of the box
    ++n_judged;
    const Index patch = mesh.patch_of(mesh.tag(f));
    const Vec3 m = 0.5 * (b + c);
    const SurfacePart halves{{{{a, b, m}, patch}, {{a, m, c}, patch}}, {}}, whole{{{{a, b, c}, patch}}, {}},
        folded{{{{a, b, c}, patch}, {{a, m, b}, patch}}, {}};
    CHECK(guard.admits(whole, halves));
    CHECK(guard.admits(halves, whole));
    CHECK_FALSE(guard.admits(halves, folded));
  });
  CHECK(n_judged > 20);
}

TEST_CASE("Where little is allowed only what lies as near as that is asked of a change", "[refine]") {
  const Model model = ball_in_box(6);
  const DomainMesh mesh = import_domain(model.plc, model.mesh, within(0.5, 1));
  const VertexIndex v = vertex_of_kind(mesh, VertexKind::surface);
  constexpr double greatest = 0.5, least = 0.01;  // the triangles about are of a size between
  const SizeField by_place({{mesh.point(v), least, 2, 1}},
                           {.global = greatest, .component_size = {}, .background = {}});
  const SurfaceGuard guard(mesh, mesh, model.plc, Honour::tolerance, LocalTolerance(greatest, by_place));
  EpochMarks marks;
  StarCavity star;
  gather_star(mesh, v, marks, star);
  const SurfacePart faces = surface_of(mesh, star, mesh.point(v));
  CHECK(guard.admits(faces, faces));
}

TEST_CASE("What is off is mended by points on the input", "[refine]") {
  const bool told_by_input = GENERATE(false, true);  // alone: what faces of the result are off is then not used
  const Model model = ball_in_box(6);
  const double tolerance = 0.03;
  const RefineOptions options = within(tolerance, 0.5);
  const DomainMesh given = import_domain(model.plc, model.mesh, options);
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  DomainMesh mesh = import_domain(model.plc, r.mesh, options);
  const SurfaceGuard guard(given, given, model.plc, Honour::tolerance, LocalTolerance(tolerance));
  const SizeField size = build_size_field(model.plc, mesh, options, LocalTolerance()).all;
  RefineStatistics statistics;
  Toolbox tools(mesh, guard, size, statistics);
  const search::TriangleSurfaces faces = faces_of(given), curves = curves_of(given);
  const ReferenceModel input{faces, curves};
  REQUIRE(verify_faces(mesh, input, tolerance).breaches.empty());
  const std::size_t n_shifted = shift_surface_vertices(tools, 2.5 * tolerance);
  REQUIRE(n_shifted > 10);
  Deviations found = verify_faces(mesh, input, tolerance);
  REQUIRE(found.breaches.size() > n_shifted);
  for (unsigned round = 0; round < 8 && !found.breaches.empty(); ++round) {
    if (told_by_input) std::erase_if(found.breaches, [](const Breach& b) { return !b.of_input; });
    if (mend_surfaces(tools, found.breaches) == 0) break;
    REQUIRE(mesh.validate().empty());
    found = verify_faces(mesh, input, tolerance);
  }
  CHECK(found.breaches.empty());
}

TEST_CASE("Where splits alone may mend, no vertex moves", "[refine]") {
  const Model model = ball_in_box(6);
  const double tolerance = 0.03;
  const RefineOptions options = within(tolerance, 0.5);
  for (const MendBy by : {MendBy::moves_and_splits, MendBy::splits}) {
    DomainMesh mesh = import_domain(model.plc, model.mesh, options);
    const SurfaceGuard guard(mesh, mesh, model.plc, Honour::tolerance, LocalTolerance(tolerance));
    const search::TriangleSurfaces faces = faces_of(mesh), curves = curves_of(mesh);
    const ReferenceModel input{faces, curves};
    const SizeField size({}, {});
    RefineStatistics statistics;
    Toolbox tools(mesh, guard, size, statistics);
    REQUIRE(shift_surface_vertices(tools, 2.5 * tolerance) > 0);
    std::vector<Vec3> before;
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) before.push_back(mesh.point(v));
    CHECK(mend_surfaces(tools, verify_faces(mesh, input, tolerance).breaches, by) > 0);
    std::size_t n_moved = 0;
    for (VertexIndex v = 0; v < before.size(); ++v) n_moved += mesh.point(v) != before[v];
    CHECK((n_moved == 0) == (by == MendBy::splits));
    CHECK(mesh.validate().empty());
  }
}

TEST_CASE("Outer faces that cross are found, with the outside between", "[refine]") {
  const Model model = ball_in_box(3);
  DomainMesh mesh = import_domain(model.plc, model.mesh, within(0.1, 1));
  CHECK(crossings_outside(mesh).empty());
  // A corner of the box, which is (-2, -2, -2) to (2, 2, 2), out through the opposite corner.
  VertexIndex corner = 0;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
    if (dot(mesh.point(v), {1, 1, 1}) < dot(mesh.point(corner), {1, 1, 1})) corner = v;
  mesh.move_vertex(corner, {2.5, 2.4, 2.6});
  const std::vector<TightZone> found = crossings_outside(mesh);
  REQUIRE_FALSE(found.empty());
  for (const TightZone& zone : found) CHECK_FALSE(zone.box.empty());
}

TEST_CASE("Segments of one curve let its points move, others keep their ends", "[refine]") {
  const Model model = with_listed_curves(two_boxes(4));
  REQUIRE(model.plc.segments.size() > 10);
  RefineOptions options = within(0.05, 0.4);
  CHECK(count_kind(import_domain(model.plc, model.mesh, options), VertexKind::curve) == 0);
  options.segment_curve.assign(model.plc.segments.size(), 7);
  const DomainMesh joined = import_domain(model.plc, model.mesh, options);
  CHECK(count_kind(joined, VertexKind::curve) > 10);
  const RefineResult r = refine_and_improve(model.plc, model.mesh, options);
  require_valid(r.mesh);
  CHECK(r.mesh.edges.size() < model.plc.segments.size());  // the size asked is larger than the segments
  for (const auto& e : r.mesh.edges) CHECK(e.segment == 0);
  options.segment_curve.assign(model.plc.segments.size(), no_index);
  CHECK(count_kind(import_domain(model.plc, model.mesh, options), VertexKind::curve) == 0);
  options.segment_curve.pop_back();
  CHECK_THROWS_AS(refine_and_improve(model.plc, model.mesh, options), Error);
}
