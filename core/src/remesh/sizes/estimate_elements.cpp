// SPDX-License-Identifier: MIT
// The number of elements before the work, declared in geomesh/core/refine.hpp and remesh/sizes/sizes.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>

#include "common/geometry.hpp"
#include "geomesh/core/error.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Parts of the model are halved until sizes are nearly even in each.
class Evenness {
 public:
  explicit Evenness(const SizeField& size)
      : growth_(std::isfinite(size.steepest()) ? size.steepest() : std::max(size.limits().gradation, usual_growth)) {}
  bool holds(double length, double size_at_centre) const { return even_share * growth_ * length <= size_at_centre; }

 private:
  static constexpr double usual_growth = 0.5, even_share = 1;
  double growth_;
};

constexpr unsigned greatest_depth = 100;

/// From the size at one place those at places about it are found sooner.
struct KnownSize {
  Vec3 place;
  double size;
  KnownSize at(const Vec3& p, Index component, const SizeField& field) const {
    return {p, field.at_beside(p, component, place, size)};
  }
};

/// A cell with what it takes to tell what it reaches into, computed once: there are many more cubes than cells.
class CellReach {
 public:
  CellReach(const DomainMesh& mesh, CellIndex c) : component_(mesh.component(c)) {
    for (const Vec3& p : mesh.places(mesh.vertices(c))) box_.add(p);
    for (unsigned i = 0; i < 4; ++i) {
      const Triangle f = mesh.face(c, i);
      const Vec3 n = mesh.normal(f);
      faces_[i] = {mesh.point(f[0]), n, std::abs(n.x) + std::abs(n.y) + std::abs(n.z)};
    }
  }

  const Box3& box() const { return box_; }
  Index component() const { return component_; }

  /// False only where cell and cube have nothing in common.
  bool may_reach(const Vec3& centre, double half) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (box_.min[axis] > centre[axis] + half || box_.max[axis] < centre[axis] - half) return false;
    return reaches(centre, half);
  }

  /// Whether no plane of a face has the whole cube about p on its other side; with a half side of 0 whether p is in the
  /// cell.
  bool reaches(const Vec3& p, double half) const {
    return std::none_of(faces_.begin(), faces_.end(),
                        [&](const Face& f) { return dot(f.inward, p - f.corner) + half * f.spread < 0; });
  }

 private:
  struct Face {
    Vec3 corner, inward;
    double spread;  ///< of a cube's half side, along the normal
  };
  Box3 box_;
  std::array<Face, 4> faces_;
  Index component_;
};

/// Integral over the mesh of 1 / size^3, by cubes that are cut in eighths: the mesh's cells may be long, with sizes at
/// their ends that differ by orders of magnitude. A cube hands the cells that reach into it on to its eighths.
class VolumeOverSizes {
 public:
  VolumeOverSizes(const DomainMesh& mesh, const SizeField& size, double enough)
      : size_(size), enough_(enough), evenness_(size) {
    cells_.reserve(mesh.n_cells());
    for (const CellIndex c : mesh.live_cells()) cells_.emplace_back(mesh, c);
  }

  double run() {
    if (cells_.empty()) return 0;
    Box3 box;
    for (const CellReach& c : cells_) box.add(c.box().min), box.add(c.box().max);
    std::vector<Index> all(cells_.size());
    std::iota(all.begin(), all.end(), 0);
    const Vec3 extent = box.max - box.min;
    const Cube whole{0.5 * (box.min + box.max), 0.5 * std::max({extent.x, extent.y, extent.z}), 0};
    visit(whole, {whole.centre, size_.at(whole.centre)}, all);
    return sum_;
  }

 private:
  struct Cube {
    Vec3 centre;
    double half;
    unsigned depth;
  };
  static constexpr unsigned least_depth = 3;

  static Cube eighth(const Cube& q, unsigned k) {
    const double h = 0.5 * q.half;
    return {q.centre + Vec3{k & 1 ? h : -h, k & 2 ? h : -h, k & 4 ? h : -h}, h, q.depth + 1};
  }

  /// `near`: a known size; `above`: of cells_, those that reach into a cube about this one.
  void visit(const Cube& q, const KnownSize& near, const std::vector<Index>& above) {
    if (sum_ > enough_) return;
    std::vector<Index> cells;
    for (const Index c : above)
      if (cells_[c].may_reach(q.centre, q.half)) cells.push_back(c);
    if (cells.empty()) return;
    const KnownSize here = near.at(q.centre, no_index, size_);
    if (q.depth >= greatest_depth || (q.depth >= least_depth && evenness_.holds(2 * q.half, here.size))) {
      add(q, here, cells);
      return;
    }
    for (unsigned k = 0; k < 8; ++k) visit(eighth(q, k), here, cells);
  }

  void add(const Cube& q, const KnownSize& near, const std::vector<Index>& cells) {
    const double volume = q.half * q.half * q.half;
    for (unsigned k = 0; k < 8; ++k) {
      const Vec3 p = eighth(q, k).centre;
      const auto home = std::find_if(cells.begin(), cells.end(), [&](Index c) { return cells_[c].reaches(p, 0); });
      if (home == cells.end()) continue;
      const double h = near.at(p, cells_[*home].component(), size_).size;
      sum_ += volume / (h * h * h);
    }
  }

  const SizeField& size_;
  double enough_;
  Evenness evenness_;
  std::vector<CellReach> cells_;
  double sum_ = 0;
};

/// Integral over the mesh's constrained faces of 1 / size^2, by triangles whose longest side is halved.
class AreaOverSizes {
 public:
  AreaOverSizes(const DomainMesh& mesh, const SizeField& size, double enough)
      : mesh_(mesh), size_(size), enough_(enough), evenness_(size) {}

  double run() {
    for (const CellIndex c : mesh_.live_cells())
      for (unsigned i = 0; i < 4; ++i) {
        if (!mesh_.is_surface(FaceRef(c, i))) continue;
        component_ = mesh_.component(c);
        visit(mesh_.places(mesh_.face(c, i)), 0);
      }
    return sum_;
  }

 private:
  using Corners = std::array<Vec3, 3>;

  void visit(const Corners& p, unsigned depth) {
    if (sum_ > enough_) return;
    near_ = near_.at((1.0 / 3) * (p[0] + p[1] + p[2]), component_, size_);
    const double h = near_.size;
    unsigned longest = 0;
    for (unsigned k = 1; k < 3; ++k)
      if (side(p, k) > side(p, longest)) longest = k;
    if (depth >= greatest_depth || evenness_.holds(std::sqrt(side(p, longest)), h)) {
      sum_ += 0.5 * length(cross(p[1] - p[0], p[2] - p[0])) / (h * h);
      return;
    }
    const Vec3 &a = p[longest], &b = p[(longest + 1) % 3], &c = p[(longest + 2) % 3], middle = 0.5 * (a + b);
    visit({a, middle, c}, depth + 1);
    visit({middle, b, c}, depth + 1);
  }
  static double side(const Corners& p, unsigned k) { return squared_distance(p[k], p[(k + 1) % 3]); }

  const DomainMesh& mesh_;
  const SizeField& size_;
  double enough_;
  Evenness evenness_;
  Index component_ = no_index;
  KnownSize near_{{}, std::numeric_limits<double>::infinity()};  // of the piece before
  double sum_ = 0;
};

}  // namespace

double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options) {
  // Measured by scripts/element-quality; 8.5 regular tetrahedra of unit size fill a unit of volume. Surfaces disturb
  // the order of what is beside them, and about given points that stay there are cells for their own sake.
  constexpr double per_volume = 11.2, per_area = 2.4, per_given_cell = 1.05;
  constexpr double least_counted = 2e6;  // a user is told how far beyond a small limit the sizes go
  const double enough = std::max(static_cast<double>(options.max_elements), least_counted);
  const double inside = per_volume * VolumeOverSizes(mesh, size, enough / per_volume).run();
  const double on_surfaces = per_area * AreaOverSizes(mesh, size, enough / per_area).run();
  const auto n_given = static_cast<double>(mesh.n_cells());
  return options.honour == Honour::exact ? inside + on_surfaces + per_given_cell * n_given : inside + on_surfaces;
}

namespace {

std::string with_three_digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", x);
  return text.data();
}

std::string in_words(double count) { return std::to_string(static_cast<long long>(count)); }

void check_estimate(double estimate, std::size_t limit) {
  if (estimate <= static_cast<double>(limit)) return;
  throw Error(ErrorKind::cannot_mesh, "the sizes ask for about " + in_words(estimate) +
                                          " elements, more than the limit of " + std::to_string(limit) +
                                          "; ask for larger sizes, a steeper gradation, or raise the limit");
}

/// Of the edges of the input, half are longer.
double middle_edge(const PiecewiseLinearComplex& plc) {
  std::vector<double> lengths;
  for (Index l = 0; l + 1 < plc.loop_offsets.size(); ++l) {
    const auto loop = plc.loop(l);
    for (std::size_t k = 0; k < loop.size(); ++k)
      lengths.push_back(length(plc.points[loop[(k + 1) % loop.size()]] - plc.points[loop[k]]));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Far fewer elements may meet what is asked of the whole model, or where nothing is asked, what most edges of the
/// input ask for. The user is told before the work.
void warn_of_short_edges(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options,
                         const RunContext& context, RefineResult& result) {
  constexpr double many = 250'000, most = 2, short_edge = 0.1;  // of the middle one
  const double estimate = result.statistics.estimated_elements;
  if (!options.size.from_input_edges || !sizes_surfaces(options) || estimate < many) return;
  const bool has_size = options.size.global > 0;
  const double least = short_edge * middle_edge(plc);
  if (has_size)
    options.size.from_input_edges = false;
  else
    options.size.min_size = std::max(options.size.min_size, least);
  const double without = estimate_elements(mesh, build_size_field(plc, mesh, options).all, options);
  if (estimate < most * without) return;
  result.warnings.push_back(
      "short edges of the input ask for most of the " + in_words(estimate) + " elements or more to come; " +
      (has_size ? "the sizes asked for" : "a least size of " + with_three_digits(least) + " asks for") + " about " +
      in_words(without) +
      ": for fewer, ask for a least size, take no sizes from the input's edges, ask for sizes "
      "inside only, or allow surfaces a tolerance");
  context.note(LogLevel::warning, result.warnings.back());
}

}  // namespace

void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                       const RunContext& context, RefineResult& result) {
  result.statistics.estimated_elements = estimate_elements(mesh, result.size_field, options);
  context.note(LogLevel::info, "about " + in_words(result.statistics.estimated_elements) + " elements to come");
  warn_of_short_edges(plc, mesh, options, context, result);
  check_estimate(result.statistics.estimated_elements, options.max_elements);
}

}  // namespace geomesh::remesh
