// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the unit of the column at a place, from the horizons in the order in which they were deposited.
#pragma once

#include <memory>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/order/column_heights.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {

/// The heights of the column's horizons over each place before any of them cut another, and the order in which the
/// rules put them. For a horizon with throw, the block on the place's sides of the faults is used. The unit is
/// therefore known even where a horizon was removed because another one cut it. Surfaces are copied.
class DepositedHorizons {
 public:
  /// Throws Error{usage} if the column names a surface that does not exist. `built` holds the division of horizons into
  /// blocks; it may cover fewer surfaces.
  DepositedHorizons(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built, const ModelRules& rules);

  /// Returns the units that are possible at the point p: one, or several if a horizon is absent or has several heights.
  /// Empty if the horizons contradict each other. O(h log t + h^2) for h horizons of t triangles.
  UnitRange units_at(const Vec3& p) const;

 private:
  /// A part of a horizon that has one height over each place of the map.
  struct Sheet {
    TriangulatedSurface surface{};
    std::unique_ptr<MapLocator> locator{};
  };
  struct Horizon {
    std::vector<FaultSides> faults{};
    std::vector<std::vector<bool>> sides{};  ///< per block
    /// For each block, the faults on both sides of which it lies; empty if there are none.
    std::vector<std::vector<bool>> on_both_sides{};
    std::vector<Sheet> blocks{};  ///< part of the horizon in each block; all of it if there are no blocks
  };
  static Horizon horizon_of(const TriangulatedSurface& surface, const BuiltRows& built, Index row,
                            const std::vector<TriangulatedSurface>& surfaces);
  static double height(const Horizon& horizon, const Vec3& p);  ///< NaN: not there

  std::vector<Horizon> horizons_;
  Keepers keepers_;
};

/// Returns the rules that name the model's units, extended by its unconformities and by the units that
/// DepositedHorizons finds from the heights of horizons. These are not used if there is no column or if it has more
/// than `most_horizons`. Surfaces are read at the first call, so they must outlive the result. Not thread-safe.
NamingRules with_heights(NamingRules naming, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                         const ModelRules& rules);

}  // namespace geomesh::geomodel
