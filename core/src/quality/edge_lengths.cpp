// SPDX-License-Identifier: MIT
#include "quality/edge_lengths.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "common/parallel.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

constexpr std::size_t chunk_size = 4096;  ///< vertices
constexpr Index whole = no_index;

/// An edge's upper vertex, with a group and a component that it is in.
struct Use {
  VertexIndex upper;
  Index group, component;
  friend bool operator==(const Use&, const Use&) = default;
  friend bool operator<(const Use& x, const Use& y) {
    return std::tie(x.upper, x.group, x.component) < std::tie(y.upper, y.group, y.component);
  }
};

struct Measured {
  Index group;  ///< or `whole`
  double length;
  std::uint8_t bin;
};

std::uint8_t bin_of(double ratio) {
  constexpr std::array<double, 7> bounds{0.25, 0.5, 0.70710678118654752, 1, 1.4142135623730951, 2, 4};
  return static_cast<std::uint8_t>(std::upper_bound(bounds.begin(), bounds.end(), ratio) - bounds.begin());
}

/// Uses of edges by their lower vertex: a counting sort, then short sorts.
class EdgeTable {
 public:
  EdgeTable(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra, const CellParts& parts,
            const SizeField* size)
      : points_(points), size_(size), first_(points.size() + 1, 0) {
    const auto for_each_edge = [&](const auto& visit) {
      for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (const auto& e : edge_vertices) {
          const auto [lower, upper] = std::minmax(tetrahedra[t][e[0]], tetrahedra[t][e[1]]);
          visit(lower, Use{upper, parts.group[t], parts.component[t]});
        }
    };
    for_each_edge([&](VertexIndex lower, const Use&) { ++first_[lower + 1]; });
    for (std::size_t v = 0; v < points.size(); ++v) first_[v + 1] += first_[v];
    uses_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_edge([&](VertexIndex lower, const Use& use) { uses_[next[lower]++] = use; });
  }

  std::size_t n_chunks() const { return (points_.size() + chunk_size - 1) / chunk_size; }

  /// The edges with a lower vertex in the chunk, for the whole and for each group that they are in.
  std::vector<Measured> measure_chunk(std::size_t chunk) {
    std::vector<Measured> out;
    const std::size_t end = std::min(points_.size(), (chunk + 1) * chunk_size);
    for (std::size_t v = chunk * chunk_size; v < end; ++v) {
      const auto begin = uses_.begin() + static_cast<std::ptrdiff_t>(first_[v]);
      const auto stop = uses_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]);
      std::sort(begin, stop);
      const auto last = std::unique(begin, stop);
      for (auto edge = begin, next = edge; edge != last; edge = next) {
        next = std::find_if(edge, last, [&](const Use& u) { return u.upper != edge->upper; });
        measure_edge(static_cast<VertexIndex>(v), std::span<const Use>(edge, next), out);
      }
    }
    return out;
  }

 private:
  void measure_edge(VertexIndex lower, std::span<const Use> uses, std::vector<Measured>& out) const {
    const Vec3 &a = points_[lower], &b = points_[uses[0].upper];
    const double length = distance(a, b);
    const auto bin = [&](double asked) { return size_ ? bin_of(length / asked) : std::uint8_t{0}; };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < uses.size();) {
      const Index group = uses[i].group;
      double asked = std::numeric_limits<double>::infinity();
      for (; i < uses.size() && uses[i].group == group; ++i)
        if (size_) asked = std::min(asked, size_->at(0.5 * (a + b), uses[i].component));
      out.push_back({group, length, bin(asked)});
      least = std::min(least, asked);
    }
    out.push_back({whole, length, bin(least)});
  }

  std::span<const Vec3> points_;
  const SizeField* size_;
  std::vector<std::size_t> first_;  // by lower vertex, in uses_
  std::vector<Use> uses_;
};

}  // namespace

std::vector<EdgeLengths> measure_edges(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                                       const CellParts& parts, const SizeField* size, unsigned threads) {
  EdgeTable table(points, tetrahedra, parts, size);
  std::vector<std::vector<Measured>> chunks(table.n_chunks());
  for_each_task(chunks.size(), thread_count(threads), [&](std::size_t k) { chunks[k] = table.measure_chunk(k); });
  std::vector<EdgeLengths> out(1 + parts.n_groups);
  for (const auto& chunk : chunks)
    for (const Measured& m : chunk) {
      EdgeLengths& part = out[m.group == whole ? 0 : 1 + m.group];
      part.length.push_back(m.length);
      if (size) ++part.by_size[m.bin];
    }
  return out;
}

}  // namespace geomesh
