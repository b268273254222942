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

/// Regions of the mesh, each of them one or several connected components that share a name.
struct NamedRegions {
  std::vector<Region> regions;                ///< regions of the mesh in the order of their ids, which start at 1
  std::vector<std::int32_t> id_of_component;  ///< region id of each component
  std::vector<UnitVerdict> verdicts;          ///< per component
};

/// Names the regions by the rules described at NamingRules and name_model. Appends warnings on suffixes, on components
/// below an older and above a younger horizon, on missing horizons and on bodies that are not closed.
NamedRegions name_regions(const MeshedModel& model, const NamingRules& rules, const Column& column,
                          std::vector<std::string>& warnings);

/// A horizon at which the model ends: at its top (topography) or at its base.
struct ModelEnd {
  std::string horizon;
  bool above;
};
/// Returns the mesh without the components beyond the model's end, and without points, faces and edges that only these
/// components used. Throws Error{usage} if no surface has the end's name, Error{cannot_mesh} if nothing is left.
ConstrainedTetrahedralization without_side(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                           const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                           const ModelEnd& end, std::vector<std::string>& warnings);

/// Removes components above the topography and below the floor that the rules name; returns the mesh unchanged if they
/// name neither. Throws as without_side.
ConstrainedTetrahedralization within_ends(ConstrainedTetrahedralization mesh, const PolygonSoup& soup,
                                          const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                          const NamingRules& rules, std::vector<std::string>& warnings);

/// Returns the seed point's region for each component that contains a seed point. Warns of seed points outside the mesh
/// and of two in one component.
std::vector<Index> seeded(const ConstrainedTetrahedralization& mesh, const std::vector<NamedPoint>& seeds,
                          std::vector<std::string>& warnings);

/// Returns the fault block of each component, numbered from 0 by position; all are 0 if there is only one block. A
/// block consists of components connected across faces of horizons.
std::vector<Index> fault_blocks(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                                const std::vector<ComponentFacts>& facts, const Column& column);

/// Returns for each component smaller than `min_volume` the neighbour with the largest common area, following chains of
/// small components to their end; for others, the component itself.
std::vector<Index> merge_targets(const ConstrainedTetrahedralization& mesh, const std::vector<ComponentFacts>& facts,
                                 double min_volume);

/// Returns for each component the one into which it is joined: the largest component with the same non-empty name (the
/// first of equal ones), or itself if no other component has its name.
std::vector<Index> join_targets(const std::vector<ComponentFacts>& facts, const std::vector<std::string>& names);

/// Returns the facts of components, but with the volume of all components that are to be joined into the same one, for
/// comparison with `min_volume`.
std::vector<ComponentFacts> joined_facts(std::vector<ComponentFacts> facts, std::span<const Index> target);

/// Finds places where horizons have holes or end inside a region. Appends warnings on these and on absent horizons,
/// with the units that are connected there.
std::vector<OpenBorders> find_gaps(const MeshedModel& model, const Column& column, const NamedRegions& named,
                                   std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
