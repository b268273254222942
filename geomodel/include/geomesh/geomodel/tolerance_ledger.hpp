// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far surfaces of the mesh may be off the input, what each stage has moved them by, and what is left for the next
/// stage. It is the one record of the tolerance in a run: stages take from it, and report, page and checker read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// What one stage used of the tolerance. Lengths in the model's unit.
struct ToleranceUse {
  std::string stage;  ///< what moved surfaces: "gridding", "smoothing", "resampling", "level sets", "settling", "order
                      ///< and thickness", "merging", "remeshing"
  /// Bound on the movement that later stages must leave room for. It is subtracted from what is left, unless the
  /// project allowed it by a key of its own.
  double taken = 0;
  bool by_own_key = false;        ///< allowed by `merge_within`, so that it is not a part of the tolerance
  std::optional<double> moved{};  ///< the largest movement measured; nothing where the stage proves the bound alone
  std::string surface{};          ///< the surface that moved farthest; empty where the stage does not know it
  std::optional<Vec3> place{};    ///< where it moved farthest
};

/// Invariant: requested() is left() and what was taken, and left() is never negative.
class ToleranceLedger {
 public:
  /// Surfaces are kept exactly.
  ToleranceLedger() = default;
  /// One length everywhere. Precondition: above 0.
  static ToleranceLedger of_length(double length);
  /// A share of the size requested at each place. Its length is known once follow_size was called.
  static ToleranceLedger of_sizes(double share);

  bool follows_sizes() const { return share_ > 0; }
  /// The largest distance that the user was promised, at the largest size.
  double requested() const { return left_ + taken_; }
  /// The largest distance that stages to come may use.
  double left() const { return left_; }
  /// As left(), as a share of the size requested at the place; 0 for one length everywhere.
  double left_share() const { return share_; }
  /// The largest distance between the input as built and the mesh: what was requested, and what keys of their own
  /// allowed beside it.
  double bound() const;
  const std::vector<ToleranceUse>& uses() const { return uses_; }

  /// Sets the length that belongs to the largest size requested. Does nothing where it does not follow sizes.
  void follow_size(double largest);
  /// Books what a stage used. Throws InternalError if it used more than is left.
  void take(ToleranceUse use);
  /// Surfaces are kept within this share of the size at each place from here on, if that is less. `left` stays the
  /// limit everywhere.
  void limit_share(double share);
  /// Sizes were scaled after stages had taken their part: `left` is what belongs to the new sizes.
  void rescale_left(double left) { left_ = left; }

 private:
  double left_ = 0, share_ = 0, taken_ = 0;
  std::vector<ToleranceUse> uses_;
};

}  // namespace geomesh::geomodel
