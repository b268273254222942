// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which unit of the column a region is, by the rules of docs/output-files.md ("Column"): decided here from the faces
/// at the region and the input's sheets, not taken from the program's naming.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "check/exact/deviation.hpp"
#include "check/judged/claimed_faces.hpp"
#include "check/names/region_places.hpp"

namespace geomesh::geomodel::checking {

/// What is known of a region's place in the column.
struct UnitVerdict {
  Index first = no_index, last = no_index;  ///< units joined; no_index: no unit
  bool close = false;  ///< a horizon shows nearly as much of either side to the region: nothing is claimed
  bool open = false;   ///< the horizons at the region leave several units, the nearest of which this is
  Index first_possible = no_index, last_possible = no_index;  ///< of these
};

class UnitJudge {
 public:
  /// `reach`: how far a face may be off the triangles that it stands for.
  UnitJudge(const ClaimedFaces& claimed, double reach);

  bool given() const { return !units_.empty(); }
  const std::vector<std::string>& units() const { return units_; }
  /// By the horizons at the region; one for each place of the region by the vertical through it, where none is at it.
  /// Where these leave several units, or none, the input's horizons over and under each place tell more: rules may have
  /// cut all of one away there. Each unit that they leave is one verdict.
  std::vector<UnitVerdict> judge(std::int32_t region, const RegionPlace& place) const;
  std::string name_of(const UnitVerdict& verdict) const;
  /// Whether the surface is a horizon of the column.
  bool is_horizon(Index surface) const { return horizon_of_surface_.contains(surface); }

 private:
  /// Areas that horizons show to one region.
  struct Contacts {
    std::map<Index, double> below, above, both;  ///< by horizon: the region is below it, above it, on both its sides
  };
  struct Horizon {
    Index surface;
    bool is_unconformity;
    std::vector<int> upper_side;
    TriangleSet triangles;
    BoxTree tree;  ///< over the surface's triangles
  };
  void add_faces(double reach);
  UnitVerdict verdict_of(const Contacts& contacts) const;
  Contacts on_vertical(const Vec3& p) const;
  /// Narrows the units first .. last by horizons of the input that lie wholly over or wholly under p; where two of them
  /// contradict each other the range stays. False where none is over or under p.
  bool narrow(const Vec3& p, Index& first, Index& last) const;
  /// The units that `narrow` leaves at the places where it tells anything.
  struct Narrowed {
    std::vector<UnitVerdict> verdicts;
    bool tells_everywhere;
  };
  Narrowed narrowed(const RegionPlace& place, Index first, Index last) const;

  const ClaimedFaces& claimed_;
  std::vector<std::string> units_;
  std::vector<Horizon> horizons_;  ///< youngest first
  std::map<Index, Index> horizon_of_surface_;
  std::map<std::int32_t, Contacts> contacts_;
  std::vector<TriangulatedSurface> left_;  ///< what the mesh has of each horizon
};

}  // namespace geomesh::geomodel::checking
