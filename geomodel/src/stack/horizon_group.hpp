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
#include "stack/throw/both_sides.hpp"

namespace geomesh::geomodel {

/// The horizons of a group, youngest first, and where they are settled.
struct GroupMembers {
  Stack stack;
  std::vector<BlockData> data;        ///< one a horizon, in the frame
  std::vector<HorizonFaults> faults;  ///< one a horizon
  MapBounds bounds;                   ///< in the frame
  /// Whether a place of the model counts for areas, moves and volumes that are told. Empty: all do.
  std::function<bool(const Vec3&)> counts{};
};

enum class Settling {
  settled,
  not_needed,  ///< nothing asks for it
  refused,     ///< a note tells why
  overhangs,   ///< a horizon has more than one height over a place of the map
};

class HorizonGroup {
 public:
  /// `built`: names of the horizons, and notes. All but the members outlives it.
  HorizonGroup(GroupMembers members, BuiltSurfaces& built, const ModelRules& rules, const MapFrame& frame);

  /// Horizons that end inside may do so exactly on a fault or body, which moving them would break.
  bool ends_inside() const { return !layout_.lines.empty() || strips_.is_open; }
  /// The first horizon with more than one height over a place of the map; their number: none.
  std::size_t first_that_overhangs() const;
  Settling settle();

  // The functions below may be called once the group is settled.

  SettledStack& told() { return told_; }
  /// A horizon without throw, in the model, oriented as it was.
  TriangulatedSurface sheet(std::size_t horizon) const;
  bool has_throw(std::size_t horizon) const { return members_.data[horizon].has_throw(); }
  const SidedHorizon& sided(std::size_t horizon) const { return sided_[horizon]; }
  /// A horizon with throw, in the model, oriented as it was.
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
  /// Gives false, with a note, where triangles of the size do not do.
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
