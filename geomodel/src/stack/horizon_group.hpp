// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A group of horizons that are settled (put in stratigraphic order) together over one part of the map.
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
#include "stack/throw/both_sides.hpp"

namespace geomesh::geomodel {

/// The horizons of a group, youngest first, and the area of the map over which they are put in order.
struct GroupMembers {
  Stack stack;
  std::vector<BlockData> data;        ///< each horizon's triangles and blocks, in the coordinate frame of the map
  std::vector<HorizonFaults> faults;  ///< one a horizon
  MapBounds bounds;                   ///< in the frame
  /// Returns whether a place of the model counts for the areas, moves and volumes in the report. If empty, all places
  /// count.
  std::function<bool(const Vec3&)> counts{};
};

enum class Settling {
  settled,
  not_needed,  ///< the horizons are in order, so nothing is changed
  refused,     ///< the horizons cannot be put in order, and a note says why
  overhangs,   ///< a horizon has more than one height over some place of the map
};

class HorizonGroup {
 public:
  /// `built` holds the horizons' names and receives notes. All arguments except `members` must outlive the
  /// HorizonGroup.
  HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame);

  /// Returns whether a horizon ends inside the model. It perhaps ends exactly on a fault, which it would leave if
  /// moved.
  bool ends_inside() const { return !layout_.lines.empty() || strips_.is_open; }
  /// Returns the first horizon with more than one height over some place of the map; the number of horizons if there is
  /// none.
  std::size_t first_that_overhangs() const;
  Settling settle();

  // The settled horizons and their report may only be queried after settle() has returned Settling::settled.

  SettledStack& told() { return told_; }
  /// Returns a settled horizon without throw, in model coordinates and with its original orientation.
  TriangulatedSurface sheet(std::size_t horizon) const;
  bool has_throw(std::size_t horizon) const { return members_.data[horizon].has_throw(); }
  const SidedHorizon& sided(std::size_t horizon) const { return sided_[horizon]; }
  /// Returns a settled horizon with throw, in model coordinates and with its original orientation.
  TriangulatedSurface surface_with_throw(std::size_t horizon) const;

 private:
  const TriangulatedSurface& given(std::size_t horizon) const { return built_.surfaces[members_.stack.rows[horizon]]; }
  bool crosses_by_mistake() const;
  std::size_t first_lost() const;
  std::size_t first_against_rule() const;
  bool moves_alone() const;
  bool has_throw() const;
  double least_thickness() const;
  MapSheets draw_sheets(const std::vector<ThinArea>& areas, const SheetOptions& options);
  /// Builds horizons with throw from both sides of faults. Returns false, with a note, if the target size is too
  /// coarse.
  bool add_sides(const SheetOptions& options);
  void ask_for_sizes(double thickness);
  void describe(const std::vector<ThinArea>& areas, const SheetOptions& options);

  GroupMembers members_;
  BuiltSurfaces& built_;
  const ModelRules& rules_;
  const MapFrame& frame_;
  FaultStrips strips_;
  std::vector<const TriangulatedSurface*> horizons_;
  MapLayout layout_;
  std::unique_ptr<MapSamples> samples_;
  MapSheets sheets_;
  std::vector<SidedHorizon> sided_;
  SettledStack told_;
};

}  // namespace geomesh::geomodel
