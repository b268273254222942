// SPDX-License-Identifier: MIT
// Points on surfaces, front by front, declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <cmath>

#include "quality/measure/shape.hpp"
#include "remesh/domain/change_stamps.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double long_squared = refine_ratios.long_edge * refine_ratios.long_edge;

/// A constrained face, to be recognised after other operations.
struct SurfaceItem {
  FaceRef face;
  Triangle corners;
  std::array<unsigned, 2>
      refused{};  ///< by kind of pass: the number of the last one that placed no point here; 0: none
};

/// The front of `refine_inside` one dimension down: points at the ideal height over edges that are done, in the plane
/// of a face.
class SurfaceRefiner {
  /// Where points are placed in a pass.
  enum class Kind : std::uint8_t { centre, front };

 public:
  SurfaceRefiner(Toolbox& tools, std::size_t max_cells) : tools_(tools), mesh_(tools.mesh), max_cells_(max_cells) {}

  std::size_t run(const RunContext& context) {
    std::vector<SurfaceItem> large;
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
      if (mesh_.is_live(c)) append_large(c, large);
    std::size_t total = 0;
    while (!large.empty()) {
      const std::size_t n_front = pass(large, Kind::front, context);
      total += n_front;
      if (n_front > 0) continue;
      const std::size_t n_centre = pass(large, Kind::centre, context);
      total += n_centre;
      if (n_front + n_centre == 0) break;
    }
    return total;
  }

 private:
  Triangle corners(FaceRef f) const {
    const Tetrahedron& t = mesh_.vertices(f.cell());
    return {t[face_vertices[f.face()][0]], t[face_vertices[f.face()][1]], t[face_vertices[f.face()][2]]};
  }
  bool is_current(const SurfaceItem& s) const {
    return mesh_.is_live(s.face.cell()) && mesh_.tag(s.face.cell(), s.face.face()).constrained() &&
           corners(s.face) == s.corners;
  }
  /// A face with two cells is taken from above.
  void append_large(CellIndex c, std::vector<SurfaceItem>& large) {
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag t = mesh_.tag(c, i);
      if (!t.constrained() || t.facet() == hull_facet || (!t.above() && mesh_.has_neighbor(c, i))) continue;
      const SurfaceItem s{FaceRef(c, i), corners(FaceRef(c, i)), {}};
      if (is_large(s.corners)) large.push_back(s);
    }
  }

  double size_of(const Triangle& t) { return (tools_.size_at(t[0]) + tools_.size_at(t[1]) + tools_.size_at(t[2])) / 3; }
  Vec3 offset_of_centre(const Triangle& t) const {
    const Vec3 &a = mesh_.point(t[0]), u = mesh_.point(t[1]) - a, v = mesh_.point(t[2]) - a, n = cross(u, v);
    return (0.5 / dot(n, n)) * (dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u));
  }
  /// By its circumradius, and at least one edge clearly longer than asked: slim faces between short edges are left to
  /// others.
  bool is_large(const Triangle& t) {
    const double h = size_of(t);
    double longest = 0;
    for (unsigned k = 0; k < 3; ++k)
      longest = std::max(longest, squared_distance(mesh_.point(t[k]), mesh_.point(t[(k + 1) % 3])));
    return longest > long_squared * h * h && !(length(offset_of_centre(t)) <= refine_ratios.large_face * h);
  }

  std::size_t pass(std::vector<SurfaceItem>& large, Kind kind, const RunContext& context) {
    std::vector<SurfaceItem> next;
    std::size_t n = 0;
    const unsigned number = changes_.begin_pass();
    for (std::size_t k = 0; k < large.size(); ++k) {
      if (k % 256 == 0) context.check_cancelled();
      SurfaceItem s = large[k];
      if (!is_current(s)) continue;
      unsigned& refused = s.refused[static_cast<std::size_t>(kind)];
      if (refused > 0 && !changes_.changed(s.corners, refused)) {
        next.push_back(s);
        continue;
      }
      const auto v = kind == Kind::front ? insert_on_front(s) : insert_at_centre(s);
      if (!v) {
        refused = number;
        next.push_back(s);
        continue;
      }
      ++n;
      changes_.note(mesh_, tools_.work.created);
      if (mesh_.n_cells() > max_cells_) throw_too_many_cells(max_cells_);
      for (const CellIndex c : tools_.work.created) append_large(c, next);
    }
    std::erase_if(next, [&](const SurfaceItem& s) { return !is_current(s); });
    large = std::move(next);
    return n;
  }

  std::optional<VertexIndex> insert(const Vec3& p, const SurfaceItem& s) {
    const double h = tools_.size.at(p, mesh_.component(s.face.cell()));
    return insert_on_surface(tools_, p, s.face, {refine_ratios.spacing * h, refine_ratios.surface_shape});
  }

  /// An edge is done where it is a curve or not longer than 1.2 times its size.
  std::optional<VertexIndex> insert_on_front(const SurfaceItem& s) {
    const Triangle& t = s.corners;
    const Vec3 n = cross(mesh_.point(t[1]) - mesh_.point(t[0]), mesh_.point(t[2]) - mesh_.point(t[0]));
    const Vec3 centre = mesh_.point(t[0]) + offset_of_centre(t);
    for (unsigned k = 0; k < 3; ++k) {
      const Vec3 &a = mesh_.point(t[k]), &b = mesh_.point(t[(k + 1) % 3]), middle = 0.5 * (a + b),
                 inward = cross(n, b - a);
      const double h = tools_.size_of_edge(t[k], t[(k + 1) % 3]), half = 0.25 * squared_distance(a, b),
                   l = length(inward);
      if (!(l > 0) || 4 * half > long_squared * h * h) continue;
      const Vec3 direction = (1 / l) * inward;
      const double height = std::sqrt(std::max(h * h - half, refine_ratios.least_height * h * h)),
                   to_centre = dot(centre - middle, direction);
      if (const auto v =
              insert(middle + std::min(height, std::max(to_centre, refine_ratios.least_way * height)) * direction, s))
        return v;
    }
    return std::nullopt;
  }

  std::optional<VertexIndex> insert_at_centre(const SurfaceItem& s) {
    const Triangle& t = s.corners;
    const Vec3 centre = mesh_.point(t[0]) + offset_of_centre(t);
    if (dot(centre, centre) < std::numeric_limits<double>::infinity())
      if (const auto v = insert(centre, s)) return v;
    return insert((1.0 / 3) * (mesh_.point(t[0]) + mesh_.point(t[1]) + mesh_.point(t[2])), s);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::size_t max_cells_;
  ChangeStamps changes_;
};

}  // namespace

std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context) {
  return SurfaceRefiner(tools, max_cells).run(context);
}

}  // namespace geomesh::remesh
