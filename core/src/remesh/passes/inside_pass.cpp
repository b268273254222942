// SPDX-License-Identifier: MIT
// Inserts points inside regions, advancing from their borders. Declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "common/sort_unique.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double spacing_ratio = refine_ratios.spacing;

/// Points are first placed at the ideal height above faces whose other side is finished: a constrained face, or one of
/// a cell that is small enough. This advancing front starts at the surfaces and moves inwards, so the points of a layer
/// fit those of the layer before (Rebay 1993; Frey, Borouchaki and George 1998). If such a point is refused, the
/// circumcentre is tried instead.
class InsideRefiner {
 public:
  InsideRefiner(Toolbox& tools, std::size_t max_cells, Insertions expected)
      : tools_(tools), mesh_(tools.mesh), max_cells_(max_cells), keeps_spheres_(expected == Insertions::many) {}

  std::size_t run(const RunContext& context) {
    mesh_.sort_cells(context.threads);
    std::vector<CellIndex> large = measure_all(context.threads);
    std::size_t total = 0;
    bool is_flipped = false;
    while (!large.empty()) {
      const std::size_t n_front = pass(large, Kind::front, context);
      total += n_front;
      if (!is_flipped && n_front * refine_ratios.slow_front < large.size() && is_many(large.size())) {
        is_flipped = true;
        flip_towards_delaunay(tools_, context);
        large = measure_all(context.threads);
        continue;
      }
      if (n_front * refine_ratios.idle_front > large.size()) continue;
      const std::size_t n_centre = pass(large, Kind::centre_at_front, context);
      total += n_centre;
      if (n_front + n_centre > 0) continue;
      // The front cannot advance, for example if sizes change over distances shorter than themselves. Cells beyond it
      // are refined too, so that the space there does not stay empty.
      const std::size_t n_beyond = pass(large, Kind::centre_beyond, context);
      total += n_beyond;
      if (n_beyond == 0) break;
    }
    return total;
  }

 private:
  /// Kinds of places that a pass tries: at the ideal height above the front, at circumcentres of cells at the front, or
  /// at those of cells beyond it.
  enum class Kind : std::uint8_t { front, centre_at_front, centre_beyond };

  /// Two bytes suffice, and each cell stores three of these numbers. Passes beyond the largest number share it and the
  /// start of the first of them, so that cells are only tried more often than necessary.
  using PassNumber = std::uint16_t;
  static constexpr std::size_t last_pass = std::numeric_limits<PassNumber>::max();

  bool is_many(std::size_t n_large) const {
    return static_cast<double>(n_large) > refine_ratios.many_stuck * static_cast<double>(mesh_.n_cells());
  }

  /// Returns the large cells.
  std::vector<CellIndex> measure_all(unsigned threads) {
    tools_.lengths.evaluate(threads);
    make_room();
    for_each_index(mesh_.n_slots(), thread_count(threads), [&](std::size_t c) {
      if (mesh_.is_live(static_cast<CellIndex>(c))) measure(static_cast<CellIndex>(c));
    });
    std::vector<CellIndex> large;
    for (const CellIndex c : mesh_.live_cells())
      if (is_large(c)) large.push_back(c);
    refused_ = {};
    return large;
  }

  void make_room() {
    if (keeps_spheres_) spheres_.grow_to(mesh_.n_slots());
    large_.grow_to(mesh_.n_slots());
  }
  /// Evaluates whether a cell is large. Must be called for each new cell, once there is room for all cells.
  void measure(CellIndex c) {
    const Sphere s = circumsphere(mesh_, c);
    if (keeps_spheres_) spheres_[c] = s;
    large_[c] = !(s.radius <= refine_ratios.large_cell * tools_.lengths.size_of_cell(c));
  }
  Sphere sphere_of(CellIndex c) const { return keeps_spheres_ ? spheres_[c] : circumsphere(mesh_, c); }
  bool is_large(CellIndex c) const { return large_[c]; }

  /// Small sizes come first, so that the front advances from fine to coarse, where points are seldom too near to
  /// others. Cells are ordered by classes of sizes, and within a class by slot, since cells created one after the other
  /// are near in space.
  void order_by_size(std::vector<CellIndex>& cells) {
    constexpr double classes_a_doubling = 4;
    std::vector<std::pair<int, CellIndex>> keyed;
    keyed.reserve(cells.size());
    for (const CellIndex c : cells)
      keyed.push_back(
          {static_cast<int>(std::floor(classes_a_doubling * std::log2(tools_.lengths.size_of_cell(c)))), c});
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = keyed[k].second;
  }

  /// Visits each large cell once. Afterwards `large` lists the cells that are still large, including new ones.
  std::size_t pass(std::vector<CellIndex>& large, Kind kind, const RunContext& context) {
    const auto number = static_cast<PassNumber>(std::min<std::size_t>(starts_.size(), last_pass));
    const std::uint64_t start = mesh_.tick();
    if (number == starts_.size()) starts_.push_back(start);
    order_by_size(large);
    std::vector<CellIndex> next;
    std::size_t n = 0;
    for (std::size_t k = 0; k < large.size(); ++k) {
      if (k % 256 == 0) context.check_cancelled(), context.report(mesh_.n_cells(), 0);
      const CellIndex c = large[k];
      if (!mesh_.is_live(c) || !is_large(c)) continue;
      PassNumber& refused = refusal(kind, c);
      const bool is_in_vain = refused > 0 && !changed_since(mesh_, mesh_.vertices(c), starts_[refused]);
      if (is_in_vain ||
          !(kind == Kind::front ? insert_on_front(c) : insert_at_centre(c, kind == Kind::centre_at_front))) {
        if (!is_in_vain) refused = number;
        next.push_back(c);
        continue;
      }
      ++n;
      make_room();
      for (const CellIndex made : tools_.work.created) measure(made);
      if (mesh_.n_cells() > max_cells_) throw_too_many_cells(max_cells_);
      next.insert(next.end(), tools_.work.created.begin(), tools_.work.created.end());
    }
    std::erase_if(next, [&](CellIndex c) { return !mesh_.is_live(c) || !is_large(c); });
    sort_unique(next);
    large = std::move(next);
    return n;
  }

  /// For each kind of pass and each cell, the last pass that placed no point there, or 0 if none. The cell is tried
  /// again if cells were created at one of its vertices since that pass began, or if its slot was reused.
  PassNumber& refusal(Kind kind, CellIndex c) {
    std::vector<PassNumber>& refused = refused_[static_cast<std::size_t>(kind)];
    if (c >= refused.size()) refused.resize(mesh_.n_slots() + mesh_.n_slots() / 4, 0);
    return refused[c];
  }

  /// Returns whether p is nearer to a corner of the cell than any size at its corners would allow. Avoids evaluating
  /// the size at p.
  bool crowds_corner(const Vec3& p, CellIndex c) {
    const Tetrahedron& t = mesh_.vertices(c);
    double h = std::numeric_limits<double>::infinity();
    for (const VertexIndex v : t) h = std::min(h, tools_.lengths.size_at(v));
    const double limit = spacing_ratio * spacing_ratio * h * h;
    return std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return squared_distance(mesh_.point(v), p) < limit; });
  }

  /// The smaller one of the size at p and `at_most`.
  double size_near(const Vec3& p, CellIndex c, double at_most = std::numeric_limits<double>::infinity()) {
    const VertexIndex v = mesh_.vertices(c)[0];
    return tools_.lengths.field().at_beside(p, mesh_.component(c), mesh_.point(v), tools_.lengths.size_at(v), at_most);
  }

  /// Returns whether a vertex of the cell is too near to p, estimated by the sizes at the vertices and how fast sizes
  /// may decrease. This decides most refusals without evaluating the size at p.
  bool surely_crowds(const Vec3& p, CellIndex c) {
    constexpr double rounding = 1 - 1e-9;
    const Tetrahedron& t = mesh_.vertices(c);
    return std::any_of(t.begin(), t.end(), [&](VertexIndex v) {
      const double d = distance(mesh_.point(v), p);
      return d < rounding * spacing_ratio * (tools_.lengths.size_at(v) - steepest_ * d);
    });
  }

  /// The smallest size at p for which a vertex of the cell is too near.
  double crowded_size(const Vec3& p, CellIndex c) const {
    constexpr double rounding = 1 + 1e-9;
    double nearest = std::numeric_limits<double>::infinity();
    for (const VertexIndex v : mesh_.vertices(c)) nearest = std::min(nearest, squared_distance(mesh_.point(v), p));
    return rounding / spacing_ratio * std::sqrt(nearest);
  }

  std::optional<VertexIndex> insert(const Vec3& p, CellIndex c) {
    if (crowds_corner(p, c)) return std::nullopt;
    const std::optional<CellIndex> home = locate(mesh_, p, c);
    if (!home || surely_crowds(p, *home)) return std::nullopt;
    const double crowded = crowded_size(p, *home), h = size_near(p, c, crowded);
    if (h >= crowded) return std::nullopt;
    const auto v = insert_in_cell(
        tools_, p, *home,
        {LocalLength(spacing_ratio * h), refine_ratios.inside_shape, keeps_spheres_ ? &spheres_ : nullptr});
    if (v) tools_.lengths.set_size(*v, h);
    return v;
  }

  std::optional<VertexIndex> insert_on_front(CellIndex c) {
    const Vec3 centre = sphere_of(c).centre;
    for (unsigned i = 0; i < 4; ++i) {
      const bool constrained = mesh_.tag(c, i).constrained();
      if (!constrained && is_large(mesh_.cells().neighbor_cell(c, i))) continue;
      if (const auto p = ideal_apex(c, i, centre))
        if (const auto v = insert(*p, c)) return v;
    }
    return std::nullopt;
  }

  /// Returns the place above the circumcentre of face i at which the new edges have the target length (the mean of
  /// those at their ends), but not beyond the circumcentre of the cell, which is `centre`.
  std::optional<Vec3> ideal_apex(CellIndex c, unsigned i, const Vec3& centre) {
    const Triangle t = mesh_.face(c, i);
    const Vec3 n = mesh_.normal(t);
    const double nn = dot(n, n);
    if (!(nn > 0)) return std::nullopt;
    const Vec3 offset = offset_of_circumcentre(mesh_, t);
    const double h = tools_.lengths.size_of_face(t), r2 = dot(offset, offset);
    if (r2 > h * h) return std::nullopt;                                             // The face itself is too large.
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

  bool is_on_front(CellIndex c) {
    for (unsigned i = 0; i < 4; ++i)
      if (mesh_.tag(c, i).constrained() || !is_large(mesh_.cells().neighbor_cell(c, i))) return true;
    return false;
  }

  /// As long as the front advances, only cells at the front get points. The front would reach points beyond it later,
  /// at an unsuitable distance.
  std::optional<VertexIndex> insert_at_centre(CellIndex c, bool at_front) {
    if (is_on_front(c) != at_front) return std::nullopt;
    const Sphere s = sphere_of(c);
    if (!(s.radius < 1e300)) return std::nullopt;
    if (const auto v = insert(s.centre, c)) return v;
    return insert(mesh_.middle(mesh_.vertices(c)), c);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::size_t max_cells_;
  const double steepest_ = tools_.lengths.field().steepest();
  std::vector<std::uint64_t> starts_{0};  // the mesh's time at the start of each pass; passes count from 1
  bool keeps_spheres_;                    // if many points are inserted, the sphere of each cell is needed repeatedly
  PodArray<Sphere> spheres_;              // sphere of each cell, if kept
  PodArray<std::uint8_t> large_;          // for each cell, whether its circumradius exceeds the target size
  std::array<std::vector<PassNumber>, 3> refused_;
};

}  // namespace

std::size_t refine_inside(Toolbox& tools, std::size_t max_cells, const RunContext& context, Insertions expected) {
  return InsideRefiner(tools, max_cells, expected).run(context);
}

}  // namespace geomesh::remesh
