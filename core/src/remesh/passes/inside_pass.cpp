// SPDX-License-Identifier: MIT
// Inserts points inside regions, advancing from their borders. Declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "remesh/domain/walled_mesh.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double spacing_ratio = refine_ratios.spacing;

/// Inserts points first at the ideal height above faces whose other side is finished: a constrained face, or one of a
/// cell that is small enough. This advancing front starts at the surfaces and moves inwards, so the points of a layer
/// fit those of the layer before (Rebay 1993; Frey, Borouchaki and George 1998). If such a point is refused, the
/// circumcentre is tried instead.
class InsideRefiner {
 public:
  InsideRefiner(Toolbox& tools, std::size_t max_cells) : tools_(tools), mesh_(tools.mesh), max_cells_(max_cells) {}

  std::size_t run(const RunContext& context) {
    std::vector<CellIndex> large = open(context.threads);
    std::size_t total = 0;
    bool is_flipped = false;
    while (!large.empty()) {
      const std::size_t n_front = pass(large, Kind::front, context);
      total += n_front;
      if (!is_flipped && n_front * refine_ratios.slow_front < large.size() && is_many(large.size())) {
        is_flipped = true;
        walled_->close(context.threads);
        flip_towards_delaunay(tools_, context);
        large = open(context.threads);
        continue;
      }
      if (n_front * refine_ratios.idle_front > large.size()) continue;
      const std::size_t n_centre = pass(large, Kind::centre_at_front, context);
      total += n_centre;
      if (n_front + n_centre > 0) continue;
      // The front of inserted points cannot advance, e.g. if sizes change over distances shorter than themselves. Cells
      // beyond the front are refined too, so that the space there does not remain empty.
      const std::size_t n_beyond = pass(large, Kind::centre_beyond, context);
      total += n_beyond;
      if (n_beyond == 0) break;
    }
    walled_->close(context.threads);
    tools_.statistics.points_inside += total;
    return total;
  }

 private:
  /// Kinds of places at which a pass inserts points: at the ideal height above the front, at circumcentres of cells at
  /// the front, or at circumcentres of cells beyond the front.
  enum class Kind : std::uint8_t { front, centre_at_front, centre_beyond };

  /// Number of a pass. It has only two bytes, because each cell stores three such numbers. Passes beyond the largest
  /// number share that number, so that cells are at worst tried more often than necessary.
  using PassNumber = std::uint16_t;
  static constexpr PassNumber last_pass = std::numeric_limits<PassNumber>::max();

  bool is_many(std::size_t n_large) const {
    return static_cast<double>(n_large) > refine_ratios.many_stuck * static_cast<double>(walled_->n_cells());
  }

  /// Opens the mesh for insertions and returns its large cells.
  std::vector<CellIndex> open(unsigned threads) {
    tools_.lengths.evaluate(threads);
    walled_.emplace(mesh_);
    tools_.lengths.set_size(static_cast<VertexIndex>(mesh_.n_vertices() - 1), 0);
    changed_.assign(mesh_.n_vertices(), 0);
    refused_ = {};
    for_each_index(walled_->n_slots(), thread_count(threads), [&](std::size_t c) {
      if (walled_->is_cell(static_cast<CellIndex>(c))) is_large(static_cast<CellIndex>(c));
    });
    return large_cells();
  }

  std::vector<CellIndex> large_cells() {
    std::vector<CellIndex> large;
    for (CellIndex c = 0; c < walled_->n_slots(); ++c)
      if (walled_->note(c) != small && walled_->is_cell(c) && is_large(c)) large.push_back(c);
    return large;
  }

  /// Returns whether a cell is too large for the target size. This is evaluated at the first call only, because most
  /// cells are replaced before it matters.
  bool is_large(CellIndex c) {
    if (walled_->note(c) == not_known) [[unlikely]]
      walled_->set_note(c, circumsphere(mesh_, c).radius <= refine_ratios.large_cell * size_of_cell(c) ? small : large);
    return walled_->note(c) == large;
  }
  double size_of_cell(CellIndex c) {
    const Tetrahedron& t = walled_->vertices(c);
    return 0.25 * (tools_.lengths.size_at(t[0]) + tools_.lengths.size_at(t[1]) + tools_.lengths.size_at(t[2]) +
                   tools_.lengths.size_at(t[3]));
  }

  /// Orders cells by target size, the smallest first, so that the front advances from fine to coarse, where points are
  /// seldom too close to others. The order is by classes of sizes, and within a class by slot, because cells created
  /// one after the other are close in space.
  void order_by_size(std::vector<CellIndex>& cells) {
    constexpr double classes_a_doubling = 4;
    std::vector<std::pair<int, CellIndex>> keyed;
    keyed.reserve(cells.size());
    for (const CellIndex c : cells)
      keyed.push_back({static_cast<int>(std::floor(classes_a_doubling * std::log2(size_of_cell(c)))), c});
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = keyed[k].second;
  }

  /// Visits each large cell once. Afterwards `large` lists the cells that are still large, including new ones.
  std::size_t pass(std::vector<CellIndex>& large, Kind kind, const RunContext& context) {
    if (pass_ < last_pass) ++pass_;
    order_by_size(large);
    std::size_t n = 0;
    for (std::size_t k = 0; k < large.size(); ++k) {
      if (k % 256 == 0) context.check_cancelled(), context.report(walled_->n_cells(), 0);
      const CellIndex c = large[k];
      if (!walled_->is_cell(c) || !is_large(c) || is_in_vain(refusal(kind, c), c)) continue;
      if (kind == Kind::front ? insert_on_front(c) : insert_at_centre(c, kind == Kind::centre_at_front)) {
        ++n;
        if (walled_->n_cells() > max_cells_) throw_too_many_cells(max_cells_);
      } else {
        refusal(kind, c) = pass_;
      }
    }
    large = large_cells();
    return n;
  }

  /// Returns the number of the last pass of the given kind that could place no point at the cell, or 0.
  PassNumber& refusal(Kind kind, CellIndex c) {
    std::vector<PassNumber>& refused = refused_[static_cast<std::size_t>(kind)];
    if (c >= refused.size()) refused.resize(walled_->n_slots() + walled_->n_slots() / 4, 0);
    return refused[c];
  }
  /// Returns whether it is in vain to try the cell again: no cell has been created at its vertices since the pass with
  /// the number `refused`, which could place no point.
  bool is_in_vain(PassNumber refused, CellIndex c) const {
    const Tetrahedron& t = walled_->vertices(c);
    return refused > 0 && std::all_of(t.begin(), t.end(), [&](VertexIndex v) { return changed_[v] < refused; });
  }

  /// Returns whether p is too close to a corner of c for any size at its corners. Does not evaluate the size at p.
  bool crowds_corner(const Vec3& p, CellIndex c) {
    const Tetrahedron& t = walled_->vertices(c);
    double h = std::numeric_limits<double>::infinity();
    for (const VertexIndex v : t) h = std::min(h, tools_.lengths.size_at(v));
    const double limit = spacing_ratio * spacing_ratio * h * h;
    return std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return squared_distance(mesh_.point(v), p) < limit; });
  }

  /// Returns the target size at p. If it is not below `at_most`, any value of at least `at_most` may be returned.
  double size_near(const Vec3& p, CellIndex c, double at_most = std::numeric_limits<double>::infinity()) {
    const VertexIndex v = mesh_.vertices(c)[0];
    return tools_.lengths.field().at_beside(p, mesh_.component(c), mesh_.point(v), tools_.lengths.size_at(v), at_most);
  }

  /// Returns whether a vertex of the cell is too near to p, estimated by the sizes at the vertices and how fast sizes
  /// may decrease. This decides most refusals without evaluating the size at p.
  bool surely_crowds(const Vec3& p, CellIndex c) {
    constexpr double rounding = 1 - 1e-9;
    const Tetrahedron& t = walled_->vertices(c);
    return std::any_of(t.begin(), t.end(), [&](VertexIndex v) {
      const double d = distance(mesh_.point(v), p);
      return d < rounding * spacing_ratio * (tools_.lengths.size_at(v) - steepest_ * d);
    });
  }

  /// Returns the smallest target size at p for which a vertex of the cell is too close to p.
  double crowded_size(const Vec3& p, CellIndex c) const {
    constexpr double rounding = 1 + 1e-9;
    double nearest = std::numeric_limits<double>::infinity();
    for (const VertexIndex v : walled_->vertices(c)) nearest = std::min(nearest, squared_distance(mesh_.point(v), p));
    return rounding / spacing_ratio * std::sqrt(nearest);
  }

  bool insert(const Vec3& p, CellIndex c) {
    if (crowds_corner(p, c)) return false;
    const std::optional<CellIndex> home = walled_->locate(p, c);
    if (!home || surely_crowds(p, *home)) return false;
    const double crowded = crowded_size(p, *home), h = size_near(p, c, crowded);
    if (h >= crowded) return false;
    const auto v = walled_->insert(p, *home, spacing_ratio * h);
    if (!v) return false;
    tools_.lengths.set_size(*v, h);
    changed_.push_back(pass_);
    for (const VertexIndex w : walled_->link()) changed_[w] = pass_;
    return true;
  }

  bool insert_on_front(CellIndex c) {
    const Vec3 centre = circumsphere(mesh_, c).centre;
    for (unsigned i = 0; i < 4; ++i) {
      if (!is_front(c, i)) continue;
      if (const auto p = ideal_apex(c, i, centre))
        if (insert(*p, c)) return true;
    }
    return false;
  }

  /// Returns whether face i of c is part of the front: constrained, or with a small enough cell on its other side.
  bool is_front(CellIndex c, unsigned i) { return walled_->is_wall(c, i) || !is_large(walled_->beyond(c, i)); }

  /// Returns the place above the circumcentre of face i at which the new edges have the target length (the mean of
  /// those at their ends), but not beyond the circumcentre of the cell, which is `centre`.
  std::optional<Vec3> ideal_apex(CellIndex c, unsigned i, const Vec3& centre) {
    const Triangle t = mesh_.face(c, i);
    const Vec3 n = mesh_.normal(t);
    const double nn = dot(n, n);
    if (!(nn > 0)) return std::nullopt;
    const Vec3 offset = offset_of_circumcentre(mesh_, t);
    const double h = tools_.lengths.size_of_face(t), r2 = dot(offset, offset);
    if (r2 > h * h) return std::nullopt;  // The face's circumradius exceeds the target size.
    const Vec3 base = mesh_.point(t[0]) + offset, normal = (1 / std::sqrt(nn)) * n;  // towards the cell
    const auto height_of = [&](double edge) {
      return std::sqrt(std::max(edge * edge - r2, refine_ratios.least_height * edge * edge));
    };
    const double to_centre = dot(centre - base, normal);
    double height = height_of(h);
    if (to_centre > height && !crowds_corner(base + height * normal, c))
      height = height_of(0.5 * (h + std::max(h, size_near(base + height * normal, c))));
    return base + std::min(height, std::max(to_centre, refine_ratios.least_way * height)) * normal;
  }

  bool is_on_front(CellIndex c) { return is_front(c, 0) || is_front(c, 1) || is_front(c, 2) || is_front(c, 3); }

  /// Inserts a point at the circumcentre or centroid of a cell at the advancing front or beyond it. Points beyond the
  /// front are tried only when it cannot advance, because it would reach them later at an unsuitable distance.
  bool insert_at_centre(CellIndex c, bool at_front) {
    if (is_on_front(c) != at_front) return false;
    const Sphere s = circumsphere(mesh_, c);
    return s.radius < 1e300 && (insert(s.centre, c) || insert(mesh_.middle(walled_->vertices(c)), c));
  }

  /// Values stored for a cell as WalledMesh::note: whether the cell is larger than its target size.
  enum Note : unsigned { not_known, small, large };

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::size_t max_cells_;
  const double steepest_ = tools_.lengths.field().steepest();
  std::optional<WalledMesh> walled_;
  PassNumber pass_ = 0;
  std::vector<PassNumber> changed_;  // for each vertex, the number of the last pass that created a cell at it
  std::array<std::vector<PassNumber>, 3> refused_;
};

}  // namespace

std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context) {
  return InsideRefiner(tools, max_cells).run(context);
}

}  // namespace geomesh::remesh
