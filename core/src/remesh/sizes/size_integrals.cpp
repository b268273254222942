// SPDX-License-Identifier: MIT
#include "remesh/sizes/size_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/geometry.hpp"
#include "common/random.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The size at a place, and bounds for sizes within some distance of it.
struct SizeAbout {
  double size, least, greatest;
};

/// A place at which the size required by sources is known, which speeds up the evaluation at places nearby.
struct KnownPlace {
  Vec3 place;
  double by_sources = infinity;
};

/// Samples a size field. Without a background the field grows no faster than its sources do within a component, and it
/// is constant where the sources require larger sizes than the limits do.
class SizeSampler {
 public:
  SizeSampler(const SizeField& field, std::size_t most_samples)
      : most_samples_(most_samples),
        limits_(field.limits()),
        sources_(field.sources(), {infinity, 0, infinity, limits_.gradation, {}, {}}) {
    growth_ = limits_.background ? std::max(limits_.gradation, growth_of_background) : sources_.steepest();
  }

  double growth() const { return growth_; }
  bool is_exhausted() const { return n_samples_ > most_samples_; }

  SizeAbout sample(const Vec3& p, double radius, Index component, KnownPlace& near) {
    ++n_samples_;
    near = {p, sources_.at_beside(p, no_index, near.place, near.by_sources)};
    const double cap = cap_at(p, component), by_sources = near.by_sources;
    const double reach = limits_.background ? infinity : growth_ * radius;
    const auto limited = [&](double size) { return std::max(std::min(size, cap), limits_.min_size); };
    return {limited(by_sources), limited(by_sources - reach), limited(by_sources + reach)};
  }

 private:
  static constexpr double growth_of_background = 0.5;  ///< assumed gradation of sizes read from a file

  double cap_at(const Vec3& p, Index component) const {
    double cap = std::min(limits_.global, limits_.max_size);
    if (component < limits_.component_size.size() && limits_.component_size[component] > 0)
      cap = std::min(cap, limits_.component_size[component]);
    if (limits_.background)
      if (const double asked = limits_.background(p); asked > 0) cap = std::min(cap, asked);
    return cap;
  }

  std::size_t most_samples_;
  SizeField::Limits limits_;
  SizeField sources_;
  double growth_ = 0;
  std::size_t n_samples_ = 0;
};

double content(const std::array<Vec3, 4>& p) { return std::abs(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]))) / 6; }
double content(const std::array<Vec3, 3>& p) { return 0.5 * length(cross(p[1] - p[0], p[2] - p[0])); }
double content(const std::array<Vec3, 2>& p) { return distance(p[0], p[1]); }

/// Integrates 1 / size^(n - 1) over simplices of n corners.
template <std::size_t n>
class Integral {
 public:
  explicit Integral(SizeSampler& sampler) : sampler_(sampler) {}

  void add(const std::array<Vec3, n>& corners, Index component) {
    KnownPlace near = last_;
    visit(corners, component, near, {});
    last_ = near;
  }
  double sum() const { return sum_; }

 private:
  static constexpr unsigned greatest_depth = 200;
  /// If a piece of a simplex contributes less than this share of the integral so far, only half of it is evaluated.
  static constexpr double small_share = 1e-4;

  /// How often a simplex was bisected to give this piece, and how many pieces like it the piece stands for.
  struct Share {
    unsigned depth = 0;
    double weight = 1;
  };

  static double times(double size) {
    double power = size;
    for (std::size_t k = 2; k < n; ++k) power *= size;
    return power;
  }

  /// A piece with a small contribution is estimated from one of its halves, chosen at random and counted twice (Russian
  /// roulette). The expected sum is unchanged, and the number of samples is limited however slender the cells are.
  void visit(const std::array<Vec3, n>& p, Index component, KnownPlace& near, const Share& share) {
    if (sampler_.is_exhausted()) return;
    Vec3 centre;
    for (const Vec3& corner : p) centre = centre + (1.0 / n) * corner;
    double radius = 0, longest = 0;
    std::size_t from = 0, to = 1;
    for (std::size_t i = 0; i < n; ++i) {
      radius = std::max(radius, squared_distance(centre, p[i]));
      for (std::size_t j = i + 1; j < n; ++j)
        if (const double side = squared_distance(p[i], p[j]); side > longest) longest = side, from = i, to = j;
    }
    const SizeAbout about = sampler_.sample(centre, std::sqrt(radius), component, near);
    const double brings = share.weight * content(p) / times(about.size);
    const bool is_even = sampler_.growth() * std::sqrt(longest) <= about.size || about.least == about.greatest;
    if (is_even || share.depth >= greatest_depth) {
      sum_ += brings;
      return;
    }
    std::array<Vec3, n> half = p;
    const Vec3 middle = 0.5 * (p[from] + p[to]);
    if (brings < small_share * sum_) {
      half[choice_.below(2) == 0 ? from : to] = middle;
      visit(half, component, near, {share.depth + 1, 2 * share.weight});
      return;
    }
    half[from] = middle;
    KnownPlace beside = near;
    visit(half, component, beside, {share.depth + 1, share.weight});
    half[from] = p[from], half[to] = middle;
    visit(half, component, near, {share.depth + 1, share.weight});
  }

  SizeSampler& sampler_;
  KnownPlace last_;
  Random choice_;
  double sum_ = 0;
};

/// Returns the edges of curves in ascending order, each once for each of its constrained faces.
std::vector<Edge> edges_of_curve_faces(const DomainMesh& mesh) {
  std::vector<Edge> edges;
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i) {
      if (!mesh.is_surface(FaceRef(c, i))) continue;
      const Triangle t = mesh.face(c, i);
      for (unsigned k = 0; k < 3; ++k) {
        const auto [from, to] = std::minmax(t[k], t[(k + 1) % 3]);
        if (mesh.curve_of(from, to) != no_index) edges.push_back({from, to});
      }
    }
  std::ranges::sort(edges);
  return edges;
}

/// Integrates 1 / size along curves at which exactly two faces meet.
double along_folds(const DomainMesh& mesh, SizeSampler& sampler) {
  Integral<2> fold(sampler);
  const std::vector<Edge> edges = edges_of_curve_faces(mesh);
  for (auto at = edges.begin(); at != edges.end();) {
    const auto next = std::find_if(at, edges.end(), [&](const Edge& e) { return e != *at; });
    if (next - at == 2) fold.add({mesh.point((*at)[0]), mesh.point((*at)[1])}, no_index);
    at = next;
  }
  return fold.sum();
}

}  // namespace

double elements_of(const SizeIntegrals& integrals) {
  // Coefficients fitted to samples, templates and real data sets. Sizes that grow away from a surface need more
  // elements than the integral over the volume indicates, in proportion to the surface's area. At a fold both faces
  // count the same elements, which are subtracted once.
  constexpr double per_volume = 10, per_area = 5.3, per_fold = 20;
  return per_volume * integrals.volume + std::max(per_area * integrals.surface - per_fold * integrals.fold, 0.0);
}

std::optional<SizeIntegrals> integrate_sizes(const DomainMesh& mesh, const SizeField& size, std::size_t most_samples,
                                             double enough) {
  // In addition to `most_samples`, one sample of the size for each cell and one for each of its faces.
  SizeSampler sampler(size, most_samples + 5 * mesh.n_cells());
  SizeIntegrals found{.volume = 0, .surface = 0, .fold = along_folds(mesh, sampler)};
  Integral<4> volume(sampler);
  Integral<3> surface(sampler);
  for (const CellIndex c : mesh.live_cells()) {
    volume.add(mesh.places(mesh.vertices(c)), mesh.component(c));
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.is_surface(FaceRef(c, i))) surface.add(mesh.places(mesh.face(c, i)), mesh.component(c));
    if (sampler.is_exhausted()) return std::nullopt;
    found.volume = volume.sum(), found.surface = surface.sum();
    if (elements_of(found) > enough) break;
  }
  return found;
}

}  // namespace geomesh::remesh
