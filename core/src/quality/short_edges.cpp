// SPDX-License-Identifier: MIT
#include "geomesh/core/short_edges.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "quality/causes.hpp"

namespace geomesh {

namespace {

/// The edges that may be short, each identified by its ends, with the cells around it.
using EdgeCells = std::map<std::array<VertexIndex, 2>, std::vector<Index>>;

double size_at(const SizeField& size, const ConstrainedTetrahedralization& mesh, const Vec3& p,
               const std::vector<Index>& cells) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index c : cells) least = std::min(least, size.at(p, mesh.component[c]));
  return least;
}

/// Returns the edges that may be short: those below `share` of the largest target size. If sizes jump from one
/// component to the next, an edge may be short for some of its cells only, so all its cells are listed.
EdgeCells candidates(const ConstrainedTetrahedralization& mesh, const SizeField& size, double share, unsigned threads) {
  constexpr std::size_t chunk = 16384;
  using Ends = std::array<VertexIndex, 2>;
  const double longest = share * std::min(size.limits().global, size.limits().max_size);
  const auto for_each_edge = [&](std::size_t k, const auto& visit) {
    for (std::size_t c = k * chunk; c < std::min(mesh.tetrahedra.size(), (k + 1) * chunk); ++c) {
      const Tetrahedron& t = mesh.tetrahedra[c];
      for (const auto& e : edge_vertices) {
        const VertexIndex a = std::min(t[e[0]], t[e[1]]), b = std::max(t[e[0]], t[e[1]]);
        const double l = distance(mesh.points[a], mesh.points[b]);
        if (l < longest) visit(Ends{a, b}, l, static_cast<Index>(c));
      }
    }
  };
  std::vector<std::vector<std::pair<Ends, Index>>> found((mesh.tetrahedra.size() + chunk - 1) / chunk);
  const bool asks_caller =
      size.limits().background != nullptr;  // size functions of the caller are evaluated on one thread only
  for_each_task(found.size(), asks_caller ? 1 : thread_count(threads), [&](std::size_t k) {
    for_each_edge(k, [&](const Ends& ends, double l, Index c) {
      const double enough = l / share;
      if (size.at_unless_below(enough, 0.5 * (mesh.points[ends[0]] + mesh.points[ends[1]]), mesh.component[c]) > enough)
        found[k].emplace_back(ends, c);
    });
  });
  EdgeCells edges;
  for (const auto& of_chunk : found)
    for (const auto& [ends, cell] : of_chunk) edges[ends].push_back(cell);
  if (edges.empty() || (size.limits().component_size.empty() && !asks_caller)) return edges;
  for (auto& [ends, cells] : edges) cells.clear();
  for (std::size_t k = 0; k < found.size(); ++k)
    for_each_edge(k, [&](const Ends& ends, double, Index c) {
      if (const auto edge = edges.find(ends); edge != edges.end()) edge->second.push_back(c);
    });
  return edges;
}

/// Returns a field of sizes that grow, by the gradation of `size`, from the edges that the input imposes.
SizeField grown_from_forced(const std::vector<ShortEdge>& edges, const SizeField& size) {
  std::vector<SizeSource> sources;
  for (const ShortEdge& e : edges)
    if (e.cause != EdgeCause::free) sources.push_back({.point = e.place, .size = e.length});
  return {std::move(sources), {.gradation = size.limits().gradation}};
}

/// A short edge counts as caused by an edge nearby that the input imposes if it has at least this share of the size
/// that grows from that edge by the gradation.
constexpr double share_of_grown = 0.5;

/// Marks edges as imposed that are long enough for their distance from an edge that the input imposes.
void excuse_near_forced(std::vector<ShortEdge>& edges, const SizeField& size) {
  const SizeField grown = grown_from_forced(edges, size);
  if (grown.n_sources() == 0) return;
  for (ShortEdge& e : edges)
    if (e.cause == EdgeCause::free && e.length >= share_of_grown * grown.at(e.place)) e.cause = EdgeCause::near_forced;
}

}  // namespace

ShortEdges find_short_edges(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options, double share, std::size_t max_worst) {
  ShortEdges found;
  const EdgeCells edges = candidates(mesh, *options.size, share, options.threads);
  if (edges.empty()) return found;
  const InputCreases creases = find_creases(plc, options);
  CauseFinder causes(mesh, options, creases);
  for (const auto& [ends, cells] : edges) {
    ShortEdge e;
    e.a = ends[0], e.b = ends[1];
    e.length = distance(mesh.points[e.a], mesh.points[e.b]);
    e.place = 0.5 * (mesh.points[e.a] + mesh.points[e.b]);
    e.size = size_at(*options.size, mesh, e.place, cells);
    if (!(e.length < share * e.size)) continue;
    causes.explain(e, cells, share);
    found.worst.push_back(e);
  }
  excuse_near_forced(found.worst, *options.size);
  found.n = found.worst.size();
  found.n_forced = static_cast<std::size_t>(std::count_if(
      found.worst.begin(), found.worst.end(), [](const ShortEdge& e) { return e.cause != EdgeCause::free; }));
  std::stable_sort(found.worst.begin(), found.worst.end(), [](const ShortEdge& x, const ShortEdge& y) {
    return std::tuple(x.cause != EdgeCause::free, x.length / x.size) <
           std::tuple(y.cause != EdgeCause::free, y.length / y.size);
  });
  found.worst.resize(std::min(found.worst.size(), max_worst));
  return found;
}

}  // namespace geomesh
