// SPDX-License-Identifier: MIT
// Moves or adds vertices where surfaces are too far from the input. Declared in remesh/operations/surface_repair.hpp.
#include <algorithm>
#include <functional>
#include <optional>

#include "quality/measure/shape.hpp"
#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

namespace {

constexpr double least_shape = 1e-3;  ///< least shape of a cell after the repair of a surface

/// A face or an edge of a curve, given by its vertices and a cell that contains it.
struct Place {
  CellIndex cell;
  std::vector<VertexIndex> vertices;
};

/// Finds the constrained faces and curve edges near a place, as they were when this object was constructed.
class Finder {
 public:
  explicit Finder(const DomainMesh& mesh) : mesh_(mesh) {
    std::vector<search::ClosestPointTrees::Item> faces, curves;
    mesh.for_each_facet_face([&](FaceRef f) {
      const Triangle t = mesh.face(f);
      faces.push_back({mesh.places(t), mesh.patch_of(mesh.tag(f)), add({f.cell(), {t.begin(), t.end()}})});
      for (unsigned k = 0; k < 3; ++k) {
        const VertexIndex a = t[k], b = t[(k + 1) % 3];
        if (const Index curve = mesh.curve_of(a, b); curve != no_index)
          curves.push_back({mesh.places(Triangle{a, b, b}), curve, add({f.cell(), {a, b}})});
      }
    });
    faces_ = search::ClosestPointTrees(std::move(faces), mesh.n_patches());
    curves_ = search::ClosestPointTrees(std::move(curves), mesh.n_curve_classes());
  }

  /// Returns the face or curve edge nearest to a place outside the tolerance, if it still exists.
  std::optional<Place> nearest(const Breach& b) const {
    const search::ClosestPoint at = (b.on_curve ? curves_ : faces_).closest(b.place, b.group);
    if (at.item == no_index) return std::nullopt;
    const Place& place = places_[at.item];
    const auto is_there = [&](VertexIndex v) { return mesh_.cells().has_vertex(place.cell, v); };
    const bool is_left = mesh_.is_live(place.cell) && std::ranges::all_of(place.vertices, is_there);
    return is_left ? std::optional(place) : std::nullopt;
  }

 private:
  Index add(Place place) {
    places_.push_back(std::move(place));
    return static_cast<Index>(places_.size() - 1);
  }

  const DomainMesh& mesh_;
  std::vector<Place> places_;
  search::ClosestPointTrees faces_, curves_;
};

/// Repairs a place where a surface or curve is too far from the input, by moving a vertex there or splitting an edge.
class Mender {
 public:
  Mender(Toolbox& tools, MendBy by) : tools_(tools), mesh_(tools.mesh), by_(by) {}

  bool mend(const Breach& breach, const Place& part) {
    best_ = {};
    target_ = breach.on_curve ? tools_.guard.project_to_curve(breach.group, breach.place)
                              : tools_.guard.project_to_patch(breach.group, breach.place);
    for (std::size_t i = 0; i < part.vertices.size(); ++i)
      for (std::size_t j = i + 1; j < part.vertices.size(); ++j)
        consider_split(breach, part.cell, part.vertices[i], part.vertices[j]);
    if (by_ == MendBy::moves_and_splits)
      for (const VertexIndex v : part.vertices) consider_move(breach, v);
    if (best_.change) best_.change();
    return static_cast<bool>(best_.change);
  }

 private:
  /// A possible repair, ranked by how many faces it leaves too far from the input, then by the worst new shape.
  struct Option {
    std::ptrdiff_t more_off = 0;
    double shape = least_shape;
    std::function<void()> change;
  };

  void consider_split(const Breach& breach, CellIndex c, VertexIndex a, VertexIndex b) {
    if (mesh_.curve_of(a, b) != (breach.on_curve ? breach.group : no_index) || mesh_.is_pinched(a, b)) return;
    StarCavity& cavity = tools_.work.cavity;
    gather_edge(mesh_, c, a, b, cavity);
    if (cavity.spokes.empty() && cavity.curves.empty()) return;
    consider(cavity, faces_at_edge(mesh_, cavity, a, b), [this, c, a, b] { split_edge(tools_, c, a, b, 0, &target_); });
  }

  void consider_move(const Breach& breach, VertexIndex v) {
    if (mesh_.kind(v) != (breach.on_curve ? VertexKind::curve : VertexKind::surface) ||
        mesh_.support(v) != breach.group)
      return;
    StarCavity& cavity = tools_.work.cavity;
    gather_star(mesh_, v, tools_.work.marks, cavity);
    consider(cavity, surface_of(mesh_, cavity, mesh_.point(v)).faces, [this, v] {
      gather_star(mesh_, v, tools_.work.marks, tools_.work.cavity);
      mesh_.move_vertex(v, target_);
      for (const CellIndex c : tools_.work.cavity.cells) mesh_.refresh_shape(c);
      tools_.lengths.forget(v);
    });
  }

  std::ptrdiff_t count_off(const std::vector<SurfaceFace>& faces) const {
    return std::count_if(faces.begin(), faces.end(),
                         [&](const SurfaceFace& f) { return !tools_.guard.is_proven_near_reference(f); });
  }

  /// Keeps a repair as an option if fewer faces are too far from the input than before it, or none before and after.
  void consider(const StarCavity& cavity, const std::vector<SurfaceFace>& before, std::function<void()> change) {
    const double shape = star_shape(mesh_, cavity, target_, least_shape);
    if (!(shape > least_shape) || !star_is_positive(mesh_, cavity, target_)) return;
    const std::ptrdiff_t n_before = count_off(before),
                         more_off = count_off(surface_of(mesh_, cavity, target_).faces) - n_before;
    if (more_off > 0 || (n_before > 0 && more_off == 0)) return;
    if (best_.change && std::pair(-more_off, shape) <= std::pair(-best_.more_off, best_.shape)) return;
    best_ = {more_off, shape, std::move(change)};
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  MendBy by_;
  Vec3 target_;
  Option best_;
};

}  // namespace

std::size_t mend_surfaces(Toolbox& tools, const std::vector<Breach>& breaches, MendBy by) {
  const Finder finder(tools.mesh);
  Mender mender(tools, by);
  std::size_t n = 0;
  for (const Breach& breach : breaches)
    if (const auto part = finder.nearest(breach); part && mender.mend(breach, *part)) ++n;
  return n;
}

}  // namespace geomesh::remesh
