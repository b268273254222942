// SPDX-License-Identifier: MIT
// Inserts points on surfaces, advancing from curves. Declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double long_squared = refine_ratios.long_edge * refine_ratios.long_edge;

/// A constrained face, stored by its vertices so that it can be found again after other operations.
struct SurfaceItem {
  FaceRef face;
  Triangle corners;
  /// For each kind of pass, the time at which the last pass began that could place no point on this face.
  std::array<std::uint64_t, 2> refused{};
};

/// Inserts points on surfaces by an advancing front, as refine_inside does in the interior: points are placed in the
/// plane of a face, at the ideal height above edges that are short enough.
class SurfaceRefiner {
  enum class Kind : std::uint8_t { centre, front };

 public:
  SurfaceRefiner(Toolbox& tools, std::size_t max_cells) : tools_(tools), mesh_(tools.mesh), max_cells_(max_cells) {}

  std::size_t run(const RunContext& context) {
    std::vector<SurfaceItem> large;
    for (const CellIndex c : mesh_.live_cells()) append_large(c, large);
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
  bool is_current(const SurfaceItem& s) const {
    return mesh_.is_live(s.face.cell()) && mesh_.tag(s.face).constrained() && mesh_.face(s.face) == s.corners;
  }
  void append_large(CellIndex c, std::vector<SurfaceItem>& large) {
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef f(c, i);
      if (mesh_.is_surface(f) && mesh_.tag(f).facet() != hull_facet && is_large(mesh_.face(f)))
        large.push_back({f, mesh_.face(f)});
    }
  }

  /// Returns whether the circumradius of a face is too large and at least one of its edges is clearly longer than its
  /// target size. Slim faces between short edges are left to other passes.
  bool is_large(const Triangle& t) {
    const double h = tools_.lengths.size_of_face(t);
    double longest = 0;
    for (unsigned k = 0; k < 3; ++k)
      longest = std::max(longest, squared_distance(mesh_.point(t[k]), mesh_.point(t[(k + 1) % 3])));
    return longest > long_squared * h * h &&
           !(length(offset_of_circumcentre(mesh_, t)) <= refine_ratios.large_face * h);
  }

  std::size_t pass(std::vector<SurfaceItem>& large, Kind kind, const RunContext& context) {
    std::vector<SurfaceItem> next;
    std::size_t n = 0;
    const std::uint64_t start = mesh_.tick();
    for (std::size_t k = 0; k < large.size(); ++k) {
      if (k % 256 == 0) context.check_cancelled(), context.report(mesh_.n_cells(), 0);
      SurfaceItem s = large[k];
      if (!is_current(s)) continue;
      std::uint64_t& refused = s.refused[static_cast<std::size_t>(kind)];
      const bool is_in_vain = refused > 0 && !changed_since(mesh_, s.corners, refused);
      if (is_in_vain || !(kind == Kind::front ? insert_on_front(s) : insert_at_centre(s))) {
        if (!is_in_vain) refused = start;
        next.push_back(s);
        continue;
      }
      ++n;
      if (mesh_.n_cells() > max_cells_) throw_too_many_cells(max_cells_);
      for (const CellIndex c : tools_.work.created) append_large(c, next);
    }
    std::erase_if(next, [&](const SurfaceItem& s) { return !is_current(s); });
    large = std::move(next);
    return n;
  }

  std::optional<VertexIndex> insert(const Vec3& p, const SurfaceItem& s) {
    const LocalLength size = tools_.lengths.at(p, mesh_.component(s.face.cell()));
    return insert_on_surface(tools_, p, s.face, {refine_ratios.spacing * size, refine_ratios.surface_shape});
  }

  /// Inserts a point at the ideal height above a front edge, one of at most 1.2 times its target size.
  std::optional<VertexIndex> insert_on_front(const SurfaceItem& s) {
    const Triangle& t = s.corners;
    const Vec3 n = mesh_.normal(t);
    const Vec3 centre = mesh_.point(t[0]) + offset_of_circumcentre(mesh_, t);
    for (unsigned k = 0; k < 3; ++k) {
      const Vec3 &a = mesh_.point(t[k]), &b = mesh_.point(t[(k + 1) % 3]), middle = 0.5 * (a + b),
                 inward = cross(n, b - a);
      const double h = tools_.lengths.absolute(t[k], t[(k + 1) % 3], 1), half = 0.25 * squared_distance(a, b),
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
    const Vec3 centre = mesh_.point(t[0]) + offset_of_circumcentre(mesh_, t);
    if (dot(centre, centre) < std::numeric_limits<double>::infinity())
      if (const auto v = insert(centre, s)) return v;
    return insert(mesh_.middle(t), s);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::size_t max_cells_;
};

}  // namespace

std::size_t refine_surfaces(Toolbox& tools, std::size_t max_cells, const RunContext& context) {
  return SurfaceRefiner(tools, max_cells).run(context);
}

}  // namespace geomesh::remesh
