// SPDX-License-Identifier: MIT
// Moves vertices so that surfaces enclose the volume of the input and their borders enclose its area. Declared in
// remesh/passes/improve_passes.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

/// Number of sweeps over all vertices. In each sweep, vertices compensate for what their neighbours could not.
constexpr unsigned n_sweeps = 2;

/// Share of its shape that a bad cell must keep when a vertex moves. Between surfaces much closer to each other than
/// their edges are long, all cells are bad, and only one surface can move at a time. If no loss were allowed, the layer
/// between two spheres 1 m apart would become much too thick (python/tests/test_fields.py).
constexpr double kept_of_bad = 0.8;

/// Moves vertices to permitted places on surfaces. Makes no good cell bad, and no cell worse than the worst.
class Mover {
 public:
  explicit Mover(Toolbox& tools) : tools_(tools), mesh_(tools.mesh) {
    for (const CellIndex c : mesh_.live_cells()) worst_ = std::min(worst_, mesh_.shape_of(c));
  }

  /// Moves v to p if permitted. `cavity` is the star of v. Vertices that share no cell may be moved concurrently.
  bool move(VertexIndex v, const Vec3& p, const StarCavity& cavity) const {
    if (!may_move(p, mesh_.point(v), cavity)) return false;
    mesh_.move_vertex(v, p);
    for (const CellIndex c : cavity.cells) mesh_.refresh_shape(c);
    tools_.lengths.forget(v);
    return true;
  }

 private:
  bool may_move(const Vec3& p, const Vec3& old, const StarCavity& cavity) const {
    if (!std::isfinite(p.x + p.y + p.z) || p == old || !star_is_positive(mesh_, cavity, p)) return false;
    const double shape = removed_shape(mesh_, cavity), bad = mesh_.measure().bad();
    const double needed = (1 - 1e-9) * std::max(worst_, shape > bad ? bad : kept_of_bad * shape);
    return star_shape(mesh_, cavity, p, needed) > needed && !tools_.spoils(cavity, p) &&
           tools_.guard.admits(surface_of(mesh_, cavity, old), surface_of(mesh_, cavity, p));
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  double worst_ = 1;  ///< worst shape of all cells before the pass
};

/// Moves vertices on free borders, perpendicular to the border.
class BorderBalancer {
 public:
  explicit BorderBalancer(Toolbox& tools) : tools_(tools), mesh_(tools.mesh), mover_(tools) {}

  std::size_t sweep(const RunContext& context) {
    std::size_t n = 0;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v) {
      if (v % 4096 == 0) context.check_cancelled();
      n += is_on_free_border(v) && balance(v);
    }
    return n;
  }

 private:
  /// Number of samples on a border edge for its distance from the input's border. For parabolas the sum is within 1 %.
  static constexpr unsigned n_samples = 8;

  bool is_on_free_border(VertexIndex v) const {
    return mesh_.kind(v) == VertexKind::curve && mesh_.curve_class(mesh_.support(v)).patches.size() == 1;
  }

  /// Returns the unit vector that is perpendicular to the border edge from v to `other` in the plane of its only face
  /// and points out of the surface; zero if that face has no area.
  Vec3 outward(VertexIndex v, VertexIndex other) const {
    for (const Spoke& s : cavity_.spokes) {
      if (s.a != other && s.b != other) continue;
      const Vec3 &p = mesh_.point(v), along = unit(mesh_.point(other) - p);
      const Vec3 in = mesh_.point(s.a == other ? s.b : s.a) - p;
      return unit(dot(in, along) * along - in);
    }
    return {};
  }

  /// Returns the area between a border edge of the mesh and the input's border; positive if the latter is outside.
  double area_lost(const Vec3& a, const Vec3& b, Index curve, const Vec3& out) const {
    double sum = 0;
    for (unsigned k = 0; k < n_samples; ++k) {
      const double t = (k + 0.5) / n_samples;
      const Vec3 p = (1 - t) * a + t * b;
      sum += dot(tools_.guard.project_to_curve(curve, p) - p, out);
    }
    return sum / n_samples * distance(a, b);
  }

  /// Moves v, a vertex on a free border, outwards or inwards until the two border edges at it have recovered half of
  /// the area that each has cut off from the input.
  bool balance(VertexIndex v) {
    gather_star(mesh_, v, tools_.work.marks, cavity_);
    if (cavity_.curves.size() != 2) return false;
    const Vec3 old = mesh_.point(v);
    Vec3 out;
    double lost = 0, length_of_both = 0;
    for (const CurveSpoke& chord : cavity_.curves) {
      const Vec3& end = mesh_.point(chord.a);
      const Vec3 direction = outward(v, chord.a);
      const double l = distance(old, end);
      lost += area_lost(old, end, chord.curve, direction);
      out = out + l * direction;
      length_of_both += l;
    }
    return mover_.move(v, old + (lost / length_of_both) * unit(out), cavity_);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Mover mover_;
  StarCavity cavity_;
};

/// Moves vertices inside of patches along the normal. Flat patches are left out, because their faces cut off no volume.
class VolumeBalancer {
 public:
  VolumeBalancer(Toolbox& tools, unsigned threads)
      : tools_(tools), mesh_(tools.mesh), mover_(tools), threads_(threads) {
    mesh_.for_each_facet_face([&](FaceRef f) {
      const Triangle t = mesh_.facet_face(f);
      if (tools_.guard.is_flat(mesh_.patch_of(mesh_.tag(f)))) return;
      if (std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return mesh_.kind(v) == VertexKind::surface; }))
        faces_.push_back({t, mesh_.patch_of(mesh_.tag(f))});
    });
  }

  void sweep() {
    for_each_index(faces_.size(), thread_count(threads_), [&](std::size_t k) { measure(faces_[k]); });
    find_offsets();
    std::vector<VertexIndex> movable;
    for (VertexIndex v = 0; v < offset_.size(); ++v)
      if (offset_[v].lost != 0 && mesh_.kind(v) == VertexKind::surface) movable.push_back(v);
    for_each_block(mesh_, std::move(movable), threads_, [&](const std::vector<VertexIndex>& vertices, Workspace& work) {
      for (const VertexIndex v : vertices) {
        const Offset& o = offset_[v];
        gather_star(mesh_, v, work.marks, work.cavity);
        mover_.move(v, mesh_.point(v) + (o.lost / o.area) * unit(o.normal), work.cavity);
      }
    });
  }

 private:
  struct Face {
    Triangle vertices;
    Index patch;
    Vec3 normal{};    ///< normal vector of the face; its length is twice the face's area
    double lost = 0;  ///< twice the volume between the face and the input; positive on the side of the normal
  };
  /// Normal vector, volume lost and area, summed over the faces around a vertex.
  struct Offset {
    Vec3 normal{};
    double lost = 0, area = 0;
  };

  /// Barycentric weights of the samples of a face, whose mean is exact for parabolas.
  static constexpr double most = 2.0 / 3, least = 1.0 / 6;
  static constexpr std::array<std::array<double, 3>, 3> samples{
      {{most, least, least}, {least, most, least}, {least, least, most}}};

  void measure(Face& face) const {
    const auto [a, b, c] = mesh_.places(face.vertices);
    face.normal = triangle_normal(a, b, c);
    const Vec3 n = unit(face.normal);
    double sum = 0;
    for (const auto& s : samples) {
      const Vec3 p = s[0] * a + s[1] * b + s[2] * c;
      const double height = dot(tools_.guard.project_to_patch(face.patch, p) - p, n);
      if (std::abs(height) > tools_.guard.rounding()) sum += height;
    }
    face.lost = sum / static_cast<double>(samples.size()) * length(face.normal);
  }

  void find_offsets() {
    offset_.assign(mesh_.n_vertices(), {});
    for (const Face& face : faces_)
      for (const VertexIndex v : face.vertices) {
        Offset& o = offset_[v];
        // Faces of one patch may have different orientations.
        const double side = dot(o.normal, face.normal) < 0 ? -1 : 1;
        o.normal = o.normal + side * face.normal;
        o.lost += side * face.lost;
        o.area += length(face.normal);
      }
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Mover mover_;
  unsigned threads_;
  std::vector<Face> faces_;
  std::vector<Offset> offset_;  ///< by vertex
};

}  // namespace

void balance_surfaces(Toolbox& tools, const RunContext& context) {
  if (tools.guard.exact()) return;
  BorderBalancer borders(tools);
  for (unsigned sweep = 0; sweep < n_sweeps && borders.sweep(context) > 0; ++sweep) {
  }
  VolumeBalancer volumes(tools, context.threads);
  for (unsigned sweep = 0; sweep < n_sweeps; ++sweep) {
    context.check_cancelled();
    volumes.sweep();
  }
}

}  // namespace geomesh::remesh
