// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names, order and ids of regions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sets/column.hpp"
#include "sets/region_facts.hpp"

namespace geomesh::geomodel {

/// How components became regions.
struct NamedRegions {
  std::vector<Region> regions;                ///< by id, which is row + 1
  std::vector<std::int32_t> id_of_component;  ///< region id per component
  std::vector<UnitVerdict> verdicts;          ///< per component
};

/// Rules as in NamingRules and name_model. Appends warnings on suffixes, pockets, missing horizons and bodies that are not closed.
NamedRegions name_regions(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                          const std::vector<TriangulatedSurface>& surfaces, const NamingRules& rules, const Column& column,
                          std::vector<std::string>& warnings);

/// Appends warnings on horizons that have holes, stop short or are absent, with the units that join there.
void warn_of_gaps(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                  const std::vector<TriangulatedSurface>& surfaces, const Column& column, const NamedRegions& named,
                  std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
