// SPDX-License-Identifier: MIT
#include "geomesh/core/size_field.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "geomesh/core/error.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

namespace {

using search::squared_distance_to;

constexpr Index leaf_size = 8;

/// Returns whether a source of the given size, radius and gradation requires `bound` or more at the given distance and
/// beyond. Computed without roots and divisions.
bool asks_at_least(double bound, double squared_distance, double size, double radius, double gradation) {
  if (size >= bound) return true;
  // gradation times the distance from the source at which the size that it requires reaches `bound`
  const double reach = radius * gradation + (bound - size);
  return squared_distance * gradation * gradation >= reach * reach;
}

}  // namespace

SizeField::SizeField(std::vector<SizeSource> sources, Limits limits)
    : limits_(std::move(limits)), sources_(std::move(sources)) {
  GEOMESH_CHECK(limits_.gradation > 0);
  std::erase_if(sources_, [&](const SizeSource& s) { return !(s.size > 0) || s.size >= limits_.max_size; });
  for (SizeSource& s : sources_)
    if (!(s.gradation > 0)) s.gradation = limits_.gradation;
  if (sources_.empty()) return;
  for (const SizeSource& s : sources_) steepest_ = std::max(steepest_, s.gradation);
  build(0, static_cast<Index>(sources_.size()));
  if (drop_redundant()) {
    nodes_.clear();
    build(0, static_cast<Index>(sources_.size()));
  }
}

SizeField SizeField::times(double factor) const {
  Limits limits = limits_;
  for (double* size : {&limits.global, &limits.min_size, &limits.max_size}) *size *= factor;
  for (double& size : limits.component_size) size *= factor;
  if (limits.background)
    limits.background = [factor, background = limits.background](const Vec3& p) { return factor * background(p); };
  std::vector<SizeSource> sources = sources_;
  for (SizeSource& source : sources) source.size *= factor;
  return SizeField(std::move(sources), std::move(limits));
}

/// Removes redundant sources and returns whether there were any. A source is redundant if no source has a larger
/// gradation, and another source requires less at its point by more than the redundant one's gradation times radius.
bool SizeField::drop_redundant() {
  std::vector<SizeSource> kept;
  for (const SizeSource& s : sources_) {
    const double limit = s.size - s.gradation * s.radius;
    if (s.gradation < steepest_ || !(least_over_sources(s.point, limit) < limit)) kept.push_back(s);
  }
  const bool dropped = kept.size() < sources_.size();
  sources_ = std::move(kept);
  return dropped;
}

Index SizeField::build(Index first, Index last) {
  const Index n = static_cast<Index>(nodes_.size());
  Node node;
  node.first = first, node.last = last;
  node.least = node.gradation = std::numeric_limits<double>::infinity();
  for (Index i = first; i < last; ++i) {
    node.box.add(sources_[i].point);
    node.least = std::min(node.least, sources_[i].size);
    node.widest = std::max(node.widest, sources_[i].radius);
    node.gradation = std::min(node.gradation, sources_[i].gradation);
  }
  nodes_.push_back(node);
  if (last - first > leaf_size) {
    const Vec3 extent = node.box.max - node.box.min;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Index middle = first + (last - first) / 2;
    std::nth_element(sources_.begin() + first, sources_.begin() + middle, sources_.begin() + last,
                     [axis](const SizeSource& a, const SizeSource& b) {
                       return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis] : a.size < b.size;
                     });
    const Index left = build(first, middle);
    const Index right = build(middle, last);
    nodes_[n].left = left;
    nodes_[n].right = right;
  }
  return n;
}

double SizeField::least_over_sources(const Vec3& p, double bound, double enough) const {
  if (nodes_.empty()) return bound;
  struct Entry {
    Index node;
    double squared_distance;
  };
  const auto entry = [&](Index n) { return Entry{n, squared_distance_to(nodes_[n].box, p)}; };
  Entry stack[96];
  int top = 0;
  stack[top++] = entry(0);
  while (top > 0 && bound > enough) {
    const Entry e = stack[--top];
    const Node& n = nodes_[e.node];
    if (asks_at_least(bound, e.squared_distance, n.least, n.widest, n.gradation)) continue;
    if (n.left == no_index) {
      for (Index i = n.first; i < n.last; ++i) {
        const SizeSource& s = sources_[i];
        const Vec3 d = p - s.point;
        const double squared = dot(d, d);
        if (!asks_at_least(bound, squared, s.size, s.radius, s.gradation))
          bound = std::min(bound, s.size + s.gradation * std::max(0.0, std::sqrt(squared) - s.radius));
      }
      continue;
    }
    const Entry left = entry(n.left), right = entry(n.right);
    const bool left_first = left.squared_distance <= right.squared_distance;
    stack[top++] = left_first ? right : left;
    stack[top++] = left_first ? left : right;
  }
  return bound;
}

double SizeField::at(const Vec3& p, Index component) const {
  return at(p, component, std::numeric_limits<double>::infinity());
}

double SizeField::at_unless_below(double enough, const Vec3& p, Index component) const {
  return at(p, component, std::numeric_limits<double>::infinity(), enough);
}

double SizeField::at_beside(const Vec3& p, Index component, const Vec3& q, double size_at_q, double at_most) const {
  constexpr double rounding = 1 + 1e-9;
  if (may_jump()) return at(p, component, at_most);
  const Vec3 d = p - q;
  return at(p, component, std::min(at_most, rounding * (size_at_q + steepest_ * length(d))));
}

double SizeField::at(const Vec3& p, Index component, double at_most, double enough) const {
  double h = std::min({limits_.global, limits_.max_size, at_most});
  if (component < limits_.component_size.size() && limits_.component_size[component] > 0)
    h = std::min(h, limits_.component_size[component]);
  if (limits_.background) {
    const double b = limits_.background(p);
    if (b > 0) h = std::min(h, b);
  }
  return std::max(least_over_sources(p, h, enough), limits_.min_size);
}

}  // namespace geomesh
