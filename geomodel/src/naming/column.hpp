// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which unit of the stratigraphic column each component is, from the horizons that bound it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// The stratigraphic column: alternating units and horizons, youngest first. Unit u is between horizons u - 1 and u.
struct Column {
  std::vector<std::string> units;
  std::vector<Index> horizons;     ///< surface index of each horizon; one fewer than units, none if there is no column
  std::vector<UpwardSides> sides;  ///< per horizon
  /// Unit normals of the triangles of each horizon; zero for triangles without area.
  std::vector<std::vector<Vec3>> normals;
  bool given() const { return !units.empty(); }
};
/// Makes the column from alternating names of units and horizons. Throws Error{usage} if the list has even length or a
/// horizon is not among the surfaces. Warns of parts of horizons that have no upper side.
Column make_column(const std::vector<std::string>& names, const std::vector<TriangulatedSurface>& surfaces,
                   std::vector<std::string>& warnings);

/// Areas of the horizon faces that bound one component, by index of the horizon in the column. A face at 84 degrees or
/// more to its input triangle is ignored, because it does not show on which side of the horizon the component lies: a
/// horizon that ends on a fault within the tolerance has such faces. Faces that rounding inverted are ignored too: a
/// horizon between two faults an ulp apart consists of such faces there.
struct HorizonContacts {
  /// Area of the faces of each horizon below (above) which the component lies, with something else on their other side.
  std::map<Index, double> lies_below, lies_above;
  std::map<Index, double> on_both_sides;  ///< area of each horizon's faces that have this component on both sides
};
std::vector<HorizonContacts> horizon_contacts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                              const ModelPlc& plc, const Column& column);

/// Returns the horizons directly above and below a point on its vertical line, as if they were in contact with it (area
/// 1); used for components between faults that touch no horizon. If the line meets no remaining part of a horizon (all
/// of it was above the topography), the surfaces before trimming by rules and bodies are used.
HorizonContacts contacts_on_vertical(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                     const Column& column, const Vec3& p);

/// The unit of a component of the mesh, as far as the horizons that touch the component determine it.
struct UnitVerdict {
  enum class Kind {
    unknown,   ///< no horizon shows to which unit the component belongs
    vertical,  ///< no horizon touches the component; those above and below it determine its unit
    unit,      ///< the horizons leave one possible unit of the component, first == last
    joined,    ///< the component has the units first .. last, connected through a gap in a horizon
    /// The horizons around the component leave the units first_possible .. last_possible possible. If nothing else
    /// decides, it belongs to first == last, the unit next to one of these horizons.
    incomplete,
    pocket,  ///< the component lies below an older and above a younger horizon, in the unit just above the younger
  } kind = Kind::unknown;
  Index first = no_index, last = no_index;
  Index first_possible = no_index, last_possible = no_index;
  bool by_heights = false;  ///< whether the order of deposition of the horizons determined the component's unit
};
/// Determines the unit of a component. Below horizon h lies unit h + 1 or an older one, above it unit h or a younger
/// one; where horizons converge (pinch-outs, erosion, onlap) the tightest bounds are used. A horizon that has the
/// component on both sides joins two units only if the bounds leave both possible; otherwise it is a dangling face
/// inside one unit. A horizon bounds nothing if it, or a horizon beyond it, has the component on both sides over a
/// larger area.
UnitVerdict find_unit(const HorizonContacts& contacts, const Column& column);

/// Returns the name of a component's unit, such as "chalk", or "chalk+basement" for joined units; empty if unknown.
std::string unit_name(const UnitVerdict& verdict, const Column& column);

}  // namespace geomesh::geomodel
