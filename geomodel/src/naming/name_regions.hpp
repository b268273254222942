// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names, order and ids of regions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "naming/column.hpp"
#include "naming/region_facts.hpp"

namespace geomesh::geomodel {

/// How components became regions.
struct NamedRegions {
  std::vector<Region> regions;                ///< by id, which is row + 1
  std::vector<std::int32_t> id_of_component;  ///< region id per component
  std::vector<UnitVerdict> verdicts;          ///< per component
};

/// Rules as in NamingRules and name_model. Appends warnings on suffixes, pockets, missing horizons and bodies that are
/// not closed.
NamedRegions name_regions(const MeshedModel& model, const NamingRules& rules, const Column& column,
                          std::vector<std::string>& warnings);

/// A horizon at which the model ends above (topography) or below (bottom).
struct ModelEnd {
  std::string horizon;
  bool above;
};
/// Without the components that lie beyond the end and everything that only they had.
/// Throws Error{usage} where no surface has that name, Error{cannot_mesh} where nothing is left.
ConstrainedTetrahedralization without_side(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                           const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                           const ModelEnd& end, std::vector<std::string>& warnings);

/// Without what lies above the rules' topography and below their floor; the mesh itself where they name neither. Throws
/// as without_side.
ConstrainedTetrahedralization within_ends(ConstrainedTetrahedralization mesh, const PolygonSoup& soup,
                                          const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces,
                                          const NamingRules& rules, std::vector<std::string>& warnings);

/// Region per component that holds a seed point; warns of points outside and of two in one component.
std::vector<Index> seeded(const ConstrainedTetrahedralization& mesh, const std::vector<NamedPoint>& seeds,
                          std::vector<std::string>& warnings);

/// Fault block of each component, from 0 by place; all 0 where there is one. Components joined across faces of
/// horizons.
std::vector<Index> fault_blocks(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                                const std::vector<ComponentFacts>& facts, const Column& column);

/// For components smaller than `min_volume`: the neighbour across most area, larger ones first followed to the end;
/// itself otherwise.
std::vector<Index> merge_targets(const ConstrainedTetrahedralization& mesh, const std::vector<ComponentFacts>& facts,
                                 double min_volume);

/// Components of one name (empty names are never joined): each joins the one of most volume, the first of equal ones.
/// One target a component; itself where nothing else has its name.
std::vector<Index> join_targets(const std::vector<ComponentFacts>& facts, const std::vector<std::string>& names);

/// The facts with the volume of everything that joins the same target: what `min_volume` is held against.
std::vector<ComponentFacts> joined_facts(std::vector<ComponentFacts> facts, std::span<const Index> target);

/// Finds where horizons have holes or stop short. Appends warnings on these and on horizons that are absent, with the
/// units that join there.
std::vector<OpenBorders> find_gaps(const MeshedModel& model, const Column& column, const NamedRegions& named,
                                   std::vector<std::string>& warnings);

}  // namespace geomesh::geomodel
