// SPDX-License-Identifier: MIT
/// @file
/// The target size of elements as a function of position. The field is h(x) = clamp(min(global, caps, callback(x),
/// min_i(s_i + g_i max(0, |x - p_i| - r_i)))): point sources have a size s_i that is constant within a radius r_i and
/// grows with the gradation g_i beyond. The field is therefore Lipschitz continuous with the greatest g_i if caps and
/// callback are. It is evaluated exactly (no background mesh, no interpolation) by branch and bound over a kd-tree of
/// the sources, in nearly logarithmic time.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A place near which a size is requested.
struct SizeSource {
  Vec3 point;
  double size = 0;
  double radius = 0;     ///< distance from the source up to which its size is constant
  double gradation = 0;  ///< growth of the size per unit of distance beyond `radius`; 0: the field's gradation
};

class SizeField {
 public:
  struct Limits {
    double global = std::numeric_limits<double>::infinity();
    double min_size = 0;
    double max_size = std::numeric_limits<double>::infinity();
    double gradation = 0.3;                           ///< growth of the target size per unit of distance; positive
    std::vector<double> component_size{};             ///< target size by component; 0 or missing: none
    std::function<double(const Vec3&)> background{};  ///< target size by place; values up to 0 request nothing
  };

  SizeField() = default;
  /// Builds a size field. Drops sources that other sources make redundant. O(n log n).
  SizeField(std::vector<SizeSource> sources, Limits limits);

  /// Returns the target size at a place in a component (no_index: in none).
  double at(const Vec3& p, Index component = no_index) const;
  /// Returns the target size at p as at() does, but faster, for callers that do not distinguish sizes up to `enough`:
  /// if the size is at most `enough`, any value up to `enough` may be returned.
  double at_unless_below(double enough, const Vec3& p, Index component = no_index) const;
  /// Returns the target size at p as at() does, but faster, because the size at a place q nearby is known. If the size
  /// is at least `at_most`, any value of at least `at_most` may be returned, which is faster still.
  double at_beside(const Vec3& p, Index component, const Vec3& q, double size_at_q,
                   double at_most = std::numeric_limits<double>::infinity()) const;
  /// Returns the largest change of the size per unit of distance; infinity if the size may jump.
  double steepest() const { return may_jump() ? std::numeric_limits<double>::infinity() : steepest_; }
  const Limits& limits() const { return limits_; }
  std::size_t n_sources() const { return sources_.size(); }
  /// Returns the field with all sizes multiplied by a factor (exactly by a power of two); radii and gradations remain.
  SizeField times(double factor) const;
  /// Returns the sources that are not redundant, with their gradations. With equal limits they define the same field.
  const std::vector<SizeSource>& sources() const { return sources_; }

 private:
  struct Node {
    Box3 box;
    double least = 0;           ///< least size of a source in this subtree of the kd-tree
    double widest = 0;          ///< largest radius of a source in this subtree of the kd-tree
    double gradation = 0;       ///< least gradation of a source in this subtree of the kd-tree
    Index first = 0, last = 0;  ///< sources
    Index left = no_index, right = no_index;
  };
  bool may_jump() const { return !limits_.component_size.empty() || limits_.background != nullptr; }
  Index build(Index first, Index last);
  bool drop_redundant();
  double least_over_sources(const Vec3& p, double bound, double enough = 0) const;
  double at(const Vec3& p, Index component, double at_most, double enough = 0) const;

  Limits limits_;
  std::vector<SizeSource> sources_;
  std::vector<Node> nodes_;
  double steepest_ = 0;  ///< largest gradation of a source
};

}  // namespace geomesh
