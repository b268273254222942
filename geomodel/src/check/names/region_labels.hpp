// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the name of each region before suffixes, and its position in the order of ids.
#pragma once

#include <optional>
#include <set>

#include "check/names/unit_of_region.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Kinds of region labels, in the order in which ids are assigned.
enum class LabelKind { unit, body, seed, unnamed };

struct RegionLabel {
  LabelKind kind = LabelKind::unnamed;
  Index rank = 0;    ///< within the kind
  std::string name;  ///< empty: `region_k`
};

/// Labels that the project allows for a region: one, or several if sampled points in the region give different results;
/// empty if nothing is known.
using AllowedLabels = std::vector<RegionLabel>;

class LabelFinder {
 public:
  LabelFinder(const CheckedFaces& checked, const Allowed& allowed);
  std::map<std::int32_t, AllowedLabels> labels() const;
  const UnitFinder& units() const { return units_; }
  const std::map<std::int32_t, RegionPlace>& places() const { return places_; }

 private:
  /// Returns the bodies that contain a region; nothing if every sampled point of the region is too near their surfaces.
  std::optional<std::vector<Index>> bodies_about(const RegionPlace& place) const;
  std::map<std::int32_t, RegionLabel> seeded() const;
  std::optional<RegionLabel> body_label(const std::vector<std::vector<Index>>& about,
                                        const std::vector<Index>& own) const;

  const CheckedFaces& checked_;
  double reach_;
  double least_volume_;  ///< regions of a smaller volume are not checked: rounding makes them
  UnitFinder units_;
  std::map<std::int32_t, RegionPlace> places_;
};

}  // namespace geomesh::geomodel::checking
