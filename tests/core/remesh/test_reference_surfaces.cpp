// SPDX-License-Identifier: MIT
// Surfaces given by a function as the reference of remeshing, in place of triangles.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "common/epoch_marks.hpp"
#include "common/geometry.hpp"
#include "refine_models.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"

using namespace geomesh;
using namespace geomesh::remesh;
using namespace refine_models;

namespace {

DomainMesh domain_of(const Model& model) { return import_domain(model.plc, model.mesh, within(1, 1)); }

/// The patch of the ball, whose corners are at a distance of 1 from the origin.
Index patch_of_ball(const DomainMesh& mesh) {
  Index patch = no_index;
  mesh.for_each_facet_face([&](FaceRef f) {
    if (std::abs(length(mesh.point(mesh.face(f)[0])) - 1) < 1e-9) patch = mesh.patch_of(mesh.tag(f));
  });
  REQUIRE(patch != no_index);
  return patch;
}

/// How far the triangle is within the unit sphere, at most: its corners may be on both sides.
double depth_below_sphere(const search::Corners& t) {
  return 1 - length(search::closest_on_triangle({0, 0, 0}, t[0], t[1], t[2]));
}

/// The patch of the ball as the unit sphere, and the other patches as the triangles of a mesh. Distances of triangles
/// from the sphere are exact up to rounding.
class RoundBall final : public search::ReferenceSurfaces {
 public:
  explicit RoundBall(const DomainMesh& given) : ball_(patch_of_ball(given)) {
    const DomainMesh fine = domain_of(ball_in_box(14));
    const Index of_fine = patch_of_ball(fine);
    const search::TriangleSurfaces given_faces = faces_of(given), fine_faces = faces_of(fine);
    std::vector<Piece> pieces;
    std::vector<Vec3> normals;
    for (const Piece& piece : given_faces.pieces()) {
      if (piece.group == ball_) {
        facet_ = piece.id;
        continue;
      }
      pieces.push_back(piece);
      if (normals.size() <= piece.id) normals.resize(piece.id + 1);
      const auto& [a, b, c] = piece.corners;
      normals[piece.id] = unit(cross(b - a, c - a));
    }
    for (const Piece& piece : fine_faces.pieces()) {
      if (piece.group != of_fine) continue;
      pieces.push_back({piece.corners, ball_, facet_});
      deviation_ = std::max(deviation_, depth_below_sphere(piece.corners));
    }
    triangles_ = search::TriangleSurfaces(std::move(pieces), given.n_patches(), std::move(normals));
  }

  search::ClosestPoint closest(const Vec3& p, Index group, double limit) const override {
    if (group != ball_) return triangles_.closest(p, group, limit);
    const double off = std::abs(length(p) - 1);
    return off <= limit ? search::ClosestPoint{off, unit(p), facet_} : search::ClosestPoint();
  }
  Vec3 normal(Index item, const Vec3& p) const override {
    return item == facet_ ? unit(p) : triangles_.normal(item, p);
  }
  bool within(const search::Corners& triangle, Index group, double limit, Index& over) const override {
    if (group != ball_) return triangles_.within(triangle, group, limit, over);
    const bool is_within = off_sphere(triangle).farthest <= limit;
    over = is_within && limit < 0.1 ? facet_ : no_index;
    return is_within;
  }
  void within(std::span<search::DistanceQuestion> questions) const override {
    triangles_.within(questions);
    for (search::DistanceQuestion& q : questions)
      if (q.group == ball_) {
        q.answer = off_sphere(q.item);
        q.answer.is_proven = q.answer.farthest <= q.limit;
      }
  }
  const std::vector<Piece>& pieces() const override { return triangles_.pieces(); }
  double deviation_of_pieces() const override { return deviation_; }
  void visit_pieces(const Box3& box, Index group, const std::function<void(const Piece&)>& visit) const override {
    triangles_.visit_pieces(box, group, visit);
  }
  bool is_even(const Box3& box, Index group, double least_cosine) const override {
    return group == ball_ ? length(box.max - box.min) < 0.5 : triangles_.is_even(box, group, least_cosine);
  }

 private:
  static search::Cover off_sphere(const search::Corners& t) {
    search::Cover cover{.farthest = depth_below_sphere(t), .place = search::closest_on_triangle({}, t[0], t[1], t[2])};
    for (const Vec3& p : t)
      if (const double off = length(p) - 1; off > cover.farthest) cover.farthest = off, cover.place = p;
    return cover;
  }

  search::TriangleSurfaces triangles_;
  Index ball_, facet_ = no_index;
  double deviation_ = 0;
};

}  // namespace

TEST_CASE("The distance of a ball of flat faces from the sphere is found, and proven within a tolerance above it",
          "[refine]") {
  const DomainMesh mesh = domain_of(ball_in_box(4));
  const RoundBall sphere(mesh);
  const search::TriangleSurfaces curves = curves_of(mesh);
  const Index ball = patch_of_ball(mesh);
  double deepest = 0;
  std::size_t n_faces = 0;
  const search::TriangleSurfaces faces = faces_of(mesh);
  for (const auto& piece : faces.pieces())
    if (piece.group == ball) deepest = std::max(deepest, depth_below_sphere(piece.corners)), ++n_faces;
  REQUIRE(n_faces > 100);
  REQUIRE(deepest > 5 * sphere.deviation_of_pieces());
  const auto verified = [&](double tolerance) {
    return verify_surfaces(mesh, {sphere, curves}, LocalTolerance(tolerance), 2);
  };
  const double enough = deepest + 2 * sphere.deviation_of_pieces();
  CHECK(verified(enough).breaches.empty());
  CHECK(std::abs(verified(enough).result_to_input - deepest) < 1e-12);
  const std::vector<Breach> breaches = verified(0.95 * deepest).breaches;
  for (const bool of_input : {false, true})
    CHECK(std::ranges::any_of(breaches, [&](const Breach& b) { return b.of_input == of_input; }));
  for (const Breach& b : breaches) CHECK(b.group == ball);
}

TEST_CASE("A change is admitted by its distance from the sphere, not from the faces that were there", "[refine]") {
  const Model model = ball_in_box(8);
  const DomainMesh mesh = domain_of(model);
  const Index ball = patch_of_ball(mesh);
  const double tolerance = 0.06;
  const SurfaceGuard by_faces(mesh, mesh, model.plc, Honour::tolerance, LocalTolerance(tolerance)),
      by_sphere(mesh, mesh, model.plc, Honour::tolerance, LocalTolerance(tolerance),
                {.surfaces = std::make_shared<RoundBall>(mesh)});
  const Vec3 above{1.3, 0.2, 0.1};
  CHECK(length(by_faces.project_to_patch(ball, above)) < 1 - 1e-4);
  CHECK(std::abs(length(by_sphere.project_to_patch(ball, above)) - 1) < 1e-14);
  CHECK(length(by_sphere.normal(ball, above) - unit(above)) < 1e-14);
  EpochMarks marks;
  StarCavity star;
  std::size_t n_moved = 0;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) {
    if (mesh.kind(v) != VertexKind::surface || std::abs(length(mesh.point(v)) - 1) > 1e-9) continue;
    gather_star(mesh, v, marks, star);
    const SurfacePart before = surface_of(mesh, star, mesh.point(v));
    for (const double way : {-3.0, -0.3, 0.3, 3.0})
      CHECK(by_sphere.admits(before, surface_of(mesh, star, (1 + way * tolerance) * mesh.point(v))) ==
            (std::abs(way) < 1));
    ++n_moved;
  }
  CHECK(n_moved > 100);
}

TEST_CASE("A ball given by flat faces is remeshed to the sphere", "[refine]") {
  const Model model = ball_in_box(6);
  const RefineOptions options = within(0.06, 0.3);
  const double whole = 4 * std::numbers::pi / 3, given = component_volumes(model.mesh)[0];
  const Attempt attempt =
      attempt_holding({.surfaces = std::make_shared<RoundBall>(domain_of(model))}, model.plc, model.mesh, options, {});
  REQUIRE(attempt.holds());
  CHECK(attempt.result.statistics.deviation_result_to_input <= options.tolerance);
  const double made = component_volumes(attempt.result.mesh)[0];
  CHECK(std::abs(made - whole) < 0.2 * std::abs(given - whole));
}
