// SPDX-License-Identifier: MIT
#include "quality/edge_lengths.hpp"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <utility>

#include "common/parallel.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh {

namespace {

/// Number of blocks of vertices whose edges are measured in parallel. Each takes 48 / n_blocks bytes per tetrahedron.
constexpr std::size_t n_blocks = 8;

/// A pair of a group (for statistics) and a component (for target sizes) that some tetrahedron belongs to.
struct Part {
  Index group, component;
  friend auto operator<=>(const Part&, const Part&) = default;
};

/// The combinations of group and component that tetrahedra belong to, ascending, and each tetrahedron's row in them.
struct PartTable {
  explicit PartTable(const CellParts& parts) : row(parts.group.size()), n_groups(parts.n_groups) {
    const auto at = [&](std::size_t t) { return Part{parts.group[t], parts.component[t]}; };
    for (std::size_t t = 0; t < row.size(); ++t)
      if (t == 0 || at(t) != at(t - 1)) part.push_back(at(t));
    sort_unique(part);
    for (std::size_t t = 0; t < row.size(); ++t)
      row[t] = t > 0 && at(t) == at(t - 1)
                   ? row[t - 1]
                   : static_cast<Index>(std::lower_bound(part.begin(), part.end(), at(t)) - part.begin());
  }
  std::vector<Part> part;
  std::vector<Index> row;
  std::size_t n_groups;
};

/// A use of an edge: its upper vertex in the high bits, and in the low bits the row of a combination of group and
/// component that has the edge. In sorted order, the uses of an edge are adjacent and ordered by group.
using Use = std::uint64_t;
constexpr Use use_of(VertexIndex upper, Index part) { return Use{upper} << 32 | part; }
constexpr VertexIndex upper_of(Use use) { return static_cast<VertexIndex>(use >> 32); }
constexpr Index part_of(Use use) { return static_cast<Index>(use & 0xffffffff); }

std::uint8_t bin_of(double ratio) {
  constexpr std::array<double, 7> bounds{0.25, 0.5, 0.70710678118654752, 1, 1.4142135623730951, 2, 4};
  return static_cast<std::uint8_t>(std::upper_bound(bounds.begin(), bounds.end(), ratio) - bounds.begin());
}

/// The target size at each vertex. If sizes may jump between components, that of a component is looked up.
class SizesAtVertices {
 public:
  SizesAtVertices(std::span<const Vec3> points, const SizeField* size, unsigned threads)
      : points_(points), size_(size) {
    if (!size || !(size->steepest() < std::numeric_limits<double>::infinity())) return;
    sizes_.resize(points.size());
    for_each_task(n_blocks, threads, [&](std::size_t k) {
      const std::size_t begin = points.size() * k / n_blocks, end = points.size() * (k + 1) / n_blocks;
      for (std::size_t v = begin; v < end; ++v)
        sizes_[v] =
            v == begin ? size->at(points[v]) : size->at_beside(points[v], no_index, points[v - 1], sizes_[v - 1]);
    });
  }
  bool are_asked() const { return size_ != nullptr; }
  double at(VertexIndex v, Index component) const {
    return sizes_.empty() ? size_->at(points_[v], component) : sizes_[v];
  }

 private:
  std::span<const Vec3> points_;
  const SizeField* size_;
  std::vector<double> sizes_;
};

/// The mesh edges whose lower vertex is in [begin, end). Their uses by groups and components are sorted by the lower
/// vertex (a counting sort), then within each lower vertex.
class EdgeBlock {
 public:
  EdgeBlock(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra, const PartTable& parts,
            const SizesAtVertices& sizes, std::size_t begin, std::size_t end)
      : points_(points),
        sizes_(sizes),
        parts_(parts.part),
        begin_(begin),
        first_(end - begin + 1, 0),
        lengths_(1 + parts.n_groups) {
    const auto for_each_edge = [&](const auto& visit) {
      for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
        const Tetrahedron& v = tetrahedra[t];
        if (std::min(std::min(v[0], v[1]), std::min(v[2], v[3])) >= end) continue;
        if (std::max(std::max(v[0], v[1]), std::max(v[2], v[3])) < begin) continue;
        for (const auto& e : edge_vertices) {
          const VertexIndex lower = std::min(v[e[0]], v[e[1]]), upper = std::max(v[e[0]], v[e[1]]);
          if (lower >= begin && lower < end) visit(lower - begin, upper, t);
        }
      }
    };
    for_each_edge([&](std::size_t row, VertexIndex, std::size_t) { ++first_[row + 1]; });
    for (std::size_t row = 0; row + 1 < first_.size(); ++row) first_[row + 1] += first_[row];
    uses_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_edge(
        [&](std::size_t row, VertexIndex upper, std::size_t t) { uses_[next[row]++] = use_of(upper, parts.row[t]); });
  }

  /// Returns the edge lengths of the whole mesh, followed by those of each group.
  std::vector<EdgeLengths> measure() && {
    for (std::size_t row = 0; row + 1 < first_.size(); ++row) {
      const auto begin = uses_.begin() + static_cast<std::ptrdiff_t>(first_[row]);
      const auto stop = uses_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]);
      std::sort(begin, stop);
      const auto last = std::unique(begin, stop);
      size_here_ = {no_index, 0};
      for (auto edge = begin, next = edge; edge != last; edge = next) {
        next = std::find_if(edge, last, [&](Use u) { return upper_of(u) != upper_of(*edge); });
        measure_edge(static_cast<VertexIndex>(begin_ + row),
                     std::span<const Use>(&*edge, static_cast<std::size_t>(next - edge)));
      }
    }
    return std::move(lengths_);
  }

 private:
  void measure_edge(VertexIndex lower, std::span<const Use> uses) {
    const Vec3 &a = points_[lower], &b = points_[upper_of(uses[0])];
    const double length = distance(a, b);
    const auto add = [&](std::size_t part, double asked) {
      lengths_[part].length.push_back(length);
      if (sizes_.are_asked()) ++lengths_[part].by_size[bin_of(length / asked)];
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < uses.size();) {
      const Index group = parts_[part_of(uses[i])].group;
      double asked = std::numeric_limits<double>::infinity();
      for (; i < uses.size() && parts_[part_of(uses[i])].group == group; ++i)
        if (sizes_.are_asked())
          asked = std::min(asked, size_of_edge(lower, upper_of(uses[i]), parts_[part_of(uses[i])].component));
      add(1 + group, asked);
      least = std::min(least, asked);
    }
    add(0, least);
  }

  /// Returns the target size of an edge: the mean of the target sizes at its ends. The size at the lower vertex is
  /// remembered, because consecutive edges share this vertex.
  double size_of_edge(VertexIndex lower, VertexIndex upper, Index component) {
    if (size_here_.component != component || !(size_here_.size > 0))
      size_here_ = {component, sizes_.at(lower, component)};
    return 0.5 * (size_here_.size + sizes_.at(upper, component));
  }

  std::span<const Vec3> points_;
  const SizesAtVertices& sizes_;
  const std::vector<Part>& parts_;
  struct {
    Index component;
    double size;  ///< 0: not known
  } size_here_{no_index, 0};
  std::size_t begin_;
  std::vector<std::size_t> first_;  // by vertex: position in uses_ of the first edge of which it is the lower end
  std::vector<Use> uses_;
  std::vector<EdgeLengths> lengths_;
};

}  // namespace

std::vector<EdgeLengths> measure_edges(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra,
                                       const CellParts& parts, const SizeField* size, unsigned threads) {
  const PartTable table(parts);
  std::array<std::vector<EdgeLengths>, n_blocks> blocks;
  const bool asks_caller =
      size && size->limits().background;  // size functions of the caller are evaluated on one thread only
  const unsigned n_threads = asks_caller ? 1 : thread_count(threads);
  const SizesAtVertices sizes(points, size, n_threads);
  for_each_task(n_blocks, n_threads, [&](std::size_t k) {
    const std::size_t begin = points.size() * k / n_blocks, end = points.size() * (k + 1) / n_blocks;
    blocks[k] = EdgeBlock(points, tetrahedra, table, sizes, begin, end).measure();
  });
  std::vector<EdgeLengths> out(1 + parts.n_groups);
  for (std::vector<EdgeLengths>& block : blocks)
    for (std::size_t part = 0; part < out.size(); ++part) {
      const EdgeLengths lengths = std::exchange(block[part], {});
      out[part].length.insert(out[part].length.end(), lengths.length.begin(), lengths.length.end());
      for (std::size_t i = 0; i < lengths.by_size.size(); ++i) out[part].by_size[i] += lengths.by_size[i];
    }
  return out;
}

}  // namespace geomesh
