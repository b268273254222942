// SPDX-License-Identifier: MIT
// Flips faces and surface edges towards Delaunay. Declared in remesh/operations/surface_repair.hpp.
#include <algorithm>
#include <optional>

#include "common/parallel.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

namespace {

/// Flips faces that are not locally Delaunay (Lawson 1986; Joe 1989). Constrained faces are not changed.
class DelaunayFlipper {
 public:
  DelaunayFlipper(Toolbox& tools, std::optional<std::uint64_t> since)
      : tools_(tools), mesh_(tools.mesh), since_(since) {}

  std::size_t run(const RunContext& context) {
    push_all(thread_count(context.threads));
    std::size_t n = 0;
    for (std::size_t k = 0; k < stack_.size(); ++k) {
      if (k % 4096 == 0) context.check_cancelled();
      const auto [c, vertices] = stack_[k];
      if (!mesh_.is_live(c) || mesh_.vertices(c) != vertices) continue;
      if (flip_one_of(c)) {
        ++n;
        for (const CellIndex created : tools_.work.created) push(created);
      }
      if (n > 8 * mesh_.n_cells()) break;  // limit for flips, which could undo each other for ever because of rounding
    }
    return n;
  }

 private:
  void push(CellIndex c) {
    if (mesh_.is_live(c)) stack_.push_back({c, mesh_.vertices(c)});
  }

  /// Collects the cells with a face that is not locally Delaunay, in parallel. Usually there are few such cells.
  void push_all(unsigned threads) {
    constexpr std::size_t chunk = 16384;
    std::vector<std::vector<CellIndex>> asked((mesh_.n_slots() + chunk - 1) / chunk);
    for_each_task(asked.size(), threads, [&](std::size_t k) {
      const auto end = static_cast<CellIndex>(std::min<std::size_t>(mesh_.n_slots(), (k + 1) * chunk));
      for (auto c = static_cast<CellIndex>(k * chunk); c < end; ++c)
        if (mesh_.is_live(c) && may_have_changed(c) &&
            any_face_to_flip(c, [](unsigned, FaceRef, VertexIndex) { return true; }))
          asked[k].push_back(c);
    });
    for (const std::vector<CellIndex>& cells : asked)
      for (const CellIndex c : cells) push(c);
  }

  bool may_have_changed(CellIndex c) const { return !since_ || changed_since(mesh_, mesh_.vertices(c), *since_); }

  /// Calls flip(i, neighbouring face, apex of the neighbouring cell) for each face i that is not locally Delaunay,
  /// until a call returns true. Returns whether one did.
  template <class Flip>
  bool any_face_to_flip(CellIndex c, const Flip& flip) const {
    const Sphere s = circumsphere(mesh_, c);
    const double r2 = s.radius * s.radius * (1 - 1e-9);
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh_.tag(c, i).constrained()) continue;
      const FaceRef n = mesh_.cells().neighbor(c, i);
      const VertexIndex apex = mesh_.vertices(n.cell())[n.face()];
      if (squared_distance(s.centre, mesh_.point(apex)) < r2 && flip(i, n, apex)) return true;
    }
    return false;
  }

  bool flip_one_of(CellIndex c) {
    return any_face_to_flip(
        c, [&](unsigned i, FaceRef n, VertexIndex apex) { return flip23(c, i, n, apex) || flip32(c, i, apex); });
  }

  bool flip23(CellIndex c, unsigned i, FaceRef n, VertexIndex bottom) {
    const Triangle f = mesh_.face(c, i);
    auto& added = tools_.work.added;
    added.clear();
    for (unsigned k = 0; k < 3; ++k) {
      added.push_back({{f[k], f[(k + 1) % 3], bottom, mesh_.vertices(c)[i]}, mesh_.component(c), {}});
      if (!mesh_.is_positive(added.back().vertices)) return false;
    }
    const std::array<CellIndex, 2> removed{c, n.cell()};
    mesh_.replace(removed, added, tools_.work.created);
    return true;
  }

  /// Flips an edge of the face that has exactly three cells: the two at the face, and one with both of their apexes.
  bool flip32(CellIndex c, unsigned i, VertexIndex bottom) {
    const Triangle f = mesh_.face(c, i);
    for (unsigned k = 0; k < 3; ++k) {
      const VertexIndex a = f[k], b = f[(k + 1) % 3];
      if (mesh_.curve_of(a, b) != no_index) continue;
      auto& cells = tools_.work.cells;
      auto& r = tools_.work.ring;
      if (!turn_about_edge(mesh_.cells(), c, a, b, cells, r) || cells.size() != 3 ||
          constrained_faces_of_ring(mesh_, cells, r, true).n > 0 || std::ranges::count(r, bottom) == 0)
        continue;
      const Tetrahedron upper{r[0], r[1], r[2], b}, lower{r[2], r[1], r[0], a};
      if (!mesh_.is_positive(upper) || !mesh_.is_positive(lower)) continue;
      tools_.work.added = {{upper, mesh_.component(c), {}}, {lower, mesh_.component(c), {}}};
      mesh_.replace(cells, tools_.work.added, tools_.work.created);
      return true;
    }
    return false;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::optional<std::uint64_t> since_;
  std::vector<std::pair<CellIndex, Tetrahedron>> stack_;
};

}  // namespace

std::size_t flip_towards_delaunay(Toolbox& tools, const RunContext& context, std::optional<std::uint64_t> since) {
  return DelaunayFlipper(tools, since).run(context);
}

}  // namespace geomesh::remesh
