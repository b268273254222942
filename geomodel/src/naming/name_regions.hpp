// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the names, order and ids of regions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "naming/column.hpp"
#include "naming/region_facts.hpp"

namespace geomesh::geomodel {

/// Result of combining components into regions.
struct NamedRegions {
  std::vector<Region> regions;                ///< regions by id, which is row + 1
  std::vector<std::int32_t> id_of_component;  ///< region id of each component
  std::vector<UnitVerdict> verdicts;          ///< per component
};

/// Rules as in NamingRules and name_model. Appends warnings on suffixes, on components below an older and above a
/// younger horizon, on missing horizons and on bodies that are not closed.
NamedRegions name_regions(const MeshedModel& model, const NamingRules& rules, const Column& column,
                          std::vector<std::string>& warnings);

/// A horizon that ends the model above (topography) or below (base).
struct ModelEnd {
  std::string horizon;
  bool above;
};
/// Returns the mesh without the components beyond the end and everything that only they used. Throws Error{usage} if no
/// surface has that name, Error{cannot_mesh} if nothing is left.
ConstrainedTetrahedralization without_side(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                           const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                           const ModelEnd& end, std::vector<std::string>& warnings);

/// Removes what lies above the rules' topography and below their floor; returns the mesh unchanged if they name
/// neither. Throws as without_side.
ConstrainedTetrahedralization within_ends(ConstrainedTetrahedralization mesh, const PolygonSoup& soup,
                                          const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                          const NamingRules& rules, std::vector<std::string>& warnings);

/// Returns the region of each component that contains a seed point; warns of points outside and of two in one
/// component.
std::vector<Index> seeded(const ConstrainedTetrahedralization& mesh, const std::vector<NamedPoint>& seeds,
                          std::vector<std::string>& warnings);

/// Returns the fault block of each component, from 0 by position; all are 0 if there is one block. Blocks are
/// components connected across faces of horizons.
std::vector<Index> fault_blocks(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                                const std::vector<ComponentFacts>& facts, const Column& column);

/// For components smaller than `min_volume`, returns the neighbour with the largest common area, following chains of
/// small components to their end; for others, the component itself.
std::vector<Index> merge_targets(const ConstrainedTetrahedralization& mesh, const std::vector<ComponentFacts>& facts,
                                 double min_volume);

/// Returns one target for each component: among components with the same non-empty name, the one with the largest
/// volume (the first of equal ones); itself if no other has its name.
std::vector<Index> join_targets(const std::vector<ComponentFacts>& facts, const std::vector<std::string>& names);

/// Returns the facts with the volume of everything that joins the same target, which is compared with `min_volume`.
std::vector<ComponentFacts> joined_facts(std::vector<ComponentFacts> facts, std::span<const Index> target);

/// Finds where horizons have holes or stop short. Appends warnings on these and on absent horizons, with the units that
/// are connected there.
std::vector<OpenBorders> find_gaps(const MeshedModel& model, const Column& column, const NamedRegions& named,
                                   std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
