// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The units of the column at a place, which follow from the horizons in the order in which they were deposited.
#pragma once

#include <memory>
#include <vector>

#include "geomesh/geomodel/build_model.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"
#include "rules/order/column_heights.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {

/// The heights of the column's horizons over each place before any cut another one, and what the rules make of them.
/// Horizons with throw count by the block in which the place lies. So the unit is known, too, where
/// nothing is left of a horizon: another one cut it there. Surfaces are copied.
class LaidDown {
 public:
  /// Throws Error{usage} if the column names a surface that does not exist. `built` holds the blocks; it may have fewer
  /// surfaces.
  LaidDown(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built, const ModelRules& rules);

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
    std::shared_ptr<const HorizonBlocks> between{};  ///< null: it is one whole
    std::vector<Index> field_of_block{};             ///< as in BuiltRows
    std::vector<Sheet> blocks{};                     ///< or fields; one where there are none
  };
  static Horizon horizon_of(const TriangulatedSurface& surface, const BuiltRows& built, Index row);
  static double height(const Horizon& horizon, const Vec3& p);  ///< NaN: not there

  std::vector<Horizon> horizons_;
  Keepers keepers_;
};

/// Returns the naming rules with the model's unconformities and with LaidDown::units_at, which gives no information if
/// there is no column or if it has more than `most_horizons`. Surfaces are read at the first call, so they must outlive
/// the result. Not thread-safe.
NamingRules with_heights(NamingRules naming, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                         const ModelRules& rules);

}  // namespace geomesh::geomodel
