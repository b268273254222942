// SPDX-License-Identifier: MIT
#include "tetrahedralize/canonical_frame.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/hash.hpp"

namespace geomesh {

namespace {

using Hash = std::uint64_t;

/// Factors that distinguish the hashes of different kinds of items.
constexpr Hash facet_factor = 0x9E3779B97F4A7C15ull, segment_factor = 0xD1B54A32D192ED03ull,
               inner_segment_factor = 0x8CB92BA72F3D8DD7ull, inner_point_factor = 0xA24BAED4963EE407ull,
               isolated_factor = 0x9FB21C651E98DF25ull;

class FrameChoice {
 public:
  FrameChoice(const PiecewiseLinearComplex& plc, const std::vector<VertexIndex>& used) : plc_(plc), used_(used) {
    for (const VertexIndex v : used) box_.add(plc.points[v]);
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, box_.max[i] - box_.min[i]);
    scale_ = extent > 0 ? std::ldexp(1.0, -std::ilogb(extent)) : 1;
  }

  AxisFrame run() {
    sign_ends();
    std::vector<AxisFrame> frames = frames_by_ends();
    keep_least(frames, [&](const AxisFrame& f) { return signature_of_points(f); });
    keep_least(frames, [&](const AxisFrame& f) { return signature_of_items(f); });
    return frames.front();
  }

 private:
  /// Returns a hash of the distance (+0, never -0) of p from the low or the high end of the box along an axis.
  Hash hash_from_end(const Vec3& p, std::size_t axis, bool from_high) const {
    const double distance = from_high ? box_.max[axis] - p[axis] : p[axis] - box_.min[axis];
    return mixed(std::bit_cast<Hash>(distance * scale_ + 0.0));
  }
  void sign_ends() {
    for (const VertexIndex v : used_)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t end = 0; end < 2; ++end) ends_[axis][end] += hash_from_end(plc_.points[v], axis, end == 1);
  }

  /// Returns the frames in which axes, and their ends, ascend by the hashes in ends_: only one if all hashes differ.
  std::vector<AxisFrame> frames_by_ends() const {
    const auto key = [&](std::size_t axis) { return std::minmax(ends_[axis][0], ends_[axis][1]); };
    std::vector<AxisFrame> frames;
    std::array<std::uint8_t, 3> axes{0, 1, 2};
    do {
      if (key(axes[1]) < key(axes[0]) || key(axes[2]) < key(axes[1])) continue;
      for (unsigned turned = 0; turned < 8; ++turned) {
        bool ascends = true;
        AxisFrame frame{axes, {}};
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t start = turned >> i & 1u;
          ascends = ascends && ends_[axes[i]][start] <= ends_[axes[i]][1 - start];
          frame.direction[i] = start == 0 ? 1 : -1;
        }
        if (ascends) frames.push_back(frame);
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return frames;
  }

  template <class Signature>
  static void keep_least(std::vector<AxisFrame>& frames, const Signature& signature) {
    if (frames.size() == 1) return;
    std::vector<Hash> of;
    for (const AxisFrame& f : frames) of.push_back(signature(f));
    const Hash least = *std::min_element(of.begin(), of.end());
    std::vector<AxisFrame> kept;
    for (std::size_t i = 0; i < frames.size(); ++i)
      if (of[i] == least) kept.push_back(frames[i]);
    frames = std::move(kept);
  }

  Hash hash_of_point(const AxisFrame& f, VertexIndex v) const {
    Hash h = 0;
    for (std::size_t i = 0; i < 3; ++i) h = mixed(h ^ hash_from_end(plc_.points[v], f.axis[i], f.direction[i] < 0)) + i;
    return h;
  }
  Hash signature_of_points(const AxisFrame& f) const {
    Hash sum = 0;
    for (const VertexIndex v : used_) sum += hash_of_point(f, v);
    return sum;
  }
  /// Returns a sum of hashes of the facets, by their edges, and of segments and points, by their vertices.
  Hash signature_of_items(const AxisFrame& f) const {
    std::vector<Hash> of_point(plc_.points.size());
    for (const VertexIndex v : used_) of_point[v] = hash_of_point(f, v);
    const auto of_edge = [&](VertexIndex a, VertexIndex b) { return mixed(of_point[a] + of_point[b]); };
    Hash sum = 0;
    std::vector<Hash> of_facet(plc_.n_facets());
    for (Index facet = 0; facet < plc_.n_facets(); ++facet) {
      for (Index l = plc_.facet_loops[facet]; l < plc_.facet_loops[facet + 1]; ++l) {
        const auto loop = plc_.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) of_facet[facet] += of_edge(loop[i], loop[(i + 1) % loop.size()]);
      }
      sum += mixed(of_facet[facet] * facet_factor);
    }
    for (const auto& s : plc_.facet_segments)
      sum += mixed((of_facet[s.facet] + of_edge(s.a, s.b)) * inner_segment_factor);
    for (const auto& p : plc_.facet_points) sum += mixed((of_facet[p.facet] + of_point[p.v]) * inner_point_factor);
    for (const auto& s : plc_.segments) sum += mixed(of_edge(s.a, s.b) * segment_factor);
    for (const VertexIndex v : plc_.isolated_points) sum += mixed(of_point[v] * isolated_factor);
    return sum;
  }

  const PiecewiseLinearComplex& plc_;
  const std::vector<VertexIndex>& used_;
  Box3 box_;
  double scale_ = 1;
  std::array<std::array<Hash, 2>, 3> ends_{};  ///< hashes of the model as seen from each axis' low end and high end
};

}  // namespace

AxisFrame canonical_frame(const PiecewiseLinearComplex& plc, const std::vector<VertexIndex>& used) {
  return FrameChoice(plc, used).run();
}

}  // namespace geomesh
