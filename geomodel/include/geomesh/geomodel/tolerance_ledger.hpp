// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Accounts for the tolerance of a run: how far the mesh's surfaces may be from the input, how far each stage has moved
/// them, and what is left for the next stage. Stages record here what they use; the report and the checker read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Share of the tolerance that one stage used to move surfaces. Lengths in the model's unit.
struct ToleranceUse {
  /// Stage that moved surfaces: "gridding", "smoothing", "resampling", "level sets", "settling", "order and thickness",
  /// "merging", "remeshing".
  std::string stage;
  /// Upper bound of how far the stage moved surfaces, which later stages must allow for. It is subtracted from the
  /// remaining tolerance, unless a separate key of the project allowed the movement.
  double taken = 0;
  /// Whether the key `merge_within` allowed this movement of surfaces, which is then not part of the tolerance.
  bool by_own_key = false;
  /// Largest movement of a surface that was measured; empty if the stage only proves an upper bound.
  std::optional<double> moved{};
  std::string surface{};        ///< name of the surface that moved farthest; empty if the stage does not know it
  std::optional<Vec3> place{};  ///< place where a surface moved farthest
};

/// The requested tolerance and how much of it is left. Invariant: requested() is the sum of left() and what stages
/// took, and left() is never negative.
class ToleranceLedger {
 public:
  /// Makes a ledger of no tolerance: surfaces are kept exactly.
  ToleranceLedger() = default;
  /// Makes a ledger of a tolerance that is the same length everywhere. Precondition: the length is above 0.
  static ToleranceLedger of_length(double length);
  /// Makes a ledger of a tolerance that is a share of the target size at each place. follow_size sets its length.
  static ToleranceLedger of_sizes(double share);

  bool follows_sizes() const { return share_ > 0; }
  /// Returns the largest distance from the input that was promised to the user, where the target size is largest.
  double requested() const { return left_ + taken_; }
  /// Returns the largest distance by which the stages that follow may move surfaces.
  double left() const { return left_; }
  /// Returns the remaining tolerance as a share of the target size at each place; 0 if it is a constant length.
  double left_share() const { return share_; }
  /// Returns the largest possible distance between the input as built and the mesh: the requested tolerance, plus the
  /// movements that separate project keys allowed.
  double bound() const;
  const std::vector<ToleranceUse>& uses() const { return uses_; }

  /// Sets the length of a tolerance that is a share of the target size, for the largest target size of the mesh.
  void follow_size(double largest);
  /// Records the tolerance that a stage used. Throws InternalError if it used more than is left.
  void take(ToleranceUse use);
  /// Restricts the tolerance of the following stages to a share of the target size at each place, if that is less than
  /// before. The length left() remains the limit everywhere.
  void limit_share(double share);
  /// Sets the remaining tolerance after all target sizes were scaled: `left` is its length for the new sizes.
  void rescale_left(double left) { left_ = left; }

 private:
  double left_ = 0, share_ = 0, taken_ = 0;
  std::vector<ToleranceUse> uses_;
};

}  // namespace geomesh::geomodel
