// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The units of the column at a place, by the horizons as they were laid down.
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
  /// Throws Error{usage} where the column names no surface. `built` tells blocks; it may be of fewer surfaces.
  LaidDown(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built, const ModelRules& rules);

  /// The units that the horizons leave: one, or several where a horizon is not there, or there more than once. Empty
  /// where they contradict each other. O(horizons * log triangles) and the square of the horizons.
  UnitRange units_at(const Vec3& p) const;

 private:
  /// A part of a horizon of one height over each place.
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

/// The naming rules with the model's unconformities and LaidDown::units_at, which tells nothing without a column, or
/// with more than `most_horizons`. Surfaces are looked at when it is first asked, and must outlive it. Not for threads.
NamingRules with_heights(NamingRules naming, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                         const ModelRules& rules);

}  // namespace geomesh::geomodel
