// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A group of horizons that are settled together over one part of the map.
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

/// The horizons of a group, youngest first, and the area of the map where they are settled.
struct GroupMembers {
  Stack stack;
  std::vector<TriangulatedSurface> data;  ///< data of each horizon, in the coordinate frame of the map
  MapBounds bounds;                       ///< in the frame
  /// Returns whether a place of the model counts for the areas, moves and volumes in the report. Empty: all places
  /// count.
  std::function<bool(const Vec3&)> counts{};
};

enum class Settling {
  settled,
  not_needed,  ///< the group needs no settling
  overhangs,   ///< a horizon has more than one height over some place of the map
};

class HorizonGroup {
 public:
  /// `built` receives notes and holds the names of the horizons. All arguments except the members must outlive this
  /// object.
  HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame);

  /// Returns whether a horizon ends inside the model. It may end exactly on a fault or body, and moving it would break
  /// that contact.
  bool ends_inside() const { return !layout_.lines.empty(); }
  /// Returns the first horizon with more than one height over some place of the map; the number of horizons if there is
  /// none.
  std::size_t first_that_overhangs() const;
  Settling settle();

  // The functions below require that the group was settled.

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
