// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which unit of the column a region is, by the rules of docs/output-files.md ("Column"). The checker uses
/// the mesh faces that bound the region and the input surfaces, independently of the program's naming.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "check/exact/deviation.hpp"
#include "check/mesh/checked_faces.hpp"
#include "check/names/region_places.hpp"

namespace geomesh::geomodel::checking {

/// first and last of the consecutive units that are joined in the region; no_index if none is known
struct UnitVerdict {
  Index first = no_index, last = no_index;  ///< first and last unit that are joined in the region; no_index if none
  /// Whether the region has nearly equal areas below and above one horizon, so that its side of it is uncertain.
  bool close = false;
  bool open = false;  ///< whether horizons around the region leave several units possible; the nearest was taken
  Index first_possible = no_index, last_possible = no_index;  ///< of these
};

class UnitFinder {
 public:
  /// `reach` is the largest distance of a mesh face from the input triangles that it represents.
  UnitFinder(const CheckedFaces& checked, double reach);

  bool given() const { return !units_.empty(); }
  const std::vector<std::string>& units() const { return units_; }
  /// Returns the possible units of a region, one verdict for each. They follow from the horizons that bound the region;
  /// if there are none, from the vertical lines through its sampled points. If these leave several units possible, or
  /// none, the input's horizons above and below each sampled point are used too, because rules may have removed a whole
  /// horizon there.
  std::vector<UnitVerdict> verdicts_of(std::int32_t region, const RegionPlace& place) const;
  std::string name_of(const UnitVerdict& verdict) const;
  bool is_horizon(Index surface) const { return horizon_of_surface_.contains(surface); }

 private:
  struct Contacts {
    /// For each horizon, the area of its faces that have the region only below them, only above them, and on both
    /// sides.
    std::map<Index, double> below, above, both;
  };
  struct Horizon {
    Index surface;
    bool is_unconformity;
    std::vector<int> upper_side;
    TriangleSet triangles;
    BoxTree tree;
  };
  void add_faces(double reach);
  UnitVerdict verdict_of(const Contacts& contacts) const;
  Contacts on_vertical(const Vec3& p) const;
  /// Narrows the range of units, first .. last, by the horizons of the input above or below p. Only horizons that lie
  /// entirely on one side of p count. If two of them contradict each other, the range is unchanged. Returns false if no
  /// horizon counts.
  bool narrow(const Vec3& p, Index& first, Index& last) const;
  /// The units that horizons of the input above and below sampled points of a region leave possible.
  struct Narrowed {
    std::vector<UnitVerdict> verdicts;
    bool tells_everywhere;
  };
  Narrowed narrowed(const RegionPlace& place, Index first, Index last) const;

  const CheckedFaces& checked_;
  std::vector<std::string> units_;
  std::vector<Horizon> horizons_;  ///< youngest first
  std::map<Index, Index> horizon_of_surface_;
  std::map<std::int32_t, Contacts> contacts_;
  std::vector<TriangulatedSurface> left_;  ///< for each horizon, its triangles that are in the mesh
};

}  // namespace geomesh::geomodel::checking
