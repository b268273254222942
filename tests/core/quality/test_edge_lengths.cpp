// SPDX-License-Identifier: MIT
// Edges of a mesh and their lengths, against a set of all of them.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "quality/edge_lengths.hpp"

using namespace geomesh;

namespace {

struct Cells {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> group;
};

/// Tetrahedra on any four points each: which edges there are is a matter of rows alone.
Cells random_cells(unsigned seed, std::size_t n_points, std::size_t n_cells, Index n_groups) {
  std::mt19937 random(seed);
  Cells cells;
  const auto unit = [&] { return random() / 4294967296.0; };
  for (std::size_t v = 0; v < n_points; ++v) cells.points.push_back({unit(), unit(), unit()});
  while (cells.tetrahedra.size() < n_cells) {
    Tetrahedron t;
    for (VertexIndex& v : t) v = static_cast<VertexIndex>(random() % n_points);
    if (std::set<VertexIndex>(t.begin(), t.end()).size() < 4) continue;
    cells.tetrahedra.push_back(t);
    cells.group.push_back(static_cast<Index>(random() % n_groups));
  }
  return cells;
}

/// Lengths of the edges of the cells that are asked for, each edge once, in ascending order of their vertices.
template <class Asked>
std::vector<double> lengths_of(const Cells& cells, const Asked& asked) {
  std::set<std::array<VertexIndex, 2>> edges;
  for (std::size_t t = 0; t < cells.tetrahedra.size(); ++t)
    for (std::size_t i = 0; i < 4 && asked(t); ++i)
      for (std::size_t j = 0; j < i; ++j)
        edges.insert({std::min(cells.tetrahedra[t][i], cells.tetrahedra[t][j]),
                      std::max(cells.tetrahedra[t][i], cells.tetrahedra[t][j])});
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) {
    const Vec3 d = cells.points[b] - cells.points[a];
    lengths.push_back(std::sqrt(dot(d, d)));
  }
  return lengths;
}

}  // namespace

TEST_CASE("edges are measured once each, in the whole and in each group", "[quality]") {
  constexpr Index n_groups = 3;
  for (const std::size_t n_points : {5, 40, 5000}) {
    const Cells cells = random_cells(1, n_points, 4 * n_points, n_groups);
    const std::vector<Index> component(cells.tetrahedra.size(), no_index);
    for (const unsigned threads : {1u, 2u, 3u}) {
      INFO(n_points << " points, " << threads << " threads");
      const std::vector<EdgeLengths> measured =
          measure_edges(cells.points, cells.tetrahedra, {component, cells.group, n_groups}, nullptr, threads);
      REQUIRE(measured.size() == 1 + n_groups);
      CHECK(measured[0].length == lengths_of(cells, [](std::size_t) { return true; }));
      for (Index g = 0; g < n_groups; ++g)
        CHECK(measured[1 + g].length == lengths_of(cells, [&](std::size_t t) { return cells.group[t] == g; }));
    }
  }
}

TEST_CASE("edges are counted by length over the least size that their cells ask for", "[quality]") {
  constexpr Index n_groups = 2, n_components = 3;
  const Cells cells = random_cells(2, 60, 200, n_groups);
  std::vector<Index> component;
  for (std::size_t t = 0; t < cells.tetrahedra.size(); ++t) component.push_back(static_cast<Index>(t % n_components));
  SizeField::Limits limits;
  limits.component_size = {0.2, 0.7, 3};
  const SizeField size({}, limits);

  const auto counts_of = [&](const auto& asked) {
    std::map<std::array<VertexIndex, 2>, double> least;  // by edge
    for (std::size_t t = 0; t < cells.tetrahedra.size(); ++t)
      for (std::size_t i = 0; i < 4 && asked(t); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const VertexIndex v = cells.tetrahedra[t][i], w = cells.tetrahedra[t][j];
          double& here = least.try_emplace({std::min(v, w), std::max(v, w)}, 1e300).first->second;
          here = std::min(here, limits.component_size[component[t]]);
        }
    std::array<std::size_t, 8> counts{};
    for (const auto& [edge, asked_size] : least) {
      const Vec3 d = cells.points[edge[1]] - cells.points[edge[0]];
      const double ratio = std::sqrt(dot(d, d)) / asked_size;
      const double bounds[] = {0.25, 0.5, std::sqrt(0.5), 1, std::sqrt(2.0), 2, 4};
      ++counts[static_cast<std::size_t>(
          std::count_if(std::begin(bounds), std::end(bounds), [&](double bound) { return ratio >= bound; }))];
    }
    return counts;
  };
  for (const unsigned threads : {1u, 2u}) {
    const std::vector<EdgeLengths> measured =
        measure_edges(cells.points, cells.tetrahedra, {component, cells.group, n_groups}, &size, threads);
    CHECK(measured[0].by_size == counts_of([](std::size_t) { return true; }));
    for (Index g = 0; g < n_groups; ++g)
      CHECK(measured[1 + g].by_size == counts_of([&](std::size_t t) { return cells.group[t] == g; }));
  }
}

TEST_CASE("the size asked of an edge is the mean of the sizes at its ends", "[quality]") {
  const Cells cells = random_cells(3, 60, 200, 1);
  const std::vector<Index> component(cells.tetrahedra.size(), 0);
  std::vector<SizeSource> sources;
  for (std::size_t k = 0; k < 9; ++k) sources.push_back({cells.points[k], 0.02 * static_cast<double>(k + 1)});
  const SizeField size(sources, {});
  std::array<std::size_t, 8> counts{};
  std::set<std::array<VertexIndex, 2>> edges;
  for (const Tetrahedron& t : cells.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) edges.insert({std::min(t[i], t[j]), std::max(t[i], t[j])});
  for (const auto& [v, w] : edges) {
    const Vec3 &a = cells.points[v], &b = cells.points[w];
    const double ratio = std::sqrt(dot(b - a, b - a)) / (0.5 * (size.at(a) + size.at(b)));
    const double bounds[] = {0.25, 0.5, std::sqrt(0.5), 1, std::sqrt(2.0), 2, 4};
    ++counts[static_cast<std::size_t>(
        std::count_if(std::begin(bounds), std::end(bounds), [&](double bound) { return ratio >= bound; }))];
  }
  for (const unsigned threads : {1u, 2u})
    CHECK(measure_edges(cells.points, cells.tetrahedra, {component, cells.group, 1}, &size, threads)[0].by_size ==
          counts);
}
