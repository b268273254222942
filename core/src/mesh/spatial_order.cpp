// SPDX-License-Identifier: MIT
#include "mesh/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/parallel.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {
namespace {

/// The Hilbert curve in 3D as a finite automaton (Hamilton 2006, "Compact Hilbert indices", algorithm 2). A state is
/// the entry corner and the axis of the curve in the current octant. A step maps an octant's bits to its rank on the
/// curve and to the next state.
struct HilbertAutomaton {
  std::array<std::array<std::uint8_t, 8>, 24> rank{};
  std::array<std::array<std::uint8_t, 8>, 24> next{};
};

constexpr unsigned rotate_left(unsigned x, unsigned k) { return (x << k | x >> (3 - k)) & 7u; }

constexpr HilbertAutomaton make_automaton() {
  HilbertAutomaton a;
  for (unsigned entry = 0; entry < 8; ++entry)
    for (unsigned axis = 0; axis < 3; ++axis)
      for (unsigned octant = 0; octant < 8; ++octant) {
        const unsigned turn = (axis + 1) % 3;
        const unsigned gray = rotate_left(octant ^ entry, (3 - turn) % 3);
        const unsigned w = gray ^ gray >> 1 ^ gray >> 2;
        const unsigned even = w == 0 ? 0 : (w - 1) / 2 * 2;
        const unsigned corner = w == 0 ? 0 : even ^ even >> 1;
        const unsigned run = w == 0 ? 0 : static_cast<unsigned>(std::countr_one(w % 2 == 0 ? w - 1 : w)) % 3;
        const unsigned state = 3 * entry + axis;
        a.rank[state][octant] = static_cast<std::uint8_t>(w);
        a.next[state][octant] =
            static_cast<std::uint8_t>(3 * (entry ^ rotate_left(corner, turn)) + (axis + run + 1) % 3);
      }
  return a;
}

constexpr HilbertAutomaton hilbert = make_automaton();

/// Positions of points along the Hilbert curve that fills a cube around the points. The cube has 2^levels cells a side.
class HilbertPlaces {
 public:
  HilbertPlaces(std::span<const Vec3> points, std::span<const VertexIndex> subset, int levels) : levels_(levels) {
    Box3 box;
    for (const VertexIndex v : subset) box.add(points[v]);
    low_ = box.min;
    extent_ = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    scale_ = extent_ > 0 ? 0x0.fffffffp0 * static_cast<double>(std::uint32_t{1} << levels) / extent_ : 0;
  }
  bool single_place() const { return !(extent_ > 0); }
  const Vec3& low() const { return low_; }
  double extent() const { return extent_; }
  std::uint64_t operator()(const Vec3& p) const {
    const auto x = static_cast<std::uint32_t>((p.x - low_.x) * scale_),
               y = static_cast<std::uint32_t>((p.y - low_.y) * scale_),
               z = static_cast<std::uint32_t>((p.z - low_.z) * scale_);
    std::uint64_t place = 0;
    unsigned state = 0;
    for (int b = levels_ - 1; b >= 0; --b) {
      const unsigned octant = (x >> b & 1u) | (y >> b & 1u) << 1 | (z >> b & 1u) << 2;
      place = place << 3 | hilbert.rank[state][octant];
      state = hilbert.next[state][octant];
    }
    return place;
  }

 private:
  int levels_;
  Vec3 low_;
  double extent_, scale_;
};

/// Number of levels at which the Hilbert curve has about 2^6 cells for each point.
int levels_for(std::size_t n) { return std::clamp((static_cast<int>(std::bit_width(n)) + 2) / 3 + 2, 3, 11); }

/// A well mixed hash of the coordinates, measured from the low corner of the points' box in a unit that is a power of
/// two near its extent. -0 counts as 0.
class CoordinateHash {
 public:
  CoordinateHash(const Vec3& low, double extent)
      : low_(low), scale_(extent > 0 ? std::ldexp(1.0, -std::ilogb(extent)) : 1) {}
  std::uint64_t operator()(const Vec3& p) const {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (std::size_t i = 0; i < 3; ++i) {
      h = (h ^ std::bit_cast<std::uint64_t>((p[i] - low_[i]) * scale_ + 0.0)) * 0xBF58476D1CE4E5B9ull;
      h ^= h >> 32;
    }
    h *= 0x94D049BB133111EBull;
    return h ^ h >> 29;
  }

 private:
  Vec3 low_;
  double scale_;
};

// An item to be sorted has a key in the high bits and the index of a point, below 2^28, in the low bits.
constexpr int index_bits = 28;
constexpr std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;
constexpr unsigned n_rounds = 8;

/// Stable sort by the low `bits` bits of the key, least significant digit first. At the end `items` refers
/// to the span that holds the result.
void radix_sort(std::span<std::uint64_t>& items, std::span<std::uint64_t> other, int bits) {
  constexpr int digit = 12;
  std::vector<std::size_t> start(std::size_t{1} << digit);
  for (int shift = index_bits; shift < index_bits + bits; shift += digit) {
    std::fill(start.begin(), start.end(), 0);
    for (const std::uint64_t x : items) ++start[x >> shift & (start.size() - 1)];
    std::size_t sum = 0;
    for (std::size_t& s : start) sum += std::exchange(s, sum);
    for (const std::uint64_t x : items) other[start[x >> shift & (start.size() - 1)]++] = x;
    std::swap(items, other);
  }
}

void sort_small(std::span<const Vec3> points, std::span<VertexIndex> run) {
  std::sort(run.begin(), run.end(), [&](VertexIndex a, VertexIndex b) {
    const int c = compare_lexicographic(points[a], points[b]);
    return c != 0 ? c < 0 : a < b;
  });
}

/// Orders points in the same cell of a coarser Hilbert curve along a Hilbert curve through the box of these points.
void refine_run(std::span<const Vec3> points, std::span<VertexIndex> run) {
  if (run.size() <= 4) return sort_small(points, run);
  const HilbertPlaces place(points, run, levels_for(run.size()));
  if (place.single_place()) return sort_small(points, run);
  std::vector<std::pair<std::uint64_t, VertexIndex>> items;
  items.reserve(run.size());
  for (const VertexIndex v : run) items.emplace_back(place(points[v]), v);
  std::sort(items.begin(), items.end());
  for (std::size_t i = 0; i < run.size(); ++i) run[i] = items[i].second;
  for (std::size_t i = 0, j; i < run.size(); i = j) {
    for (j = i + 1; j < run.size() && items[j].first == items[i].first;) ++j;
    if (j - i > 1) refine_run(points, run.subspan(i, j - i));
  }
}

/// Cuts the Hilbert curve into parts that hold equally many points of the last and largest round, and stores the number
/// of its part for each point.
void assign_places(std::span<const std::uint64_t> items, std::uint64_t place_mask, SpatialOrder& result) {
  const std::size_t first = result.round_begin[result.round_begin.size() - 2], n = items.size() - first;
  std::vector<std::uint64_t> cut;
  for (unsigned i = 1; i < SpatialOrder::n_places; ++i)
    cut.push_back(items[first + n * i / SpatialOrder::n_places] >> index_bits & place_mask);
  result.place.resize(items.size());
  for (std::size_t r = 0; r + 1 < result.round_begin.size(); ++r) {
    std::size_t part = 0;
    for (std::size_t i = result.round_begin[r]; i < result.round_begin[r + 1]; ++i) {
      const std::uint64_t key = items[i] >> index_bits & place_mask;
      while (part < cut.size() && cut[part] <= key) ++part;
      result.place[i] = static_cast<std::uint16_t>(part);
    }
  }
}

}  // namespace

SpatialOrder spatial_order(std::span<const Vec3> points, std::span<std::uint64_t> scratch, unsigned threads) {
  const std::size_t n = points.size();
  GEOMESH_CHECK(n <= index_mask);
  std::vector<std::uint64_t> own;
  if (scratch.size() < 2 * n) {
    own.resize(2 * n);
    scratch = own;
  }
  std::span<std::uint64_t> items = scratch.first(n);
  SpatialOrder result;
  result.order.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.order[i] = static_cast<VertexIndex>(i);
  const int levels = levels_for(points.size());
  const HilbertPlaces place(points, result.order, levels);
  const CoordinateHash hash(place.low(), place.extent());
  for_each_index(n, threads, [&](std::size_t i) {
    const auto zeros =
        static_cast<unsigned>(std::countr_zero(hash(points[i]) | std::uint64_t{1} << 3 * (n_rounds - 1)) / 3);
    const std::uint64_t round = n_rounds - 1 - zeros;
    items[i] = (round << 3 * levels | place(points[i])) << index_bits | i;
  });
  radix_sort(items, scratch.subspan(n, n), 3 * levels + 3);
  for (std::size_t i = 0; i < items.size(); ++i) result.order[i] = static_cast<VertexIndex>(items[i] & index_mask);
  result.round_begin.push_back(0);
  for (std::size_t i = 1; i < items.size(); ++i)
    if (items[i] >> (index_bits + 3 * levels) != items[i - 1] >> (index_bits + 3 * levels))
      result.round_begin.push_back(i);
  if (!items.empty()) result.round_begin.push_back(items.size());
  if (!items.empty()) assign_places(items, (std::uint64_t{1} << 3 * levels) - 1, result);
  for (std::size_t i = 0, j; i < items.size(); i = j) {
    for (j = i + 1; j < items.size() && items[j] >> index_bits == items[i] >> index_bits;) ++j;
    if (j - i > 1) refine_run(points, std::span(result.order).subspan(i, j - i));
  }
  return result;
}

std::vector<VertexIndex> hilbert_order(std::span<const Vec3> points) {
  std::vector<VertexIndex> order(points.size());
  std::iota(order.begin(), order.end(), VertexIndex{0});
  refine_run(points, order);
  return order;
}

}  // namespace geomesh
