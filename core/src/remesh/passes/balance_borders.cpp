// SPDX-License-Identifier: MIT
// Borders that enclose the area of the input, declared in remesh/passes/improve_passes.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

namespace {

/// Samples of a chord at which its distance from the input's border is measured. The sum over them is exact for
/// parabolas up to 1 %.
constexpr unsigned n_samples = 8;
/// Each sweep leaves the area that corners, which never move, cannot make up for, to their neighbours.
constexpr unsigned n_sweeps = 3;

class BorderBalancer {
 public:
  explicit BorderBalancer(Toolbox& tools) : tools_(tools), mesh_(tools.mesh) {
    double worst = 1;
    for (const CellIndex c : mesh_.live_cells()) worst = std::min(worst, mesh_.shape_of(c));
    floor_ = std::max(worst, mesh_.measure().bad());
  }

  std::size_t sweep(const RunContext& context) {
    std::size_t n = 0;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v) {
      if (v % 4096 == 0) context.check_cancelled();
      n += is_on_free_border(v) && balance(v);
    }
    return n;
  }

 private:
  bool is_on_free_border(VertexIndex v) const {
    return mesh_.kind(v) == VertexKind::curve && mesh_.curve_class(mesh_.support(v)).patches.size() == 1;
  }

  /// The direction in the plane of the only face at the chord that leads out of the surface, of unit length; zero where
  /// the face is none or has no area.
  Vec3 outward(VertexIndex v, VertexIndex other) const {
    for (const Spoke& s : cavity_.spokes) {
      if (s.a != other && s.b != other) continue;
      const Vec3 &p = mesh_.point(v), along = unit(mesh_.point(other) - p);
      const Vec3 in = mesh_.point(s.a == other ? s.b : s.a) - p;
      return unit(dot(in, along) * along - in);
    }
    return {};
  }

  /// The area between a chord and the input's border: positive where the border lies outside of the chord.
  double area_lost(const Vec3& a, const Vec3& b, Index curve, const Vec3& out) const {
    double sum = 0;
    for (unsigned k = 0; k < n_samples; ++k) {
      const double t = (k + 0.5) / n_samples;
      const Vec3 p = (1 - t) * a + t * b;
      sum += dot(tools_.guard.project_to_curve(curve, p) - p, out);
    }
    return sum / n_samples * distance(a, b);
  }

  /// Moves v outwards, or inwards, until the two chords at it have made up for half of the area that each lost.
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
    const Vec3 p = old + (lost / length_of_both) * unit(out);
    return may_move(p, old) && move(v, p);
  }

  bool may_move(const Vec3& p, const Vec3& old) {
    if (!std::isfinite(p.x + p.y + p.z) || p == old || !star_is_positive(mesh_, cavity_, p)) return false;
    const double needed = (1 - 1e-9) * std::min(removed_shape(mesh_, cavity_), floor_);
    return star_shape(mesh_, cavity_, p, needed) > needed && !tools_.spoils(cavity_, p) &&
           tools_.guard.admits(surface_of(mesh_, cavity_, old), surface_of(mesh_, cavity_, p));
  }

  bool move(VertexIndex v, const Vec3& p) {
    mesh_.move_vertex(v, p);
    for (const CellIndex c : cavity_.cells) mesh_.refresh_shape(c);
    tools_.forget_size(v);
    return true;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  StarCavity cavity_;
  double floor_ = 0;  ///< the least shape of all cells before, or that of a bad cell if there were worse ones
};

}  // namespace

void balance_borders(Toolbox& tools, const RunContext& context) {
  if (tools.guard.exact()) return;
  BorderBalancer balancer(tools);
  for (unsigned sweep = 0; sweep < n_sweeps; ++sweep)
    if (balancer.sweep(context) == 0) return;
}

}  // namespace geomesh::remesh
