// SPDX-License-Identifier: MIT
/// @file
/// The size that elements are asked to have, as a function of place.
///
/// The field is h(x) = clamp(min(global, caps, callback(x), min_i(s_i + g_i max(0, |x - p_i| - r_i)))): point sources
/// with size s_i that holds within a radius r_i and grows with the gradation g_i beyond. So it is Lipschitz with the
/// greatest of these where caps and callback are. Evaluated exactly (no background mesh, no interpolation) by branch
/// and bound over a kd-tree of the sources: near-logarithmic.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// A place near which a size is asked.
struct SizeSource {
  Vec3 point;
  double size = 0;
  double radius = 0;     ///< the size holds unchanged within this distance
  double gradation = 0;  ///< growth beyond; 0: the field's
};

class SizeField {
 public:
  struct Limits {
    double global = std::numeric_limits<double>::infinity();
    double min_size = 0;
    double max_size = std::numeric_limits<double>::infinity();
    double gradation = 0.3;                         ///< growth of the size per unit of distance; positive
    std::vector<double> component_size;             ///< per component; 0 or missing: none asked
    std::function<double(const Vec3&)> background;  ///< optional; a value that is not positive asks for nothing
  };

  SizeField() = default;
  /// Sources that others make redundant are dropped. O(n log n).
  SizeField(std::vector<SizeSource> sources, Limits limits);

  /// Size asked at a place of a component (no_index: of none).
  double at(const Vec3& p, Index component = no_index) const;
  /// The same, sooner, where no size up to `enough` matters: those come out as at most that.
  double at_unless_below(double enough, const Vec3& p, Index component = no_index) const;
  /// The same, sooner, where the size at a place q nearby is known. It is sooner again where no size beyond `at_most`
  /// matters: those come out as at least that.
  double at_beside(const Vec3& p, Index component, const Vec3& q, double size_at_q,
                   double at_most = std::numeric_limits<double>::infinity()) const;
  /// By which sizes differ at most, a unit of distance; infinity where they may jump.
  double steepest() const { return may_jump() ? std::numeric_limits<double>::infinity() : steepest_; }
  const Limits& limits() const { return limits_; }
  std::size_t n_sources() const { return sources_.size(); }
  /// All sizes asked times a factor; where they hold and how they grow stays. Powers of two do not round.
  SizeField times(double factor) const;
  /// Those that are left, each with its gradation. With the same limits they make the same field.
  const std::vector<SizeSource>& sources() const { return sources_; }

 private:
  struct Node {
    Box3 box;
    double least = 0;           ///< least size of a source below
    double widest = 0;          ///< largest radius of a source below
    double gradation = 0;       ///< least of a source below
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
  double steepest_ = 0;  ///< gradation of a source
};

}  // namespace geomesh
