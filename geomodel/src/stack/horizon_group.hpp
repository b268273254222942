// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons that are settled together over one piece of the map.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stack/map/map_frame.hpp"
#include "stack/map/map_layout.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/sheets/sheet_approximation.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {

/// The horizons of a group, youngest first, and where they are settled.
struct GroupMembers {
  Stack stack;
  std::vector<TriangulatedSurface> data;  ///< one a horizon, in the frame
  MapBounds bounds;                       ///< in the frame
  /// Whether a place of the model counts for areas, moves and volumes that are told. Empty: all do.
  std::function<bool(const Vec3&)> counts{};
};

enum class Settling {
  settled,
  not_needed,  ///< nothing asks for it
  overhangs,   ///< a horizon has more than one height over a place of the map
};

class HorizonGroup {
 public:
  /// `built`: names of the horizons, and notes. All but the members outlives it.
  HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame);

  /// Horizons that end inside may do so exactly on a fault or body, which moving them would break.
  bool ends_inside() const { return !layout_.lines.empty(); }
  /// The first horizon with more than one height over a place of the map; their number: none.
  std::size_t first_that_overhangs() const;
  Settling settle();

  // The functions below may be called once the group is settled.

  SettledStack& told() { return told_; }
  /// A horizon in the model, oriented as it was.
  TriangulatedSurface sheet(std::size_t horizon) const;

 private:
  const TriangulatedSurface& given(std::size_t horizon) const { return built_.surfaces[members_.stack.rows[horizon]]; }
  bool crosses_by_mistake() const;
  double least_thickness() const;
  MapSheets draw_sheets(const std::vector<ThinArea>& areas, const SheetOptions& options);
  void ask_for_sizes(double thickness);
  void describe(const std::vector<ThinArea>& areas, const SheetOptions& options);

  GroupMembers members_;
  BuiltSurfaces& built_;
  const ModelRules& rules_;
  const MapFrame& frame_;
  std::vector<const TriangulatedSurface*> horizons_;
  MapLayout layout_;
  std::unique_ptr<MapSamples> samples_;
  MapSheets sheets_;
  SettledStack told_;
};

}  // namespace geomesh::geomodel
