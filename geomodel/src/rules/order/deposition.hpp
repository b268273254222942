// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The units of the column at a place, which follow from the horizons in the order in which they were deposited.
#pragma once

#include <memory>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/order/column_heights.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {

/// The heights of the column's horizons over each place before any of them cut another one, and the order that the
/// rules make of them. For horizons with throw, the block is used that lies on the place's sides of the faults. The
/// unit is therefore known even where a horizon was removed because another one cut it. Surfaces are copied.
class DepositedHorizons {
 public:
  /// Throws Error{usage} if the column names a surface that does not exist. `built` holds the blocks; it may have fewer
  /// surfaces.
  DepositedHorizons(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built, const ModelRules& rules);

  /// Returns the units that are possible at p: one, or several if a horizon is absent there or has several heights.
  /// Empty if the horizons contradict each other. O(horizons * log triangles) and the square of the horizons.
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
    /// For each block, the faults on both sides of which it lies; or empty.
    std::vector<std::vector<bool>> on_both_sides{};
    std::vector<Sheet> blocks{};  ///< one sheet for each block; a single one if there are no blocks
  };
  static Horizon horizon_of(const TriangulatedSurface& surface, const BuiltRows& built, Index row,
                            const std::vector<TriangulatedSurface>& surfaces);
  static double height(const Horizon& horizon, const Vec3& p);  ///< NaN: not there

  std::vector<Horizon> horizons_;
  Keepers keepers_;
};

/// Returns the naming rules with the model's unconformities and with DepositedHorizons::units_at, which gives no
/// information if there is no column or if it has more than `most_horizons`. Surfaces are read at the first call, so
/// they must outlive the result. Not thread-safe.
NamingRules with_heights(NamingRules naming, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                         const ModelRules& rules);

}  // namespace geomesh::geomodel
