// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Accounts for the tolerance of a run: how far surfaces of the mesh may be from the input, how far each stage has
/// moved them, and what is left for the next stage. It is the only such record: stages take from it; the report, the
/// page and the checker read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Share of the tolerance that one stage used. Lengths in the model's unit.
struct ToleranceUse {
  /// Stage that moved surfaces: "gridding", "smoothing", "resampling", "level sets", "settling", "order and thickness",
  /// "merging", "remeshing".
  std::string stage;
  /// Upper bound of the movement, for which later stages must leave room. It is subtracted from what is left, unless a
  /// project key of its own allowed it.
  double taken = 0;
  bool by_own_key = false;        ///< set if `merge_within` allowed it, so that it is not part of the tolerance
  std::optional<double> moved{};  ///< largest movement that was measured; empty if the stage only proves the bound
  std::string surface{};          ///< name of the surface that moved farthest; empty if the stage does not know it
  std::optional<Vec3> place{};    ///< place where it moved farthest
};

/// Invariant: requested() is the sum of left() and what was taken, and left() is never negative.
class ToleranceLedger {
 public:
  /// Makes a ledger without tolerance: surfaces are kept exactly.
  ToleranceLedger() = default;
  /// Makes a ledger with the same length everywhere. Precondition: above 0.
  static ToleranceLedger of_length(double length);
  /// Makes a ledger with a share of the target size at each place. Its length is known once follow_size was called.
  static ToleranceLedger of_sizes(double share);

  bool follows_sizes() const { return share_ > 0; }
  /// Returns the largest distance promised to the user, at the largest size.
  double requested() const { return left_ + taken_; }
  /// Returns the largest distance that the following stages may use.
  double left() const { return left_; }
  /// Returns left() as a share of the target size at a place; 0 if it is one length everywhere.
  double left_share() const { return share_; }
  /// Returns the largest possible distance between the input as built and the mesh: what was requested, plus what
  /// separate project keys allowed.
  double bound() const;
  const std::vector<ToleranceUse>& uses() const { return uses_; }

  /// Sets the length that belongs to the largest target size. Does nothing if the tolerance does not follow sizes.
  void follow_size(double largest);
  /// Records what a stage used. Throws InternalError if it used more than is left.
  void take(ToleranceUse use);
  /// From here on, surfaces must also stay within this share of the size at each place, if that is less. `left` remains
  /// the limit everywhere.
  void limit_share(double share);
  /// Sets what is left after all sizes were scaled, which changes it: `left` belongs to the new sizes.
  void rescale_left(double left) { left_ = left; }

 private:
  double left_ = 0, share_ = 0, taken_ = 0;
  std::vector<ToleranceUse> uses_;
};

}  // namespace geomesh::geomodel
