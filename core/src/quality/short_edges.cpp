// SPDX-License-Identifier: MIT
#include "geomesh/core/short_edges.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "common/geometry.hpp"
#include "quality/causes.hpp"
#include "quality/measure/shape.hpp"
#include "quality/thin_gaps.hpp"

namespace geomesh {

namespace {

constexpr double forcing_angle = 20;  // degrees

/// Each edge that may be short once, by its ends, with the cells at it.
using EdgeCells = std::map<std::array<VertexIndex, 2>, std::vector<Index>>;

double size_at(const SizeField& size, const ConstrainedTetrahedralization& mesh, const Vec3& p,
               const std::vector<Index>& cells) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index c : cells) least = std::min(least, size.at(p, mesh.component[c]));
  return least;
}

/// No edge that is longer is short: no size above this is asked anywhere.
EdgeCells candidates(const ConstrainedTetrahedralization& mesh, const SizeField& size, double share) {
  const double longest = share * std::min(size.limits().global, size.limits().max_size);
  EdgeCells edges;
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    for (const auto& e : edge_vertices) {
      const VertexIndex a = std::min(t[e[0]], t[e[1]]), b = std::max(t[e[0]], t[e[1]]);
      const double l = distance(mesh.points[a], mesh.points[b]);
      if (l < longest && l < share * size.at(0.5 * (mesh.points[a] + mesh.points[b]), mesh.component[c]))
        edges[{a, b}].push_back(c);
    }
  }
  return edges;
}

class EdgeCauses {
 public:
  EdgeCauses(const ConstrainedTetrahedralization& mesh, const QualityOptions& options, const InputCreases& creases)
      : stars_(mesh, options.facet_patch, &creases),
        gaps_(stars_, options.forcing_angle, options.tolerance == 0),
        closable_(options.gaps_stay ? 0 : 2 * options.tolerance) {}

  void explain(ShortEdge& e, const std::vector<Index>& cells, double share) const {
    if (explain_by_angle(e)) return;
    if (are_ends_of_near_curves(e)) {
      e.cause = EdgeCause::near_curves;
      return;
    }
    for (const Index c : cells) {
      const double width = gaps_.narrowest(c, closable_).width;
      if (!(width < share * e.size)) continue;
      e.cause = EdgeCause::thin_gap;
      e.gap = width;
      return;
    }
  }

 private:
  bool explain_by_angle(ShortEdge& e) const {
    std::vector<VertexIndex> about{e.a, e.b};
    for (const VertexIndex w : common_neighbours(e)) about.push_back(w);
    double least = forcing_angle;
    for (const VertexIndex v : about) least = std::min(least, stars_.least_angle(v).degrees);
    if (!(least < forcing_angle)) return false;
    e.cause = EdgeCause::input_angle;
    e.forcing_angle = least;
    return true;
  }

  /// Where curves from both ends meet.
  std::vector<VertexIndex> common_neighbours(const ShortEdge& e) const {
    std::vector<VertexIndex> common;
    for (const SoupEdge& x : stars_.edges(e.a))
      for (const SoupEdge& y : stars_.edges(e.b))
        if (x.other == y.other) common.push_back(x.other);
    return common;
  }

  bool is_end_of_curves(VertexIndex v) const { return stars_.edges(v).size() != 2; }

  bool are_ends_of_near_curves(const ShortEdge& e) const {
    const auto at_a = stars_.edges(e.a);
    if (at_a.empty() || stars_.edges(e.b).empty()) return false;
    const bool is_along = std::any_of(at_a.begin(), at_a.end(), [&](const SoupEdge& s) { return s.other == e.b; });
    if (is_along) return is_end_of_curves(e.a) && is_end_of_curves(e.b);
    return common_neighbours(e).empty();
  }

  SoupStars stars_;
  GapFinder gaps_;
  double closable_;
};

}  // namespace

ShortEdges find_short_edges(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options, double share, std::size_t max_worst) {
  ShortEdges found;
  const EdgeCells edges = candidates(mesh, *options.size, share);
  if (edges.empty()) return found;
  const InputCreases creases = find_creases(plc, options);
  const EdgeCauses causes(mesh, options, creases);
  for (const auto& [ends, cells] : edges) {
    ShortEdge e;
    e.a = ends[0], e.b = ends[1];
    e.length = distance(mesh.points[e.a], mesh.points[e.b]);
    e.place = 0.5 * (mesh.points[e.a] + mesh.points[e.b]);
    e.size = size_at(*options.size, mesh, e.place, cells);
    if (!(e.length < share * e.size)) continue;
    causes.explain(e, cells, share);
    ++found.n;
    found.n_forced += e.cause != EdgeCause::free;
    found.worst.push_back(e);
  }
  std::stable_sort(found.worst.begin(), found.worst.end(), [](const ShortEdge& x, const ShortEdge& y) {
    return std::tuple(x.cause != EdgeCause::free, x.length / x.size) <
           std::tuple(y.cause != EdgeCause::free, y.length / y.size);
  });
  found.worst.resize(std::min(found.worst.size(), max_worst));
  return found;
}

}  // namespace geomesh
